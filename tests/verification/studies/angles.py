"""Contact angles from 30 to 150 degrees on a rigid wall, both wall laws.

Young's law: the circle through the interface of a droplet at rest meets the wall at the angle alpha of the case. Half a
droplet on a slip side. The circle is fitted to the level (rho_l + rho_v)/2 above a layer of 3 gamma_hat at the wall, with its
centre on the slip side; the angle is the one at which it meets y = 0, cos(alpha) = -y_centre/R. The interface has a width,
so what is left falls with gamma_hat/R, not with the mesh."""

import _measure
import _shape
import numpy

MINUTES = {"quick": 0.3, "full": 12}
RADIUS = {30: 0.8, 45: 0.5, 60: 0.4, 75: 0.35}  # others 0.3: caps 7 gamma_hat high and more
SIZE = {30: (1, 0.25), 45: (0.5, 0.25), 60: (0.5, 0.375), 75: (0.5, 0.5), 90: (0.5, 0.5)}  # others 0.5 x 0.75
CASE = """# Half a droplet at rest on a rigid wall; the left side is its plane of symmetry.
name = "angle"
[domain]
size = [0.5, 0.5]
elements = [64, 64]
[fluid]
viscosity = "1/256"
capillarity = "1/64"
temperature = 0.39
contact_angle = 90.0
[[droplet]]
centre = [0.0, 0.0]
radius = 0.2
[boundary]
bottom = "no_slip"
top = "no_slip"
[time]
end = 400.0
[output]
fields = { times = [400.0] }
"""


def settings(alpha, law, g=64, h=128):
    """@param g, h  1/gamma_hat and elements per length"""
    size = SIZE.get(alpha, (0.5, 0.75))
    return [f"domain.size=[{size[0]},{size[1]}]", f"domain.elements=[{size[0] * h:g},{size[1] * h:g}]",
            f"fluid.capillarity=1/{g}", f"fluid.contact_angle={alpha}", f"fluid.wall_law={law}",
            f"droplet[0].radius={RADIUS.get(alpha, 0.3)}"]


def angle(run, g):
    """Angle in degrees and radius of the circle."""
    points, density = _measure.fluid_field(run.folder, 0)
    seen = _shape.crossings(points, density, 0.5 * (_measure.VAPOUR + _measure.LIQUID))
    _, y, radius = _shape.circle(seen[seen[:, 1] > 3 / g], on_axis=True)
    return numpy.degrees(numpy.arccos(-y / radius)), radius


def study(lab):
    alphas, g = ((60, 90, 120), 32) if lab.quick else ((30, 45, 60, 75, 90, 105, 120, 135, 150), 64)
    laws = ("gradient",) if lab.quick else ("gradient", "energy")
    runs = lab.runs({f"{alpha}, {law}": (CASE, settings(alpha, law, g, 2 * g)) for law in laws for alpha in alphas}, limit=1500)
    rows = []
    for label, run in runs.items():
        alpha = float(label.split(",")[0])
        found, radius = angle(run, g)
        speed = run.history["speed_max_liquid"][-1]
        rows.append((label.split(", ")[1], f"{alpha:g}", f"{found:.2f}", f"{found - alpha:+.2f}", f"{1 / g / radius:.3f}",
                     f"{speed:.1e}"))
        lab.expect(f"{label}: angle", f"{alpha:g} +- 1.5", f"{found:.2f}", abs(found - alpha) <= 1.5)
    lab.table(("wall law", "asked", "angle", "off by", "gamma_hat / R", "speed of the liquid"), rows, "angles")
    if not lab.quick:
        convergence(lab)


def convergence(lab):
    lab.title("Mesh and interface width")
    wanted = {f"{alpha}, gamma_hat = 1/{g}, h = 1/{h}": (CASE, settings(alpha, "gradient", g, h))
              for alpha in (45, 135) for g, h in ((32, 64), (64, 64), (64, 128), (64, 256), (128, 256))}
    runs = lab.runs(wanted, limit=1500)
    rows = []
    for label, run in runs.items():
        alpha, g = float(label.split(",")[0]), float(label.split("= 1/")[1].split(",")[0])
        rows.append((label, f"{angle(run, g)[0] - alpha:+.3f}"))
    lab.table(("run", "angle off by, degrees"), rows, "convergence")
