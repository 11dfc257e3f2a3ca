"""Surface tension of the solid: standing waves, droplets at rest on stiff and soft layers, and the energy balance.

**Waves.** A layer of solid alone on a roller base carries waves whose frequencies the tension U of its top raises. A run starts
with the velocities of the slowest wave of linear theory (tests/verification/_layer.py), as far as eight [[wave]] over the height can be
like it; the rest, which has 1 % of the energy, sets off other waves. Elastic + surface - kinetic energy of a wave goes with
cos(2 w t). The w that is fitted is compared with linear theory, after the error of the time scheme (rho_inf = 1) is taken out.

**A droplet at rest.** The traction of a resolved contact line is sigma t 2 D(rho) sin(alpha)/sigma across the line, that of a
droplet of the radius R is sigma/R inside (tests/oracle/ridge_locking.py). Linear theory turns it into displacements: u(k) = C(k) t(k),
where a tension U of the wall adds U k^2 to the inverse of u_y/t_y. With fluid.wall_tension = "acts" the tension is U + f_w(rho(x)).
It varies along the wall and couples the waves, and its slope cancels the tangential traction. The stiff layer has 50 times the Young
modulus and the surface tension of the soft one, so that its displacements are linear theory's over 50. A tension below the liquid
of U - sigma cos(alpha) that is given by hand has to give the same wall as f_w that acts, up to the 1e-5 by which the wall energy is
smoothed at its ends.

**Energy.** With "acts" the balance of energy closes without a power that goes into a wall that is stretched.

**Soft.** The glycerol droplet of Style et al. (PRL 110, 066103, 2013) in 2D, on a gel whose elastocapillary length is
four times the capillarity. It has to come to rest, and on a gel that is three times softer too, where a run without surface tension does
not get there."""

from typing import NamedTuple

import _layer
import _measure
import _shape
import numpy
import ridge_locking
from _case import case, fields

MINUTES = {"quick": 0.2, "full": 5}
YOUNG, POISSON, HEIGHT, CAPILLARITY = 0.7554, 0.45, 0.125, 1 / 64
SIGMA = _measure.TENSION_OVER_CAPILLARITY * CAPILLARITY
FACTOR = 50  # of the stiff layer


class Drop(NamedTuple):
    """The right half of a droplet on a layer, and of the domain."""
    radius: float
    angle: float
    capillarity: float
    length: float
    height: float
    poisson: float
    clamped: bool = False


FIG2 = Drop(0.155, 75.0, CAPILLARITY, 0.5, HEIGHT, POISSON)


# --- standing waves

SPEED = 1e-5  # at the top


def swinging(k, tension, dimension=2):
    """A layer half a wave long, in 3D along both axes of the wall, with velocities near its slowest wave's.
    @return the frequency of this wave and the case"""
    wave = _layer.SlowestWave(k, HEIGHT, YOUNG, POISSON, tension)
    y, numbers = (numpy.arange(400) + 0.5) / 400 * HEIGHT, numpy.arange(8)  # of half waves over the height
    along, waves = dimension - 1, []
    for axis in range(dimension):
        shape, of = (wave.shape(y)[1], numpy.sin) if axis == along else (wave.shape(y)[0] / numpy.sqrt(along), numpy.cos)
        parts = numpy.linalg.lstsq(of(numpy.outer(y, numbers) * numpy.pi / HEIGHT), shape, rcond=1e-9)[0]
        waves += [dict(field=f"velocity_{'xyz'[axis]}", amplitude=SPEED * part, mode=[1] * along + [int(number)])
                  for number, part in zip(numbers, parts) if number or axis < along]
    length, elements = numpy.pi / k * numpy.sqrt(along), 16 if dimension == 2 else 8
    return wave.omega, case(
        "A layer that swings, most of all in its slowest wave.", "surface_wave",
        domain=dict(size=[length] * along + [HEIGHT], elements=[elements] * dimension),
        substrate=dict(thickness=HEIGHT, young=YOUNG, poisson=POISSON, surface_tension=tension),
        wave=waves,
        boundary=dict(bottom="slip", top="free"),
        time=dict(rho_inf=1.0, end=1.0, tolerance=1e6),
        solver=dict(newton=dict(rtol=1e-9, atol=1e-20), krylov=dict(rtol=1e-4)))


def frequency(run, omega):
    """Of the wave with about omega, after the first step, one of backward Euler."""
    rows = run.history
    difference = rows["energy_elastic"] + rows["energy_surface"] - rows["energy_kinetic"]
    return _shape.damped_wave(rows["t"][1:], difference[1:], 2j * omega, drift=False)[0].imag / 2


def steps(omega, count, periods):
    dt = 2 * numpy.pi / omega / count
    return dt, [f"time.dt_initial={dt:.17g}", f"time.dt_max={dt:.17g}", f"time.end={count * periods * dt:.17g}"]


def waves(lab):
    wanted, exact = {}, {}
    for dimension, number in ((2, 8), (3, 8)) if lab.quick else ((2, 2), (2, 8), (3, 2), (3, 8)):
        for ratio in (0, 1, 5) if dimension == 2 else (5,):
            label = f"{dimension}D, k = {number} pi, U/sigma = {ratio}"
            omega, text = swinging(number * numpy.pi, ratio * SIGMA, dimension)
            dt, settings = steps(omega, 60, 2 if dimension == 2 else 1)
            exact[label], wanted[label] = (omega, dt), (text, settings)
    rows, worst = [], [0.0, 0.0]
    for label, run in lab.runs(wanted).items():
        omega, dt = exact[label]
        found = 2 / dt * numpy.tan(0.5 * dt * frequency(run, omega))
        rows.append((label, f"{omega:.6f}", f"{found:.6f}", f"{100 * (found / omega - 1):+.4f} %"))
        worst[label[0] == "3"] = max(worst[label[0] == "3"], abs(found / omega - 1))
    lab.title("Standing waves")
    lab.text(f"Half a wave on 16 elements (2D), or on 8 x 8 along the diagonal (3D). H = {HEIGHT}, E = {YOUNG}, nu = {POISSON}, "
             f"sigma = {SIGMA:.4e}.")
    lab.table(("wave", "linear theory", "measured", "off"), rows, "waves")
    for what, error, bound in zip(("2D", "3D"), worst, (2e-4, 2e-3)):
        lab.expect(f"{what}: largest error of a frequency", f"<= {100 * bound:g} %", f"{100 * error:.2g} %", error <= bound)


# --- a droplet at rest

def half(drop, elements, height, young, surface, end, **wall):
    """@param height  of the domain;  @param surface  further keys of the substrate;  @param wall  further keys of the
    fluid"""
    return case("Half a droplet at rest; the left side is its plane of symmetry.", "gel",
                domain=dict(size=[drop.length, height], elements=elements),
                fluid=dict(viscosity="1/256", capillarity=drop.capillarity, temperature=0.39, contact_angle=drop.angle,
                           wall_law="energy", **wall),
                substrate=dict(thickness=drop.height, young=young, poisson=drop.poisson, **surface),
                droplet=[dict(centre=[0.0, drop.height], radius=drop.radius)],
                boundary=dict(bottom="clamped" if drop.clamped else "slip", top="no_slip"),
                time=dict(end=end),
                output=fields(end))


def stiff(ratio, wall_tension, **surface):
    """The droplet of Fig. 2 on FACTOR times its modulus and FACTOR times `ratio` sigma of tension."""
    return half(FIG2, [64, 64], 0.5, FACTOR * YOUNG, {"surface_tension": FACTOR * ratio * SIGMA, **surface}, 300.0,
                wall_tension=wall_tension)


def linear_theory(x, drop, young, surface_tension, acts, modulus=0.0):
    """Displacement (u_x, u_y) of the wall at the points x; acts: f_w is part of the tension; modulus: lambda_s + 2 G_s
    of the wall."""
    count, modes = 4000, 400
    s = (numpy.arange(count) + 0.5) * drop.length / count
    across, down = ridge_locking.tractions(s, drop.capillarity, drop.radius, numpy.radians(drop.angle), 0.0)
    tension = numpy.full(count, float(surface_tension))
    if acts:  # across + f_w' = 0, and f_w = 0 where the wall is dry
        tension += (across.sum() - numpy.cumsum(across)) * drop.length / count
        across = numpy.zeros(count)
    k = numpy.arange(modes) * numpy.pi / drop.length
    sine, cosine = numpy.sin(numpy.outer(k, s)), numpy.cos(numpy.outer(k, s))
    norm = numpy.where(k > 0, 2, 1) / drop.length
    stiffness = numpy.zeros((2 * modes, 2 * modes))
    for m in range(modes):
        layer = _layer.compliance(k[m], drop.height, young, drop.poisson, clamped=drop.clamped, modulus=modulus)
        stiffness[m::modes, m::modes] = numpy.linalg.inv(layer + (m == 0) * numpy.diag([1.0, 0.0]))
    # (tension u_y', w_y'), for each wave over its norm
    stiffness[modes:, modes:] += norm[:, None] * numpy.outer(k, k) * ((sine * tension) @ sine.T) * drop.length / count
    forces = numpy.concatenate((norm * (sine @ across), norm * (cosine @ down))) * drop.length / count
    u = numpy.linalg.solve(stiffness, forces)
    return numpy.stack((numpy.sin(numpy.outer(x, k)) @ u[:modes], numpy.cos(numpy.outer(x, k)) @ u[modes:]))


def wall_of(run):
    wall = _measure.interface(run.folder)
    return wall["x_reference"], numpy.stack([wall["displacement_x"], wall["displacement_y"]])


def at_line(x, u):
    """u_x where the middle density of a flat wall is."""
    return numpy.interp(FIG2.radius * numpy.sin(numpy.radians(FIG2.angle)), x, u[0])


def droplet(lab):
    scenes = {(0, 1), (0, 5), (1, 1)} if lab.quick else {(0, 0), (0, 1), (0, 5), (1, 1), (1, 2), (1, 5)}
    names = {(acts, ratio): f"{'acts' if acts else 'none'}, U/sigma = {ratio}" for acts, ratio in sorted(scenes)}
    wanted = {name: (stiff(ratio, "acts" if acts else "none"), []) for (acts, ratio), name in names.items()}
    under = FACTOR * SIGMA - SIGMA * numpy.cos(numpy.radians(FIG2.angle))
    wanted["none, U/sigma = 1, and U - sigma cos(alpha) below the liquid"] = (stiff(1, "none", surface_tension_wet=under), [])
    runs = lab.runs(wanted)
    rows, pictures = [], {}
    for (acts, ratio), name in names.items():
        x, u = wall_of(runs[name])
        theory = linear_theory(x, FIG2, FACTOR * YOUNG, FACTOR * ratio * SIGMA, acts)
        off = numpy.abs(u - theory).max(axis=1) / theory[1].max()
        ridge, middle = u[1].max() / theory[1].max() - 1, u[1, 0] / theory[1, 0] - 1
        rows.append((name, *(f"{FACTOR * v:.3e}" for v in (theory[1].max(), theory[1, 0], theory[1, -1], at_line(x, theory))),
                     f"{100 * ridge:+.2f} %", f"{100 * middle:+.2f} %", f"{FACTOR * u[1, -1]:.3e}", f"{FACTOR * at_line(x, u):.3e}",
                     *(f"{100 * w:.2f} %" for w in off)))
        pictures[name] = (x, u, theory)
        for what, value in (("ridge", ridge), ("middle", middle)):
            lab.expect(f"{name}: {what}", "linear theory +- 3 %", f"{100 * value:+.2f} %", abs(value) <= 0.03)
        lab.expect(f"{name}: profiles of u_x and u_y", "within 3 % of the ridge", " and ".join(f"{100 * w:.2f} %" for w in off),
                   off.max() <= 0.03)
    lab.title("A droplet at rest")
    lab.text(f"Lengths times {FACTOR}, as in linear theory with E = {YOUNG}. The right half of a droplet of alpha = {FIG2.angle:g} "
             f"degrees and R = {FIG2.radius}, on 64 elements of 1/128.")
    lab.table(("fluid.wall_tension", "ridge", "middle", "far side", "u_x at the line", "ridge", "middle", "far side, softwet",
               "u_x at the line, softwet", "profile u_x", "profile u_y"), rows, "droplet")
    tangential(lab, names, pictures, wall_of(runs["none, U/sigma = 1, and U - sigma cos(alpha) below the liquid"])[1])

    def draw(axes):
        for (acts, ratio), color in (((0, 1), "C0"), ((0, 5), "C1"), ((1, 1), "C2")):
            x, u, theory = pictures[names[acts, ratio]]
            axes.plot(x, FACTOR * u[1], color=color, label=names[acts, ratio])
            axes.plot(x, FACTOR * theory[1], "--", color=color)
        axes.set(xlabel="x", ylabel=f"u_y times {FACTOR}", title="softwet, and linear theory (dashes)")
        axes.legend()
    lab.plot("profile", draw)


def tangential(lab, names, pictures, by_hand):
    """What f_w that acts does: no force along the wall at the line, as if the tension below the liquid had been
    given."""
    x, u, _ = pictures[names[0, 1]]
    acting = pictures[names[1, 1]][1]
    moved, held = at_line(x, u), at_line(x, acting)
    lab.expect("the line is pulled towards the liquid by 'none'; |u_x| with 'acts' as a part of that", "<= 0.4",
               f"{abs(held / moved):.2f}", moved < 0 and abs(held) <= 0.4 * abs(moved))
    far = [abs(v[1, -1]) for v in (acting, u)]
    lab.expect("far side with 'acts', as a part of that with 'none'", "<= 0.15", f"{far[0] / far[1]:.2f}", far[0] <= 0.15 * far[1])
    error = numpy.abs(by_hand - acting).max() / acting[1].max()
    lab.expect("U - sigma cos(alpha) below the liquid against f_w that acts", "<= 1e-4 of the ridge", f"{error:.1e}", error <= 1e-4)


# --- energy

PULL = ["domain.elements=[32,16]", "fluid.capillarity=1/16", "fluid.wall_law=energy", "fluid.traction=blended",
        "substrate.surface_tension=0.03", "substrate.density=400", "substrate.young=0.0018885",
        "load[0].force=[0.000405375,0]", "load[0].start=2", "load[0].ramp=4", "time.end=4", "output.fields.times=[0,4]",
        "time.tolerance=1e3", "solver.newton.rtol=1e-11", "solver.newton.atol=1e-14", "solver.krylov.rtol=1e-4"]


def balance(lab):
    """The droplet and the load of the study energy_balance, with a tension of 1.9 sigma."""
    sizes = (0.025, 0.0125) if lab.quick else (0.0015625, 0.00078125, 0.000390625)
    runs = lab.runs({f"{tension}, dt = {dt}": ("tensotaxis_pull_2d", [
        *PULL, f"fluid.wall_tension={tension}", f"time.dt_initial={dt}", f"time.dt_max={dt}"])
        for tension in ("none", "acts") for dt in sizes}, limit=1500)
    rows = []
    for tension in ("none", "acts"):
        parts = [_measure.balance_error(runs[f"{tension}, dt = {dt}"].folder, 0, 4) for dt in sizes]
        rows.append((tension, *(f"{part:.2e}" for part in parts)))
        if lab.quick:
            lab.expect(f"{tension}: open at dt = {sizes[1]} / at twice that", "<= 1/4 + 10 %", f"{parts[1] / parts[0]:.3f}",
                       parts[1] <= 0.275 * parts[0])
        else:
            order, rest = _measure.falls(parts)
            lab.expect(f"{tension}: order in dt of the imbalance, less its rest", ">= 1.86 (1/4 + 10 %)", f"{order:.2f}", order >= 1.86)
            lab.expect(f"{tension}: rest at dt = 0", "<= 2e-5", f"{rest:.1e}", abs(rest) <= 2e-5)
    lab.title("Energy")
    lab.text("The imbalance from t = 0 to 4, as a part of the dissipation.")
    lab.table(("fluid.wall_tension", *(f"dt = {dt}" for dt in sizes)), rows, "balance")
    last = runs[f"acts, dt = {sizes[-1]}"].history
    stretch, surface = numpy.abs(last["wall_stretch"]).max(), numpy.ptp(last["energy_surface"]) / numpy.ptp(last["energy_elastic"])
    lab.expect("acts: wall_stretch", "0", f"{stretch:g}", stretch == 0)
    lab.expect("the energy of the surface takes part: its change, as a part of the change of the elastic energy", ">= 0.01", f"{surface:.2g}",
               surface >= 0.01)


# --- soft

def soft(lab):
    """The droplet of Style et al., with interfaces of two widths whose surface tension over Young's modulus is the
    same."""
    rows, results = [], {}
    for inverse, elements in ((64, [80, 75]), (128, [160, 150])):
        drop = Drop(0.3568, 96.24, 1 / inverse, 0.64, 0.104 if inverse == 64 else 0.1, 0.49, clamped=True)
        young, tension = 0.0645 * 128 / inverse, 1.333e-3 * 128 / inverse
        run = lab.run(f"soft, 1/gamma = {inverse}", half(drop, elements, 0.6, young, dict(surface_tension=tension), 100.0,
                                                         wall_tension="acts"), limit=3000)
        x, u = wall_of(run)
        line = run.history["x_right"][-1]
        theory = linear_theory(x, drop, young, tension, True)
        now = [v[1].max() for v in (u, theory)], [opening(x + v[0], v[1]) for v in (u, theory)]
        results[inverse] = now, run.history["speed_max_solid"][-1]
        rows.append((inverse, *(f"{v:.3e}" for v in now[0]), *(f"{v:.1f}" for v in now[1]), f"{u[1, 0]:.3e}", f"{theory[1, 0]:.3e}",
                     f"{line:.4f}", f"{run.history['angle_right'][-1]:.1f}"))
    lab.title("Soft")
    lab.text("sigma/E = 0.031. Opening: the angle of the solid between its steepest slopes next to the line, in degrees; Neumann's law asks "
             "for 93.6 at an interface without width. Slopes are near 0.4, so that linear theory is no more than a guide.")
    lab.table(("1/gamma", "ridge", "ridge, linear", "opening", "opening, linear", "middle", "middle, linear", "line at x", "angle"), rows,
              "soft")
    for inverse, (((ridge, linear), (angle, _)), speed) in results.items():
        lab.expect(f"1/gamma = {inverse}: it comes to rest; speed of the solid at the end", "<= 1e-5", f"{speed:.1e}", speed <= 1e-5)
        lab.expect(f"1/gamma = {inverse}: ridge over the ridge of linear theory", "0.75 to 1", f"{ridge / linear:.2f}",
                   0.75 <= ridge / linear <= 1)
    softer(lab)
    lab.expect("a thinner interface opens the wall more, towards Neumann's law", "by 5 to 15 degrees",
               f"{results[64][0][1][0] - results[128][0][1][0]:.1f}", 5 <= results[64][0][1][0] - results[128][0][1][0] <= 15)


# --- the width of the interface

WIDE = Drop(0.2, 90.0, 1 / 128, 0.5, HEIGHT, 0.49)


def widths(lab):
    """One line force and one tension, spread over interfaces of several widths."""
    wanted, of = {}, {}
    for inverse in (32, 64) if lab.quick else (32, 64, 128, 256):
        drop, scale = WIDE._replace(capillarity=1 / inverse), 128 / inverse
        sigma = _measure.TENSION_OVER_CAPILLARITY / inverse
        for factor in (FACTOR,) if lab.quick else (FACTOR, 1):
            young, tension = 0.05 * scale * factor, 2 * sigma * factor
            text = half(drop, [inverse, inverse], 0.5, young, dict(surface_tension=tension), 1.0)
            graded = ["domain.grading.box=[[0,0.08],[0.26,0.38]]", "domain.grading.coarsest=8"] if inverse > 64 else []
            label = f"1/gamma = {inverse}, {'stiff' if factor > 1 else 'soft'}"
            wanted[label] = text, [*graded, "time.start=equilibrium", "time.max_steps=1", "output.fields.times=[0]"]
            of[label] = inverse, factor, drop, young, tension
    rows, found = [], {}
    for label, run in lab.runs(wanted, limit=3000).items():
        inverse, factor, drop, young, tension = of[label]
        x, u = wall_of(run)
        now, fine = (x + u[0], u[1]), numpy.linspace(0, drop.length, 2001)
        theory = linear_theory(fine, drop, young, tension, False)
        ridge, linear = factor * u[1].max(), factor * theory[1].max()
        bend, line = factor * kink(*now), factor * kink(fine, theory[1])
        found[label] = ridge / linear - 1, bend / line - 1, bend
        rows.append((label, f"{linear:.3e}", f"{ridge:.3e}", f"{100 * found[label][0]:+.2f} %", f"{line:.4f}", f"{bend:.4f}",
                     f"{100 * found[label][1]:+.2f} %"))
    lab.title("Width of the interface")
    lab.text("alpha = 90 degrees, R = 0.2, nu = 0.49. Young's modulus and the tension U = 2 sigma go with the surface tension of the fluid, "
             "which goes with gamma: the line force over the modulus has its value for gamma = 1/128 and E = 0.05, whatever the width. Kink: the "
             f"steepest slopes on both sides of the ridge together; of an interface without width 1/2. Stiff: times {FACTOR}.")
    lab.table(("scene", "ridge, linear", "ridge", "off", "kink, linear", "kink", "off"), rows, "widths")
    for label, (ridge, bend, _) in found.items():
        if label.endswith("stiff"):
            lab.expect(f"{label}: ridge and kink", "linear theory at the same width +- 3 %", f"{100 * ridge:+.2f} %, {100 * bend:+.2f} %",
                       max(abs(ridge), abs(bend)) <= 0.03)
    for kind in {label.split(", ")[1] for label in found}:
        bends = [bend for label, (_, _, bend) in found.items() if label.endswith(kind)]
        lab.expect(f"{kind}: a thinner interface has a sharper kink", "yes", ", ".join(f"{bend:.3f}" for bend in bends),
                   bends == sorted(bends))


def kink(x, y):
    slope = numpy.diff(y) / numpy.diff(x)
    return slope.max() - slope.min()


def softer(lab):
    """A third of that modulus. The layer is neo-Hookean, for a Saint Venant-Kirchhoff layer gives way under the
    pressure of the droplet, and viscous, so that the pull of the start does not shake it."""
    drop = Drop(0.3568, 96.24, 1 / 64, 0.64, 0.104, 0.49, clamped=True)
    layer = dict(material="neo_hookean", viscosity=0.05)
    held = half(drop, [80, 75], 0.6, 0.043, dict(surface_tension=2.666e-3, **layer), 100.0, wall_tension="acts")
    bare = half(drop, [80, 75], 0.6, 0.043, layer, 100.0)
    speed = lab.run("a third of the modulus, with surface tension", held, limit=3000).history["speed_max_solid"][-1]
    lab.expect("a third of the modulus, sigma/E = 5.9 gamma: it comes to rest; speed of the solid at the end", "<= 1e-5", f"{speed:.1e}",
               speed <= 1e-5)
    code = lab.run("a third of the modulus, without surface tension", bare, expect=None, limit=3000).code
    lab.expect("without surface tension it does not: exit code", "2", f"{code}", code == 2)


def opening(x, y):
    """Angle between the steepest slopes on both sides of the ridge, degrees."""
    slope = numpy.degrees(numpy.arctan(numpy.diff(y) / numpy.diff(x)))
    return 180 - (slope.max() - slope.min())


def study(lab):
    waves(lab)
    droplet(lab)
    balance(lab)
    widths(lab)
    if not lab.quick:
        soft(lab)


def explicit(lab):
    """The slowest wave on 16 x 16 elements, U = 5 sigma, against linear theory."""
    omega, text = swinging(8 * numpy.pi, 5 * SIGMA)
    run = lab.run("wave, U/sigma = 5", text, steps(omega, 480, 2)[1])
    off = frequency(run, omega) / omega - 1
    lab.expect("frequency of a wave under surface tension", "+- 0.2 %", f"{100 * off:+.3f} %", abs(off) <= 2e-3)
