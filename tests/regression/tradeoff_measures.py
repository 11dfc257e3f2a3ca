#!/usr/bin/env python3
"""What `softwet tradeoff` measures, on series and fields whose errors are known: each is written down by hand as a
known change of the reference. Also the Pareto front, and which settings are combined.
usage: tradeoff_measures.py SOFTWET"""

import types

import numpy as np
from _scene import check, check_true

try:
    import pandas  # noqa: F401
except ImportError:
    raise SystemExit(print("no pandas: nothing to test; on Debian: apt-get install python3-pandas") or 0)
from softwet._tradeoff import measures, table
from softwet._tradeoff.combine import combinations
from softwet._tradeoff.parameters import Setting, elements_times, same
from softwet._tradeoff.plan import field_times, reference_values
from softwet._tradeoff.shapes import contour

SIZE, RADIUS, WIDTH = (1.0, 0.5), 0.2, 1 / 64
LIQUID, VAPOUR = 0.8, 0.002


class Scene:
    """A run that no program has computed: a droplet that moves, a wall with a ridge, a round interface.
    @param scale  of everything that moves;  @param radius  of the droplet;  @param angle  added to the angles"""

    def __init__(self, times, elements, scale=1.0, radius=RADIUS, angle=0.0, to_left=False):
        self.case, self.dimension, self.parts = {"domain": {"size": SIZE, "elements": elements}}, 2, ["fluid", "solid"]
        self.record = {"equilibrium": {"density_vapour": VAPOUR, "density_liquid": LIQUID}}
        self.radius, self.times = radius, [5.0]
        way = -1 if to_left else 1
        path, speed = 1 - np.cos(times / 5), np.sin(times / 5) / 5
        self.history = {"t": times, "x_centre": 0.3 + way * scale * path, "velocity": way * scale * speed,
                        "angle_left": 60 + 5 * path + (angle if to_left else 0),
                        "angle_right": 70 + 5 * path + (0 if to_left else angle),
                        "energy_total": -3 + scale * path, "mass_drift": 1e-12 * scale * np.sin(times)}
        x = np.linspace(0, 1, 2 * elements[0] + 1)
        self.interface = {5.0: {"x_reference": x, "displacement_x": 0 * x, "displacement_y": scale * x * (1 - x)}}

    def fields(self, time):
        return self

    def at(self, points):
        far = np.hypot(points[..., 0] - 0.5, points[..., 1])
        return {"density": (LIQUID + VAPOUR) / 2 + (LIQUID - VAPOUR) / 2 * np.tanh((self.radius - far) / WIDTH)}

    def on_grid(self, *counts):
        lines = [np.linspace(0, length, n) for length, n in zip(SIZE, counts)]
        points = np.stack(np.meshgrid(*lines[::-1], indexing="ij")[::-1], axis=-1)
        return type("Sample", (dict,), {"positions": points})(self.at(points))


def close(name, value, wanted, bound):
    check(f"{name}: {value:.6g}, wanted {wanted:.6g}", abs(value - wanted), bound)


# --- series: the reference has other times; what is interpolated is smooth -----------------------------------------
fine, coarse = np.linspace(-2, 10, 474), np.array([-2, -1, 0, 0.3, 1, 2.5, 3.1, 5, 7.8, 9, 10.0])
parabola = measures.interpolate(coarse, fine[::43], fine[::43] ** 2)  # 473 intervals are 11 times 43
check("interpolation meets parabolas", abs(parabola - coarse**2).max(), 1e-12)
reference, equal = Scene(fine, [64, 32]), Scene(coarse, [64, 32])
for name in ("path", "energy", "advancing", "receding", "wall", "density", "interface"):
    check(f"{name} of an equal run", measures.MEASURES[name](equal, reference), 1e-5)
other = Scene(coarse, [48, 24], scale=1.1, radius=RADIUS + 0.003, angle=3.0)
close("path, a tenth longer", measures.path(other, reference), 10, 1e-3)
close("energy, a tenth more", measures.energy(other, reference), 10, 1e-3)
top = 100 * (1.1 * abs(np.sin(coarse[coarse >= 0] / 5)).max() / np.sin(fine[fine >= 0] / 5).max() - 1)
close("peak speed", measures.peak(other, reference), top, 1e-9)
close("angle in front", measures.advancing(other, reference), 3, 1e-6)
check("angle behind", measures.receding(other, reference), 1e-5)
left = Scene(fine, [64, 32], to_left=True)
close("angle in front, to the left", measures.advancing(Scene(coarse, [64, 32], angle=3.0, to_left=True), left), 3, 1e-6)
shifted = Scene(coarse, [64, 32])
shifted.history["x_centre"] = shifted.history["x_centre"] + 0.05
check("a path that starts elsewhere is the same path", measures.path(shifted, reference), 1e-5)
later = Scene(coarse, [64, 32])
later.history["x_centre"] = np.where(coarse > 6, later.history["x_centre"] + 0.1, later.history["x_centre"])
close("a jump of 0.1", measures.path(later, reference), 100 * 0.1 / np.ptp(reference.history["x_centre"][fine >= 0]), 1e-3)
close("drift", measures.drift(other, reference), 1.1e-12 * abs(np.sin(coarse)).max(), 1e-18)

# --- shapes ---------------------------------------------------------------------------------------------------------
close("wall, a tenth higher, other elements", measures.wall(other, reference), 10, 1e-9)
close("interface, 0.003 further out", measures.interface(other, reference), 0.003, 3e-5)
# For a thin interface: rho - rho_ref = drho/dR dR, and the integral of (drho/dr)^2 across it is (rho_l - rho_v)^2 / (3
# w).
half = np.pi * RADIUS * (LIQUID - VAPOUR) ** 2 / (3 * WIDTH) * 0.003**2
close("density", measures.density(other, reference), 100 * np.sqrt(half / (np.pi * RADIUS**2 / 2 * LIQUID**2)), 0.5)
grid = reference.on_grid(97, 49)
places, normals = contour(grid.positions, grid["density"], (LIQUID + VAPOUR) / 2)
check("places on the circle", abs(np.hypot(places[:, 0] - 0.5, places[:, 1]) - RADIUS).max(), 2e-4)
outward = (places - [0.5, 0]) / RADIUS
check("normals across it", abs(abs((normals * outward).sum(axis=-1)) - 1).max(), 1e-2)

# --- what a scene lacks ---------------------------------------------------------------------------------------------
still = Scene(fine, [64, 32], scale=0.0)
check_true("a droplet at rest has no path", np.isnan([measures.path(still, still), measures.peak(still, still)]).all())
solid = Scene(fine, [64, 32])
solid.parts = ["solid"]
solid.history = {"t": fine, "energy_total": fine}
blank = [name for name in measures.MEASURES if name not in measures.measure(solid, solid)]
check_true("a solid alone", blank == ["path", "peak", "advancing", "receding", "density", "interface", "drift"], str(blank))

# --- parameters, the front, combinations ----------------------------------------------------------------------------
case = {"domain": {"size": [1, 0.5], "elements": [32, 16]}, "substrate": {"thickness": 0.125}, "fluid": {}}
tried = [elements_times(case, factor) for factor in ("1/2", "3/4", "3/2", "1/3")]
check_true("elements", tried[:3] == [("[16,8]", ""), ("[24,12]", ""), ("[48,24]", "")], str(tried))
check_true("no whole elements", "no whole number" in tried[3][1], tried[3][1])
case["domain"]["elements"] = [24, 12]
check_true("no whole rows", "1.5 rows" in elements_times(case, "1/2")[1])
check_true("values that are those of the base", same("0.50", 0.5) and same("exact", "exact") and same("[32,16]", [32, 16])
           and not same("1e-3", 0.002) and not same("lu", "schwarz"))
case["time"] = {"end": 9, "tolerance": 0.002, "scheme": "generalized_alpha"}
case["solver"] = {"newton": {"rtol": 1e-6}}
wanted = {"domain.elements": "[48,24]", "time.tolerance": "0.0002", "solver.newton.rtol": "1e-08"}
check_true("the reference", reference_values(case, []) == wanted)
check_true("and one of the user", reference_values(case, ["domain.elements=[30,15]", "time.rho_inf=1"]) ==
           {**wanted, "domain.elements": "[30,15]", "time.rho_inf": "1"})
case["output"] = {"fields": {"times": [12.0], "every": 0}}
check_true("field files at the end, where there are none before", field_times(case, []) == ["output.fields.times=[9]"])
check_true("but not against the user", field_times(case, ["output.fields.times=[]"]) == [])
case["output"]["fields"]["times"] = [0.0, 12.0]
check_true("nor where there are some", field_times(case, []) == [])


def entry(parameter, cost, error, kind="parameter"):
    setting = Setting([parameter] if parameter else [], {parameter: "1"} if parameter else {})
    return types.SimpleNamespace(kind=kind, setting=setting, state="done", costs={"seconds": cost}, errors={"path": error},
                                 front=False)


base = entry("", 10, 4, "base")
entries = [base, entry("a", 5, 4.01), entry("b", 20, 2), entry("c", 30, 5), entry("d", 8, 9), entry("e", 60, 0.1),
           entry("reference", 1, 0, "reference")]
points = table.mark_front(entries, "path", {"path": 0.5}, "seconds")
check_true("front", [e.setting.name for e in entries if e.front] == ["base", "a=1", "b=1", "e=1"])
check_true("an error below the reference's counts as the reference's", points[-1][2] == 0.5)
check_true("and is shown so", table.error_cell("parameter", 0.1, "path", {"path": 0.5}) == "<= 0.5")
again = entry("f", 9, 4)  # what the base computed, in less time
table.mark_front([*entries, again], "path", {"path": 0.5}, "seconds")
check_true("what computes the same is on the front together", again.front and base.front)
check_true("and is reported", table.like_base([*entries, again]) == [again])
slower = entry("f", 11, 4)
table.mark_front([*entries, slower], "path", {"path": 0.5}, "seconds")
check_true("however long it took", slower.front and base.front)
combined = combinations(points, points[0], 0.5, 6)
check_true("combinations of what did well", {"a=1__b=1"} <= {s.name for s in combined} and
           not any("c" in s.parameters or "d" in s.parameters for s in combined), str([s.name for s in combined]))
check_true("no more than asked for", len(combinations(points, points[0], 0.5, 1)) == 1)
