#!/usr/bin/env python3
"""The three precisions compute the same pull: the droplet is at the same place, energies agree, and the mass is kept. What
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
refused("solver.precision=single", "solver.krylov.jacobian=difference")

rows = {}
for precision in ("double", "mixed", "single"):
    run("tensotaxis_pull_2d", precision, [*PULL, *FIXED, f"solver.precision={precision}"])
    rows[precision] = history(precision)
    check_true(f"{precision}: run.json names it", record(precision)["precision"] == precision)

reference = rows["double"]
# mixed: Newton's method ends at a millionth of the first residual, as with double, and not at the same numbers.
# single: rounded fields have errors of 6e-8, and a step has the errors of a residual that is a few of them large.
ALLOWED = {"mixed": {"place": 1e-7, "energy": 1e-6}, "single": {"place": 1e-6, "energy": 1e-5}}
for precision, allowed in ALLOWED.items():
    found = rows[precision]
    check_true(f"{precision}: the same times", list(found["t"]) == list(reference["t"]))
    apart = abs(found["x_centre"] - reference["x_centre"]).max()
    check(f"{precision}: X_c beside double", apart, allowed["place"])
    check_true(f"{precision}: other numbers than double", apart > 0)
    for column in ("energy_elastic", "energy_kinetic", "energy_free"):
        scale = abs(reference[column]).max()
        check(f"{precision}: {column} beside double", abs(found[column] - reference[column]).max() / scale,
              allowed["energy"])
    # Moments are stepped with fluxes in double precision, whatever the precision of Newton's method.
    check(f"{precision}: drift of the mass", abs(found["mass_drift"]).max(), 1e-8)
newton = {p: record(p)["counts"]["newton"] for p in rows}
check("mixed: Newton iterations more than with double, relative", newton["mixed"] / newton["double"] - 1, 0.05)
check("single: it ends where its residual is round-off", newton["single"], newton["double"])
