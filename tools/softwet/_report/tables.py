"""The tables of tools/report: the scene, its groups, the result, the cost. Each is a list of (name, value) texts."""

import numpy as np

from .._drawing.history_curves import energy_label

FOUNDATION = {"foundation": "springs", "foundation_damping": "dashpots"}  # keys of [boundary] that are no sides


def number(value):
    return f"{value:.4g}" if isinstance(value, (int, float)) else str(value)


def listed(values):
    return " x ".join(map(number, values))


def shortened(value):
    """A number, an expression, the path of a table, or a list of them; its beginning where it is long."""
    text = listed_texts(value) if isinstance(value, list) else number(value)
    return text if len(text) <= 50 else text[:47] + "..."


def listed_texts(values):
    return f"({', '.join(map(number, values))})"


def scene(case):
    """What was computed, from case.toml."""
    domain = case["domain"]
    rows = [("$L_0$; liquid", f"{lab['length']}; {lab['surface_tension']}, {lab['density']}") for lab in [case.get("laboratory")] if lab]
    rows += [("domain / $L_0$", listed(domain["size"])),
            ("elements, degree", f"{listed(domain['elements'])}, {domain['degree']}")]
    if "fluid" in case:
        fluid = case["fluid"]
        rows += [("viscosity, capillarity", f"{number(fluid['viscosity'])}, {number(fluid['capillarity'])}"),
                 ("temperature", number(fluid["temperature"])),
                 ("contact angle, wall law", f"{shortened(fluid['contact_angle'])} degrees, {fluid['wall_law']}")]
    for droplet in case.get("droplet", []):
        rows.append(("droplet: centre, radius", f"({', '.join(map(number, droplet['centre']))}), "
                                                f"{number(droplet['radius'])}"))
    if "substrate" in case:
        solid = case["substrate"]
        rows += [("substrate: thickness, density", f"{number(solid['thickness'])}, {number(solid['density'])}"),
                 ("young (times density), poisson", f"{shortened(solid['young'])}, {number(solid['poisson'])}")]
    for load in case.get("load", []):
        factor = load.get("factor", 1)
        varies = f", times {shortened(factor)}" if factor != 1 else ""
        rows.append(("load: force, ramp", f"({', '.join(map(number, load['force']))}), {number(load['ramp'])}{varies}"))
    for needle in case.get("needle", []):
        rows.append(("needle: stiffness, path", f"{number(needle['stiffness'])}, "
                                                f"({', '.join(map(shortened, needle['path'] or ['rests']))})"))
    rows += [(f"initial {key}", shortened(value)) for key, value in case.get("initial", {}).items() if value]
    sides = {}
    for side, kind in case.get("boundary", {}).items():
        if side not in FOUNDATION:
            sides.setdefault(kind, []).append(side)
        elif kind:
            rows.append((f"{FOUNDATION[side]} below the solid", ", ".join(map(number, kind))))
    return rows + [(kind.replace("_", " "), ", ".join(names)) for kind, names in sides.items()]


def groups(record):
    """Dimensionless groups as run.json lists them; none of older records. Those of a speed are given for the speed
    1."""
    of_speed = ("capillary_number", "reynolds")
    return [(name.replace("_", " ") + (" at speed 1" if name in of_speed else ""), number(value))
            for name, value in (record.get("groups") or {}).items()]


class Budget:
    """Energy since the first row shown: {name: array over the rows}.

    change of the energy = work of the loads and needles + work of the wall's stretch - what is dissipated + rest; the
    rest is the error of the discretisation, and with the paper's wall law what that law takes or gives at the contact
    line."""

    def __init__(self, curves):
        table, steps = curves.table, np.diff(curves.t)

        def integral(name):
            rate = np.nan_to_num(table[name])  # empty: there is no such power in this scene
            return np.append(0.0, np.cumsum(0.5 * (rate[1:] + rate[:-1]) * steps))

        self.change = table["energy_total"] - table["energy_total"][0]
        self.work, self.stretch, self.lost = map(integral, ("power_load", "wall_stretch", "dissipation"))
        if "power_needle" in table:
            self.work = self.work + integral("power_needle")
        self.rest = self.change - self.work - self.stretch + self.lost


def result(curves, budget, record):
    """What came out, at the last row."""
    table, unit = curves.table, curves.units.name
    if len(curves.t) == 1:
        return state(curves)
    rows = [("t, step", f"{curves.t[-1]:.6g}{unit('t')}, {table['step'][-1]:.0f}")]
    for suffix in curves.droplets:
        centre = table[("x_centre" if curves.flat else "track_centre") + suffix][-1]
        speeds = table["velocity" + suffix]
        name = f"droplet {suffix[1:]}" if suffix else "droplet"
        if np.isfinite(speeds[curves.settled()]).any():  # not on an axis of symmetry
            where = np.nanargmax(np.abs(np.where(curves.settled(), speeds, np.nan)))
            rows += [(f"{name}: place", number(float(centre)) + unit("x_centre") if np.isfinite(centre) else "gone"),
                     (f"{name}: peak velocity", f"{speeds[where]:.3e}{unit('velocity')} at t = {curves.t[where]:.4g}{unit('t')}")]
        ripple = (record.get("groups") or {}).get("speed_ripple")
        if ripple:
            rows.append((f"{name}: ripple of V by the mesh", f"about {100 * ripple:.1f} %; 1.2 times the elements halve it"))
        rows += [(f"{name}: {text}", value) for text, value in at_the_line(curves, suffix, ("angle", "ridge"))]
    if np.isfinite(table["mass_drift"]).any():
        rows.append(("largest drift of the mass", f"{np.nanmax(np.abs(table['mass_drift'])):.1e}"))
    rows += [(name, f"{values[-1]:.4e}") for name, values in (
        (f"{energy_label(curves)}: change", budget.change), ("work of the loads", budget.work),
        ("work of the stretched wall", budget.stretch), ("dissipated", budget.lost), ("rest of the balance", budget.rest))]
    return rows


LINE = {"angle": ("angles", "{:.2f}"), "ridge": ("ridges", "{:.4g}"), "contact": ("contact line", "{:.5g}")}


def at_the_line(curves, suffix, kinds):
    """Numbers at the ends of a droplet, in the last row: both, or the one that is not an axis of symmetry. @param kinds
    of LINE"""
    rows = []
    for kind in kinds:
        ends = ("left", "right") if curves.flat else ("rear", "front")
        start = kind if kind != "contact" else "x" if curves.flat else "track"
        values = [curves.table.get(f"{start}_{end}{suffix}", [np.nan])[-1] for end in ends]
        name, form = LINE[kind]
        unit = " degrees" if kind == "angle" else curves.units.name(f"{start}_{ends[1]}")
        known = [form.format(value) for value in values if np.isfinite(value)]
        rows += [(name, " and ".join(known) + unit)] if known else []
    return rows


def state(curves):
    """What the one row of a state of rest holds: its droplets, and its energies."""
    rows, table = [("t", f"{curves.t[-1]:.6g}{curves.units.name('t')}")], curves.table
    for suffix in curves.droplets:
        name = f"droplet {suffix[1:]}" if suffix else "droplet"
        rows += [(f"{name}: {text}", value) for text, value in at_the_line(curves, suffix, ("contact", "angle", "ridge"))]
        dimple = table.get("dimple" + suffix, [np.nan])[-1]
        rows += [(f"{name}: dimple", f"{dimple:.4g}{curves.units.name('dimple')}")] if np.isfinite(dimple) else []
    energies = sorted((name for name in table if name.startswith("energy_")), key="energy_total".__eq__)
    least = 1e-12 * abs(table["energy_total"][-1])
    return rows + [(f"{energy_label(curves)}: {name.removeprefix('energy_')}", f"{table[name][-1]:.4e}")
                   for name in energies if abs(table[name][-1]) > least]  # an empty one is no number


def rest(record):
    """How `softwet steady` found its state, and whether it is stable; none of a run."""
    found = record.get("rest")
    if not found:
        return []
    rows = [("end", shortened(record.get("stop", {}).get("reason", ""))),
            ("residual, over that of the last digit", number(found["residual_over_round_off"])),
            ("largest speed", f"{found['largest_speed']:.1e}"), ("change of the mass", f"{found['mass_change']:.1e}"),
            ("droplets moved by", ", ".join(map(number, found.get("moved", []))))]
    stability = found.get("stability", {})
    rates = zip(stability.get("growth_rates", []), stability.get("frequencies", []))
    rows += [("rate of a disturbance" + (", frequency" if frequency else ""), number(rate) +
              (f", {number(frequency)}" if frequency else "")) for rate, frequency in rates]
    return [(name, value) for name, value in rows if value]


def cost(record):
    """What it took, from run.json."""
    if "seconds" not in record:
        return [("run.json", "not written yet")]
    seconds, counts = record["seconds"], {**record["counts"], **record.get("rest", {})}  # of a search for a state of rest
    refused = counts.get("rejected", counts["rejected_by_newton"] + counts["rejected_by_error"])
    total = seconds["total"] or 1.0
    parts = sorted(((value, name) for name, value in seconds.items() if name != "total"), reverse=True)[:3]
    builds = [] if "rest" in record else [str(counts["preconditioner_builds"])]  # that search does not count them
    return [("where", f"{record['host']}, {record['backend']}, {record['threads']} threads"),
            ("unknowns solved", f"{record['unknowns']['solved']}"),
            ("steps; rejected", f"{counts['steps']}; {refused}"),
            ("Newton, Krylov iterations", f"{counts['newton']}, {counts['krylov']}"),
            ("preconditioner; builds", "; ".join([record["preconditioner"], *builds])),
            ("wall seconds", f"{total:.1f}"),
            *((f"of that {name.replace('_', ' ')}", f"{100 * value / total:.0f} %") for value, name in parts),
            ("peak memory", f"{record['peak_memory_mib']:.0f} MiB")]
