"""The parameters of `softwet tradeoff`: the settings of a case to vary, one at a time.

A parameter is a row of PARAMETERS: its name, and one of
  key, factors   the number of the base, multiplied by each factor
  key, values    these values
  key, choices   every value that `softwet explain KEY` allows; for keys whose choices the program knows best
  refine         domain.elements along all axes, multiplied by each fraction
  settings       combinations of several keys
To add one, add a row. A setting that the program refuses is listed with its reason and harms nothing. What a case is
about does not belong here: materials, loads, sizes, and laws such as fluid.wall_law."""

import re
import subprocess
import tomllib
from fractions import Fraction

from .._tools.messages import fail, last_line
from ..program import ERROR
from .._store.values import member_name, split_values

PARAMETERS = [
    {"name": "tolerance", "key": "time.tolerance", "factors": ["10", "3", "3/10", "1/10"]},
    {"name": "scheme", "settings": [
        {"time.scheme": scheme, "time.mass": mass} for scheme in ("kick_drift", "rkl2", "ssp_rk3")
        for mass in ("corrected", "lumped")]},
    {"name": "rho_inf", "key": "time.rho_inf", "values": ["0", "0.8", "1"]},
    {"name": "elements", "refine": ["1/2", "3/4", "3/2"]},
    {"name": "grading", "key": "domain.grading.fine", "values": ["everywhere", "automatic"]},
    {"name": "degree", "key": "domain.degree", "values": ["2", "3"]},
    {"name": "newton", "key": "solver.newton.rtol", "values": ["1e-2", "1e-3", "1e-4", "1e-8"]},
    {"name": "krylov", "key": "solver.krylov.rtol", "values": ["0.1", "1e-3"]},
    {"name": "jacobian", "key": "solver.krylov.jacobian", "choices": True},
    {"name": "preconditioner", "key": "solver.krylov.preconditioner", "values": ["lu", "schwarz"]},
    {"name": "stabilisation", "key": "fluid.stabilisation", "values": ["0", "0.002", "0.02"]},
    {"name": "traction", "key": "fluid.traction", "choices": True},
    {"name": "precision", "key": "solver.precision", "choices": True},
    {"name": "quadrature", "key": "domain.quadrature", "choices": True},
    {"name": "inertia", "key": "substrate.inertia", "choices": True},
    {"name": "strain", "key": "substrate.strain", "choices": True},
    {"name": "start", "key": "time.start", "choices": True},
    {"name": "quality", "key": "quality", "choices": True},
]


class Setting:
    """Some keys with other values than in the base. @param parameters  names;  @param values  {key: text};
    refusal  why it cannot be computed; empty where it can"""

    def __init__(self, parameters, values, refusal=""):
        self.parameters, self.values, self.refusal = list(parameters), dict(values), refusal

    @property
    def label(self):
        return " ".join(f"{key}={value}" for key, value in self.values.items()) or "base"

    @property
    def name(self):
        return member_name(list(self.values), list(self.values.values()), whole=True) if self.values else "base"

    def words(self):
        return [f"{key}={value}" for key, value in self.values.items()]


def plain(number):
    """A number as text, without the digits that rounding leaves."""
    return f"{float(number):.12g}"


def value_of(case, key):
    """Value of a key in the resolved case; None where it has none."""
    for part in key.split("."):
        case = case.get(part) if isinstance(case, dict) else None
    return case


def same(text, value):
    """Whether the text of a setting means this value of the resolved case."""
    try:
        read = tomllib.loads(f"value = {text}")["value"]
    except tomllib.TOMLDecodeError:
        read = text.strip("\"'")
    return read == value and isinstance(read, bool) == isinstance(value, bool)


def elements_times(case, factor):
    """(text of domain.elements, why not) for the elements of the case times a fraction."""
    counts = [Fraction(factor) * n for n in case["domain"]["elements"]]
    text = f"[{','.join(plain(n) for n in counts)}]"
    if any(n.denominator != 1 for n in counts):
        return text, f"{factor} of {case['domain']['elements']} elements are no whole numbers"
    if "substrate" in case and "fluid" in case:
        rows = float(counts[-1]) * case["substrate"]["thickness"] / case["domain"]["size"][-1]
        if abs(rows - round(rows)) > 1e-9:  # as close as the program asks
            return text, f"the substrate would have {rows:.6g} rows of elements, which is no whole number"
    return text, ""


def choices_of(program, key):
    """(values, why not): what `softwet explain` says of a key."""
    told = subprocess.run([str(program), "explain", key], capture_output=True, text=True)
    if told.returncode:
        return [], last_line(told.stderr, ERROR).removeprefix("explain: ")
    found = re.search(r'one of ((?:"[^"]*"(?:, )?)+)', told.stdout)
    return (re.findall(r'"([^"]*)"', found[1]), "") if found else ([], f"{key} has no list of choices; give values with "
                                                                       f"--parameters {key}=V1,V2")


def settings_of(parameter, case, program):
    """The settings of a parameter."""
    name = parameter["name"]
    if "settings" in parameter:
        return [Setting([name], values) for values in parameter["settings"]]
    if "refine" in parameter:
        tried = [elements_times(case, factor) for factor in parameter["refine"]]
        return [Setting([name], {"domain.elements": text}, refusal) for text, refusal in tried]
    key, values = parameter["key"], parameter.get("values", [])
    if "choices" in parameter:
        values, refusal = choices_of(program, key)
        if refusal:
            return [Setting([name], {key: "..."}, refusal)]
    base = value_of(case, key)
    if "factors" in parameter:
        if not isinstance(base, (int, float)):
            return [Setting([name], {key: "..."}, f"the case has no number {key}")]
        values = [plain(Fraction(factor) * Fraction(plain(base))) for factor in parameter["factors"]]
    return [Setting([name], {key: value}) for value in values]


def chosen_parameters(words):
    """The rows of PARAMETERS that --parameters asks for, all without it; KEY=V1,V2 is a parameter of the user's own."""
    if not words:
        return PARAMETERS
    known, chosen = {parameter["name"]: parameter for parameter in PARAMETERS}, []
    for word in words:
        key, equals, text = word.partition("=")
        if equals:
            values = split_values(text)
            if not key or "" in values:
                fail(f"--parameters {word} is not a list of values; write --parameters KEY=V1,V2,..., for example --parameters "
                     "time.tolerance=1e-2,1e-4")
            chosen.append({"name": key, "key": key, "values": values})
            continue
        for name in word.split(","):
            if name not in known:
                fail(f"--parameters {name}: there is no such parameter; there are {', '.join(known)}; values of another key are "
                     "given as KEY=V1,V2,...")
            chosen.append(known[name])
    return chosen


def single_settings(parameters, case, program):
    """All settings of the parameters that differ from the base, each once."""
    found = {}
    for parameter in parameters:
        for setting in settings_of(parameter, case, program):
            if not all(same(text, value_of(case, key)) for key, text in setting.values.items()):
                found.setdefault(setting.name, setting)
    return list(found.values())
