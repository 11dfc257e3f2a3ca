"""A droplet carried by a uniform flow: shape, position, mass and momentum.

The equations are invariant under a uniform velocity. In a periodic square a droplet with velocity (v, 0) everywhere must do
what the droplet at rest does, moved by v t. The frame of the mesh breaks this to the order of the discretisation: what is
compared is the position of the droplet (phase of the first Fourier mode of the density), the difference of the densities
after moving back by a whole number of elements, mass, and momentum (constant: no walls). Step and element are halved
together. On 64 x 64 elements half the step leaves a quarter of the difference, so it is the error of the time scheme. From
32 to 64 elements the difference falls only with order 1.5."""

import _measure
import numpy
from _case import case, fields, sides

MINUTES = {"quick": 0.1, "full": 4}
SPEED = 0.125
CASE = case("A droplet in a periodic square with a uniform velocity.", "carried_droplet",
            domain=dict(size=[1.0, 1.0], elements=[64, 64]),
            fluid=dict(viscosity="1/256", capillarity="1/32", temperature=0.85),
            droplet=[dict(centre=[0.5, 0.5], radius=0.25)],
            wave=[dict(field="velocity_x", amplitude=0.125, mode=[0, 0])],
            boundary=sides("periodic"),
            time=dict(end=8.0, dt_initial=0.02, dt_max=0.02, tolerance=1e3),
            output=fields(8.0))


def density(run):
    """Density at the corners of the elements; a periodic line counts once."""
    _, rho = _measure.fluid_field(run.folder, 0)
    return rho[:-1:2, :-1:2]


def position(rho):
    """x of the droplet: phase of the first mode, in [0, 1)."""
    return -numpy.angle(numpy.fft.fft(rho.mean(axis=0))[1]) / (2 * numpy.pi) % 1


def carried(lab, n, g, end, dt, *more):
    """The droplet carried and at rest on n x n elements, steps dt. @return error of the position, largest difference of
    the density over the step, changes of momentum and mass"""
    base = [f"domain.elements=[{n},{n}]", f"time.end={end}", f"output.fields.times=[{end}]", f"fluid.capillarity=1/{g}",
            f"time.dt_initial={dt}", f"time.dt_max={dt}", *more]
    name = ", ".join((f"{n} x {n}", *more))
    runs = lab.runs({f"{name}, carried": (CASE, base), f"{name}, at rest": (CASE, base + ["wave[0].amplitude=0"])}, limit=1500)
    moving, still = runs.values()
    a, b = density(moving), density(still)
    moved = SPEED * end  # a whole number of elements
    error = (position(a) - position(b) - moved + 0.5) % 1 - 0.5
    shape = numpy.abs(numpy.roll(a, -round(moved * n), axis=1) - b).max() / (b.max() - b.min())
    history = moving.history
    momentum = numpy.abs(history["momentum_x"] / history["momentum_x"][0] - 1).max()
    return error, shape, momentum, numpy.abs(history["mass_drift"]).max()


def study(lab):
    end, meshes, g = (1.0, (16, 32), 16) if lab.quick else (4.0, (32, 64, 128), 32)
    rows, errors, moved = [], {}, SPEED * end
    for n in meshes:
        error, shape, momentum, mass = carried(lab, n, g, end, 1.25 / n)
        errors[n] = (abs(error), shape)
        rows.append((f"{n} x {n}", f"{error:+.2e}", f"{shape:.2e}", f"{momentum:.1e}", f"{mass:.1e}"))
        lab.expect(f"{n} x {n}: drift of the mass", "<= 1e-10", f"{mass:.1g}", mass <= 1e-10)
    lab.expect("position off, finer mesh", "<= 0.1 % of the way", f"{100 * errors[n][0] / moved:.2g} %", errors[n][0] <= 1e-3 * moved)
    lab.expect("density moved back, largest difference over the step, finer mesh", "<= 1 %", f"{100 * errors[n][1]:.2g} %",
               errors[n][1] <= 0.01)
    lab.expect("momentum, finer mesh", "constant to 0.1 %", f"{100 * momentum:.2g} %", momentum <= 1e-3)
    rate = numpy.log2(errors[meshes[-2]][1] / errors[meshes[-1]][1])
    lab.expect("order of that difference in h and dt, two finest meshes", ">= 1.7", f"{rate:.1f}", rate >= 1.7)
    lab.table(("mesh", "position off", "largest difference of the density over the step", "change of momentum", "of mass"), rows,
              "carried")


def explicit(lab):
    """16 x 16 and 32 x 32 elements at the temperature 0.85, to t = 1: what the study asks on 32 x 32, and an order of
    3, less 0.2."""
    found = {n: carried(lab, n, 16, 1.0, 1.25 / n) for n in (16, 32)}
    mass, momentum = max(row[3] for row in found.values()), found[32][2]
    lab.expect("drift of the mass", "<= 1e-10", f"{mass:.1g}", mass <= 1e-10)
    lab.expect("momentum, 32 x 32", "constant to 0.1 %", f"{100 * momentum:.2g} %", momentum <= 1e-3)
    for what, i in (("position off", 0), ("density moved back", 1)):
        order = numpy.log2(abs(found[16][i] / found[32][i]))
        lab.expect(f"{what}: order in h, 16 to 32 elements", ">= 2.8", f"{order:.2f}", order >= 2.8)
    error, shape, *_ = found[32]
    lab.expect("32 x 32: position off", "<= 0.1 % of the way", f"{100 * abs(error) / SPEED:.2g} %", abs(error) <= 1e-3 * SPEED)
    lab.expect("32 x 32: density moved back", "<= 1 %", f"{100 * shape:.2g} %", shape <= 0.01)
