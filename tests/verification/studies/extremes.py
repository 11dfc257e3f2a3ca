"""Extremes: where runs survive, stop with a reason, or are refused

Each run pushes a parameter to its end, or two at once (tests/verification/_extremes.py). A run may *survive* (exit code
0, laws intact), *stop* (exit code 2: it says why, the checkpoint of the last good state can be read, no file holds a
number that is not finite) or be *refused* before it starts (exit code 1). Everything else *fails*: another exit code, a
run longer than its limit, a number that is not finite, mass that drifts by more than 1e-8, a density outside (-0.05,
1), and with the wall-energy law on a rigid wall an energy that grows. Where the outcome is not in doubt (EXPECTED in
that file, with the reasons) it is asked for, so that a program that refuses or stops everything does not pass."""

import numpy

import _extremes as matrix
import _lab

MINUTES = {"quick": 0.5, "full": 10}
EXPLICIT = "see the study extremes_explicit"
LIMIT = 600  # seconds for a run


def finite(run):
    """No number of history.csv and of the fields is nan or infinite. An empty cell is no number."""
    text = (run.folder / "history.csv").read_text().lower() + (run.folder / "interface.csv").read_text().lower()
    if "nan" in text or "inf" in text:
        return False
    import h5py
    for path in [*run.folder.glob("fields/*.hdf"), run.folder / "checkpoint.h5"]:
        bad = []
        with h5py.File(path) as file:
            file.visititems(lambda name, item: bad.append(name) if isinstance(item, h5py.Dataset) and item.dtype.kind == "f"
                            and not numpy.isfinite(item[()]).all() else None)
        if bad:
            return False
    return True


def broken_laws(label, run):
    """What a run that says it is done got wrong; empty when nothing."""
    rows, wrong = run.history, []
    if "mass_drift" in rows and numpy.nanmax(numpy.abs(rows["mass_drift"])) > 1e-8:
        wrong.append(f"mass drifts by {numpy.nanmax(numpy.abs(rows['mass_drift'])):.1e}")
    if not (rows["rho_min"].min() > -0.05 and rows["rho_max"].max() < 1):
        wrong.append(f"density in [{rows['rho_min'].min():.3g}, {rows['rho_max'].max():.3g}]")
    case, settings = matrix.RUNS[label]
    if case == "static_droplet_rigid_2d" and matrix.ENERGY in settings:  # there the energy may only fall
        energy = rows["energy_total"]
        growth = numpy.diff(energy).max() / max(numpy.ptp(energy), 1e-15) if len(energy) > 1 else 0
        if growth > 1e-6:
            wrong.append(f"energy grows by {growth:.1e} of its change")
    return ", ".join(wrong)


def verdict(label, run):
    """(verdict, reason)"""
    if run.code == 1:
        return "refused", run.message.strip().splitlines()[-1].split("error: ")[-1].replace(f"{_lab.ROOT}/", "")
    if run.code not in (0, 2) or not (run.folder / "checkpoint.h5").exists():
        return "FAILS", f"exit code {run.code}: {run.message.strip()[-150:]}"
    if not finite(run):
        return "FAILS", "a number that is not finite in its files"
    wrong = broken_laws(label, run)
    if run.code == 0:
        return ("FAILS", wrong) if wrong else ("survives", run.record["stop"]["reason"].replace("end reached", ""))
    if wrong:
        return "FAILS", wrong
    return "stops", run.message.split("error: ")[-1].split("the computation stopped: ")[-1].split("; the last good")[0]


def row(label, run):
    found, reason = verdict(label, run)
    if run.code == 1 or found == "FAILS" and run.code not in (0, 2):
        return found, [label, found, matrix.EXPECTED.get(label, ""), reason] + [""] * 6
    rows, counts = run.history, run.record["counts"]
    steps, newton = max(1, counts["steps"]), max(1, counts["newton"])
    rejected = counts["rejected_by_newton"] + counts["rejected_by_error"]
    return found, [label, found, matrix.EXPECTED.get(label, ""), reason, counts["steps"], rejected,
                   f"{rows['dt'].max():.3g}", f"{newton / steps:.1f}", f"{counts['krylov'] / newton:.1f}",
                   f"{rows['rho_min'].min():.2g}"]


def study(lab):
    chosen = {label: matrix.RUNS[label] for label in (matrix.QUICK if lab.quick else matrix.RUNS)}
    runs = lab.runs(chosen, expect=None, limit=LIMIT)
    found = {label: row(label, runs[label]) for label in chosen}
    kinds = [kind for kind, _ in found.values()]
    lab.text(f"{len(kinds)} runs: " + ", ".join(f"{kinds.count(kind)} {kind}" for kind in
                                              ("survives", "stops", "refused", "FAILS")) + ".")
    lab.expect("runs that fail", 0, kinds.count("FAILS"), kinds.count("FAILS") == 0)
    wrong = [f"{label}: {found[label][0]}, not {asked}" for label, asked in matrix.EXPECTED.items()
             if label in found and found[label][0] != asked]
    sure = len(found.keys() & matrix.EXPECTED.keys())
    lab.expect(f"of {sure} runs whose outcome is not in doubt, those that came out otherwise", "none",
               "; ".join(wrong) or "none", not wrong)
    lab.table(["run", "verdict", "asked", "reason", "steps", "rejected", "largest step", "Newton per step",
               "Krylov per Newton", "least density"], [cells for _, cells in found.values()], name="runs")
