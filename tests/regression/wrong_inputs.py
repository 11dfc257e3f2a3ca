#!/usr/bin/env python3
"""Wrong inputs, each answered with its place, the value, what may stand there and what to write instead.
usage: wrong_inputs.py SOFTWET"""

import argparse
import pathlib
import subprocess
import sys
import tempfile

# One line of the case of `softwet init --like pull` is replaced by another; the answer contains the parts.
LINES = [
    # syntax
    ('viscosity = "1/256"', 'viscosity = 1/256', ["fluid.viscosity = 1/256", 'viscosity = "1/256"']),
    ('force = [0.16215, 0.0]', 'force = [1/8, 0.0]', ["load[0].force", '"1/8"']),
    ('contact_angle = 75.0', 'contact_angle = 75,0', ["fluid.contact_angle = 75,0", "write contact_angle = 75.0"]),
    ('temperature = 0.39', 'temperature = .39', ["fluid.temperature = .39", "write temperature = 0.39"]),
    ('radius = 0.155', 'radius = 155 um', ["droplet[0].radius = 155 um", "no units", "softwet units"]),
    ('contact_angle = 75.0', 'contact_angle = 75°', ["fluid.contact_angle", "no units"]),
    ('left = "slip"', 'left = slip', ["boundary.left = slip", 'left = "slip"']),
    ('ramp = 5.0', 'ramp =', ["load[0].ramp", "no value"]),
    ('ramp = 5.0', 'ramp: 5.0', ["load[0].ramp", "write ramp = 5.0"]),
    ('[fluid]', '[fluid', ["not TOML", "softwet init"]),
    ('name = "first"', 'name = "first', ["not TOML"]),
    # names
    ('viscosity =', 'viscosty =', ["fluid.viscosty", "did you mean fluid.viscosity"]),
    ('viscosity =', 'magnetism = 1\nviscosity =', ["fluid.magnetism = 1", "[fluid] has the keys viscosity"]),
    ('viscosity =', 'density = 1\nviscosity =', ["fluid.density", "density is a key of [substrate]"]),
    ('contact_angle =', 'angle =', ["fluid.angle", "did you mean fluid.contact_angle"]),
    ('young =', 'model = "neo_hooke"\nyoung =', ["substrate.model", "[substrate] has the keys thickness"]),
    ('young =', 'young_modulus =', ["substrate.young_modulus", "did you mean substrate.young"]),
    ('[fluid]', '[fluids]', ["fluids", "did you mean the table [fluid]"]),
    ('[boundary]', '[walls]', ["walls", "the tables are [domain]"]),
    ('[[load]]', '[load]', ["load", "[[load]]"]),
    ('[[droplet]]', '[[drops]]', ["drops", "the tables are"]),
    ('[fluid]', '[[fluid]]', ["fluid", "appears once"]),
    ('name = "first"', 'name = "first"\nload = { box = [[0.7, 0.0], [0.8, 0.1]] }', ["load", "[[load]]"]),
    ('viscosity = "1/256"', 'viscosity = 0.1\nviscosity = 0.2', ["viscosity", "appears twice"]),
    # missing
    ('radius = 0.155', '', ["droplet[0].radius is missing", "radius = 0.155"]),
    ('end = 1884.0', '', ["time.end is missing"]),
    ('size = [1.0, 0.5]', '', ["domain.size is missing"]),
    # kinds
    ('elements = [128, 64]', 'elements = "many"', ["domain.elements", "whole numbers"]),
    ('elements = [128, 64]', 'elements = [128.5, 64]', ["domain.elements", "whole numbers"]),
    ('elements = [128, 64]', 'elements = 128', ["domain.elements", "list of whole numbers"]),
    ('velocity = []', 'velocity = -0.1', ["droplet[0].velocity", "list of numbers"]),
    ('radius = 0.155', 'radius = true', ["droplet[0].radius = true", "number"]),
    ('radius = 0.155', 'radius = "0,155"', ["droplet[0].radius", "write radius = 0.155"]),
    ('viscosity = "1/256"', 'viscosity = "1/0"', ['"1/0"', "(0, inf)"]),
    ('box = [[0.7, 0.0], [0.8, 0.125]]', 'box = [0.7, 0.8]', ["load[0].box", "[[lower corner], [upper corner]]"]),
    ('top = "no_slip"', 'top = "noslip"', ["boundary.top", '"no_slip"']),
    ('top = "no_slip"', 'top = "wall"', ["boundary.top", "one of"]),
    ('preconditioner = "automatic"', 'preconditioner = "umfpack"', ["solver.krylov.preconditioner", '"umfpack"',
     'write krylov.preconditioner = "lu", which computes in double precision']),
    ('preconditioner = "automatic"', 'preconditioner = "lux"', ["solver.krylov.preconditioner", 'did you mean "lu"?']),
    ('name = "first"', 'name = 7', ["name = 7", "text"]),
    # ranges
    ('velocity = []', 'velocity = [0.0, inf]', ["droplet[0].velocity", "inf"]),
    ('radius = 0.155', 'radius = nan', ["droplet[0].radius = nan", "(0, inf)"]),
    ('radius = 0.155', 'radius = -0.1', ["droplet[0].radius = -0.1", "(0, inf)"]),
    ('young = 0.7554', 'young = 1e300', ["substrate.young", "1e-30 and 1e+30"]),
    ('young = 0.7554', 'young = 0', ["substrate.young = 0", "(0, inf)"]),
    ('temperature = 0.39', 'temperature = 1.2', ["fluid.temperature = 1.2", "[0.3, 1)", "below 1"]),
    ('temperature = 0.39', 'temperature = 293.15', ["fluid.temperature", "[0.3, 1)"]),
    ('contact_angle = 75.0', 'contact_angle = 180', ["fluid.contact_angle = 180", "(0, 180)"]),
    ('contact_angle = 75.0', 'contact_angle = -5', ["fluid.contact_angle = -5", "(0, 180)"]),
    ('poisson = 0.45', 'poisson = 0.5', ["substrate.poisson = 0.5", "(-1, 0.5)", "0.49"]),
    ('degree = 2', 'degree = 4', ["domain.degree = 4", "[2, 3]"]),
    ('ramp = 5.0', 'ramp = -5.0', ["load[0].ramp = -5", "[0, inf)"]),
    ('start = 30.0', 'start = -1', ["load[0].start = -1", "[0, inf)"]),
    ('end = 1884.0', 'end = 0', ["time.end = 0", "(0, inf)"]),
    ('elements = [128, 64]', 'elements = [128, 0]', ["domain.elements", "[1, 100000]"]),
    # expressions and tables
    ('young = 0.7554', 'young = "1 + 2*foo"', ['substrate.young = "1 + 2*foo"', "column 7", "'foo' is not known", "Lx"]),
    ('young = 0.7554', 'young = "0.5 + z"', ["substrate.young", "column 7", "'z' is not known"]),
    ('young = 0.7554', 'young = "2x"', ["substrate.young", "column 2", "2*x"]),
    ('young = 0.7554', 'young = "1 - x"', ["substrate.young", "is 0 at (1, 0)", "(0, inf)"]),
    ('young = 0.7554', 'young = "0,5"', ["substrate.young", "write young = 0.5"]),
    ('young = 0.7554', 'young = "stiffness.csv"', ["substrate.young", "stiffness.csv cannot be read", "No such file"]),
    ('contact_angle = 75.0', 'contact_angle = "75 degrees"', ["fluid.contact_angle", "column 4", "'degrees'"]),
    ('contact_angle = 75.0', 'contact_angle = "90 + 100*x"', ["fluid.contact_angle", "at (0.902344, 0.125)", "(0, 180)"]),
    ('factor = 1', 'factor = "sin(x)"', ["load[0].factor", "column 5", "known are t"]),
    ('factor = 1', 'factor = "sqrt(1 - t)"', ["load[0].factor", "nan at t = "]),
    ('[[load]]', '[initial]\ndensity = "0.1 + x"\n[[load]]', ["initial.density", "(0, 0.999]"]),
    ('[[load]]', '[initial]\nvelocity = ["x"]\n[[load]]', ["initial.velocity", "must be 2 numbers"]),
    # what does not fit together
    ('size = [1.0, 0.5]', 'size = [1.0, 0.5, 1.0, 1.0]', ["domain.size", "2 numbers (2D) or 3 (3D)"]),
    ('size = [1.0, 0.5]', 'size = [1.0, 1.0, 0.5]', ["domain.elements", "must be 3 numbers"]),
    ('elements = [128, 64]', 'elements = [100000, 100000]', ["domain.elements", "fewer elements"]),
    ('thickness = 0.125', 'thickness = 0.13', ["substrate.thickness = 0.13", "0.125 or 0.1328125"]),
    ('joint = 0', 'joint = 0.05', ["substrate.joint = 0.05", "write joint = 0.046875"]),
    ('thickness = 0.125', 'thickness = 0.5', ["substrate.thickness", "(0, 0.5)"]),
    ('[0.8, 0.125]]', '[0.8, 0.2]]', ["load[0].box", "outside the solid"]),
    ('[0.8, 0.125]]', '[0.7, 0.125]]', ["load[0].box", "empty along axis 0"]),
    ('force = [0.16215, 0.0]', 'force = [0.16215]', ["load[0].force", "2 numbers"]),
    ('centre = [0.5, 0.125]', 'centre = [0,5, 0,125]', ["droplet[0].centre", "decimal numbers have a point"]),
    ('centre = [0.5, 0.125]', 'centre = [1.5, 0.125]', ["droplet[0].centre", "outside the fluid"]),
    ('centre = [0.5, 0.125]', 'centre = [0.5, 0.1]', ["droplet[0].centre", "[0.125, 0.5]"]),
    ('centre = [0.5, 0.125]', 'centre = [0.9, 0.125]', ["droplet[0].radius", "right side", "at most"]),
    ('velocity = []', 'velocity = [-0.1]', ["droplet[0].velocity", "must be 2 numbers", "not 1"]),
    ('velocity = []', 'velocity = [0,0, -0,1]', ["droplet[0].velocity", "decimal numbers have a point"]),
    ('velocity = []', 'speed = [0.0, -0.1]', ["droplet[0].speed", "[[droplet]] has the keys"]),
    ('right = "slip"', 'right = "periodic"', ["boundary.right", 'boundary.left = "periodic"']),
    ('right = "slip"', 'right = "free"', ["boundary.right", "closed to mass"]),
    ('right = "slip"', 'front = "slip"', ["boundary.front", "3D only"]),
    ('times = [0.0, 235.0', 'times = [235.0, 0.0', ["output.fields.times", "increase"]),
    ('times = [0.0, 235.0', 'times = [-31.0, 235.0', ["output.fields.times", "at least -30"]),
    ('name = "first"', 'name = "../first"', ["name", "letters, digits"]),
    # probes
    ('[[load]]', '[[probe]]\nname = "p"\nquantity = "rho"\npoint = [0.5, 0.2]\n[[load]]', ["probe[0].quantity", '"density"']),
    ('[[load]]', '[[probe]]\nname = "p"\nquantity = "density"\n[[load]]', ["probe[0].point", "or box is missing"]),
    ('[[load]]', '[[probe]]\nname = "mass"\nquantity = "density"\npoint = [0.5, 0.2]\n[[load]]',
     ["probe[0].name", "has already"]),
    ('[[load]]', '[[probe]]\nname = "p"\nquantity = "density"\npoint = [0.5, 0.1]\n[[load]]',
     ["probe[0].point", "below the wall at 0.125"]),
    ('[[load]]', '[[probe]]\nname = "p"\nquantity = "speed"\noperation = "max"\nbox = [[0.5, 0.1], [0.5, 0.2]]\n[[load]]',
     ["probe[0].box", "both sides of the wall"]),
    ('[[load]]', '[[probe]]\nname = "p"\nquantity = "density"\nbox = [[0.5, 0.2], [0.6, 0.3]]\n[[load]]',
     ["probe[0].box", "belongs to a point", '"mean"']),
    ('[[load]]', '[[probe]]\nname = "p"\nquantity = "velocity_z"\npoint = [0.5, 0.2]\n[[load]]',
     ["probe[0].quantity", "3D only"]),
]

# Command lines, on the case as it is.
COMMANDS = [
    (["check", "case.toml", "--set", "fluid.viscosity=-1"], ["--set fluid.viscosity=-1", "(0, inf)"]),
    (["check", "case.toml", "--set", "fluid.viscosity=0,5"], ["write viscosity = 0.5"]),
    (["check", "case.toml", "--set", "gravity=9.81"], ["gravity = 9.81", "did you mean fluid.gravity"]),
    (["check", "case.toml", "--set", "magnetism=9.81"], ["magnetism = 9.81", "the tables are"]),
    (["check", "case.toml", "--set", "time.edn=1"], ["did you mean time.end"]),
    (["check", "case.toml", "--set", "load[1].ramp=1"], ["has 1 of these tables"]),
    (["check", "case.toml", "--set", "substrate.gel={ exponent = 1/2 }"], ["substrate.gel", "is no TOML", "in double quotes"]),
    (["check", "case.toml", "--set", "substrate.gel=0.5"], ["substrate.gel = 0.5", "is a table", "--set 'substrate.gel={"]),
    (["check", "case.toml", "--set", f"name={'a' * 201}"], ["has 201 letters", "200 at most"]),
    (["check", "case.toml", "--set", "load[x].ramp=1"], ["load[0].ramp=5"]),
    (["check", "case.toml", "--set", "time.end"], ["write --set key=value"]),
    (["check", "case.toml", "--set", "load[0].start=0", "--set", "output.fields.times=[-1]"], ["must be at least 0,"]),
    (["check", "missing.toml"], ["missing.toml", "No such file"]),
    (["check", "."], ["it is a folder"]),
    (["check", "/dev/zero"], ["longer than 16 MiB"]),
    (["check"], ["CASE"]),
    (["explain", "angel"], ["did you mean substrate.fibre.angle"]),
    (["explain", "contact"], ["did you mean fluid.contact_angle"]),
    (["explain", "gravty"], ["did you mean fluid.gravity"]),
    (["explain", "magnetism"], ["the tables are"]),
    (["run", "case.toml", "--thread", "2"], ["--thread", "did you mean --threads"]),
    (["run", "case.toml", "--threads", "0"], ["--threads"]),
    (["run", "case.toml", "--threads", "600"], ["--threads", "512"]),
    (["run", "case.toml", "--fast"], ["--fast", "--help"]),
    (["chekc", "case.toml"], ["did you mean 'softwet check'"]),
    (["simulate", "case.toml"], ["unknown command 'simulate'"]),
]

MANY = ["size = [1.0, 1.0, 0.5]"]  # the one mistake that is several: all other keys are as in a 2D case
ERROR = "softwet: error: "


class Inputs:
    """A folder with the case of `softwet init --like pull`, and the answers to what is wrong."""

    def __init__(self, softwet, folder):
        self.softwet, self.folder = softwet, pathlib.Path(folder)
        self.answer(["init", "first.toml", "--like", "pull"])
        self.case = (self.folder / "first.toml").read_text()

    def answer(self, words):
        return subprocess.run([self.softwet, *words], cwd=self.folder, capture_output=True, text=True, timeout=900)

    def all(self):
        """(input as text, result, parts) of each wrong input."""
        for old, new, parts in LINES:
            if self.case.count(old) < 1:
                sys.exit(f"wrong_inputs: the case of init has no '{old}'")
            (self.folder / "case.toml").write_text(self.case.replace(old, new, 1))
            yield new, self.answer(["check", "case.toml"]), parts
        (self.folder / "case.toml").write_text(self.case)
        for words, parts in COMMANDS:
            yield "softwet " + " ".join(words), self.answer(words), parts


def problems_of(what, result, parts):
    lines = result.stderr.splitlines()
    problems = [] if result.returncode == 1 else [f"exit code {result.returncode}, not 1"]
    problems += [f"not '{ERROR}...': {line}" for line in lines if not line.startswith(ERROR)]
    problems += [f"{len(lines)} lines for one mistake"] if len(lines) != 1 and what not in MANY else []
    return problems + [f"no '{part}'" for part in parts if part not in result.stderr]


def main():
    parser = argparse.ArgumentParser()
    parser.add_argument("softwet", type=pathlib.Path)
    arguments = parser.parse_args()
    with tempfile.TemporaryDirectory() as folder:
        answers = list(Inputs(str(arguments.softwet.resolve()), folder).all())
    failures = 0
    for what, result, parts in answers:
        problems = problems_of(what, result, parts)
        failures += bool(problems)
        print(f"{'FAIL' if problems else 'ok':4}  {what!r}: {result.stderr.strip()} {'; '.join(problems)}")
    print(f"{len(answers)} wrong inputs, {failures} without the right answer")
    sys.exit(1 if failures or len(answers) < 60 else 0)


main()
