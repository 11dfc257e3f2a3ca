"""What a study works with: runs of softwet that are kept, tables, pictures, and what was asked and measured.

A study is a file of tests/verification/studies:

    '''Title in one line.

    What is done and where the exact answers come from.'''
    MINUTES = {"quick": 0.2, "full": 5}   # as measured on one core, rounded up; in one line
    def study(lab): ...

tools/verify calls study(lab) and writes <out>/<name>/<name>.md with its tables and pictures."""

import csv
import pathlib
import re
import shlex
import subprocess
import sys
import time
from concurrent.futures import ThreadPoolExecutor
from typing import NamedTuple

ROOT = pathlib.Path(__file__).resolve().parent.parent.parent
sys.path.insert(0, str(ROOT / "tools"))
from _page import asked_rows, asked_table, markdown, named_table, plain  # noqa: E402
from softwet._store.kept import ENVIRONMENT  # noqa: E402


class StudyError(Exception):
    """A study cannot go on: a run ended with another exit code than expected, or took too long."""


class MissingConfiguration(StudyError):
    """The program was built without the dimension, the degree or the coordinates of a run."""


class Known(NamedTuple):
    """A miss whose cause is known: its cause, how large it is at most, and whether it is no larger."""
    cause: str
    bound: str
    within: bool


class Lab:
    """@param name  of the study;  @param store  of the runs, softwet._store.kept.KeptRuns;  @param folder  what the
    study writes
    @param jobs  runs at once"""

    prefix = ""  # of the files of cases

    def __init__(self, name, store, folder, quick, jobs):
        self.name, self.store, self.folder, self.quick, self.jobs = name, store, folder, quick, jobs
        self.program = store.program
        self.lines, self.asked, self.files, self.texts = [], [], [], {}
        self.commands, self.seconds = {}, {}
        folder.mkdir(parents=True, exist_ok=True)

    def has_configuration(self, name):
        """Whether the program was built for it, e.g. "2D degree 3"."""
        return name in subprocess.run([self.program, "info"], capture_output=True, text=True, check=True).stdout

    # --- runs

    def run(self, label, case, settings=(), options=(), **keywords):
        """One run; parameters as in get."""
        return self.runs({label: (case, settings, options)}, **keywords)[label]

    def get(self, label, case, settings=(), options=(), expect=0, limit=600):
        """Runs `softwet run`, unless an equal run is kept. @param label  names the run in this study
        @param case      a name in cases/, or the text of a case
        @param settings  values of --set;  @param options  further options, default "--threads 1"
        @param expect    exit code, None: any;  @param limit  seconds"""
        path, shown = self.case_file(case)
        run = self.store.get(path, shown, settings, options, limit)
        self.commands[label], self.seconds[label] = run.commandline, run.processor_seconds
        if expect is not None and run.code != expect:
            kind = MissingConfiguration if run.code == 1 and "not in this build" in run.message else StudyError
            raise kind(f"{label}: exit code {run.code}, not {expect}: {run.commandline}\n{run.message.strip()}")
        print(f"verify: {self.name}: {label} ({run.seconds:.0f} s)", flush=True)
        return run

    def runs(self, wanted, **keywords):
        """@param wanted  {label: (case, settings)};  @return {label: KeptRun}, computed side by side (--jobs)

        Runs are started by the threads of the pool only: the main thread is the one that a signal stops anywhere."""
        for case, *_ in wanted.values():
            self.case_file(case)
        with ThreadPoolExecutor(self.jobs) as pool:
            futures = {label: pool.submit(self.get, label, *words, **keywords) for label, words in wanted.items()}
            return {label: future.result() for label, future in futures.items()}

    def case_file(self, case):
        """Path of a case and its name in commands. The text of a case becomes a file in the folder of the tables."""
        if "\n" not in case:
            return ROOT / "cases" / f"{case}.toml", f"cases/{case}.toml"
        if case not in self.texts:
            found = re.search(r'^name *= *"(.*)"', case, re.M)
            name, number = self.prefix + (found.group(1) if found else self.name), len(self.texts) + 1
            if f"{name}.toml" in self.texts.values():
                name = f"{name}_{number}"
            self.texts[case] = f"{name}.toml"
            (self.folder / f"{name}.toml").write_text(case)
            self.files.append(f"{name}.toml")
        return self.folder / self.texts[case], self.texts[case]

    def ask(self, command, case, *options):
        """What `softwet check` or `softwet bench` prints about a case."""
        path, shown = self.case_file(case)
        words = [command, str(path), *options]
        label = f"{command} {case if shown.startswith('cases') else shown}"
        self.commands[label] = shlex.join(["softwet", command, shown, *options])
        start = time.monotonic()
        done = subprocess.run([str(self.program), *words], cwd=ROOT, text=True, check=True, capture_output=True,
                              env=ENVIRONMENT)
        self.seconds[label] = time.monotonic() - start
        return done.stdout

    def tools(self, *names):
        """Other programs of the build that a study needs. @return {name: path}"""
        paths = {name: self.program.parent / name for name in names}
        missing = [name for name, path in paths.items() if not path.exists()]
        if missing:
            raise StudyError(f"{' and '.join(missing)} not found in {self.program.parent}; this study needs the sources of softwet: "
                             f"tools/setup softwet {' '.join(missing)} builds what is missing, then tools/verify {self.name}")
        return paths

    # --- what is written

    def title(self, text):
        self.lines += ["", f"## {text}", ""]

    def text(self, text):
        self.lines += ["", text, ""]

    def table(self, columns, rows, name=None):
        """A table; with a name also <study>_<name>.csv."""
        if name:
            self.lines += named_table(columns, rows, self.numbers(columns, rows, name))
        else:
            self.lines += ["", *markdown(columns, rows), ""]

    def numbers(self, columns, rows, name):
        """A table that is the file <study>_<name>.csv alone. @return that name"""
        file = f"{self.name}_{name}.csv"
        (self.folder / file).write_text("\n".join(",".join(map(plain, row)) for row in [columns, *rows]) + "\n")
        self.files.append(file)
        return file

    def expect(self, what, asked, measured, holds, known=None):
        """A row of the table "asked, measured, holds". A row that does not hold makes the exit code 1, unless it is a
        `Known` miss within its bound: then the miss and its cause are reported and count as missed, not as failed."""
        cause = f"{known.cause}; known: {known.bound}" if known and known.within else ""
        if known and not holds and not known.within:
            measured = f"{measured}; worse than known: {known.bound}"
        self.asked.append((what, asked, measured, bool(holds), cause))
        print(f"{'ok' if holds else 'MISS' if cause else 'FAIL':4}  {what}: {measured} (asked: {asked})", flush=True)

    def plot(self, name, draw, shown=True):
        """draw(axes) with matplotlib into <study>_<name>.png; left out where matplotlib is missing. @param shown  on
        the page
        @return its name, or None"""
        try:
            import matplotlib
        except ImportError:
            print(f"verify: {self.name}: no matplotlib, no picture '{name}'")
            return None
        matplotlib.use("Agg")
        from matplotlib import pyplot
        figure, axes = pyplot.subplots(figsize=(6.4, 4.2), layout="constrained")
        draw(axes)
        file = f"{self.name}_{name}.png"
        figure.savefig(self.folder / file, dpi=110)
        pyplot.close(figure)
        self.picture(file, shown)
        return file

    def picture(self, file, shown=True):
        """A picture the study has made itself, in lab.folder."""
        if shown:
            self.lines += ["", f"![{file}]({file})", ""]
        self.files.append(file)

    def write_commands(self):
        """<study>_commands.csv with the command of each run. @return its name"""
        file = f"{self.name}_commands.csv"
        with open(self.folder / file, "w", newline="") as out:
            csv.writer(out, lineterminator="\n").writerows([("run", "command"), *self.commands.items()])
        self.files.append(file)
        return file

    # --- what came out

    def counts(self):
        """Rows that hold, that are missed and have a note, that fail."""
        held = sum(holds for _, _, _, holds, _ in self.asked)
        missed = sum(not holds and bool(cause) for _, _, _, holds, cause in self.asked)
        return held, missed, len(self.asked) - held - missed

    def document(self, title, about, minutes, build):
        held, missed, failed = self.counts()
        verdict = f"{held} of {len(self.asked)} hold" + (f", {missed} missed as noted" if missed else "") + (
            f", **{failed} fail**" if failed else "")
        form = " --quick" if self.quick else ""
        lines = [f"# {title}", "", about, "", f"Verdict: {verdict}", "",
                 f"Command: `softwet verify {self.name}{form}`, {minutes:.2g} minutes of one core. {build}", ""]
        if self.asked:
            causes = list(dict.fromkeys(cause for *_, holds, cause in self.asked if cause and not holds))
            rows = [(what, asked, measured, "yes" if holds else f"**no** ({causes.index(cause) + 1})" if cause else "**no**")
                    for what, asked, measured, holds, cause in self.asked]
            shown = asked_rows(rows)
            lines += ["## Asked and measured", "", *asked_table(rows, shown), ""]
            if len(shown) < len(rows):
                file = self.numbers(("what", "asked", "measured", "holds"), rows, "asked")
                lines += [f"The other {len(rows) - len(shown)} rows hold; all are in `{file}`.", ""]
            lines += [f"({i}) {cause}." for i, cause in enumerate(causes, 1)] + [""]
        lines += self.lines
        if self.commands:
            file = self.write_commands()
            lines += ["", f"The commands of all runs: `{file}`. The command above writes it with the other tables and the cases."]
        return re.sub(r"\n{3,}", "\n\n", "\n".join(lines).strip()) + "\n"
