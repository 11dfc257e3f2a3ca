"""Which keys a state of rest depends on, and how."""

import re

from .._tools.messages import fail
from .._store.values import one_spelling
from .table import FOUND

# Keys of the start alone: a state that starts from another one knows nothing of them.
OF_START = ("droplet", "film", "wave", "initial", "fluid.initial")
# Keys that change what a run does, or what is written, but no state of rest.
IDLE = {"name": "it is a name", "output": "it says what is written", "probe": "probes only look",
        "substrate.branch": "branches of the solid carry nothing there", "substrate.gel": "the gel carries nothing there",
        "fluid.creep_speed": "contact lines have no hysteresis there",
        "fluid.line_friction": "contact lines have no friction there"}
# Columns that show whether states differ, and the share of the largest that a search leaves open.
COMPARED = {"energy_total": 1e-9, "mass": 1e-9, "growth_rate": 1e-3}
# What begins a state from the one before it, and not from what the case says of its start.
FROM_EARLIER = ("initial.time=[]", 'initial.density=""', "initial.velocity=[]", "initial.displacement=[]")


def is_of_start(key):
    """Whether only the first state of a chain would know of the key."""
    plain = re.sub(r"\[\d+\]", "", one_spelling(key))
    return any(plain == start or plain.startswith(start + ".") for start in OF_START)


def refuse_without_effect(key):
    """Refuses a key on which no state of rest depends."""
    plain = re.sub(r"\[\d+\]", "", one_spelling(key))
    if plain == "time" or plain.startswith("time."):
        fail(f"--along {key}: a state of rest does not depend on time.*; follow another key, or vary this one with "
             f"'softwet sweep CASE --vary {key}=...'")
    if plain in ("load.start", "load.ramp"):
        fail(f"--along {key}: a state of rest has the full load, whenever it begins; follow load.force, or vary "
             f"this key with 'softwet sweep CASE --vary {key}=...'")
    for start, why in IDLE.items():
        if plain == start or plain.startswith(start + "."):
            fail(f"--along {key}: a state of rest does not depend on {start}: {why}; follow another key, or vary this one with "
                 f"'softwet sweep CASE --vary {key}=...'")


def without_effect(rows):
    """Whether all states that were found are one state, as far as energy, mass and growth rate show."""
    found = [row for row in rows if row["state"] == FOUND]
    return len(found) > 1 and all(same([row.get(name) for row in found], digits) for name, digits in COMPARED.items())


def same(values, share):
    """Whether numbers differ by no more than a share of the largest; what no state has does not count."""
    numbers = [value for value in values if isinstance(value, (int, float)) and value == value]
    return not numbers or max(numbers) - min(numbers) <= share * max(map(abs, numbers))
