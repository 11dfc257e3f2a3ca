"""The studies with explicit schemes: what applies, and what was measured.

The other studies run with `generalized_alpha`. Each says in its own file whether it applies to the explicit schemes: a text
EXPLICIT says why not, a function explicit(lab) is the form that suits them. Here these forms run with `kick_drift`, `rkl2` and
`ssp_rk3`, with corrected masses and full quadrature where nothing else is said. Steps follow the bound, with the default
`time.safety`, unless a form says otherwise. A scene whose steps would be too short (a thin vapour) has a higher temperature."""

import importlib.util
import pathlib

from _lab import Known
from _scheme_lab import SchemeLab

MINUTES = {"quick": 0.3, "full": 10}
STUDIES = pathlib.Path(__file__).resolve().parent
SCHEMES = ("kick_drift", "rkl2", "ssp_rk3")
MEASURED = ("study", "what", "asked", *SCHEMES)
QUICK = ("elastic_waves", "laws", "reproducible")


def load(name):
    spec = importlib.util.spec_from_file_location(f"study_{name}", STUDIES / f"{name}.py")
    module = importlib.util.module_from_spec(spec)
    spec.loader.exec_module(module)
    return module


def study(lab):
    modules = {path.stem: load(path.stem) for path in sorted(STUDIES.glob("[!_]*.py")) if path.stem != "schemes"}
    forms, reasons, measured = [], {}, []
    for name, module in modules.items():
        form = getattr(module, "explicit", None)
        if not form:
            reasons.setdefault(module.EXPLICIT, []).append(name)
        elif not lab.quick or name in QUICK:
            parts = {scheme: measure(lab, name, form, scheme) for scheme in SCHEMES}
            forms.append((name, *map(share, parts.values()), " ".join(form.__doc__.split())))
            measured += compared(name, parts)
    show(lab, forms, reasons, measured)


def show(lab, forms, reasons, measured):
    lab.title("What applies")
    lab.table(("study", *SCHEMES, "the form"), forms)
    lab.title("What does not apply, and why")
    lab.table(("studies", "why"), [(", ".join(names), why) for why, names in reasons.items()])
    lab.title("What was measured")
    file = lab.numbers(MEASURED, measured, "measured")
    missed = {row[0] for row in measured if any(cell.startswith("**") for cell in row[3:])}
    lab.text(f"All {len(measured)} rows are in `{file}`." + (" Rows of studies that some scheme misses:" if missed else ""))
    if missed:
        lab.table(MEASURED, [row for row in measured if row[0] in missed])


def measure(lab, name, form, scheme):
    """Runs one study with one scheme, and asks that all its rows hold."""
    part = SchemeLab(lab, name, scheme)
    form(part)
    held, missed, failed = part.counts()
    if not part.asked:
        return part
    causes = {}
    for *_, holds, cause in part.asked:
        if not holds:
            why, _, bound = cause.partition("; known: ")
            causes.setdefault(why, []).append(bound)
    causes = "; ".join(f"{why} ({', '.join(filter(None, bounds))})" for why, bounds in causes.items())
    lab.expect(f"{name}, {scheme}: what holds", f"{len(part.asked)} of {len(part.asked)}", f"{held} of {len(part.asked)}",
               missed + failed == 0, Known(causes, "each row in its bound", failed == 0))
    return part


def share(part):
    return f"{part.counts()[0]}/{len(part.asked)}" if part.asked else ""


def compared(name, parts):
    """What was asked, and what each scheme has: rows of MEASURED."""
    rows = {}
    for scheme, part in parts.items():
        for what, asked, measured, holds, _ in part.asked:
            rows.setdefault((what, asked), {})[scheme] = f"{measured}" if holds else f"**{measured}**"
    return [(name, *key, *(cells.get(scheme, "") for scheme in parts)) for key, cells in rows.items()]
