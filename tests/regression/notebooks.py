#!/usr/bin/env python3
"""The notebooks of docs/notebooks run from their first to their last cell, as plain Python, and their results are
right; a page links to each. usage: notebooks.py SOFTWET"""

import importlib.util
import os
import re
import runpy
import shutil

from _scene import check, check_true, tools

os.environ["MPLBACKEND"] = "Agg"
NOTEBOOKS = tools.parent / "docs" / "notebooks"
CELL = re.compile(r"^# %%(.*)\n", re.MULTILINE)


def has(*modules):
    lacking = [name for name in modules if importlib.util.find_spec(name) is None]
    if lacking:
        print(f"no {' and '.join(lacking)}: a notebook is left out; python3 -m pip install {' '.join(lacking)}")
    return not lacking


shutil.rmtree("out", ignore_errors=True)
page = (tools.parent / "docs" / "python.md").read_text()
for path in sorted(NOTEBOOKS.glob("*.py")):
    text = path.read_text()
    kinds = [kind.strip() for kind in CELL.findall(text)]
    check_true(f"{path.name}: cells of jupytext, and a link", "format_name: percent" in text and kinds[0] == "[markdown]" and
               set(kinds) == {"", "[markdown]"} and f"notebooks/{path.name}" in page)

if has("pandas", "matplotlib"):
    table = runpy.run_path(str(NOTEBOOKS / "sweep_over_stiffness.py"))["table"]
    check_true("stiffness: four members, and their picture", list(table["status"]) == ["done"] * 4 and os.path.getsize("out/ridge_sweep/ridge.png") > 10000)
    # Linear elasticity: the ridge of a stiff layer is inversely proportional to its modulus.
    scaled = table["ridge times young"].to_numpy()
    check("stiffness: ridge times modulus of the two stiffest layers", abs(scaled[-1] / scaled[-2] - 1), 0.03)
    check("stiffness: both ends of a droplet in the middle", abs(table["ridge_left"] / table["ridge_right"] - 1).max(), 1e-4)

if has("pyvista"):
    found = runpy.run_path(str(NOTEBOOKS / "droplet_in_pyvista.py"))
    check_true("droplet: a picture", os.path.getsize("out/droplet_3d/droplet.png") > 10000)
    # VTK's reader and the package have the same points; a wetting cap is lower than its radius.
    of_package = found["run"].fields(0.1).to_pyvista("density")
    check("droplet: both ways of reading", max(abs(of_package.points - found["fluid"].points).max(),
                                              abs(of_package["density"] - found["fluid"]["density"]).max()), 1e-12)
    check_true("droplet: height of its cap", 0.15 < found["surface"].bounds[5] - 0.1 < 0.3, str(found["surface"].bounds))
