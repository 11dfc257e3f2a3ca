#!/usr/bin/env python3
"""usage: tests/device/host_code.py [FOLDER] [LOG]      Runs the code of the host of a CUDA build, on a machine without a device.

FOLDER is the build, by default build/cuda, and LOG what nvcc printed, which has the registers of kernels; a kernel that it lacks
counts with 32. `softwet bench` of several scenes runs with a CUDA runtime whose kernels do nothing (the folder cuda). It fails where
the program crashes, where a kernel asks for more than the chip has, and where a call is made that is forbidden while launches are
recorded. Numbers of results are not looked at. What each scene asked of the device is printed. Where there are unit tests beside the
program, those of the launches of explicit steps and of rows of history.csv run too: as many kernels and copies as listed, and one wait; and with
solver.krylov.launch = "graph" one graph, one launch and one wait. Exit code 1: something failed; 77: the program is not made for CUDA."""

import os
import pathlib
import re
import shutil
import signal
import subprocess
import sys
import time

sys.dont_write_bytecode = True
HERE = pathlib.Path(__file__).resolve().parent
ROOT = HERE.parents[1]
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


class Runtime:
    """The runtime in the place of libcudart, and what it has counted."""

    def __init__(self, build, log):
        self.program, self.folder = build / "softwet", build / "host_code"
        self.folder.mkdir(exist_ok=True)
        linked = re.search(r"libcudart\.so\.\d+", output(["ldd", self.program]))
        if not linked:
            print(f"host_code: {self.program} does not use the CUDA runtime as a library")
            sys.exit(77)
        self.make(linked.group())
        self.kernels = self.folder / "kernels.txt"
        self.kernels.write_text("".join(f"{name} {registers} {shared}\n" for name, registers, shared in needs(log)))

    def make(self, name):
        nvcc = shutil.which("nvcc")
        include = pathlib.Path(os.path.realpath(nvcc)).parents[1] / "include" if nvcc else "/usr/local/cuda/include"
        versions = self.folder / "versions"
        versions.write_text(f"{name} {{ global: *; }};\n")
        subprocess.run(["c++", "-O1", "-shared", "-fPIC", "-std=c++17", f"-I{include}", f"-Wl,-soname,{name}",
                        f"-Wl,--version-script={versions}", "-o", self.folder / name, *sorted((HERE / "cuda").glob("*.cpp"))], check=True)
        shutil.copy(self.folder / name, self.folder / "libcuda.so.1")

    def bench(self, case, settings, **environment):
        words = [self.program, "bench", ROOT / "cases" / f"{case}.toml"]
        for setting in settings:
            words += ["--set", setting]
        return self.run(words, environment)

    def test(self, name, **environment):
        """Runs the unit tests of a name."""
        return self.run([self.program.parent / "softwet_unit", f"--gtest_filter={name}"], environment)

    def run(self, words, environment):
        """(exit code or None: stopped, what it printed, {what was counted: how often}, seconds)"""
        report, start = self.folder / "report.txt", time.monotonic()
        report.unlink(missing_ok=True)
        variables = {**os.environ, "LD_LIBRARY_PATH": str(self.folder), "SOFTWET_STUB_REPORT": str(report),
                     "SOFTWET_STUB_KERNELS": str(self.kernels), "OMP_NUM_THREADS": "1", **environment}
        try:
            done = subprocess.run(words, stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True, env=variables,
                                  timeout=LIMIT, cwd=self.folder)
        except subprocess.TimeoutExpired as stopped:
            return None, (stopped.stdout or b"").decode(), {}, LIMIT
        counts = dict(line.split() for line in report.read_text().splitlines()) if report.exists() else {}
        return (done.returncode, done.stdout, {name: int(count) for name, count in counts.items()},
                time.monotonic() - start)


def output(words):
    return subprocess.run(words, capture_output=True, text=True, check=True).stdout


def needs(log):
    """(mangled name, registers, bytes of static shared memory) of each kernel that nvcc printed."""
    name = None
    for line in log.read_text(errors="replace").splitlines() if log else ():
        if found := re.search(r"Compiling entry function '(\w+)'", line):
            name = found.group(1)
        elif (found := re.search(r"Used (\d+) registers", line)) and name:
            shared = re.search(r"(\d+) bytes smem", line)
            yield name, found.group(1), shared.group(1) if shared else 0
            name = None


def problems(scene, code, text, counts):
    """What is wrong with the run of a scene."""
    tail = "\n".join(text.splitlines()[-6:])
    if code is None:
        return [f"not done in {LIMIT} s: {tail}"]
    if code < 0:
        return [f"crashed ({signal.Signals(-code).name}): {tail}"]
    wrong = [f"exit code {code}: {tail}"] if code else []
    wrong += [f"{counts[name]} launches or calls were {name}" for name in ("forbidden", "impossible") if counts.get(name)]
    if not counts.get("launches"):
        wrong.append("nothing was launched")
    if "implicit" in scene and not counts.get("graphs"):
        wrong.append("no graph was launched")
    return wrong


def names_the_kernel(runtime):
    """A chip with too little memory for the teams that were compiled: the error names the kernel, and no setting of the case."""
    case, settings = SCENES["2D rigid, explicit"]
    code, text, _, _ = runtime.bench(case, settings, SOFTWET_STUB_SHARED="16384")
    last = text.splitlines()[-1] if text else ""
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
    build = pathlib.Path(sys.argv[1] if len(sys.argv) > 1 else ROOT / "build/cuda").resolve()
    log = pathlib.Path(sys.argv[2]) if len(sys.argv) > 2 else None
    runtime, failed = Runtime(build, log), 0
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
    if not (build / "softwet_unit").exists():
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
