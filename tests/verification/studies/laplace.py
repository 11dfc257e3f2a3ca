"""Laplace pressure of droplets of several radii, two and three dimensions.

A quarter (2D) or an eighth (3D) of a droplet between slip sides, at 90 degrees to the wall. Sharp answer:
(mu - mu_sat)(rho_l - rho_v) R = (D - 1) sigma with sigma of the plane interface; their ratio is the Laplace ratio. It neglects the width of the interface and
the compression of the liquid, which matter more for small droplets. Exact answer: the radial solution of the mass of
the run in the disc or ball of the volume of its box (tests/oracle/radial_droplet.py), for the chemical potential, both
densities and the radius R of the middle density. The density outside is taken at the corner of the box and compared with the
rim of the ball: nearer to the droplet, on the side of the box, the interface has not ended (3 gamma_hat from it in 3D, where
the density is 6 % above the vapour). In 3D the mesh is refined with gamma_hat = 4/3 elements, and once alone."""

import _measure
import _shape
import numpy
from _case import case, fields
from _lab import Known
from _measure import radial_droplet
from plane_interface import PlaneInterface

MINUTES = {"quick": 0.1, "full": 2.5}
SIDE = 0.5
CASE = case("A quarter of a droplet; left and bottom sides are planes of symmetry.", "quarter_droplet",
            domain=dict(size=[0.5, 0.5], elements=[64, 64]),
            fluid=dict(viscosity="1/1024", capillarity="1/64", temperature=0.39, contact_angle=90.0),
            droplet=[dict(centre=[0.0, 0.0], radius=0.2)],
            boundary=dict(top="slip"),
            time=dict(end=2000.0),
            output=fields(2000.0),
            solver=dict(newton=dict(rtol=1e-8, atol=1e-14)))
CASE_3D = case("An eighth of a droplet; left, front and bottom sides are planes of symmetry.", "eighth_droplet",
               domain=dict(size=[0.25, 0.25, 0.25], elements=[8, 8, 8]),
               fluid=dict(viscosity="1/1024", capillarity="1/24", temperature=0.39, contact_angle=90.0),
               droplet=[dict(centre=[0.0, 0.0, 0.0], radius=0.12)],
               boundary=dict(top="slip"),
               time=dict(end=400.0),
               output=fields(400.0),
               solver=dict(newton=dict(rtol=1e-8, atol=1e-14), krylov=dict(preconditioner="lu")))


def line(run):
    """Distance from the centre, density and chemical potential along the bottom side."""
    fluid = _measure.field(run.folder, 0)
    first = (0,) * (fluid.dimension - 1)
    values = [fluid[name][first] for name in ("density", "chemical_potential")]
    return fluid.positions[first][:, 0], *values, fluid["density"].flat[-1]


def compare(lab, label, run, theta, g, side, dimension):
    """One droplet against the sharp and the exact answer. @return the row of the table"""
    plane, whole = PlaneInterface(theta), 2**dimension
    x, rho, potential, corner = line(run)
    ball = side * (4 / numpy.pi if dimension == 2 else 6 / numpy.pi) ** (1 / dimension)
    inside, outside, mu, radius = radial_droplet.solve(g, whole * run.history["mass"][-1], theta=theta, dimension=dimension,
                                                       length=ball)
    seen, excess = _shape.position(x, rho, 0.5 * (plane.vapour + plane.liquid)), potential[0] - plane.potential
    laplace = excess * plane.step * seen / ((dimension - 1) * plane.tension * g)
    exact = (mu - plane.potential) * plane.step * radius / ((dimension - 1) * plane.tension * g)
    errors = {"mu - mu_sat": excess / (mu - plane.potential) - 1, "rho inside": rho[0] / inside - 1,
              "rho outside": corner / outside - 1, "R": seen / radius - 1}
    worst = max(errors, key=lambda name: abs(errors[name]))
    lab.expect(f"{label}: Laplace ratio", "1 +- 1 %", f"{laplace:.4f}", abs(laplace - 1) <= 0.01,
               Known("the exact droplet of this interface width is as far off", "0.003 from it", abs(laplace - exact) <= 0.003)
               if abs(exact - 1) > 0.008 else None)
    lab.expect(f"{label}: mu - mu_sat, densities and R of the exact droplet", "1 %",
               f"largest error {worst}: {100 * errors[worst]:+.2f} %", abs(errors[worst]) <= 0.01)
    return (label, f"{seen:.4f}", f"{g / seen:.3f}", f"{laplace:.4f}", f"{exact:.4f}",
            *(f"{100 * error:+.3f} %" for error in errors.values()))


def study(lab):
    radii, g = ((0.15, 0.25), 32) if lab.quick else ((0.1, 0.15, 0.2, 0.25), 64)
    thetas = (0.39,) if lab.quick else (0.39, 0.85)
    wanted, facts = {}, {}
    for theta in thetas:
        for radius in radii if theta == 0.39 else (0.2, 0.25):  # the interface is wider at 0.85
            label = f"2D, theta = {theta}, R = {radius}"
            facts[label] = (theta, 1 / g, SIDE, 2)
            wanted[label] = (CASE, [f"fluid.temperature={theta}", f"fluid.capillarity=1/{g}", f"domain.elements=[{g},{g}]",
                                    f"droplet[0].radius={radius}"])
    for n, width in () if lab.quick else ((8, 24), (12, 24), (12, 36), (16, 48)):
        label = f"3D, theta = 0.39, R = 0.12, {n}^3, gamma_hat = 1/{width}"
        facts[label] = (0.39, 1 / width, 0.25, 3)
        wanted[label] = (CASE_3D, [f"domain.elements=[{n},{n},{n}]", f"fluid.capillarity=1/{width}"])
    runs = lab.runs(wanted, limit=3000)
    rows = [compare(lab, label, run, *facts[label]) for label, run in runs.items()]
    lab.table(("droplet", "R", "gamma_hat / R", "Laplace ratio", "exact", "mu - mu_sat off", "rho inside off", "rho outside off",
               "R off"), rows, "radii")


def explicit(lab):
    """Two radii in 2D on 32 x 32 elements, capillarity 1/32, brought to rest by `time.start`; then explicit steps for a
    moment."""
    plane = PlaneInterface(0.39)
    for radius in (0.15, 0.25):
        run = lab.run(f"R = {radius}", CASE, [
            "fluid.capillarity=1/32", "domain.elements=[32,32]", f"droplet[0].radius={radius}", "time.start=equilibrium",
            f"time.end={lab.moment}", f"output.fields.times=[{lab.moment}]"])
        x, rho, potential, corner = line(run)
        seen, excess = _shape.position(x, rho, 0.5 * (plane.vapour + plane.liquid)), potential[0] - plane.potential
        ball = SIDE * (4 / numpy.pi)**0.5
        inside, outside, mu, exact = radial_droplet.solve(1 / 32, 4 * run.history["mass"][-1], theta=0.39, dimension=2, length=ball)
        laplace = excess * plane.step * seen / (plane.tension / 32)
        lab.expect(f"R = {radius}: Laplace ratio", "1 +- 1 %", f"{laplace:.4f}", abs(laplace - 1) <= 0.01)
        for what, error in (("mu - mu_sat", excess / (mu - plane.potential) - 1), ("rho inside", rho[0] / inside - 1),
                            ("rho outside", corner / outside - 1), ("R", seen / exact - 1)):
            lab.expect(f"R = {radius}: {what} of the exact droplet", "+- 1 %", f"{100 * error:+.3f} %", abs(error) <= 0.01)
