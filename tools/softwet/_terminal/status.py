"""How a run stands, in one line. Needs nothing but Python; used by tools/status and tools/watch."""

import time
from datetime import datetime, timezone

import softwet
from softwet.table import last_row
from softwet.units import OF_THE_CASE, chosen_units


def duration(seconds):
    """Seconds in words: 12 s, 5 min, 3.2 h, 2.5 days."""
    for unit, length, digits in (("days", 172800, 1), ("h", 5400, 1), ("min", 90, 0)):
        if seconds >= length:
            return f"{seconds / {'days': 86400, 'h': 3600, 'min': 60}[unit]:.{digits}f} {unit}"
    return f"{seconds:.0f} s"


def age(text):
    """Seconds since an ISO 8601 time; None where it is none."""
    try:
        then = datetime.fromisoformat(text)
    except (TypeError, ValueError):
        return None
    then = then if then.tzinfo else then.replace(tzinfo=timezone.utc)
    return max(0.0, time.time() - then.timestamp())


def newest_row(run, units):
    """The last row of history.csv; where run.json has a later one, that one."""
    row, told = last_row(run.folder / "history.csv"), run.record.get("last_row") or {}
    return units.shown(told if told.get("t", float("-inf")) > row.get("t", float("-inf")) else row)


def droplet_text(row, units):
    """Where the first droplet meets the wall and under which angles; empty where it does not."""
    form = ".5g" if units.named else ".4f"
    for rear, front, first, second in (("x_left", "x_right", "angle_left", "angle_right"),
                                       ("track_rear", "track_front", "angle_rear", "angle_front")):
        if rear in row and front in row:
            angles = [f"{row[name]:.1f}" for name in (first, second) if name in row]
            ridges = [f"{row[name]:.3g}" for name in (first.replace("angle", "ridge"), second.replace("angle", "ridge"))
                      if name in row]
            return f"contact line {row[rear]:{form}} to {row[front]:{form}}{units.name(front)}" + (
                f", angles {' and '.join(angles)} degrees" if angles else "") + (
                f", ridges {' and '.join(ridges)}{units.name(first.replace('angle', 'ridge'))}" if ridges else "")
    return ""


def probe_text(run, row, units):
    """The numbers of the probes of the case."""
    names = [probe["name"] for probe in run.case.get("probe", [])]
    return ", ".join(f"{name} {row[name]:.4g}{units.name(name)}" for name in names if name in row)


def state_text(run, state):
    """The state, and what may be done about it."""
    saved = (run.folder / "checkpoint.h5").exists()
    remedy = "continue it with --resume" if saved else "start it again with --overwrite"
    if state == "died":
        return f"died: it has not recorded its end, and no process holds the folder; {remedy}"
    if state == "failed":
        return run.record.get("stop", {}).get("reason", "failed")
    return f"stopped, {remedy}" if state == "stopped" else state


def search_text(record, state):
    """Of a search for a state of rest: whether it is one, the steps, and what a small disturbance does."""
    found = record["rest"]
    rates = found.get("stability", {}).get("growth_rates", [])
    return [record.get("stop", {}).get("reason", "") if state == "done" else "", f"{found.get('steps', 0)} steps of the search"] + (
        [f"largest growth rate {max(rates):.3g}"] if rates else [])


def rate_text(record):
    steps, seconds = record.get("counts", {}).get("steps", 0), record.get("seconds", {}).get("total", 0)
    return f"{seconds / steps:.2g} s a step" if steps > 0 and seconds > 0 else ""


def left_text(record, since):
    """The time left, which run.json gave `since` seconds ago; empty where it gives none or has run out."""
    left = record.get("seconds_left")
    left = left - (since or 0) if isinstance(left, (int, float)) else 0
    return f"{duration(left)} left" if left > 0 else ""


def status(run, state, units=OF_THE_CASE):
    """One line: state, time, step, rate, time left, last contact line. Parts that are not known are left out."""
    record, row = run.record, newest_row(run, units)
    since = age(record.get("updated"))
    parts = [f"{run.folder}: {state_text(run, state)}"]
    if "rest" in record:
        parts += search_text(record, state)
    elif "t" in row:
        end = run.case["time"]["end"] * units.of("t")[1]
        parts += [f"t = {row['t']:.6g} of {end:.6g}{units.name('t')}", f"step {row.get('step', 0):.0f}"]
        parts += [f"dt {row['dt']:.3g}{units.name('dt')}"] if row.get("dt", 0) > 0 else []
    else:
        parts.append("no row of history.csv yet")
    parts += [rate_text(record), left_text(record, since) if state == "running" else "", droplet_text(row, units),
              probe_text(run, row, units)]
    if state == "running" and since is not None and since > 120:
        parts.append(f"run.json is {duration(since)} old")
    if record.get("events"):
        event = record["events"][-1]
        at = event.get("t", float("nan")) * units.of("t")[1]
        parts.append(f"last event: at t = {at:.6g}{units.name('t')} {event.get('what', '')}")
    return ", ".join(part for part in parts if part)


def look(folder, asked=None):
    """The run as it is now, its state, and the units in which it is shown. Raises softwet.Problem
    @param asked  of --units"""
    run = softwet.open(folder)
    run.case
    return run, run.state, chosen_units(run.folder, asked)
