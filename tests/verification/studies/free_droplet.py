"""Free droplet: densities, pressure jump and chemical potential.

Against the exact radial solution of the mass of the run in the area of its square (tests/oracle/radial_droplet.py),
which is itself compared with values of another solver in a disc and a ball of radius 0.5."""

import _measure
from _measure import radial_droplet

MINUTES = {"quick": 0.5, "full": 0.5}
KNOWN = {(2, 0.10): (0.87454040, 0.00204483, 0.04044886), (2, 0.15): (0.87199616, 0.00177476, 0.02661551),
         (3, 0.15): (0.87694492, 0.00235407, 0.05420046)}


def study(lab):
    pressure = radial_droplet.pressure
    for (dimension, radius), known in KNOWN.items():
        mass = radial_droplet.sharp_mass(radius, dimension=dimension)
        inside, outside, _, _ = radial_droplet.solve(1 / 64, mass, dimension=dimension)
        found = (inside, outside, pressure(0.39, inside) - pressure(0.39, outside))
        error = max(abs(value / expected - 1) for value, expected in zip(found, known))
        lab.expect(f"radial solution, {dimension}D, sharp radius {radius}", "values of another solver, 1e-5", f"{error:.1g}",
                   error <= 1e-5)
    compare(lab, lab.run("free", "free_droplet_2d", limit=3000), 1 / 64, 1)


def ends(run, number):
    """Densities in the middle and in a corner of the square."""
    _, density = _measure.fluid_field(run.folder, number)
    return density[density.shape[0] // 2, density.shape[1] // 2], density[0, 0]


def compare(lab, run, capillarity, number):
    """Asks for the exact state in the field file of this number and the last row of history.csv."""
    pressure = radial_droplet.pressure
    last = {name: values[-1] for name, values in run.history.items()}
    inside, outside, mu, _ = radial_droplet.solve(capillarity, last["mass"], volume=1.0)
    middle, corner = ends(run, number)
    p = [pressure(_measure.THETA, rho) for rho in (middle, corner, inside, outside)]
    for what, found, exact in (("rho_in", middle, inside), ("rho_out", corner, outside),
                               ("pressure jump", p[0] - p[1], p[2] - p[3]),
                               ("mu - mu_sat", last["laplace"], mu - _measure.POTENTIAL)):
        error = found / exact - 1
        lab.expect(what, f"{exact:.8f} +- 0.5 %", f"{found:.8f}, {100 * error:+.4f} %", abs(error) <= 0.005)


def explicit(lab):
    """64 x 64 elements, capillarity 1/32, brought to rest by `time.start`; then explicit steps for a moment."""
    run = lab.run("free", "free_droplet_2d", [
        "domain.elements=[64,64]", "fluid.capillarity=1/32", "droplet[0].radius=0.25", "time.start=equilibrium",
        f"time.end={lab.moment}", f"output.fields.times=[{lab.moment}]"])
    compare(lab, run, 1 / 32, 0)
