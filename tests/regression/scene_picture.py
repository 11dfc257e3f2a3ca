#!/usr/bin/env python3
"""The picture of a scene before it is computed: `softwet check --picture`, tools/plot CASE.toml, and what they draw,
which is the first state that `softwet check --scene` writes. usage: scene_picture.py SOFTWET"""

import pathlib
import shutil
import subprocess
import sys

import numpy
from _scene import PULL, cases, check, check_true, environment, run, softwet, tools, write_box

try:
    import matplotlib.pyplot as plt
except ImportError:
    sys.exit(print("no matplotlib: no picture is made here"))

from softwet._drawing import scene_picture  # noqa: E402

PULL_CASE = str(cases / "tensotaxis_pull_2d.toml")
SETS = [word for setting in PULL for word in ("--set", setting)]


def start(*words, code=0):
    done = subprocess.run(list(map(str, words)), capture_output=True, text=True, timeout=900, env=environment)
    check_true(f"{pathlib.Path(words[0]).name} {words[1]}: exit code {code}", done.returncode == code and
               "Traceback" not in done.stderr, f"{done.returncode} {done.stderr}")
    return done


def picture(name, *words):
    pathlib.Path(name).unlink(missing_ok=True)
    done = start(*words)
    check_true(f"{name} is a picture", pathlib.Path(name).read_bytes()[:8] == b"\x89PNG\r\n\x1a\n", done.stdout)
    return done


def texts(state):
    """All that stands in the picture of a state."""
    figure = plt.figure()
    scene_picture.draw(figure, state)
    figure.canvas.draw()
    return {text.get_text() for text in figure.findobj(plt.Text)}


# --- the first state -------------------------------------------------------------------------------------------------
for folder in ("state", "first", "stripes", "deep"):
    shutil.rmtree(folder, ignore_errors=True)
start(softwet, "check", PULL_CASE, *SETS, "--scene", "state")
state = scene_picture.FirstState("state")
run("tensotaxis_pull_2d", "first", [*PULL, "output.fields.times=[-2]", "time.max_steps=1"])
same = scene_picture.softwet.open("first").fields(-2)
check("the state is that with which a run begins", abs(state.fields("fluid")["density"] - same["density"]).max(), 0.0)
check_true("its time", state.time == -2.0)
check("lines of the mesh", max(abs(lines - numpy.linspace(0, length, count + 1)).max() for lines, length, count in
                               zip(state.mesh_lines(), (1.0, 0.5), (32, 16))), 1e-12)
check_true("a mesh of equal elements is not plotted", not state.is_graded)
told = texts(state)
check_true("sides in words", {"left: slip", "right: slip", "bottom: slip", "top: no slip"} <= told, str(told))
check_true("loads by their numbers", " 0" in told)
start(softwet, "check", PULL_CASE, *SETS, "--scene", "first", code=1)  # there is a result

# --- given fields ----------------------------------------------------------------------------------------------------
varying = [*SETS, "--set", "substrate.young=0.5 + x*y", "--set", "fluid.contact_angle=60 + 30*sin(2*pi*x)"]
start(softwet, "check", PULL_CASE, *varying, "--scene", "stripes")
state = scene_picture.FirstState("stripes")
(x, y, z), young = state.samples["substrate.young"]
check_true("where Young's modulus is given", (x[0], x[-1], y[0], y[-1], z) == (0, 1, 0, 0.125, [0]))
check("its values", abs(young[0] - (0.5 + numpy.outer(y, x))).max(), 1e-12)
(x, y, _), angle = state.samples["fluid.contact_angle"]
check("the contact angle along the wall", abs(angle[0, 0] - 60 - 30 * numpy.sin(2 * numpy.pi * numpy.array(x))).max() +
      abs(y[0] - 0.125), 1e-10)
told = texts(state)
check_true("scales of colours", set(scene_picture.SYMBOLS.values()) <= told, str(told))

# --- a mesh that is graded: the same state with its points moved ----------------------------------------------------
class Graded(scene_picture.FirstState):
    def mesh_lines(self):
        return [lines**2 for lines in super().mesh_lines()]


state = Graded("stripes")
figure = plt.figure()
axes = scene_picture.draw(figure, state)[0]
drawn = sorted(line.get_xdata()[0] for line in axes.lines if len(set(line.get_xdata())) == 1)
check_true("lines of a graded mesh", state.is_graded and len(drawn) == 33 and abs(drawn[1] - (1 / 32)**2) < 1e-12, str(drawn))

# --- pictures -------------------------------------------------------------------------------------------------------
done = picture("check.png", softwet, "check", PULL_CASE, *varying, "--picture", "check.png")
check_true("check prints the case too", "young = " in done.stdout and "unknowns" in done.stdout and "check.png" in done.stdout)
picture("tensotaxis_pull_2d_scene.png", sys.executable, tools / "plot", PULL_CASE, *SETS)
picture("solid.png", softwet, "check", cases / "solid_layer_2d.toml", "--set", "domain.elements=[16,2]", "--picture", "solid.png")
write_box("deep", height=0.4, elements=[6, 6, 4], capillarity=0.2, angle=90.0, tables="""
[substrate]
thickness = 0.1
young = "1 + x"
poisson = 0.45
[[droplet]]
centre = [0.4, 0.4, 0.1]
radius = 0.25
[[load]]
box = [[0.1, 0.1, 0.0], [0.3, 0.3, 0.1]]
force = [0.1, 0.1, 0.0]
[time]
end = 1.0
""")
picture("deep.png", softwet, "check", "deep.toml", "--set", "fluid.contact_angle=60 + 40*x*y", "--picture", "deep.png")
start(softwet, "check", "deep.toml", "--scene", "deep")
told = texts(scene_picture.FirstState("deep"))
check_true("three dimensions: all six sides", {"left: slip", "front: slip", "back: slip", "top: no slip"} <= told, str(told))

# --- what is wrong ---------------------------------------------------------------------------------------------------
done = start(sys.executable, tools / "plot", PULL_CASE, "--set", "substrate.young=-1", code=1)
check_true("a wrong case is reported as by the program", "plot: error: --set substrate.young=-1: substrate.young" in done.stderr,
           done.stderr)
done = start(softwet, "check", PULL_CASE, *SETS, "--picture", "nowhere/scene.png", code=1)
check_true("a picture that cannot be written", "nowhere/scene.png" in done.stderr, done.stderr)
