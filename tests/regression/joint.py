#!/usr/bin/env python3
"""A column of two materials under its weight, in which the stress goes on across the joint and the strain jumps:
probes, field files, their readers, and a run that begins from such a file. The heights are some whose division by the
elements rounds up and some that rounds down. usage: joint.py SOFTWET"""

import pathlib
import shutil
import subprocess
import sys

import h5py
import numpy
from _scene import check, check_true, environment, history, open_output, run_file, softwet

HEIGHT, WEIGHT, POISSON, STIFF = 0.3, 1e-3, 0.3, 100
MODULUS = (1 - POISSON) / ((1 + POISSON) * (1 - 2 * POISSON))  # of the lower material, confined
EDGE = 1e-7


def probe(name, quantity, place, operation=None):
    where = f"box = {place}" if operation else f"point = {place}"
    return f'[[probe]]\nname = "{name}"\nquantity = "{quantity}_yy"\n{where}\n' + (f'operation = "{operation}"\n' if operation else "")


def scene(rows, row):
    joint = HEIGHT * row / rows
    both = f"[[0, 0], [0.5, {HEIGHT}]]"
    return joint, f"""
name = "joint"
domain = {{ size = [0.5, {HEIGHT}], elements = [4, {rows}] }}
substrate = {{ thickness = {HEIGHT}, joint = {joint}, young = "y <= {joint} ? 1 : {STIFF}", poisson = {POISSON}, strain = "small", gravity = [0.0, -{WEIGHT}] }}
boundary = {{ bottom = "slip", top = "free" }}
time = {{ end = 1.0 }}
output = {{ fields = {{ times = [0.0] }} }}
""" + probe("at", "cauchy_stress", [0.25, joint]) + probe("above", "cauchy_stress", [0.25, joint + EDGE]) + \
        probe("below", "cauchy_stress", [0.25, joint - EDGE]) + \
        probe("upper_least", "green_lagrange_strain", f"[[0, {joint}], [0.5, {HEIGHT}]]", "min") + \
        probe("lower_most", "green_lagrange_strain", f"[[0, 0], [0.5, {joint}]]", "max") + \
        probe("least_stress", "cauchy_stress", both, "min") + probe("mean_stress", "cauchy_stress", both, "mean")


def strain(slope):
    return slope + slope**2 / 2


def check_probes(name, joint):
    row = {key: float(values[-1]) for key, values in history(name).items()}
    stress = -WEIGHT * (HEIGHT - joint)
    for key, value in (("at", stress), ("above", stress + WEIGHT * EDGE), ("below", stress - WEIGHT * EDGE),
                       ("least_stress", -WEIGHT * HEIGHT), ("mean_stress", -WEIGHT * HEIGHT / 2),
                       ("lower_most", strain(stress / MODULUS)), ("upper_least", strain(stress / MODULUS / STIFF))):
        check(f"{name}: {key}", abs(row[key] / value - 1), 1e-6)  # a small strain is what is left of displacements


def check_file(name, rows, row, joint):
    solid = open_output(name).fields(0, "solid")
    with h5py.File(solid.path) as file:
        group = file["VTKHDF"]
        cells = group["Connectivity"][:].reshape(-1, 9)
        below = set(cells[:4 * row].ravel())
        check_true(f"{name}: cells do not share points across the joint", not below & set(cells[4 * row:].ravel()))
        check_true(f"{name}: all points are used", len(set(cells.ravel())) == len(group["Points"]) == 9 * (2 * rows + 2))
    check_true(f"{name}: the lattice has each height once", solid.shape == (2 * rows + 1, 9) and len(solid.lines[0]) == 2 * rows + 1)
    for side, part in zip(("below", "above"), solid.sides):
        y = part.reference[..., 1]
        stress = -WEIGHT * (HEIGHT - y)
        check(f"{name}: stress {side}", abs(part["cauchy_stress"][..., 1, 1] - stress).max() / WEIGHT, 1e-8)
        modulus = MODULUS * (1 if side == "below" else STIFF)
        check(f"{name}: strain {side}", abs(part["green_lagrange_strain"][..., 1, 1] - strain(stress / modulus)).max() * modulus / WEIGHT, 1e-8)
    check_true(f"{name}: the field has the values from above",
               (solid["green_lagrange_strain"][2 * row] == solid.sides[1]["green_lagrange_strain"][0]).all())
    check_true(f"{name}: and its rows one by one", (solid.read("displacement", slice(2 * row, 2 * row + 1)) == solid["displacement"][2 * row]).all())
    heights = numpy.linspace(0.01, HEIGHT * 0.98, 41)
    found = solid.at(numpy.stack([numpy.full(41, 0.2), heights], axis=-1))
    check_true(f"{name}: places are found in both sides", found.inside.all())
    check(f"{name}: stress at places", abs(found["cauchy_stress"][:, 1, 1] + WEIGHT * (HEIGHT - heights)).max() / WEIGHT, 1e-3)


def begin_from(name, rows, row):
    """Another mesh takes the displacement of the file."""
    joint, text = scene(2 * rows, 2 * row)
    start = f'initial = {{ from = "{name}", time = 0 }}\n'
    pathlib.Path("begin.toml").write_text(text.replace('time = {', start + 'time = {', 1))
    run_file("begin.toml", "begin", ["time.max_steps=1"])
    first, then = open_output("begin").fields(0, "solid"), open_output(name).fields(0, "solid")
    check(f"{name}: a run begins with its displacement",
          abs(first["displacement"][::2] - then["displacement"]).max() / abs(then["displacement"]).max(), 1e-12)


def read_by_paraview(name):
    script = pathlib.Path(__file__).with_name("_read_series.py")
    path = str(pathlib.Path(name) / "fields" / "solid.hdf.series")
    result = subprocess.run(["pvpython", "--force-offscreen-rendering", str(script), path], capture_output=True, text=True, timeout=900)
    check_true(f"{name}: ParaView opens it", result.returncode == 0 and "found " in result.stdout, result.stderr)


for rows in (6, 10):
    for row in range(1, rows, 1 if rows == 6 else 3):
        name = f"joint_{rows}_{row}"
        joint, text = scene(rows, row)
        pathlib.Path(f"{name}.toml").write_text(text)
        subprocess.run([softwet, "steady", f"{name}.toml", "--out", name, "--overwrite", "--quiet", "--threads", "1"], check=True,
                       env=environment, stdout=subprocess.DEVNULL)
        check_probes(name, joint)
        check_file(name, rows, row, joint)
begin_from("joint_6_2", 6, 2)
if shutil.which("pvpython"):
    read_by_paraview("joint_6_2")
else:
    print("no pvpython: read with h5py alone", file=sys.stderr)
