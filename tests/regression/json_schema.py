#!/usr/bin/env python3
"""The schema of `softwet explain --json-schema` takes every case that the program takes, and refuses what a schema can
know to be wrong. It is judged by the reader of _json_schema.py, and by jsonschema and taplo where they are installed
(pip install jsonschema taplo). `softwet init` writes it beside a case and names it. usage: json_schema.py SOFTWET"""

import json
import pathlib
import shutil
import subprocess
import tomllib

from _json_schema import faults, plain
from _list_lengths import case as case_of_lists
from _list_lengths import lists_of, resized, value_of
from _scene import cases, check_true, softwet

# A line of the case of `softwet init --like pull`, and what stands in its place.
RIGHT = [("elements = [128, 64]", "elements = [128.0, 6_4]"), ("elements = [128, 64]", 'elements = ["128.0", "6_4"]'),
         ("elements = [128, 64]", 'elements = [0x80, "128/2"]'), ("degree = 2 ", "degree = 2.0 "),
         ("degree = 2 ", 'degree = "2" '), ("end = 1884.0", "end = 1_884"), ("end = 1884.0", 'end = "1_884.0"'),
         ("end = 1884.0", 'end = "+1.884e3"'), ("end = 1884.0", 'end = " 3768 / 2 "'),
         ("times = [0.0, 235.0, 471.0, 1884.0]", 'times = ["0:471:3", 1884]'),
         ("times = [0.0, 235.0, 471.0, 1884.0]", "times = 10:50:11"), ("young = 0.7554", 'young = "1 + x"'),
         ("young = 0.7554", "young = 1"), ("max_steps = 1000000", "max_steps = 1e6")]
WRONG = [("viscosity =", "viscosty ="), ("[fluid]", "[fluids]"), ("radius = 0.155", ""), ("[[droplet]]", "[droplet]"),
         ("elements = [128, 64]", "elements = [128.5, 64]"), ("elements = [128, 64]", "elements = [0, 64]"),
         ("elements = [128, 64]", 'elements = "many"'), ("elements = [128, 64]", "elements = 128"),
         ("degree = 2 ", "degree = 4 "), ("degree = 2 ", "degree = 2.5 "), ("end = 1884.0", "end = 0"),
         ("end = 1884.0", 'end = "soon"'), ("end = 1884.0", 'end = "1__884"'), ("end = 1884.0", "end = true"),
         ("end = 1884.0", "end = [1884.0]"), ("end = 1884.0", "# end"), ('"1/256"', "-1.0"), ('"1/256"', '"1/256 mm"'),
         ("temperature = 0.39", "temperature = 1.2"), ("contact_angle = 75.0", "contact_angle = 180"),
         ("poisson = 0.45", "poisson = 0.5"), ('left = "slip"', 'left = "sliding"'), ('name = "first"', "name = 1"),
         ('name = "first"', 'name = "../escape"'), ('name = "first"', 'name = ""'),
         ("box = [[0.7, 0.0], [0.8, 0.125]]", "box = [[0.7, 0.0]]"), ("young = 0.7554", "young = [1]"),
         ("times = [0.0, 235.0, 471.0, 1884.0]", 'times = ["0-471"]'), ("[time]", "[[time]]"),
         ('name = "first"', f'name = "{"a" * 201}"'), ('name = "first"', 'name = ".first"'), ("young = 0.7554", "young = 1e31"),
         ("viscosity = ", "viscosity = 1e-31 #")]


def shown(*words):
    return subprocess.run([softwet, *words], capture_output=True, text=True)


def changed(text, old, new):
    if text.count(old) < 1:
        raise SystemExit(f"the case of init has no '{old}'")
    return text.replace(old, new, 1)


class Judges:
    """Ours, and those that are installed. Each takes or refuses a file."""

    def __init__(self, path):
        self.path, self.schema = path, json.loads(path.read_text())
        self.all = {"the reader of this test": self.ours}
        try:
            import jsonschema
            jsonschema.Draft7Validator.check_schema(self.schema)
            judge = jsonschema.Draft7Validator(self.schema)
            self.all["jsonschema"] = lambda file: list(judge.iter_errors(plain(tomllib.loads(file.read_text()))))
        except ImportError:
            print("no jsonschema: left out")
        self.taplo = shutil.which("taplo")
        if self.taplo:
            self.all["taplo"] = self.by_taplo
        else:
            print("no taplo: left out")

    def ours(self, file):
        return faults(plain(tomllib.loads(file.read_text())), self.schema)

    def by_taplo(self, file):
        done = subprocess.run([self.taplo, "lint", "--no-auto-config", "--schema", self.path.resolve().as_uri(),
                               str(file.resolve())], capture_output=True, text=True)
        return done.stderr if done.returncode else ""

    def take(self, name, file):
        for judge, complaints in self.all.items():
            found = complaints(file)
            check_true(f"{judge} takes {name}", not found, str(found))

    def refuse(self, name, file):
        for judge, complaints in self.all.items():
            check_true(f"{judge} refuses {name}", complaints(file))


# --- init names the schema and writes it ---------------------------------------------------------------------------
shutil.rmtree("work", ignore_errors=True)
folder = pathlib.Path("work")
folder.mkdir()
first = folder / "first.toml"
check_true("init", shown("init", str(first), "--like", "pull").returncode == 0)
text = first.read_text()
path = folder / "softwet.schema.json"
check_true("its first line names the schema", text.splitlines()[0] == f"#:schema {path.name}", text[:80])
check_true("the schema lies beside it", path.read_text() == shown("explain", "--json-schema").stdout)
path.write_text("{}")
check_true("a second case", shown("init", str(folder / "second.toml")).returncode == 0)
check_true("writes the schema again", path.read_text() == shown("explain", "--json-schema").stdout)
judges = Judges(path)
if judges.taplo:
    for name, broken in (("a case", False), ("a wrong case", True)):
        (folder / "third.toml").write_text(changed(text, "degree = 2 ", "degree = 4 ") if broken else text)
        done = subprocess.run([judges.taplo, "lint", "--no-auto-config", "third.toml"], cwd=folder, capture_output=True)
        check_true(f"taplo finds the schema of {name} by its first line", (done.returncode != 0) == broken, str(done))

# --- every case, and every case with all that it leaves out ---------------------------------------------------------
judges.take("the case of init", first)
quantities = folder / "second.toml"  # its keys follow from a table [laboratory]
judges.take("a case of quantities", quantities)
file = folder / "third.toml"
file.write_text(changed(quantities.read_text(), "length = ", "# "))
judges.refuse("quantities without a scale", file)
whole = quantities.read_text()
file.write_text(whole[:whole.index("[laboratory]")] + whole[whole.index("[domain]"):])
judges.refuse("the same case without its quantities", file)
for file in sorted(cases.glob("*.toml")):
    judges.take(file.name, file)
    resolved = folder / file.name
    resolved.write_text(shown("check", "--resolved", str(file)).stdout)
    judges.take(f"{file.name} with its defaults", resolved)

# --- right and wrong inputs: the schema and the program agree -------------------------------------------------------
plain_case = shown("check", "--resolved", str(first)).stdout
for old, new in RIGHT:
    file = folder / "first.toml"
    file.write_text(changed(text, old, new))
    judges.take(new.strip(), file)
    answer = shown("check", "--resolved", str(file))
    check_true(f"softwet takes {new.strip()}", answer.returncode == 0, answer.stderr)
    if "young" not in new and "times" not in new:
        check_true(f"{new.strip()} is the same number", answer.stdout == plain_case)
for old, new in WRONG:
    file.write_text(changed(text, old, new))
    judges.refuse(f"{old} -> {new}", file)
    answer = shown("check", str(file))
    check_true(f"softwet refuses {old} -> {new}", answer.returncode == 1, answer.stderr)

# --- lists of numbers: the schema takes those numbers of entries that the program takes in two or in three dimensions
# ----------
def complaints(text, name, value):
    """What the program says about a key when it has this value."""
    file = folder / "lists.toml"
    file.write_text(text)
    sets = [f"--set={name}={json.dumps(value)}", *(["--set=substrate.prestretch=[]"] if ".gel." in name else [])]
    return [line for line in shown("check", str(file), *sets).stderr.splitlines() if f": {name} = " in line]


bases = {dimension: case_of_lists(dimension) for dimension in (2, 3)}
tried = set()
for name, schema in lists_of(judges.schema):
    shown_name = name.replace("probe[0].box", "probe[1].box")  # a probe has a point or a box
    given = value_of(tomllib.loads(bases[3]), name) or (shown_name != name and [[0.75] * 3] * 2)
    if not given:
        continue
    tried.add(name)
    for count in range(5):
        if (name, count) == ("probe[0].point", 0):  # the schema cannot know that there is no box either
            continue
        value = resized(given, count)
        said = [complaints(text, shown_name, value) for text in bases.values()]
        check_true(f"{name} with {count} entries: the schema takes it where the program does in 2D or 3D",
                   all(said) == bool(faults(value, schema)), str(said))
untried = {name for name, _ in lists_of(judges.schema)} - tried
check_true("all lists of numbers", untried == {"load[0].factor", "output.fields.times", "output.fields.select"}, str(untried))
