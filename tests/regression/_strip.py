"""A layer of solid alone, half a wave wide and at rest under a force in a strip below its top, against linear theory.

By Betti's theorem the wave of the displacement of the top is the wave of the force times the mean, over the height of
the strip, of the displacement that a traction on the top makes there (tests/verification/_layer.py): exact for small
displacements."""

import os
import pathlib
import subprocess
import sys

import numpy
from _scene import environment, open_output, softwet

verification = pathlib.Path(os.environ["SOFTWET_SOURCE_DIR"]) / "tests" / "verification"
sys.path[:0] = [str(verification), str(verification / "studies")]
import _layer  # noqa: E402

YOUNG, POISSON, HEIGHT, LENGTH = 0.7554, 0.45, 0.125, 0.25
SIGMA = 3.956293e-3  # surface tension of the liquid of the paper at a capillarity of 1/64
STRIP = HEIGHT / 8
# Splines of degree 2 on elements twice as long are within 2e-5 of linear theory under smooth loads (an independent
# code). The sides of the loaded boxes come on top here, and the errors fall with the fourth power of the elements: by
# 16 or more from 16 x 8 to 32 x 16. The error of a response in one direction to a force in the other is a product of
# the errors of both: it counts over the geometric mean of the responses along the forces.
CLOSE = 2e-5
FORCE = 1e-4  # strains of about 1e-6: what is nonlinear in them is as small
GAUSS = numpy.polynomial.legendre.leggauss(8)


def write_layer(name, substrate="", boundary='bottom = "slip"', load="", more="", coordinates="plane",
                elements=(32, 16), time="time = { end = 1.0 }"):
    """Writes <name>.toml. @return that name"""
    pathlib.Path(f"{name}.toml").write_text(f"""
name = "{name}"
domain = {{ size = [{LENGTH}, {HEIGHT}], elements = {list(elements)}, coordinates = "{coordinates}" }}
substrate = {{ thickness = {HEIGHT}, young = {YOUNG}, poisson = {POISSON}{", " * bool(substrate)}{substrate} }}
boundary = {{ left = "slip", right = "slip", top = "free", {boundary} }}
{time}
solver = {{ newton = {{ rtol = 1e-10, atol = 1e-18 }}, krylov = {{ rtol = 1e-4 }} }}
output = {{ fields = {{ times = [1.0] }}, history = {{ every = 1 }} }}
{load}
{more}
""")
    return f"{name}.toml"


def strip_load(width, force):
    """On [0, width] of the strip."""
    return f"[[load]]\nbox = [[0.0, {HEIGHT - STRIP}], [{width}, {HEIGHT}]]\nforce = {force}\nstart = 0.0\nramp = 0.0\n"


def rest(case):
    """The output of `softwet steady`."""
    folder = case.removesuffix(".toml")
    done = subprocess.run([softwet, "steady", case, "--out", folder, "--overwrite", "--threads", "1"], capture_output=True,
                          text=True, timeout=900, env=environment)
    if done.returncode != 0:
        sys.exit(f"{case}: exit code {done.returncode}\n{done.stdout}{done.stderr}")
    return open_output(folder)


def projected(run, axis, wave, weight=lambda x: 1.0):
    """Integral of a displacement of the top times wave(x) weight(x): exact for splines of degree 2, whose ends and
    middles of elements are the rows of interface.csv."""
    walls = run.interface
    wall = walls[max(walls)]
    x, u = wall["x_reference"], wall[f"displacement_{axis}"]
    s, w = GAUSS
    shapes = numpy.array([0.5 * s * (s - 1), 1 - s * s, 0.5 * s * (s + 1)])
    total = 0.0
    for e in range(0, len(x) - 1, 2):
        points = 0.5 * (x[e] + x[e + 2]) + 0.5 * (x[e + 2] - x[e]) * s
        total += 0.5 * (x[e + 2] - x[e]) * (w * (u[e:e + 3] @ shapes) * wave(points) * weight(points)).sum()
    return total


def of_strip(k, **layer):
    """Displacement of the top, 2 x 2 as a compliance, for the force of a wave in the strip; the force on its height is
    1."""
    s, w = GAUSS
    heights = HEIGHT - STRIP * 0.5 * (1 + s)
    return numpy.tensordot(0.5 * w, _layer.displacement(heights, k, HEIGHT, YOUNG, POISSON, **layer), 1).T
