"""Fibrotaxis: a droplet on a layer with oblique fibres: Bhopalam, Bueno, Gomez, Soft Matter 20, 9301 (2024), in 2D.

S. R. Bhopalam, J. Bueno, H. Gomez, "Fibrotaxis: gradient-free, spontaneous and controllable droplet motion on soft solids". Its abstract
names what matters: wettability, direction and strength of the fibres, and the elastocapillary number. The droplet is said to be fastest
where the contact angle is near the angle of the fibres, or that plus 90 degrees. Its energy of the fibres and its numbers were not at hand.

Sides are periodic, E = 0.4, nu = 0.3, and the energy of the fibres is k/2 (I_4 - 1)^2, their angle counted from the wall. Speeds are means
from t = 10 to 30. One sweep has five angles of the fibres and four k at the contact angle 60 degrees, a second one four contact angles
and five angles of the fibres; see _drafts.py. What drives a droplet is compared with linear elasticity (tests/oracle/driven_droplet.py),
also where layer and fibres are ten times as stiff and strains are small."""

import matplotlib.pyplot as plt

from softwet._figures.journal import SERIES, WIDTH, letter
from softwet._papers import _drafts
from softwet._papers._drafts import judged

FIBRES, STIFFNESSES, YOUNG, POISSON, WETTING = (30, 60, 90, 120, 150), (0.15, 0.3, 0.6, 1.2), 0.4, 0.3, 60
LEANING, ANGLES, STIFFNESS = (15, 30, 45, 60, 75), (60, 75, 105, 120), 0.6  # of the second sweep
STIFFER = 10
ANGLE_KEY, STIFFNESS_KEY, WETTING_KEY = "substrate.fibre.angle", "substrate.fibre.stiffness", "fluid.contact_angle"
UPRIGHT = ("--set", f"{ANGLE_KEY}=90")  # these fibres drive no droplet


def case_of(name, elements):
    return _drafts.tables(name, elements, {"contact_angle": WETTING}, {"young": YOUNG, "poisson": POISSON,
                                                                      "fibre": {"stiffness": STIFFNESS, "angle": 60}},
                          left="periodic", right="periodic")


def compute(runs):
    if runs.quick:
        _drafts.sweep(runs, "stiffness", case_of, {STIFFNESS_KEY: [STIFFNESS], ANGLE_KEY: [60, 120]})
        return
    pull, stiff = _drafts.pulled(WETTING), ["--set", f"substrate.young={YOUNG * STIFFER:g}"]
    _drafts.sweep(runs, "stiffness", case_of, {STIFFNESS_KEY: STIFFNESSES, ANGLE_KEY: FIBRES})
    _drafts.sweep(runs, "pulled_stiffness", case_of, {STIFFNESS_KEY: STIFFNESSES}, more=[*UPRIGHT, "--set", f"{WETTING_KEY}={pull}"])
    _drafts.sweep(runs, "wetting", case_of, {WETTING_KEY: ANGLES, ANGLE_KEY: LEANING})
    _drafts.sweep(runs, "pulled", case_of, {WETTING_KEY: [_drafts.pulled(angle) for angle in ANGLES]}, more=UPRIGHT)
    _drafts.sweep(runs, "stiff", case_of, {STIFFNESS_KEY: [STIFFNESS * STIFFER], ANGLE_KEY: LEANING}, more=stiff)
    _drafts.sweep(runs, "pulled_stiff", case_of, {STIFFNESS_KEY: [STIFFNESS * STIFFER]},
                  more=[*stiff, *UPRIGHT, "--set", f"{WETTING_KEY}={pull}"])


def read(folder):
    """Three dicts: {(k, angle of the fibres): Droplet}, {(contact angle, angle of the fibres): Droplet}, and the first
    for the stiff layer."""
    stiffness, stiff = (read_stiffness(folder, *which) for which in (("stiffness", 1), ("stiff", STIFFER)))
    wetting, angle_of = _drafts.droplets(folder, "wetting"), {_drafts.pulled(angle): angle for angle in ANGLES}
    mobility = {angle_of[text]: value for text, value in _drafts.mobilities(folder, "pulled", angle_of.get).items()}
    layers = {fibres: _drafts.layer(YOUNG, POISSON, 0, (STIFFNESS, fibres)) for fibres in {fibres for _, fibres in wetting}}
    for (angle, fibres), droplet in wetting.items():
        droplet.foretold(layers[fibres], angle)
        droplet.driven(mobility.get(angle))
    return stiffness, wetting, stiff


def read_stiffness(folder, name, stiffer):
    found, mobility = _drafts.droplets(folder, name), _drafts.mobilities(folder, f"pulled_{name}", lambda value: WETTING)
    for (k, fibres), droplet in found.items():
        droplet.foretold(_drafts.layer(YOUNG * stiffer, POISSON, 0, (k, fibres)), WETTING)
        droplet.driven(mobility.get(k))
    return found


# --- agreement -----------------------------------------------------------------------------------------------------
def agreement(stiffness, wetting, stiff):
    fastest = max(abs(droplet.speed) for droplet in stiffness.values())
    apart = max(abs(stiffness[k, fibres].speed + stiffness[k, 180 - fibres].speed) for k, fibres in stiffness if fibres < 90) / fastest
    yield ("speed with mirrored fibres", "the opposite", f"{apart:.1e} of the largest apart", judged(apart < 0.01, "the mesh drives it"))
    if not stiff:
        return
    still = max(abs(stiffness[k, 90].speed) for k in STIFFNESSES) / fastest
    yield ("speed with upright fibres", "0", f"{still:.1e} of the largest", judged(still < 1e-3, "the mesh drives it"))
    for angle in ANGLES:
        yield fastest_fibres(angle, {fibres: abs(wetting[angle, fibres].speed) for fibres in LEANING})
    for fibres in LEANING:
        yield _drafts.compared(f"E = {YOUNG * STIFFER:g}, k = {STIFFNESS * STIFFER:g}, fibres {fibres}",
                               stiff[STIFFNESS * STIFFER, fibres], "work", _drafts.STRAINS)
    for angle in ANGLES[1:]:
        yield _drafts.compared(f"k = {STIFFNESS:g}, fibres 60, contact angle {angle}", wetting[angle, 60], "work", _drafts.STRAINS)
    for k in STIFFNESSES:
        yield _drafts.compared(f"k = {k:g}, fibres 60", stiffness[k, 60], "work", _drafts.STRAINS)
    yield _drafts.compared(f"k = {STIFFNESS:g}, fibres 60", stiffness[STIFFNESS, 60], "slopes", _drafts.POINTS)


def fastest_fibres(angle, speeds):
    """The angle of the fibres below 90 degrees at which a droplet is fastest; those beyond mirror it."""
    best = max(speeds, key=speeds.get)
    wanted = sorted({side for fibres in (angle, angle - 90) for side in (fibres, 180 - fibres) if 0 < side < 90})
    return (f"fibres of the fastest droplet, contact angle {angle}", f"{' or '.join(map(str, wanted))} degrees, the paper",
            f"{best} degrees", judged(any(abs(best - side) < 10 for side in wanted), "so at any contact angle"))


# --- picture -------------------------------------------------------------------------------------------------------
def draw_speeds(axes, found, name, unit):
    for value, colour in zip(dict.fromkeys(first for first, _ in found), SERIES):
        chosen = {fibres: droplet for (first, fibres), droplet in found.items() if first == value}
        _drafts.draw_speeds(axes, chosen, colour, f"{name} {value:g}{unit}")
    axes.axhline(0, color="0.6", linewidth=0.6)
    axes.set(xlabel="angle of the fibres, degrees")
    _drafts.draw_legend(axes)


def draw(folder):
    stiffness, wetting, stiff = read(folder)
    figure, axes = plt.subplots(1, 3, figsize=(WIDTH, 3.2), layout="constrained")
    draw_speeds(axes[0], stiffness, "k =", "")
    axes[0].set(title=f"contact angle {WETTING}°")
    if stiff:
        draw_speeds(axes[1], wetting, "contact angle", "°")
        axes[1].set(title=f"k = {STIFFNESS:g}")
        draw_mechanism(axes[2], {fibres: wetting[WETTING, fibres] for fibres in LEANING},
                       {fibres: droplet for (_, fibres), droplet in stiff.items()})
    for panel, name in zip(axes, "ABC"):
        letter(panel, name)
    rows = [(YOUNG * stiffer, k, WETTING, fibres, droplet) for of, stiffer in ((stiffness, 1), (stiff, STIFFER))
            for (k, fibres), droplet in of.items()]
    rows += [(YOUNG, STIFFNESS, angle, fibres, droplet) for (angle, fibres), droplet in wetting.items()]
    rows = [[*(f"{value:g}" for value in row[:-1]), *row[-1].row()] for row in rows]
    return figure, [("young", "stiffness", "contact_angle", "fibres", *_drafts.HEADER), *rows], list(agreement(stiffness, wetting, stiff))


def draw_mechanism(axes, soft, stiff):
    _drafts.draw_drives(axes, soft, f"E = {YOUNG:g}, k = {STIFFNESS:g}")
    _drafts.draw_more(axes, stiff, STIFFER, f"E = {YOUNG * STIFFER:g}, k = {STIFFNESS * STIFFER:g}, times {STIFFER}")
    axes.set(xlabel="angle of the fibres, degrees", title=f"contact angle {WETTING}°")
    _drafts.draw_legend(axes)
