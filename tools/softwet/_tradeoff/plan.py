"""What `softwet tradeoff` computes: the case with all its values, the reference, and what the folder keeps."""

import itertools
import re
import subprocess
import tomllib

from .._tools.messages import fail, last_line
from ..program import ERROR
from .._store.definition import Definition
from .._store.member import Member, ask_check
from .._store.values import one_spelling
from .parameters import elements_times, plain, value_of

REFERENCE = {"tolerance": 10, "newton": 1e-8, "elements": 2}  # finer by, at most, finer by
ORDER = 2  # of the error in element size and time step: what Richardson's extrapolation of the reference assumes
REFINED = {"domain.elements", "time.tolerance"}  # keys whose refinement has that order
ALGEBRAIC = {"solver.newton.rtol", "solver.newton.atol", "solver.newton.max", "solver.krylov.rtol", "solver.krylov.max",
             "solver.krylov.restart", "solver.krylov.jacobian", "solver.krylov.preconditioner",
             "solver.krylov.launch"}  # with no order of their own


def resolved_case(program, path, settings):
    """Every key of the case as `softwet check` prints it; ends where the case is refused."""
    told = ask_check(program, path, Member("", (), settings, path))
    if told.returncode:
        fail(last_line(told.stderr, ERROR), told.returncode)
    lines = itertools.takewhile(re.compile(r"$|\[|[\w.]+ = ").match, told.stdout.splitlines())
    return tomllib.loads("\n".join(lines))


def field_times(case, settings):
    """The setting that gives all members field files at the end, for a case that has none; [] where it has some."""
    output, end = case["output"], case["time"]["end"]
    given = any(one_spelling(word).startswith("output.fields") for word in settings)
    times = output["fields"]["times"]
    if given or output["fields"]["every"] or any(isinstance(t, str) or t <= end for t in times):
        return []
    return [f"output.fields.times=[{plain(end)}]"]


def reference_values(case, words):
    """{key: value} of the reference: finer than the case, and as --reference says.
    Time steps: time.tolerance a tenth, which is steps about a third as long. Space: elements of half the size."""
    values = {"domain.elements": elements_times(case, str(REFERENCE["elements"]))[0],
              "solver.newton.rtol": plain(min(REFERENCE["newton"], value_of(case, "solver.newton.rtol")))}
    if value_of(case, "time.scheme") == "generalized_alpha":
        values["time.tolerance"] = plain(case["time"]["tolerance"] / REFERENCE["tolerance"])
    for word in words:
        key, equals, value = word.partition("=")
        if not key or not equals:
            fail(f"--reference {word} is not a setting; write --reference KEY=VALUE, for example --reference "
                 "domain.elements=[64,32]")
        values[one_spelling(key)] = value
    return values


def companion_values(program, path, settings, reference):
    """({key: value}, order) of the companion: the reference with elements of twice the size and steps of twice the
    length. The local error that time.tolerance bounds grows with the square of the step, so the tolerance is four times
    the one of the reference. The order is None where the reference refines what is neither."""
    words = [f"{key}={value}" for key, value in reference.items()]
    fine = resolved_case(program, path, [*settings, *words])
    base = resolved_case(program, path, settings)
    values, refined = dict(reference), False
    if fine["domain"]["elements"] != base["domain"]["elements"]:
        text, refusal = elements_times(fine, "1/2")
        values, refined = {**values, "domain.elements": text}, not refusal
    if fine["time"]["tolerance"] != base["time"]["tolerance"]:
        values, refined = {**values, "time.tolerance": plain(fine["time"]["tolerance"] * 2 ** ORDER)}, True
    other = {key for key in reference if key not in REFINED | ALGEBRAIC
             and value_of(fine, key) != value_of(base, key)}
    return (values if refined else {}), (ORDER if refined and not other else None)


def read_definition(arguments):
    """What the folder is made for; refuses a folder that holds another. Parameters and combinations may change from one
    command to the next."""
    definition = Definition(arguments.out / "definition.json", arguments.case, set=arguments.set, reference=arguments.reference)
    told = definition.difference("set", "reference")
    if told:
        fail(f"{arguments.out} holds another comparison: {told}; give the same case, --set and --reference, or a new "
             "folder with --out")
    return definition


def commit_of(program):
    """What `softwet version` says in its first line."""
    return subprocess.run([str(program), "version"], capture_output=True, text=True).stdout.split("\n")[0].strip()
