"""Extremes with explicit schemes: where runs survive, stop with a reason, or are refused

The runs of the study extremes (tests/verification/_extremes.py) with `kick_drift` and `rkl2`, and eight of them with `ssp_rk3`, with
lumped and with consistent masses. Explicit steps are short, so each run takes a number of steps and not a time: 60, and 20 with
consistent masses. The load begins at once, with its ramp of 5
units of time, so that only sudden loads reach their size. The study extremes says how runs are judged. Left out are the runs
whose subject is a key of the implicit scheme alone. Asked: no run fails, the refused ones are refused here too, and those with
phases near to each other, with a stiff or a heavy solid, with viscosities of 0.1 and more and with a rigid wall survive."""

import importlib.util
import pathlib

import _extremes as matrix

MINUTES = {"quick": 0.5, "full": 6}
EXPLICIT = "is about the explicit schemes"
LIMIT = 300
STEPS = {("kick_drift", "corrected"): 60, ("rkl2", "corrected"): 60, ("ssp_rk3", "corrected"): 60, ("kick_drift", "lumped"): 60,
         ("kick_drift", "consistent"): 20}
WHOLE = list(STEPS)[:2]  # the others take the runs of QUICK
IMPLICIT = {"rho_inf 0", "rho_inf 1", *(f"fixed dt {dt:g}" for dt in (1, 10, 100, 1000)), "fixed dt 10, rho_inf 1",
            "fixed dt 10, rho_inf 0", "difference products", "Schwarz", "no preconditioner", "mixed precision",
            "mixed precision, explicit", "tight tolerances, gamma h, rigid", "mu 1e-5, fixed dt 1",
            "rho0s 1e4, fixed dt 10"}
SURVIVE = {"base soft", "base rigid", "base rigid, wall energy", "theta 0.5", "theta 0.7", "theta 0.85", "E 10", "E 1000",
           "rho0s 100", "rho0s 10000", "mu 0.1", "mu 1", "mu 10", "gamma 4 h", "nu 0", "nu 0.49", "half a droplet", "two droplets touch",
           "film", "all liquid", "no droplet", "bubble on the wall", "load x 3", "load up"}
CI = ("base soft", "load x 10 sudden", "film", "droplet of radius gamma/4")  # of the quick form, with a third of the steps
QUICK = ("base soft", "theta 0.85", "nu 0.5", "E 0.001", "load x 10 sudden", "film", "no droplet", "droplet of radius gamma/4")


def judge():
    """The study extremes, for what it says about a run."""
    spec = importlib.util.spec_from_file_location("study_extremes", pathlib.Path(__file__).with_name("extremes.py"))
    module = importlib.util.module_from_spec(spec)
    spec.loader.exec_module(module)
    return module


def words(settings, scheme, mass, steps):
    """Settings of a run of the matrix for an explicit scheme."""
    kept = [word for word in settings if not word.startswith(("load[0].start=", "time.max_steps=", "output.fields.times="))]
    loaded = ["load[0].start=0"] if any(word.startswith("load[0].start=") for word in settings) else []
    return kept + loaded + ["output.fields.times=[0]", f"time.max_steps={steps}", f"time.scheme={scheme}", f"time.mass={mass}",
                            "output.history.every=1"]


def study(lab):
    extremes = judge()
    chosen = [label for label in matrix.RUNS if label not in IMPLICIT and (not lab.quick or label in CI)]
    found, cells = {}, {}
    for (scheme, mass), most in STEPS.items():
        steps = most // 3 if lab.quick else most
        column = f"{scheme}, {mass}"
        labels = chosen if (scheme, mass) in WHOLE else [label for label in chosen if label in QUICK]
        wanted = {f"{column}: {label}": (matrix.RUNS[label][0], words(matrix.RUNS[label][1], scheme, mass, steps)) for label in labels}
        runs = lab.runs(wanted, expect=None, limit=LIMIT)
        for label in labels:
            run = runs[f"{column}: {label}"]
            kind, reason = extremes.verdict(label, run)
            found[column, label] = kind
            cells[column, label] = (kind, reason, run.record["counts"]["steps"] if run.code in (0, 2) else 0,
                                    run.history["t"][-1] - run.history["t"][0] if run.code in (0, 2) else 0.0)
        summary(lab, column, {label: found[column, label] for label in labels})
    table(lab, chosen, cells)


def asked():
    """{run: outcome} where it is not in doubt"""
    refused = [label for label, kind in matrix.EXPECTED.items() if kind == "refused"]
    return dict.fromkeys(SURVIVE, "survives") | dict.fromkeys(refused, "refused")


def summary(lab, column, found):
    kinds = list(found.values())
    lab.text(f"{column}: {len(kinds)} runs, " + ", ".join(f"{kinds.count(kind)} {kind}" for kind in
                                                        ("survives", "stops", "refused", "FAILS")) + ".")
    fail = [label for label, kind in found.items() if kind == "FAILS"]
    lab.expect(f"{column}: runs that fail", "none", "; ".join(fail) or "none", not fail)
    sure = asked()
    wrong = [f"{label}: {found[label]}" for label in sure if label in found and found[label] != sure[label]]
    lab.expect(f"{column}: of {len(found.keys() & sure.keys())} runs whose outcome is not in doubt, those that came out otherwise",
               "none", "; ".join(wrong) or "none", not wrong)


def table(lab, labels, cells):
    columns = [f"{scheme}, {mass}" for scheme, mass in STEPS]
    rows = []
    for label in labels:
        row = [label]
        for column in columns:
            kind, _, steps, time = cells.get((column, label), ("", "", 0, 0.0))
            row.append(f"{kind}, t = {time:.2g}" if kind in ("survives", "stops") else kind)
        reasons = dict.fromkeys(cells[column, label][1] for column in columns if (column, label) in cells)
        rows.append(row + ["; ".join(reason for reason in reasons if reason and "max_steps" not in reason)])
    lab.table(["run", *columns, "reason"], rows, "runs")
