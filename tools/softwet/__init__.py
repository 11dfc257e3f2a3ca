"""softwet in Python: computing cases, and output folders as arrays.

    import softwet

    run = softwet.run("cases/tensotaxis_pull_2d.toml", out="out/soft", sets={"substrate.young": 0.5})
    case = softwet.Case("my_case.toml")       # checked by the program; case.warnings, case["fluid"]["viscosity"]
    run = softwet.open("out/tensotaxis_pull_2d")
    run.case["substrate"]["young"]            # any key of case.toml
    run.record["counts"]["steps"]             # run.json
    run.history["t"], run.history["x_centre"] # columns of history.csv; an empty cell is nan
    run.interface[471.0]["displacement_y"]    # the wall at a field time
    run.times                                 # times of the field files
    fluid = run.fields(471.0)                 # the fluid on the points of its file
    fluid["density"], fluid.positions
    fluid.on_grid(200, 100)["density"]        # the same on a uniform grid
    softwet.columns()["energy_wall"].unit     # what a column of history.csv means, and its unit
    swept = softwet.sweep("cases/tensotaxis_pull_2d.toml", {"substrate.young": [0.5, 1, 2]}, jobs=3)
    swept.table["substrate.young"], swept.table["velocity_peak"]
    for member in softwet.open_sweep("out/tensotaxis_pull_2d_sweep"):
        print(member.values, member.run.history["x_centre"][-1])

Everything is in the units of the paper: lengths in L0, times in L0/sqrt(ab), velocities in sqrt(ab), densities in b,
stresses in a b^2. Time 0 is the start of the first load. Arrays need numpy, fields need h5py too; what needs neither is
read without them. What is wrong with a file or a question raises softwet.Problem, whose text says what to do. What the
program refuses or fails to compute raises softwet.Failure, a Problem with its sentence and its exit code. """

from .case import read_case
from .columns import Column, columns
from .definition import Case, run, sweep
from .problem import Problem
from .program import Failure
from .run import Run
from .sweep import Member, Sweep
from .table import read_table

__all__ = ["Case", "Column", "Failure", "Member", "Problem", "Run", "Sweep", "columns", "open", "open_sweep", "read_case",
           "read_table", "run", "sweep"]


def open(folder):
    """The output folder of `softwet run`. @return Run; raises Problem where the folder is none"""
    return Run(folder)


def open_sweep(folder):
    """The folder of `softwet sweep`, or a folder that holds output folders. @return Sweep; raises Problem"""
    return Sweep(folder)
