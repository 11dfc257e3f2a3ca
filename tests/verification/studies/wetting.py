"""Where the wall law "gradient" stops near complete wetting and drying.

The paper's law d_n rho = |grad rho| cos(alpha) has no wall energy, and no closed bound of the density is known:
without a gradient along the wall it asks d_n rho = 0 at every angle, so the profile normal to the wall shows nothing,
and a plane interface that meets the wall at alpha obeys it exactly for all alpha. So the limit is measured: half a
droplet, or half a bubble for the side of drying, with a cap of two gamma_hat, let go at the angle alpha; whether the
density stays in its range to t = 20, bisected to half a degree. Asked: every angle that stops is outside what
`softwet check` gives for that mesh. It falls as the mesh gets finer, so a part of it is an error of the mesh at the
contact line."""

import math
import re
import subprocess

from _lab import StudyError

MINUTES = {"quick": 0.1, "full": 2}
EXPLICIT = "asks where a wall law stops, to the temperature 0.39 and t = 20: a hundred thousand explicit steps for each angle"
CASE = """# Half a droplet (or bubble) with a thin cap, let go at its angle; the left side is its plane of symmetry.
name = "cap"
[domain]
size = [1.0, 0.25]
elements = [64, 16]
[fluid]
viscosity = "1/256"
capillarity = "1/32"
temperature = 0.39
contact_angle = 20.0
[[droplet]]
centre = [0.0, 0.0]
radius = 1.0
[boundary]
bottom = "no_slip"
top = "no_slip"
[time]
end = 20.0
[output]
fields = { times = [] }
"""
WIDTH, HEIGHT = 1 / 32, 0.06  # gamma_hat; the cap


def settings(angle, n, theta, ambient):
    """@param n  elements for a gamma_hat"""
    inside = math.radians(angle if ambient == "vapour" else 180 - angle)
    radius, h = HEIGHT / (1 - math.cos(inside)), WIDTH / n
    columns = math.ceil(max(8 * WIDTH, radius * math.sin(inside) + 6 * WIDTH) / h)
    return [f"fluid.contact_angle={angle}", f"fluid.temperature={theta}", f"fluid.ambient={ambient}",
            f"domain.size=[{columns * h},0.25]", f"domain.elements=[{columns},{8 * n}]",
            f"droplet[0].radius={radius:.8g}"]


def limit(lab, n, theta, ambient, end):
    """Bisects between `end`, where runs stop, and an angle where they do not.
    @return (angle that stops, angle that works, latest time of a stop)"""
    times = []

    def stops(angle):
        run = lab.run(f"{ambient} around, {n} elements, theta = {theta}, {angle:g} degrees", CASE,
                      settings(angle, n, theta, ambient), expect=None)
        if run.code not in (0, 2) or run.code == 2 and "density" not in run.message:
            raise StudyError(f"{angle}: {run.message}")
        times.extend(run.history["t"][-1:] if run.code else [])
        return run.code == 2

    works = 45.0 if ambient == "vapour" else 135.0
    if stops(works):
        raise StudyError(f"{works} degrees stops")
    if not stops(end):
        return None, end, None
    bad = end
    while abs(works - bad) > (2 if lab.quick else 0.5):
        middle = 0.5 * (works + bad)
        bad, works = (middle, works) if stops(middle) else (bad, middle)
    return bad, works, max(times)


def warned(lab, n):
    """The angles between which `softwet check` is silent, from its warning at an angle outside."""
    path, _ = lab.case_file(CASE)
    words = [word for setting in settings(1, n, 0.39, "vapour") for word in ("--set", setting)]
    told = subprocess.run([str(lab.program), "check", str(path), *words], capture_output=True, text=True, check=True)
    found = re.search(r"fluid\.contact_angle = \S+ is outside \[([^,]*), ([^\]]*)\]", told.stderr)
    return float(found.group(1)), float(found.group(2))


def study(lab):
    wanted = [(1, 0.39, "vapour", 5)]
    if not lab.quick:
        wanted += [(n, 0.39, "vapour", 5) for n in (2, 3, 4)]
        wanted += [(2, theta, "vapour", 5) for theta in (0.3, 0.5, 0.7, 0.85)]
        wanted += [(n, 0.39, "liquid", 172) for n in (1, 2)]
    rows = []
    for n, theta, ambient, end in wanted:
        stops, works, time = limit(lab, n, theta, ambient, end)
        low, high = warned(lab, n)
        wetting = ambient == "vapour"
        if theta <= 0.39:
            side = "wetting" if wetting else "drying"
            lab.expect(f"{side}, gamma_hat = {n} h, theta = {theta}: last angle that stops",
                       f"< {low:.4g}" if wetting else f"> {high:.4g}", "none" if stops is None else f"{stops:.2f}",
                       stops is None or (stops < low if wetting else stops > high))
        rows.append((n, theta, ambient, "none tried" if stops is None else f"{stops:.2f}", f"{works:.2f}",
                     "" if time is None else f"{time:.3f}", f"[{low:.4g}, {high:.4g}]"))
    lab.table(("gamma_hat / h", "theta", "around", "stops at", "works at", "latest stop at t =", "check is silent in"),
              rows, "limits")
