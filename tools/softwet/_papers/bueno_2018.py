"""Durotaxis: a droplet on a layer whose stiffness grows along it: Bueno et al., Soft Matter 14, 1417 (2018), in 2D.

J. Bueno, Y. Bazilevs, R. Juanes, H. Gomez, "Wettability control of droplet durotaxis", on the equations of softwet. The paper could not be
read; known is that in it the direction depends on the wettability. The Young modulus of the layer is 0.6 exp(s (x - 1/2)), the droplet
begins at x = 1/2, and its speed is the mean from t = 10 to 30. A sweep has five s and four contact angles; see _drafts.py.

What drives a droplet is compared with two formulas of linear elasticity, with the contact lines that were found
(tests/oracle/driven_droplet.py): on the layer above, Saint Venant-Kirchhoff, on one that is neo-Hookean, and on one that is ten times as
stiff, where strains are small."""

import matplotlib.pyplot as plt

from softwet._figures.journal import SERIES, WIDTH, letter
from softwet._papers import _drafts
from softwet._papers._drafts import judged

GROWTHS, ANGLES, YOUNG, POISSON = (-2, 0, 0.5, 1, 2), (60, 75, 105, 120), 0.6, 0.45
STIFFER, NEO_HOOKEAN = 10, ["--set", "substrate.material=neo_hookean"]
SAINT_VENANT = "saint_venant_kirchhoff"
YOUNG_KEY, ANGLE_KEY = "substrate.young", "fluid.contact_angle"


def young(growth, stiffer=1):
    return f"{YOUNG * stiffer:g}*exp({growth}*(x - 0.5))"


def case_of(name, elements):
    return _drafts.tables(name, elements, {"contact_angle": 75.0}, {"young": YOUNG, "poisson": POISSON})


def compute(runs):
    if runs.quick:
        _drafts.sweep(runs, "graded", case_of, {YOUNG_KEY: [young(-2), young(2)], ANGLE_KEY: [75]})
        return
    pulled = {ANGLE_KEY: [_drafts.pulled(angle) for angle in ANGLES]}
    _drafts.sweep(runs, "graded", case_of, {YOUNG_KEY: [young(growth) for growth in GROWTHS], ANGLE_KEY: ANGLES})
    _drafts.sweep(runs, "pulled", case_of, pulled)
    _drafts.sweep(runs, "stiff", case_of, {YOUNG_KEY: [young(1, STIFFER)], ANGLE_KEY: ANGLES})
    _drafts.sweep(runs, "pulled_stiff", case_of, pulled, more=["--set", f"{YOUNG_KEY}={YOUNG * STIFFER:g}"])
    _drafts.sweep(runs, "neo_hookean", case_of, {YOUNG_KEY: [young(1)], ANGLE_KEY: ANGLES}, more=NEO_HOOKEAN)
    _drafts.sweep(runs, "pulled_neo_hookean", case_of, pulled, more=NEO_HOOKEAN)


def read(folder):
    """Three dicts {(s, contact angle): Droplet}: of the layer, the stiff one and the neo-Hookean one."""
    return [read_sweep(folder, name, stiffer) for name, stiffer in (("", 1), ("_stiff", STIFFER), ("_neo_hookean", 1))]


def read_sweep(folder, name, stiffer):
    growth_of, angle_of = {young(growth, stiffer): growth for growth in GROWTHS}, {_drafts.pulled(angle): angle for angle in ANGLES}
    found = {(growth_of[text], angle): droplet for (text, angle), droplet in _drafts.droplets(folder, name.strip("_") or "graded").items()}
    mobilities = {angle_of[text]: value for text, value in _drafts.mobilities(folder, f"pulled{name}", angle_of.get).items()}
    layers = {growth: _drafts.layer(YOUNG * stiffer, POISSON, growth) for growth in {growth for growth, _ in found}}
    for (growth, angle), droplet in found.items():
        droplet.foretold(layers[growth], angle)
        droplet.driven(mobilities.get(angle))
    return found


# --- agreement -----------------------------------------------------------------------------------------------------
def agreement(found, stiff, neo):
    angles = [angle for angle in ANGLES if (2, angle) in found]
    fastest = max(abs(found[2, angle].speed) for angle in angles)
    apart = max(abs(found[2, angle].speed + found[-2, angle].speed) for angle in angles) / fastest
    yield ("speed on the mirrored layer", "the opposite", f"{apart:.1e} of the largest apart", judged(apart < 0.01, "the mesh drives it"))
    if not stiff:
        return
    still = max(abs(found[0, angle].speed) for angle in angles) / fastest
    yield ("speed on a uniform layer", "0", f"{still:.1e} of the largest", judged(still < 1e-3, "the mesh drives it"))
    shares = [found[1, angle].speed / found[2, angle].speed for angle in angles]
    yield ("speed at s = 1 over that at s = 2", "0.5, small s", f"{min(shares):.2f} to {max(shares):.2f}",
           judged(all(abs(share - 0.5) < 0.1 for share in shares), "s = 2 is not small"))
    yield from directions(found, neo)
    for angle in angles:
        yield _drafts.compared(f"E = {YOUNG * STIFFER:g}, contact angle {angle}", stiff[1, angle], "work", _drafts.STRAINS)
    for of, name in ((found, "Saint Venant-Kirchhoff"), (neo, "neo-Hookean")):
        for angle in angles:
            yield _drafts.compared(f"E = {YOUNG:g}, {name}, contact angle {angle}", of[1, angle], "work", _drafts.STRAINS)
    for angle in angles:
        yield _drafts.compared(f"E = {YOUNG * STIFFER:g}, contact angle {angle}", stiff[1, angle], "slopes", _drafts.POINTS)


def directions(found, neo):
    for of, name in ((found, "Saint Venant-Kirchhoff"), (neo, "neo-Hookean")):
        sides = {angle: side(of[1, angle]) for angle in ANGLES}
        told, kinds = ", ".join(f"{angle}° {side}" for angle, side in sides.items()), set(sides.values())
        yield (f"side to which droplets go, {name}", "it turns with the wettability, the paper", told,
               judged({"softer", "stiffer"} <= kinds, "it does not turn"))
        yield (f"side to which droplets go, {name}", "softer, both formulas", told, judged(kinds == {"softer"}, _drafts.STRAINS))


def side(droplet):
    return "open" if abs(droplet.speed) < droplet.error else "stiffer" if droplet.speed > 0 else "softer"


# --- picture -------------------------------------------------------------------------------------------------------
def draw_speeds(axes, found):
    for angle, colour in zip(ANGLES, SERIES):
        chosen = {growth: droplet for (growth, other), droplet in found.items() if other == angle}
        _drafts.draw_speeds(axes, chosen, colour, f"contact angle {angle}°")
    axes.set(xlabel=r"$s$, growth of $\ln E_Y$ along the layer", title="above 0: to the right")
    axes.legend()


def draw(folder):
    found, stiff, neo = read(folder)
    figure, axes = plt.subplots(1, 2, figsize=(WIDTH, 3.2), layout="constrained")
    draw_speeds(axes[0], found)
    if stiff:
        _drafts.draw_drives(axes[1], {angle: found[1, angle] for angle in ANGLES}, f"E = {YOUNG:g}, Saint Venant-Kirchhoff")
        _drafts.draw_more(axes[1], {angle: neo[1, angle] for angle in ANGLES}, 1, f"E = {YOUNG:g}, neo-Hookean")
        _drafts.draw_more(axes[1], {angle: stiff[1, angle] for angle in ANGLES}, STIFFER, f"E = {YOUNG * STIFFER:g}, times {STIFFER}")
        axes[1].set(xlabel="contact angle, degrees", title="s = 1")
        _drafts.draw_legend(axes[1])
    for panel, name in zip(axes, "AB"):
        letter(panel, name)
    rows = [[f"{young:g}", material, f"{growth:g}", f"{angle:g}", *droplet.row()]
            for young, material, of in ((YOUNG, SAINT_VENANT, found), (YOUNG * STIFFER, SAINT_VENANT, stiff), (YOUNG, "neo_hookean", neo))
            for (growth, angle), droplet in sorted(of.items())]
    return figure, [("young", "material", "s", "contact_angle", *_drafts.HEADER), *rows], list(agreement(found, stiff, neo))
