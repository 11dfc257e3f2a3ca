#!/usr/bin/env python3
"""Both precisions compute the same pull: the droplet is at the same place, energies agree, and the mass is kept. What
is said in the wrong place is refused. usage: precision.py SOFTWET"""

import subprocess

from _scene import PULL, cases, check, check_true, environment, history, record, run, softwet

# Steps of one size, so that the runs can be compared row by row, solved far beyond the errors that are asked about.
FIXED = ["time.tolerance=1e30", "time.dt_initial=0.25", "time.dt_max=0.25", "solver.newton.rtol=1e-6"]


def refused(*settings):
    sets = [word for setting in settings for word in ("--set", setting)]
    result = subprocess.run([softwet, "check", str(cases / "tensotaxis_pull_2d.toml"), *sets], capture_output=True,
                            text=True, env=environment)
    check_true(f"{' '.join(settings)} is refused", result.returncode == 1, result.stderr)
    return result.stderr


for scheme in ("ssp_rk3", "kick_drift"):
    message = refused("solver.precision=mixed", f"time.scheme={scheme}")
    check_true("the message names the scheme that has it", "generalized_alpha" in message, message)
refused("solver.precision=mixed", "solver.krylov.jacobian=difference")
message = refused("solver.precision=single")
check_true("what is not a precision is refused with those there are", '"mixed"' in message, message)

rows = {}
for precision in ("double", "mixed"):
    run("tensotaxis_pull_2d", precision, [*PULL, *FIXED, f"solver.precision={precision}"])
    rows[precision] = history(precision)
    check_true(f"{precision}: run.json names it", record(precision)["precision"] == precision)

reference, found = rows["double"], rows["mixed"]
# Newton's method ends at a millionth of the first residual, as with double, and not at the same numbers.
check_true("the same times", list(found["t"]) == list(reference["t"]))
apart = abs(found["x_centre"] - reference["x_centre"]).max()
check("X_c beside double", apart, 1e-7)
check_true("other numbers than double", apart > 0)
for column in ("energy_elastic", "energy_kinetic", "energy_free"):
    scale = abs(reference[column]).max()
    check(f"{column} beside double", abs(found[column] - reference[column]).max() / scale, 1e-6)
# Moments are stepped with fluxes in double precision, whatever the precision of Newton's method.
check("drift of the mass", abs(found["mass_drift"]).max(), 1e-8)
newton = {p: record(p)["counts"]["newton"] for p in rows}
check("mixed: Newton iterations more than with double, relative", newton["mixed"] / newton["double"] - 1, 0.05)
