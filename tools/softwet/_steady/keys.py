"""Which keys a state of rest depends on, and how."""

import re

from .._tools.messages import fail
from .._store.values import one_spelling

# Keys of the start alone: a state that starts from another one knows nothing of them.
OF_START = ("droplet", "film", "wave", "initial", "fluid.initial")
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
