#!/usr/bin/env python3
"""Field files of a plane and of a box: their content, and that ParaView (else VTK's reader, where one of them is
installed) opens their series with all times and fields. usage: field_files.py SOFTWET"""

import json
import pathlib
import shutil
import subprocess
import sys

import h5py
import numpy
from _scene import check, check_true, record, run, run_file, write_box

TIMES = [0, 0.25, 0.5, 1]
FIELDS = ["time.end=1", "output.fields.times=0:0.5:3", "output.fields.every=1"]
SCALARS = {"density": "b", "chemical_potential": "a b", "pressure": "a b^2"}
TENSORS = {"green_lagrange_strain": "1", "first_piola_stress": "a b^2", "cauchy_stress": "a b^2"}
EXPECTED = {"fluid": {"velocity": 3, **dict.fromkeys(SCALARS, 1)},
            "solid": {"velocity": 3, "displacement": 3, "volume_ratio": 1, **dict.fromkeys(TENSORS, 9)}}
UNITS = {"velocity": "sqrt(ab)", "displacement": "L0", "volume_ratio": "1", **SCALARS, **TENSORS}
YOUNG, POISSON = 0.7554, 0.45  # of both scenes, times density 1

run("static_droplet_soft_2d", "plane", ["domain.elements=[32,16]", "fluid.capillarity=1/16", *FIELDS])
write_box("box", 0.4, [8, 8, 8], 0.2, 75.0, f"""
[substrate]
thickness = 0.1
young = {YOUNG}
poisson = {POISSON}
[[droplet]]
centre = [0.4, 0.4, 0.1]
radius = 0.2
[time]
end = 1
dt_initial = 0.1
""")
run_file("box.toml", "box", FIELDS)


def text(attribute):
    return attribute.decode() if isinstance(attribute, bytes) else str(attribute)


def check_head(name, file, case, time):
    run_json = record(pathlib.Path(name).parent.parent)
    told = {key: text(file.attrs[key]) for key in ("case", "version", "commit", "unit_length", "unit_time")}
    wanted = {"case": case, "version": run_json["softwet"], "commit": run_json["commit"], "unit_length": "L0",
              "unit_time": "L0/sqrt(ab)"}
    check_true(f"{name}: whose fields these are", told == wanted, str(told))
    stored = float(file["VTKHDF/FieldData/TimeValue"][0])
    check_true(f"{name}: time", file.attrs["time"] == stored == time, f"{stored:g}")
    for field, data in file["VTKHDF/PointData"].items():
        check_true(f"{name}: unit of {field}", text(data.attrs["unit"]) == UNITS[field])


def check_cells(name, group, dimension):
    nodes, kind = (9, 28) if dimension == 2 else (27, 29)
    cells, points = int(group["NumberOfCells"][0]), int(group["NumberOfPoints"][0])
    check_true(f"{name}: cells of {nodes} nodes", (group["Types"][:] == kind).all() and len(group["Points"]) == points
               and (numpy.diff(group["Offsets"][:]) == nodes).all() and len(group["Connectivity"]) == nodes * cells)
    check_true(f"{name}: all points are used", set(group["Connectivity"][:]) == set(range(points)))
    return points, cells


def check_stress(name, fields):
    """S = lambda tr(E) I + 2 G E gives the invariants of the stresses without F: P^T P = S C S with C = 2 E + I,
    tr(sigma) J = S : C, and det C = J^2."""
    strain, piola, cauchy = (fields[field][:].reshape(-1, 3, 3) for field in TENSORS)
    ratio, unit = fields["volume_ratio"][:], numpy.eye(3)
    lame, shear = POISSON * YOUNG / (1 + POISSON) / (1 - 2 * POISSON), YOUNG / 2 / (1 + POISSON)
    metric = 2 * strain + unit
    stress = lame * numpy.trace(strain, axis1=1, axis2=2)[:, None, None] * unit + 2 * shear * strain
    size = numpy.abs(stress).max()
    check_true(f"{name}: there is a stress", size > 1e-4, f"{size:.2e}")
    check(f"{name}: first Piola-Kirchhoff stress",
          numpy.abs(piola.swapaxes(1, 2) @ piola - stress @ metric @ stress).max() / size**2, 1e-12)
    check(f"{name}: Cauchy stress", numpy.abs(numpy.trace(cauchy, axis1=1, axis2=2) * ratio
                                              - (stress * metric).sum(axis=(1, 2))).max() / size, 1e-12)
    check(f"{name}: Cauchy stress is symmetric", numpy.abs(cauchy - cauchy.swapaxes(1, 2)).max() / size, 1e-12)
    check(f"{name}: volume ratio", numpy.abs(numpy.linalg.det(metric) / ratio**2 - 1).max(), 1e-12)


def check_series(folder, case, dimension, part):
    """The files of a series. @return what a reader should find in each"""
    path, wanted = pathlib.Path(folder) / "fields" / f"{part}.hdf.series", []
    listed = [(entry["name"], entry["time"]) for entry in json.loads(path.read_text())["files"]]
    check_true(f"{path}: files and times",
               listed == [(f"{part}_{number:04}.hdf", time) for number, time in enumerate(TIMES)])
    for name, time in listed:
        with h5py.File(path.parent / name) as file:
            check_head(str(path.parent / name), file, case, time)
            points, cells = check_cells(name, file["VTKHDF"], dimension)
            fields = file["VTKHDF/PointData"]
            check_true(f"{name}: fields", set(fields) == set(EXPECTED[part]), " ".join(fields))
            if part == "solid" and time > 0:
                check_stress(f"{folder}/{name}", fields)
        wanted.append([time, points, cells, EXPECTED[part]])
    return str(path), wanted


def read_by_paraview(paths):
    script = pathlib.Path(__file__).with_name("_read_series.py")
    result = subprocess.run(["pvpython", "--force-offscreen-rendering", str(script), *paths], capture_output=True,
                            text=True, timeout=900)
    answer = [line for line in result.stdout.splitlines() if line.startswith("found ")]
    if result.returncode or not answer:
        sys.exit(f"pvpython ended with {result.returncode}:\n{result.stdout}{result.stderr}")
    return json.loads(answer[0].removeprefix("found "))


def read_by_vtk(paths):
    """VTK has no reader of series: their files one by one."""
    from vtkmodules.vtkIOHDF import vtkHDFReader
    found = {}
    for path in paths:
        for entry in json.loads(pathlib.Path(path).read_text())["files"]:
            reader = vtkHDFReader()
            reader.SetFileName(str(pathlib.Path(path).parent / entry["name"]))
            reader.Update()
            data = reader.GetOutputDataObject(0)
            arrays = [data.GetPointData().GetArray(i) for i in range(data.GetPointData().GetNumberOfArrays())]
            found.setdefault(path, []).append([entry["time"], data.GetNumberOfPoints(), data.GetNumberOfCells(),
                                               {a.GetName(): a.GetNumberOfComponents() for a in arrays}])
    return found


wanted = dict(check_series(folder, case, dimension, part)
              for folder, case, dimension in (("plane", "static_droplet_soft_2d", 2), ("box", "box", 3))
              for part in ("fluid", "solid"))
if shutil.which("pvpython"):
    reader, found = "ParaView", read_by_paraview(list(wanted))
else:
    try:
        reader, found = "VTK's reader", read_by_vtk(list(wanted))
    except ImportError:
        print("no pvpython and no Python module of VTK (Debian: paraview, or python3-vtk9): only read with h5py")
        sys.exit(0)
for path, files in wanted.items():
    check_true(f"{reader} opens {path}", found[path] == files, "" if found[path] == files else str(found[path]))
