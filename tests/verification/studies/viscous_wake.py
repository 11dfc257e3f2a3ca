"""Viscous layer under what moves along it: a load, and a droplet

A box of force that moves along a periodic layer for ever leaves a displacement that moves along. It is a sum over waves, with inertia and
the complex modulus G - i k V eta.

A droplet that is dragged along carries the ridges at its contact lines along, and the layer dissipates. The power over the speed, a force,
is largest where the speed times eta/G is about twice the capillarity (Karpitschka et al. 2015 for a power-law gel; here a line of finite
width on the complex compliance of a layer)."""

import _layer
import _measure
import numpy
import ridge_locking
from _case import case

MINUTES = {"quick": 0.1, "full": 2}
EXPLICIT = "the viscosity of the vapour would ask for steps of 1e-5 under the droplet; waves in a viscous solid: see viscous_solid"
YOUNG, POISSON = 0.7554, 0.45
FIRST, SHEAR = _layer.lame(YOUNG, POISSON)
STIFF = FIRST + 2 * SHEAR


# --- a moving load

SPEED, FORCE, SIDE, DEPTH = 0.2, -0.01, 0.1, 0.125  # of the box; its width and the height of the layer


def under_box(x, viscosity):
    """u_y of the top of a periodic layer on rollers at the distances x from the middle of a box that moves for ever: a
    sum over waves e^(i k x). A force that is uniform over the height moves a wave by f/(G k^2 - rho w^2) as a whole;
    waves from the base and from the top make up for what the two ask for: u_y = 0 and no shear stress below, no stress
    above."""
    u = FORCE * SIDE * DEPTH**2 / 2 / STIFF * numpy.ones(len(x), complex)
    for m in range(1, 120):
        k = 2 * numpy.pi * m
        shear = SHEAR - 1j * k * SPEED * viscosity
        first = FIRST - 2 / 3 * (shear - SHEAR)
        p, q = (numpy.sqrt(k**2 - (k * SPEED)**2 / c) for c in (first + 2 * shear, shear))

        def columns(y):
            """(u_x, u_y, sigma_xy, sigma_yy) of phi and psi that fall from the top, and from the base."""
            rows = []
            for is_phi, root in ((True, p), (True, -p), (False, q), (False, -q)):
                value = numpy.exp(root * (y - DEPTH) if root.real > 0 else root * y)
                a, b = (-k * value, root * value) if is_phi else (root * value, -k * value)
                rows.append((a, b, shear * (root * a - k * b), first * (k * a + root * b) + 2 * shear * root * b))
            return numpy.array(rows).T

        push = FORCE * 2 * numpy.sin(k * SIDE / 2) / k * 2 / (shear * k**2 - (k * SPEED)**2)
        base, top = columns(0.0), columns(DEPTH)
        parts = numpy.linalg.solve(numpy.array([base[1], base[2], top[2], top[3]]), push * numpy.array([-1, shear * k, shear * k, 0]))
        u += (push + top[1] @ parts) * numpy.exp(1j * k * x)
    return u.real


def moving_load(lab):
    lab.title("A moving load")
    rows, sizes = [], (0.05, 0.025) if lab.quick else (0.05, 0.025, 0.0125)
    for viscosity, end in ((0.1, 10.0),) if lab.quick else ((0.01, 20.0), (0.1, 10.0)):
        text = case("A box of force that moves along a periodic layer.", "moving_load",
                    domain=dict(size=[1.0, DEPTH], elements=[64, 8]),
                    substrate=dict(thickness=DEPTH, young=YOUNG, poisson=POISSON, viscosity=viscosity),
                    load=[dict(box=[[0.5 - SIDE / 2, 0.0], [0.5 + SIDE / 2, DEPTH]], force=[0.0, FORCE], path=[f"{SPEED}*t", 0.0])],
                    boundary=dict(left="periodic", right="periodic", bottom="slip", top="free"),
                    time=dict(rho_inf=1.0, end=end, tolerance=1e6),
                    output=dict(fields=dict(times=[end], select=["displacement"])),
                    solver=dict(newton=dict(rtol=1e-9, atol=1e-20), krylov=dict(rtol=1e-4)))
        runs = lab.runs({f"moving load, eta = {viscosity}, dt = {dt}": (text, [f"time.dt_initial={dt}", f"time.dt_max={dt}"])
                         for dt in sizes})
        errors = []
        for run in runs.values():
            wall = _measure.interface(run.folder)
            theory = under_box(wall["x_reference"] - 0.5 - SPEED * wall["time"][0], viscosity)
            errors.append(numpy.abs(wall["displacement_y"] - theory).max() / numpy.abs(theory).max())
        rows.append((viscosity, f"{theory.min():.4e}", *(f"{100 * error:.2f} %" for error in errors)))
        lab.expect(f"eta = {viscosity}: top of the layer, dt = {sizes[-1]}", "within 1 % of its largest displacement",
                   f"{100 * errors[-1]:.2f} %", errors[-1] <= 0.01)
    lab.text(f"A box of force, {SIDE} wide, moves with the speed {SPEED} along a layer with inertia. Largest error of u_y of the top.")
    lab.table(("eta", "smallest u_y", *(f"dt = {dt}" for dt in sizes)), rows, "load")


# --- a moving droplet

TENSION, WIDTH, TIME = _measure.TENSION_OVER_CAPILLARITY / 32, 1 / 32, 10.0  # sigma, the capillarity, eta/G


def sliding(force):
    return case("A droplet that gravity drags along a viscous layer.", "sliding",
                domain=dict(size=[2.0, 0.5], elements=[128, 32]),
                fluid=dict(viscosity="1/256", capillarity=WIDTH, temperature=0.39, contact_angle=75.0, wall_law="energy",
                           wall_tension="acts", gravity=[force, 0.0]),
                substrate=dict(thickness=0.125, young=YOUNG, poisson=POISSON, surface_tension=TENSION, viscosity=TIME * SHEAR),
                droplet=[dict(centre=[0.5, 0.125], radius=0.155)],
                boundary=dict(bottom="slip", top="slip"),
                time=dict(end=10.0 / force, dt_max=0.03 / force))


def drag(speed):
    """Power over speed that linear theory loses in the layer under the traction of a droplet that moves with the speed;
    a period of 4."""
    count, period = 8192, 4.0
    x = (numpy.arange(count) - count // 2) * period / count
    down = ridge_locking.tractions(x, WIDTH, middle=0.0)[1]
    k = 2 * numpy.pi * numpy.fft.rfftfreq(count, period / count)[1:]
    shear = SHEAR * (1 - 1j * k * speed * TIME)
    first = FIRST - 2 / 3 * (shear - SHEAR)  # the viscosity is one of shear alone
    z = numpy.minimum(2 * k * 0.125, 60)
    give = (first + 2 * shear) / (2 * shear * (first + shear) * k) * (numpy.cosh(z) - 1) / (numpy.sinh(z) + z)
    u = numpy.fft.rfft(numpy.fft.ifftshift(down))[1:] / (1 / give + TENSION * k**2)
    slope = numpy.fft.fftshift(numpy.fft.irfft(numpy.concatenate(([0], 1j * k * u)), count))
    return -(down * slope).sum() * period / count


def moving(lab):
    forces, place = (0.02, 0.04, 0.06, 0.1, 0.2), 0.85
    runs, rows, found = lab.runs({f"droplet, force {force}": (sliding(force), []) for force in forces}, limit=1500), [], []
    for force, run in zip(forces, runs.values()):
        h = run.history
        i = numpy.nonzero(h["x_centre"] >= place)[0][0]
        speed = h["velocity"][i]
        found.append((speed * TIME, h["dissipation_solid"][i] / speed, drag(speed)))
        rows.append((force, *(f"{v:.3e}" for v in (speed, *found[-1])), f"{h['dissipation_solid'][i] / h['dissipation'][i]:.2f}"))
    lab.title("A moving droplet")
    lab.text(f"Gravity drags a droplet along a layer whose viscosity over its shear modulus is {TIME:g}. Its drag is the power dissipated in the "
             f"solid over the speed, where X_c = {place}. Linear theory: the traction of the droplet at rest moves along.")
    lab.table(("force", "speed", "speed eta/G", "drag", "drag, linear theory", "part of all dissipation"), rows, "moving")
    worst = max(abs(d / theory - 1) for _, d, theory in found)
    lab.expect("drag against linear theory", "within 20 %", f"{100 * worst:.0f} %", worst <= 0.2)
    fastest = max(found, key=lambda row: row[1])[0]
    lab.expect("the drag is largest where speed eta/G is about two capillarities (0.063)", "0.03 to 0.13", f"{fastest:.3f}",
               0.03 <= fastest <= 0.13)


def study(lab):
    moving_load(lab)
    if not lab.quick:
        moving(lab)
