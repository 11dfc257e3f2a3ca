#!/usr/bin/env python3
"""Bad input ends with the right exit code, one readable line on stderr, and no output folder.
usage: bad_input.py SOFTWET"""

import pathlib
import resource
import subprocess
import sys
import tempfile

# What is replaced in the case of `softwet init --like pull`, and what the message must contain.
BAD_CASES = {
    "unknown key": ("viscosity =", "viscosty =", ["fluid.viscosty", "fluid.viscosity"]),
    "unknown table": ("[fluid]", "[fluids]", ["fluids", "did you mean"]),
    "missing key": ("radius = 0.155", "", ["droplet[0].radius is missing"]),
    "wrong type": ("elements = [128, 64]", 'elements = "many"', ["domain.elements", "whole numbers"]),
    "out of range": ('"1/256"', "-1.0", ["fluid.viscosity", "(0, inf)"]),
    "no ratio": ('"1/256"', '"1/0"', ["fluid.viscosity", '"1/0"']),
    "broken file": ("[fluid]", "[fluid", ["not TOML"]),
    "thickness": ("thickness = 0.125", "thickness = 0.13", ["substrate.thickness", "0.0078125", "0.125"]),
    "load outside": ("[0.8, 0.125]]", "[0.8, 0.2]]", ["load[0].box", "outside the solid"]),
    "load empty": ("[0.8, 0.125]]", "[0.7, 0.125]]", ["load[0].box", "empty"]),
    "droplet outside": ("centre = [0.5, 0.125]", "centre = [1.5, 0.125]", ["droplet[0].centre", "outside the fluid"]),
    "droplet crosses": ("centre = [0.5, 0.125]", "centre = [0.9, 0.125]", ["droplet[0].radius", "right side"]),
    "angle 180": ("contact_angle = 75.0", "contact_angle = 180.0", ["fluid.contact_angle", "(0, 180)"]),
    "angle -5": ("contact_angle = 75.0", "contact_angle = -5", ["fluid.contact_angle", "(0, 180)"]),
    "zero size": ("size = [1.0, 0.5]", "size = [0.0, 0.5]", ["domain.size", "(0, inf)"]),
    "negative elements": ("elements = [128, 64]", "elements = [128, -64]", ["domain.elements", "[1, 100000]"]),
    "critical": ("temperature = 0.39", "temperature = 1.2", ["fluid.temperature", "below 1"]),
    "half periodic": ('left = "slip"', 'left = "periodic"', ["boundary.left", "boundary.right"]),
    "unsafe name": ('"first"', '"../escape"', ["name", "letters"]),
}

WAVE = '[[wave]]\nfield = "density"\namplitude = 0.3\nmode = [0, 0]\n'
FOLD = '[[wave]]\nfield = "displacement_y"\namplitude = 0.5\nmode = [0, 4]\n'

failures = []


def expect(name, result, code, parts, folder, kept):
    """One line on stderr that contains `parts`, the exit code, and nothing new in the folder."""
    lines = result.stderr.strip().splitlines()
    problems = []
    if result.returncode != code:
        problems.append(f"exit code {result.returncode}, not {code}")
    if len(lines) != 1 or not lines[0].startswith("softwet: error: "):
        problems.append(f"not one line 'softwet: error: ...' but {lines}")
    problems += [f"no '{part}' in: {result.stderr.strip()}" for part in parts if part not in result.stderr]
    left = {str(path.relative_to(folder)) for path in folder.rglob("*")}
    if left != kept:
        problems.append(f"files changed: {sorted(left ^ kept)}")
    print(f"{'FAIL' if problems else 'ok':4}  {name}: {result.stderr.strip()}")
    failures.extend(f"{name}: {problem}" for problem in problems)


class Scene:
    """A fresh folder with case files, and softwet inside it."""

    def __init__(self, softwet, root, files):
        self.softwet = softwet
        self.folder = pathlib.Path(tempfile.mkdtemp(dir=root))
        for name, text in files.items():
            path = self.folder / name
            path.parent.mkdir(parents=True, exist_ok=True)
            path.write_text(text)
        self.kept = {str(path.relative_to(self.folder)) for path in self.folder.rglob("*")}

    def fails(self, name, arguments, code, parts):
        result = subprocess.run([self.softwet, *arguments], cwd=self.folder, capture_output=True, text=True, timeout=900)
        expect(name, result, code, parts, self.folder, self.kept)


def bad_cases(softwet, root, good):
    for name, (old, new, parts) in BAD_CASES.items():
        assert old in good, f"{name}: the initial case has no '{old}'"
        scene = Scene(softwet, root, {"case.toml": good.replace(old, new, 1)})
        for command in ("check", "run"):
            scene.fails(f"{command}, {name}", [command, "case.toml"], 1, parts + ["case.toml"])


def bad_files(softwet, root, good):
    for command in ("check", "run"):
        scene = Scene(softwet, root, {"empty.toml": "", "binary.toml": "\x01\x02\n", "good.toml": good,
                                      "wave.toml": good + WAVE, "fold.toml": good + FOLD})
        # What only the state at the start shows.
        scene.fails(f"{command}, density wave", [command, "wave.toml"], 1,
                    ["the density at the start is 1.17", "at (0.", "[0, 0.999)", "wave[0].amplitude = 0.3", "at most 0.4"])
        scene.fails(f"{command}, displacement wave", [command, "fold.toml"], 1,
                    ["wave[0].amplitude = 0.5", "turn the solid inside out", "smaller amplitudes"])
        scene.fails(f"{command}, empty file", [command, "empty.toml"], 1, ["empty.toml", "softwet init"])
        scene.fails(f"{command}, no TOML", [command, "binary.toml"], 1, ["binary.toml"])
        scene.fails(f"{command}, no file", [command, "missing.toml"], 1, ["missing.toml"])
        scene.fails(f"{command}, a folder", [command, "."], 1, ["folder"])
        scene.fails(f"{command}, --set unknown", [command, "good.toml", "--set", "time.edn=1"], 1, ["time.end"])
        scene.fails(f"{command}, --set value", [command, "good.toml", "--set", "time.end=-1"], 1, ["--set", "(0, inf)"])
        scene.fails(f"{command}, no name", [command, ""], 1, ["case file"])
        scene.fails(f"{command}, --set word", [command, "good.toml", "--set", "time.end"], 1, ["key=value"])


def bad_folders(softwet, root, good):
    old = {"good.toml": good, "out/history.csv": "step\n", "plain": "a file\n"}
    scene = Scene(softwet, root, old)
    scene.fails("init, a name no case can have", ["init", "my case.toml"], 1, ["name", "letters, digits"])
    scene.fails("old result", ["run", "good.toml", "--out", "out"], 1, ["first checkpoint", "--overwrite", "--out"])
    scene.fails("nothing to resume", ["run", "good.toml", "--out", "out", "--resume"], 1, ["first checkpoint", "--overwrite"])
    scene.fails("nothing at all", ["run", "good.toml", "--out", "new", "--resume"], 1, ["no run in 'new'", "--out"])
    scene.fails("both", ["run", "good.toml", "--resume", "--overwrite"], 1, ["--resume", "--overwrite"])
    scene.fails("out is a file", ["run", "good.toml", "--out", "plain"], 3, ["plain", "--out"])
    scene.fails("out under a file", ["run", "good.toml", "--out", "plain/out"], 3, ["plain/out", "--out"])
    scene.fails("init over a file", ["init", "good.toml"], 1, ["good.toml"])
    scene.fails("init nowhere", ["init", "no/such/folder.toml"], 3, ["no/such/folder.toml"])


def too_large(softwet, root, good):
    """More memory than there is is refused with both amounts: before anything is allocated, and before the factors."""
    scene = Scene(softwet, root, {"good.toml": good})
    huge = ["--set", "domain.elements=[20000, 20000]"]
    scene.fails("run, huge mesh", ["run", "good.toml", *huge], 3, ["memory", "GiB", "[20000, 20000]"])
    sized = subprocess.run([softwet, "check", "good.toml", *huge], capture_output=True, text=True, cwd=scene.folder)
    if sized.returncode != 0 or "more than this machine has" not in sized.stdout:
        failures.append(f"check sizes a case larger than this machine: {sized.returncode} {sized.stderr}")
    # A mesh that fits and factors that do not: refused by the count of memory, or by the system while setting up.
    fine = ["--set", "domain.elements=[256, 128]", "--threads", "1", "--out", "new"]
    limit = 150 << 20  # the program takes about 40 MiB, the factors 150
    result = subprocess.run([softwet, "run", "good.toml", *fine], cwd=scene.folder, capture_output=True, text=True,
                            timeout=900, preexec_fn=lambda: resource.setrlimit(resource.RLIMIT_AS, (limit, limit)))
    expect("run, factors beyond the limit", result, 3, ["memory"], scene.folder, scene.kept)


def bad_command_lines(softwet, root):
    scene = Scene(softwet, root, {})
    scene.fails("no command", [], 1, ["--help"])
    scene.fails("unknown command", ["rnu"], 1, ["rnu", "softwet run"])
    scene.fails("no case", ["run"], 1, ["CASE"])
    scene.fails("unknown option", ["run", "case.toml", "--fast"], 1, ["--fast"])
    scene.fails("no threads", ["run", "case.toml", "--threads", "0"], 1, ["--threads"])
    scene.fails("explain", ["explain", "fluid.viscosty"], 1, ["fluid.viscosity"])


def main():
    softwet = str(pathlib.Path(sys.argv[1]).resolve())
    with tempfile.TemporaryDirectory() as root:
        first = pathlib.Path(root) / "first.toml"
        subprocess.run([softwet, "init", str(first), "--like", "pull"], check=True, capture_output=True)
        good = first.read_text()
        bad_cases(softwet, root, good)
        bad_files(softwet, root, good)
        bad_folders(softwet, root, good)
        bad_command_lines(softwet, root)
        too_large(softwet, root, good)
    for failure in failures:
        print(f"bad_input: {failure}", file=sys.stderr)
    sys.exit(1 if failures else 0)


main()
