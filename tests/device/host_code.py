#!/usr/bin/env python3
"""usage: tests/device/host_code.py [FOLDER]      Runs the code of the host of a CUDA build, on a machine without a device.

FOLDER is the build, by default build/cuda. `softwet bench` of several scenes runs with the CUDA runtime of tests/device/emulate, whose
launches are checked and counted here and kernels are not executed. It fails where the program crashes, where a kernel asks for more than
the chip has, and where a call is made that is forbidden while launches are recorded. Numbers of results are not looked at. What each
scene asked of the device is printed. Where there are unit tests beside the program, those of the launches of explicit steps and of rows
of history.csv run too: as many kernels and copies as listed, and one wait; and with solver.krylov.launch = "graph" one graph, one launch
and one wait. Exit code 1: something failed; 77: the program is not made for CUDA."""

import pathlib
import re
import signal
import sys

sys.dont_write_bytecode = True
from scenes import Build, Runtime, run  # noqa: E402

ROOT = pathlib.Path(__file__).resolve().parents[2]
LIMIT = 300  # seconds for a scene

FLAT, FILM = ["domain.elements=[16,12]"], ["domain.elements=[8,8,6]"]
# name: case, settings
SCENES = {
    "2D rigid, explicit": ("impact_rigid_2d", FLAT + ["fluid.capillarity=1/24"]),
    "2D soft, implicit": ("tensotaxis_pull_2d", FLAT + ["fluid.capillarity=1/16"]),
    "3D rigid, explicit": ("impact_rigid_3d", FILM + ["fluid.capillarity=1/8", "domain.quadrature=full"]),
    "3D soft, explicit": ("impact_soft_3d", FILM + ["fluid.capillarity=1/8", "domain.quadrature=full"]),
    "3D soft, implicit": ("fig4_needle_3d_small", ["domain.elements=[8,8,10]", "fluid.capillarity=0.2"]),
}


class Bench:
    """Runs the programs of a build without executing kernels, and reads what the runtime has counted."""

    def __init__(self, build):
        self.build, self.runtime = build, Runtime(build)
        self.folder = build.folder / "host_code"
        self.folder.mkdir(exist_ok=True)

    def bench(self, case, settings, **environment):
        words = [self.build.program, "bench", ROOT / "cases" / f"{case}.toml"]
        for setting in settings:
            words += ["--set", setting]
        return self.run(words, environment)

    def test(self, name, **environment):
        """Runs the unit tests of a name."""
        return self.run([self.build.folder / "softwet_unit", f"--gtest_filter={name}"], environment)

    def run(self, words, environment):
        """(exit code or None: stopped, what it printed, {what was counted: how often}, seconds)"""
        report = self.folder / "report.txt"
        report.unlink(missing_ok=True)
        variables = self.runtime.environment(EMU_EXECUTE="0", EMU_FILL="0", EMU_EXIT="0", EMU_REPORT="1", EMU_REPORT_FILE=str(report),
                                             **environment)
        code, text, seconds = run(words, variables, LIMIT, self.folder)
        counts = re.findall(r"^calls: (.*) (\d+)$", report.read_text(), re.MULTILINE) if report.exists() else []
        return code, text, {name: int(count) for name, count in counts}, seconds


def problems(scene, code, text, counts):
    """What is wrong with the run of a scene."""
    tail = "\n".join(text.splitlines()[-6:])
    if code is None:
        return [f"not done in {LIMIT} s: {tail}"]
    if code < 0:
        return [f"crashed ({signal.Signals(-code).name}): {tail}"]
    wrong = [f"exit code {code}: {tail}"] if code else []
    wrong += [f"{name}: {number}" for name, number in counts.items() if name.startswith(("forbidden", "impossible", "faults"))]
    if not counts.get("launches"):
        wrong.append("nothing was launched")
    if "implicit" in scene and not counts.get("graphs"):
        wrong.append("no graph was launched")
    return wrong


def names_the_kernel(runtime):
    """A chip with too little memory for the teams that were compiled: the error names the kernel, and no setting of the case."""
    case, settings = SCENES["2D rigid, explicit"]
    code, text, _, _ = runtime.bench(case, settings, EMU_SHARED="16384")
    last = next((line for line in reversed(text.splitlines()) if line.startswith("softwet: ")), "")
    good = code == 3 and "softwet::" in last and "threads" in last and "softwet check" not in last
    return [] if good else [f"a kernel that does not start: exit code {code}: {last}"]


def launches_of_steps(runtime):
    """The unit tests that count what an explicit step and a row start, by their names in the code of a device."""
    code, text, counts, _ = runtime.test("Launches.*")
    passed = re.search(r"\[  PASSED  \] (\d+) test", text)
    number = int(passed.group(1)) if passed else 0
    wrong = problems("launches", code, text, counts)
    if code == 0 and number == 0:
        wrong.append("no test counted launches")
    return wrong, f"{number} tests passed"


def calls_of_recorded_steps(runtime):
    """What an explicit step that is recorded asks of a device: one graph, the launch that stores the accepted state, and one wait. It is
    the difference between runs with unlike numbers of steps."""
    expected, few, many, wrong, found = {"graphs": 1, "launches": 1, "copies": 0, "waits": 1}, 10, 30, [], []
    for scene in ("OfARigidWall", "OfASoftLayer"):
        counts = []
        for steps in (few, many):
            code, text, count, _ = runtime.test(f"RecordedLaunches.{scene}", SOFTWET_TEST_STEPS=str(steps))
            wrong += problems("launches", code, text, count)
            if "[  PASSED  ] 1 test" not in text:
                wrong.append(f"RecordedLaunches.{scene} did not run")
            counts.append(count)
        of_step = {name: (counts[1].get(name, 0) - counts[0].get(name, 0)) / (many - few) for name in expected}
        found.append(f"{scene}: " + ", ".join(f"{n:g} {name}" for name, n in of_step.items()))
        if of_step != expected:
            wrong.append(f"{found[-1]} in a step, not {expected}")
    return wrong, "; ".join(found)


def main():
    if len(sys.argv) > 1 and sys.argv[1] in ("-h", "--help"):
        print(__doc__)
        return 0
    build = Build(sys.argv[1] if len(sys.argv) > 1 else ROOT / "build/cuda")
    runtime, failed = Bench(build), 0
    for scene, (case, settings) in SCENES.items():
        code, text, counts, seconds = runtime.bench(case, settings)
        wrong = problems(scene, code, text, counts)
        failed += bool(wrong)
        print(f"host_code: {scene}: {', '.join(f'{n} {name}' for name, n in counts.items())}; {seconds:.0f} s", flush=True)
        for problem in wrong:
            print(f"host_code: {scene}: FAILED: {problem}", flush=True)
    for problem in names_the_kernel(runtime):
        failed += 1
        print(f"host_code: FAILED: {problem}")
    of_steps = {"launches of explicit steps and of rows": launches_of_steps, "explicit steps that are recorded": calls_of_recorded_steps}
    if not (build.folder / "softwet_unit").exists():
        print("host_code: explicit steps: there are no unit tests beside the program")
        of_steps = {}
    for name, check in of_steps.items():
        wrong, found = check(runtime)
        failed += bool(wrong)
        print(f"host_code: {name}: {found}")
        for problem in wrong:
            print(f"host_code: {name}: FAILED: {problem}")
    print(f"host_code: {len(SCENES) + 1 + len(of_steps)} checks, {failed} failed")
    return 1 if failed else 0


if __name__ == "__main__":
    sys.exit(main())
