"""What is read from the files of a run, and what the exact answers are. Nothing here starts softwet."""

import pathlib
import sys

import _shape
import numpy

ROOT = pathlib.Path(__file__).resolve().parent.parent.parent
sys.path[:0] = [str(ROOT / "tests" / "oracle"), str(ROOT / "tools")]
import radial_droplet  # noqa: E402
import softwet  # noqa: E402

THETA = 0.39
VAPOUR, LIQUID = radial_droplet.coexistence(THETA)
POTENTIAL = radial_droplet.energy_slope(THETA, LIQUID)
TENSION_OVER_CAPILLARITY = 0.2532027493  # tests/oracle/equilibrium.py

# X_c of the pull at 128x64 by an independent solver.
PULL_CENTRE = {50: 0.5048, 235: 0.5163, 471: 0.5378, 700: 0.5860, 1000: 0.6396, 1400: 0.6505, 1884: 0.6526}
PULL_PEAK = (2.8e-4, 686.0)


def history(folder):
    return softwet.open(folder).history


def interface(folder, first=False):
    """The last (or first) field time of interface.csv."""
    walls = softwet.open(folder).interface
    return walls[min(walls) if first else max(walls)]


def field(folder, number, part="fluid"):
    """The softwet.Field of the field file of this number."""
    run = softwet.open(folder)
    return run.fields(run.times[number], part)


def fluid_field(folder, number, name="density"):
    """Points (rows, columns, 2) and values (rows, columns) of a field file."""
    fluid = field(folder, number)
    return fluid.positions, fluid[name]


def solid_field(folder, number):
    """Points of the reference and displacement, (points, 2) each."""
    solid = field(folder, number, "solid")
    return solid.reference.reshape(-1, 2), solid.moved().reshape(-1, 2)


def crossing(row, values, i):
    """Where values cross 0 between nodes i and i + 1. Three nodes have the quadratic that the spline is in an element;
    linear interpolation between nodes two to the capillarity would see a droplet 0.1 % too large."""
    first = 2 * (i // 2)

    def at(nodes, s):
        a, b, c = nodes[first:first + 3]
        return a + s * (4 * b - 3 * a - c) + s * s * (2 * a - 4 * b + 2 * c)

    low, high = 0.5 * (i - first), 0.5 * (i - first + 1)
    for _ in range(50):
        middle = 0.5 * (low + high)
        low, high = (middle, high) if (at(values, middle) < 0) == (values[i] < 0) else (low, middle)
    return at(row, 0.5 * (low + high))


def cap(folder, number, capillarity, lowest=2.0, highest=0.85):
    """Circle through the level (rho_l + rho_v)/2 of the left half, from `lowest` g above the wall up to the part
    `highest` of what is above: angle where it meets the height of the contact line, degrees, and radius."""
    points, density = fluid_field(folder, number)
    level, left = 0.5 * (VAPOUR + LIQUID), []
    for row, rho in zip(points, density - level):
        rising = numpy.nonzero((rho[:-1] < 0) & (rho[1:] >= 0))[0]
        if len(rising) == 0:
            break
        left.append(crossing(row, rho, rising[0]))
    left = numpy.array(left)
    start = left[0, 1] + lowest * capillarity
    chosen = left[(left[:, 1] > start - 1e-9) & (left[:, 1] < start + highest * (left[-1, 1] - start))]
    x, y, radius = _shape.circle(chosen)
    return {"angle": numpy.degrees(numpy.arccos((left[0, 1] - y) / radius)), "radius": radius, "line": left[0],
            "wall": points[0], "circle": (x, y)}


def wall_forces(folder):
    """Forces per width on the right half of a rigid wall from the traction in interface.csv: vertical and tangential
    line force, and the pressure jump between droplet and vapour on the wall."""
    wall = interface(folder)
    x, middle = wall["x_reference"], (len(wall["time"]) - 1) // 2
    last = {name: values[-1] for name, values in history(folder).items()}

    def integral(values):  # Simpson's rule: exact for the quadratic spline
        v, dx = values[middle:], x[middle + 2] - x[middle]
        return dx / 6 * (v[0:-1:2] + 4 * v[1::2] + v[2::2]).sum()

    line = last["x_right"]
    inside, outside = -wall["traction_y"][middle], -wall["traction_y"][-1]
    vertical = integral(wall["traction_y"]) + inside * (line - x[middle]) + outside * (x[-1] - line)
    return {"vertical": vertical, "tangential": integral(wall["traction_x"]), "jump": inside - outside}


def radial_at_potential(capillarity, excess):
    """The exact droplet in a disc whose chemical potential exceeds mu_sat by `excess`.
    @return densities inside and outside, radius of the middle density, pressure jump"""
    low, high = 0.05, 0.3
    for _ in range(45):
        radius = 0.5 * (low + high)
        inside, outside, mu, middle = radial_droplet.solve(capillarity, radial_droplet.sharp_mass(radius), points=240)
        low, high = (radius, high) if mu - POTENTIAL > excess else (low, radius)
    jump = radial_droplet.pressure(THETA, inside) - radial_droplet.pressure(THETA, outside)
    return inside, outside, middle, jump


def balance_error(folder, start, end):
    """Sum over the steps in [start, end] of |change of the energy - trapezoidal integral of (- dissipation + power of
    the load + wall stretch)|, as a part of the dissipation. A solid alone has no wall that stretches."""
    rows = history(folder)
    t, rate = rows["t"], rows["power_load"] + numpy.nan_to_num(rows["wall_stretch"]) - rows["dissipation"]
    dt = numpy.diff(t)
    error = numpy.abs(numpy.diff(rows["energy_total"]) - 0.5 * (rate[1:] + rate[:-1]) * dt)
    inside = (t[:-1] >= start - 1e-9) & (t[1:] <= end + 1e-9)
    return error[inside].sum() / (rows["dissipation"][1:] * dt)[inside].sum()


def falls(parts):
    """Errors with steps that are halved from one to the next, the last three looked at: what falls with the step is
    separated from a rest that no step removes. @return (order of what falls, the rest at dt = 0 if that order is 2)"""
    first, second, third = parts[-3:]
    return numpy.log2((first - second) / (second - third)), third - (second - third) / 3


def scheme(rate, dt, rho_inf):
    """What generalized-alpha (Jansen, Whiting, Hulbert 2000) makes of y' = rate y: the rate of the part that stays.

    am y'_1 + (1 - am) y'_0 = rate (af y_1 + (1 - af) y_0),  y_1 = y_0 + dt ((1 - ga) y'_0 + ga y'_1)."""
    am, af = (3 - rho_inf) / (2 * (1 + rho_inf)), 1 / (1 + rho_inf)
    ga = 0.5 + am - af
    new = numpy.array([[1, -dt * ga], [-rate * af, am]])
    old = numpy.array([[1, dt * (1 - ga)], [rate * (1 - af), -(1 - am)]])
    factors = numpy.linalg.eigvals(numpy.linalg.solve(new, old))
    return numpy.log(factors[numpy.argmin(abs(factors - numpy.exp(rate * dt)))]) / dt
