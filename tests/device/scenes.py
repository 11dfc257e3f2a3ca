"""Small scenes of all cases, a CUDA build, and the runtime that executes its kernels on a processor: for emulated.py, counts.py and
host_code.py."""

import collections
import os
import pathlib
import re
import subprocess
import sys
import time
import tomllib

HERE = pathlib.Path(__file__).resolve().parent
CASES = HERE.parents[1] / "cases"

# What columns of explicit scenes may differ by (emulated.py).
EXPLICIT = 1e-12
# With these tolerances of Newton's method another preconditioner or another precision of the linear solves changes results of a processor
# by up to 1.4e-7 (tensotaxis_pull_2d, lu and schwarz).
NEWTON, IMPLICIT = ["solver.newton.rtol=1e-8", "solver.newton.atol=1e-14"], 1e-6

Scene = collections.namedtuple("Scene", "case settings steps allowed fast")
FULL, REDUCED = "domain.quadrature=full", "domain.quadrature=reduced"
GRAPH, LUMPED, CONSISTENT = "solver.krylov.launch=graph", "time.mass=lumped", "time.mass=consistent"
DOUBLE, SCHWARZ = "solver.precision=double", "solver.krylov.preconditioner=schwarz"
PULL, NEEDLE = "tensotaxis_pull_2d", "fig4_needle_3d_small"
# Small scenes need these too: a box of fine elements around fewer of them; steps below their bound, which depends on slopes of a density
# that is almost uniform, so that rounding changes it by 1e-11.
FURTHER = {"style_2013_axisymmetric": ["domain.grading.box=[[0,0],[0.5,0.5]]"], "impact_rigid_3d": ["time.dt_max=0.01"]}
# case: settings of a variant, steps (0: as many as the case itself), whether it is in the selection
VARIANTS = {
    "impact_rigid_2d": [([FULL], 0, True), ([REDUCED], 0, True), ([FULL, GRAPH], 0, True), ([LUMPED], 0, False),
                        ([CONSISTENT], 4, False), (["time.scheme=ssp_rk3"], 4, False), (["time.scheme=rkl2"], 4, False)],
    "impact_soft_2d": [([FULL], 0, True), ([REDUCED], 0, True), ([GRAPH], 0, False)],
    "impact_rigid_3d": [([FULL], 0, True), ([REDUCED], 0, False), ([GRAPH], 0, False)],
    "impact_soft_3d": [([FULL], 0, True), ([REDUCED], 0, False), ([GRAPH], 0, False)],
    PULL: [([FULL], 0, True), ([REDUCED], 0, False), ([GRAPH], 0, False), ([DOUBLE], 0, False), ([SCHWARZ], 0, False)],
    NEEDLE: [([FULL], 0, True), ([REDUCED], 0, False), ([DOUBLE], 0, False)],
    "impact_axisymmetric": [([FULL], 0, True)],
    "sessile_soft_axisymmetric": [([FULL], 0, True)],
    "power_law_gel_2d": [([FULL], 0, True)],
}


class Build:
    """A build folder: its program, and what was compiled."""

    def __init__(self, folder):
        self.folder = pathlib.Path(folder).resolve()
        self.program = self.folder / "softwet"
        text = (self.folder / "CMakeCache.txt").read_text()
        options = dict(re.findall(r"^(SOFTWET_\w+):\w+=(.*)$", text, re.MULTILINE))
        self.configurations = options["SOFTWET_CONFIGURATIONS"].split(";")
        self.reduced = options.get("SOFTWET_REDUCED_QUADRATURE", "ON") in ("ON", "TRUE", "1")


class Runtime:
    """The CUDA runtime that executes kernels on a processor, in the folder emulate of the build."""

    def __init__(self, build):
        self.folder = build.folder / "emulate"
        libraries = subprocess.run(["ldd", build.program], capture_output=True, text=True).stdout
        if not re.search(r"libcudart\.so\.\d+", libraries):
            sys.exit(leave(f"{build.program} does not use the CUDA runtime as a library"))
        made = subprocess.run([HERE / "emulate/build", self.folder, "--no-tests"], capture_output=True, text=True)
        if made.returncode == 77:
            sys.exit(leave("there is no nvcc here"))
        if made.returncode:
            sys.exit(f"emulated: the runtime was not built: {made.stdout}{made.stderr}")

    def environment(self, **variables):
        return {**os.environ, "LD_LIBRARY_PATH": str(self.folder), **variables}


def leave(why):
    print(f"{pathlib.Path(sys.argv[0]).stem}: left out: {why}")
    return 77


def run(words, environment, limit, folder=None):
    """(exit code or None: stopped, what it printed, seconds)"""
    start = time.monotonic()
    try:
        done = subprocess.run([str(word) for word in words], stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True,
                              errors="replace", timeout=limit, cwd=folder, env={**environment, "OMP_NUM_THREADS": "1"})
    except subprocess.TimeoutExpired as stopped:
        return None, (stopped.stdout or b"").decode(errors="replace"), limit
    return done.returncode, done.stdout, time.monotonic() - start


def small(case):
    """Settings that give a case few elements: 12 along the longest side in 2D and 5 in 3D, and along the last axis as many as the
    thickness of the solid asks for."""
    values = tomllib.loads((CASES / f"{case}.toml").read_text())
    size = values["domain"]["size"]
    most = 12 if len(size) == 2 else 5
    width = max(size) / most
    elements = [max(4, round(length / width)) for length in size]
    thickness = values.get("substrate", {}).get("thickness")
    if thickness:
        share = thickness / size[-1]
        elements[-1] = next(n for n in range(elements[-1], 60) if abs(n * share - round(n * share)) < 1e-9)
    settings = [f"domain.elements={elements}", *FURTHER.get(case, [])]
    if "capillarity" in values.get("fluid", {}):
        settings.append(f"fluid.capillarity={width * (1 if len(size) == 2 else 1.5):.4f}")
    return settings


def make_scenes():
    """{name: scene}: each case with its defaults, and the variants."""
    scenes = {}
    for path in sorted(CASES.glob("*.toml")):
        case, values = path.stem, tomllib.loads(path.read_text())
        explicit = values.get("time", {}).get("scheme") == "kick_drift"
        flat = len(values["domain"]["size"]) == 2
        steps, allowed = (10 if flat else 3, EXPLICIT) if explicit else (2 if flat else 1, IMPLICIT)
        own = small(case) + ([] if explicit else NEWTON)
        scenes[case] = Scene(case, own, steps, allowed, False)
        for settings, other, fast in VARIANTS.get(case, ()):
            name = ", ".join([case] + [setting.split("=")[1] for setting in settings])
            solved = IMPLICIT if CONSISTENT in settings else allowed
            scenes[name] = Scene(case, own + settings, other or steps, solved, fast)
    return scenes


def lacks(scene, cuda, release):
    """What one of the builds lacks for a scene, or None."""
    domain = tomllib.loads((CASES / f"{scene.case}.toml").read_text())["domain"]
    flat = "rz" if domain.get("coordinates") == "axisymmetric" else f"{len(domain['size'])}x"
    configuration = f"{flat}{domain.get('degree', 2)}"
    for build in (cuda, release):
        if configuration not in build.configurations:
            return f"configuration {configuration} in {build.folder}"
        if REDUCED in scene.settings and not build.reduced:
            return f"reduced quadrature in {build.folder}"
    return None
