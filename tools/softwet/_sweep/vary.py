"""The values of --vary, and whether the folder of a sweep may have more of them."""

from .._store.values import expand, one_spelling, split_values
from .._tools.messages import fail


def read_vary(assignments, settings):
    """[(key, values)] of --vary."""
    vary, taken = [], {one_spelling(setting.partition("=")[0]) for setting in settings}
    for assignment in assignments:
        key, equals, text = assignment.partition("=")
        if not equals or not key:
            fail(f"--vary {assignment} is not a list of values; write --vary KEY=V1,V2,..., for example "
                 "--vary substrate.poisson=0,0.15,0.3")
        values = [value for part in split_values(text) for value in expand(key, part)]
        twice = [value for i, value in enumerate(values) if value in values[:i]]
        if "" in values or twice:
            fail(f"--vary {assignment}: " + (f"{twice[0]} is there twice" if "" not in values else "a value is empty") +
                 "; write each value once, separated by commas")
        if one_spelling(key) in taken:
            fail(f"{key} is set twice; give it to one --vary or one --set")
        taken.add(one_spelling(key))
        vary.append((key, values))
    return vary


def values_of(vary):
    """{key: its values, as a set} of a list of KEY=V1,V2,..."""
    return {key: set(split_values(text)) for key, _, text in (entry.partition("=") for entry in vary)}


def has_all(some, other):
    """Whether `some` varies the same keys in the same order as `other` over at least its values."""
    mine, theirs = values_of(some), values_of(other)
    return list(mine) == list(theirs) and all(theirs[key] <= mine[key] for key in mine)


def may_grow(definition, part):
    """Whether a sweep has at least the values of the earlier one in its folder.
    @param part  or at most those: a task of an array script from before they were added"""
    old, new = (words["vary"] for words in (definition.old, definition.new))
    return has_all(new, old) or (part and has_all(old, new))
