"""The runs of the study extremes: every parameter to its end and beyond, alone and in nasty pairs.

Base scene: the pull of Fig. 2 on 64x32 elements with gamma_hat = 2h, an early load, 20 units of time."""

from _case import case, fields

SOFT = ["domain.elements=[64,32]", "fluid.capillarity=1/32", "load[0].start=5", "load[0].ramp=5", "time.end=20",
        "output.fields.times=[0,20]", "time.max_steps=3000", "domain.grading.fine=everywhere"]
RIGID = ["domain.elements=[64,32]", "fluid.capillarity=1/32", "time.end=20", "output.fields.times=[0,20]",
         "time.max_steps=3000"]
FORCE = 0.16215


def soft(*settings):
    return "tensotaxis_pull_2d", SOFT + list(settings)


def rigid(*settings):
    return "static_droplet_rigid_2d", RIGID + list(settings)


def fluid(*settings, **tables):
    """A rigid wall with other things in the fluid than the droplet of the case."""
    return case("A fluid over a rigid wall, 64 x 32 elements.", "extreme",
                domain=dict(size=[1.0, 0.5], elements=[64, 32]),
                fluid=dict(viscosity="1/256", capillarity="1/32", temperature=0.39, contact_angle=75.0),
                **tables,
                time=dict(end=20.0, max_steps=3000),
                output=fields(0.0, 20.0)), list(settings)


def droplet(x, y, radius):
    return dict(centre=[x, y], radius=radius)


def load(factor, ramp=5):
    return [f"load[0].force=[{FORCE * factor},0]", f"load[0].ramp={ramp}"]


def heavy(density):
    """Density of the solid at the same Young modulus and force per volume."""
    return [f"substrate.density={density}", f"substrate.young={0.7554 / density}", f"load[0].force=[{FORCE / density},0]"]


def fixed(dt, steps=60):
    return [f"time.dt_initial={dt}", f"time.dt_max={dt}", f"time.dt_min={min(dt, 1e-8)}", "time.tolerance=1e6",
            f"time.end={min(20, steps * dt) if dt < 1 else steps * dt}", "output.fields.times=[]",
            *([f"load[0].start={0.1 * steps * dt}", f"load[0].ramp={0.1 * steps * dt}"])]


ENERGY = "fluid.wall_law=energy"

RUNS = {
    "base soft": soft(),
    "base rigid": rigid(),
    "base rigid, wall energy": rigid(ENERGY),
    **{f"theta {t}": soft(f"fluid.temperature={t}") for t in (0.3, 0.31, 0.35, 0.5, 0.7, 0.85, 0.95, 0.99, 1.0)},
    **{f"theta {t}, rigid": rigid(f"fluid.temperature={t}", ENERGY) for t in (0.31, 0.99)},
    **{f"angle {a}": rigid(f"fluid.contact_angle={a}") for a in (0, 5, 15, 30, 150, 165, 175, 180)},
    **{f"angle {a}, wall energy": rigid(f"fluid.contact_angle={a}", ENERGY) for a in (5, 15, 165, 175)},
    **{f"angle {a}, soft": soft(f"fluid.contact_angle={a}") for a in (5, 175)},
    **{f"nu {nu}": soft(f"substrate.poisson={nu}") for nu in (-1, -0.99, -0.5, 0, 0.49, 0.499, 0.4999, 0.5)},
    **{f"E {e:g}": soft(f"substrate.young={e}") for e in (1e-3, 1e-2, 0.03, 0.1, 10, 1e3, 1e6)},
    **{f"rho0s {r:g}": soft(*heavy(r)) for r in (1e-3, 1e-2, 1e2, 1e4)},
    **{f"gamma {n} h": soft(f"fluid.capillarity={n / 64}") for n in (0.5, 1, 4, 8)},
    **{f"gamma {n} h, rigid": rigid(f"fluid.capillarity={n / 64}") for n in (0.25, 0.5, 1)},
    **{f"mu {m:g}": soft(f"fluid.viscosity={m}") for m in (1e-6, 1e-5, 1e-4, 1e-3, 0.1, 1, 10)},
    **{f"load x {f:g}": soft(*load(f)) for f in (3, 10, 100, 1000)},
    "load sudden": soft(*load(1, 0)),
    "load x 10 sudden": soft(*load(10, 0)),
    "load up": soft(f"load[0].force=[0,{FORCE}]"),
    "load up x 10": soft(f"load[0].force=[0,{10 * FORCE}]"),
    "load down x 10": soft(f"load[0].force=[0,{-10 * FORCE}]"),
    "load of the whole layer": soft("load[0].box=[[0,0],[1,0.125]]"),
    "layer of one element": soft("substrate.thickness=0.015625", "load[0].box=[[0.7,0],[0.8,0.015625]]",
                                 "droplet[0].centre=[0.5,0.015625]"),
    "layer thicker than the fluid": soft("substrate.thickness=0.25", "droplet[0].centre=[0.5,0.25]"),
    "one element a layer": soft("domain.elements=[64,2]", "substrate.thickness=0.25", "droplet[0].centre=[0.5,0.25]"),
    "one element across": soft("domain.elements=[1,32]"),
    "two elements, rigid": rigid("domain.elements=[1,1]"),
    "stretched 256x8": soft("domain.elements=[256,8]"),
    "stretched 8x64": soft("domain.elements=[8,64]"),
    "degree 3": soft("domain.degree=3"),
    "mixed precision": soft("solver.precision=mixed"),
    "mixed precision, explicit": soft("solver.precision=mixed", "time.scheme=kick_drift"),
    "rho_inf 0": soft("time.rho_inf=0"),
    "rho_inf 1": soft("time.rho_inf=1"),
    **{f"fixed dt {dt:g}": soft(*fixed(dt)) for dt in (1e-6, 1e-3, 1, 10, 100, 1000)},
    "fixed dt 10, rho_inf 1": soft(*fixed(10, 5), "time.rho_inf=1"),  # undamped waves keep the steps short
    "fixed dt 10, rho_inf 0": soft(*fixed(10), "time.rho_inf=0"),
    "difference products": soft("solver.krylov.jacobian=difference"),
    "Schwarz": soft("solver.krylov.preconditioner=schwarz"),
    "no preconditioner": soft("solver.krylov.preconditioner=none", "time.end=1", "load[0].start=0.5",
                              "output.fields.times=[]"),
    "no checkerboard control": soft("fluid.stabilisation=0"),
    "checkerboard control 1": soft("fluid.stabilisation=1"),
    "tight tolerances, gamma h, rigid": rigid("fluid.capillarity=1/64", "solver.newton.rtol=1e-10",
                                              "solver.newton.atol=1e-14"),
    "smoothing 1e-12": soft("fluid.smoothing=1e-12"),
    "droplet touches a side": soft("droplet[0].centre=[0.155,0.125]"),
    "droplet cut by a side": soft("droplet[0].centre=[0.1,0.125]"),
    "half a droplet": soft("droplet[0].centre=[0,0.125]"),
    "droplet on the load": soft("load[0].box=[[0.45,0],[0.55,0.125]]"),
    "droplet touches the top": rigid("droplet[0].centre=[0.5,0.3]", "droplet[0].radius=0.199"),
    "two droplets touch": fluid(droplet=[droplet(0.3, 0, 0.155), droplet(0.62, 0, 0.155)]),
    "two droplets overlap": fluid(droplet=[droplet(0.4, 0, 0.155), droplet(0.6, 0, 0.155)]),
    "droplet of radius gamma": fluid(droplet=[droplet(0.5, 0.25, 1 / 32)]),
    "droplet of radius gamma/4": fluid(droplet=[droplet(0.5, 0.25, 1 / 128)]),
    "droplet of radius 1e-9": fluid(droplet=[droplet(0.5, 0.25, 1e-9)]),
    "film": fluid(film=[dict(box=[[0, 0], [1, 0.1]])]),
    "film thinner than the interface": fluid(film=[dict(box=[[0, 0], [1, 0.01]])]),
    "all liquid": fluid(film=[dict(box=[[0, 0], [1, 0.5]])]),
    "no droplet": fluid(),
    "bubble on the wall": fluid("fluid.ambient=liquid", droplet=[droplet(0.5, 0, 0.155)]),
    "wave breaks the vapour": fluid(wave=[dict(field="density", amplitude=0.0013, mode=[4, 2])]),
    "supersonic start": fluid(droplet=[droplet(0.5, 0.25, 0.15)],
                              wave=[dict(field="velocity_x", amplitude=5, mode=[1, 0])]),
    "unstable start": fluid("fluid.initial=[0.3,0.3]"),
    "theta 0.3, angle 5": soft("fluid.temperature=0.3", "fluid.contact_angle=5"),
    "theta 0.3, angle 175, wall energy": rigid("fluid.temperature=0.3", "fluid.contact_angle=175", ENERGY),
    "theta 0.3, gamma h/2": soft("fluid.temperature=0.3", "fluid.capillarity=1/128"),
    "theta 0.99, gamma h/2": rigid("fluid.temperature=0.99", "fluid.capillarity=1/128"),
    "E 1e-3, nu 0.4999": soft("substrate.young=1e-3", "substrate.poisson=0.4999"),
    "E 1e-3, rho0s 1e-3": soft("substrate.density=1e-3", "substrate.young=1"),
    "E 1e-2, nu -0.5": soft("substrate.young=1e-2", "substrate.poisson=-0.5"),
    "E 1e-2, load x 10": soft("substrate.young=1e-2", *load(10)),
    "E 1e6, nu 0.4999": soft("substrate.young=1e6", "substrate.poisson=0.4999"),
    "mu 1e-5, fixed dt 1": soft("fluid.viscosity=1e-5", *fixed(1)),
    "mu 10, rho0s 1e-3": soft("fluid.viscosity=10", *heavy(1e-3)),
    "rho0s 1e4, fixed dt 10": soft(*heavy(1e4), *fixed(10)),
}

# Outcomes that are not in doubt, each group for its reason. The other runs may survive or stop.
EXPECTED = {
    # What the cases show, and the same equations solved in other ways or with smaller steps.
    **dict.fromkeys(("base soft", "base rigid", "base rigid, wall energy", "degree 3", "rho_inf 0", "rho_inf 1",
                     "difference products", "Schwarz", "divergence form", "fixed dt 1e-06", "fixed dt 0.001"),
                    "survives"),
    # Milder than the base scene: phases nearer to each other, a solid stiffer or heavier, a fluid more viscous, a wider
    # interface; Poisson ratios up to the 0.49 that the program advises.
    **dict.fromkeys(("theta 0.5", "theta 0.7", "theta 0.85", "E 10", "E 1000", "E 1e+06", "rho0s 100", "rho0s 10000",
                     "mu 0.1", "mu 1", "mu 10", "gamma 4 h", "nu 0", "nu 0.49"), "survives"),
    # Contact angles for which the manual names the wall law.
    **dict.fromkeys(("angle 30", "angle 150", *(f"angle {a}, wall energy" for a in (5, 15, 165, 175))), "survives"),
    # Forces far below what the layer carries (see "load x 1000"), and what a fluid is at rest or flows gently from.
    **dict.fromkeys(("load x 3", "load sudden", "load up", "half a droplet", "two droplets touch",
                     "two droplets overlap", "film", "all liquid", "no droplet", "bubble on the wall"), "survives"),
    # A Saint Venant-Kirchhoff solid carries a pressure of at most 0.19 (lambda + 2 G), at the stretch 1/sqrt(3); here
    # that is 0.73 E. The pressure in the droplet is sigma/R = 0.051, and "load x 1000" pushes with 16 against 0.55.
    **dict.fromkeys(("E 0.001", "E 0.01", "E 0.03", "E 1e-3, rho0s 1e-3", "E 1e-2, load x 10", "load x 1000"), "stops"),
    # Beyond what a key may be: no two phases, no contact line, no stable or an incompressible solid, a precision that
    # explicit schemes do not have, a droplet that crosses a side.
    **dict.fromkeys(("theta 1.0", "angle 0", "angle 180", "nu -1", "nu 0.5", "mixed precision, explicit",
                     "droplet cut by a side"), "refused"),
}
QUICK = ("base soft", "angle 5, wall energy", "nu 0.5", "E 0.001", "load x 1000", "film", "no droplet",
         "mixed precision, explicit", "droplet of radius gamma/4", "fixed dt 100")
