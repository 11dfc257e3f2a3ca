"""The states that `softwet steady --along` has found, as a table."""

import softwet
from .._store.files import write_csv

FOUND, NOT_FOUND = "at rest", "not at rest"
HISTORY = ["mass", "energy_total", "x_centre", "y_centre", "x_left", "x_right", "track_rear", "track_front",
           "angle_left", "angle_right", "angle_rear", "angle_front", "laplace"]
SHOWN = ["steps", "newton", "largest_speed", "residual_over_round_off"]


def wall_of(run):
    """Largest and smallest vertical displacement of the wall; empty without a solid and a wall."""
    if "substrate" not in run.case or "fluid" not in run.case:
        return {}
    wall = run.interface[run.times[-1]]
    vertical = wall["displacement_y" if run.dimension == 2 else "displacement_z"]
    return {"ridge": vertical.max(), "dimple": vertical.min()}


def stability_of(rest):
    """Rate and frequency of the mode that grows fastest; empty where none was found."""
    stability = rest.get("stability", {})
    if not stability.get("growth_rates"):
        return {}
    return {"growth_rate": stability["growth_rates"][0], "frequency": stability["frequencies"][0]}


def row_of(folder, value, state):
    """One row: what was asked for, whether it was found, and its numbers. Where it was not found, only how the search
    went: the fields that it left are no state of rest."""
    run = softwet.open(folder)
    rest = run.record["rest"]
    search = {"value": value, "state": state, "folder": folder.name, **{name: rest[name] for name in SHOWN}}
    if state != FOUND:
        return search
    last = {name: column[-1] for name, column in run.history.items()}
    moved = rest.get("moved") or []
    return {**search, **stability_of(rest), **wall_of(run), **{name: last[name] for name in HISTORY if name in last},
            **{f"moved_{k}": way for k, way in enumerate(moved, 1)}}


def write_table(path, key, rows):
    names = list(dict.fromkeys(name for row in rows for name in row))
    write_csv(path, [[key, *names[1:]], *([cell(row.get(name)) for name in names] for row in rows)])


def cell(value):
    return "" if value is None or value != value else value
