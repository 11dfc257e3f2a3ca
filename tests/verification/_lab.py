"""What a study works with: runs of softwet that are kept, tables, pictures, and what was asked and measured.

A study is a file of tests/verification/studies:

    '''Title in one line.

    What is done and where the exact answers come from.'''
    MINUTES = {"quick": 0.2, "full": 5}   # as measured on one core, rounded up; in one line
    def study(lab): ...

tools/verify calls study(lab) and writes <out>/<name>/<name>.md with the tables and pictures beside it."""

import csv
import hashlib
import json
import os
import pathlib
import re
import shlex
import subprocess
import sys
import tempfile
import threading
import time
from concurrent.futures import ThreadPoolExecutor
from functools import cached_property
from typing import NamedTuple

ROOT = pathlib.Path(__file__).resolve().parent.parent.parent
sys.path.insert(0, str(ROOT / "tools"))
import softwet  # noqa: E402
from _page import asked_rows, markdown, named_table, plain  # noqa: E402

# Threads that wait without spinning: runs share the machine with each other.
ENVIRONMENT = {**os.environ, "OMP_WAIT_POLICY": "passive", "OMP_PROC_BIND": "false"}


class StudyError(Exception):
    """A study cannot go on: a run ended with another exit code than expected, or took too long."""


class Known(NamedTuple):
    """A miss whose cause is known: its cause, how large it is at most, and whether it is no larger."""
    cause: str
    bound: str
    within: bool


class Run:
    """A finished run: .folder, .code, .message (stderr), .seconds (wall), .processor_seconds, .commandline,
    .output, .history, .record."""

    def __init__(self, folder, note):
        self.folder, self.code, self.message = folder, note["code"], note["message"]
        self.seconds, self.commandline = note["seconds"], note["command"]
        self.processor_seconds = note.get("processor_seconds", self.seconds)

    @cached_property
    def output(self):
        """The output folder, a softwet.Run."""
        return softwet.open(self.folder)

    @property
    def history(self):
        """Columns of history.csv by name; an empty cell is nan."""
        return self.output.history

    @property
    def record(self):
        return self.output.record


class Store:
    """Runs of one program under a folder. A run with the command, case and program of an earlier one is that one."""

    def __init__(self, program, folder):
        self.program, self.folder = pathlib.Path(program), folder
        self.content = hashlib.sha1(self.program.read_bytes()).hexdigest()
        self.running, self.stopped = set(), False

    def stop(self):
        """Kills the runs under way, which are not kept; no other starts. Takes no lock: for a signal handler."""
        self.stopped = True
        for process in list(self.running):
            process.kill()

    def get(self, case, shown, settings, options, limit):
        """@param case   path of the case; @param shown  how the command names it
        @return the run, whatever its exit code"""
        self.go_on()
        words = [word for setting in settings for word in ("--set", setting)] + list(options)
        if "--threads" not in words:
            words += ["--threads", "1"]
        told = [self.content, case.read_text(), *words]
        key = hashlib.sha1("\0".join(told).encode()).hexdigest()[:12]
        folder = self.folder / f"{case.stem}_{key}"
        file = self.folder / f"{case.stem}_{key}.json"
        if not file.exists():
            note = self.compute(
                [str(self.program), "run", str(case), *words, "--out", str(folder), "--quiet", "--overwrite"], limit)
            self.go_on()
            note["command"] = shlex.join(["softwet", "run", shown, *words])
            if note["code"] not in (0, 1, 2):
                return Run(folder, note)  # the machine's fault, or too slow: not kept
            part = file.with_suffix(".part")
            part.write_text(json.dumps(note))
            part.rename(file)  # whole or not at all
        return Run(folder, {**json.loads(file.read_text()), "command": shlex.join(["softwet", "run", shown, *words])})

    def go_on(self):
        if self.stopped:
            raise StudyError("interrupted")

    def compute(self, words, limit):
        start = time.monotonic()
        with tempfile.TemporaryFile("w+") as errors:
            # In a session of its own: Ctrl-C does not reach it, which it would take as the order to end early and well.
            process = subprocess.Popen(words, cwd=ROOT, stdout=subprocess.DEVNULL, stderr=errors, env=ENVIRONMENT,
                                       start_new_session=True)
            self.running.add(process)
            if self.stopped:  # since go_on()
                process.kill()
            timer = threading.Timer(limit, process.kill)
            timer.start()
            _, status, usage = os.wait4(process.pid, 0)
            timer.cancel()
            self.running.discard(process)
            process.returncode = os.waitstatus_to_exitcode(status)
            errors.seek(0)
            message = errors.read()
        wall = time.monotonic() - start
        if process.returncode < 0:
            message += f"ended by signal {-process.returncode} after {wall:.0f} s (limit {limit} s)"
        return {"code": process.returncode, "message": message, "seconds": wall,
                "processor_seconds": usage.ru_utime + usage.ru_stime}


class Lab:
    """@param name  of the study;  @param store  of the runs;  @param folder  what the study writes
    @param jobs  runs at once"""

    prefix = ""  # of the files of cases

    def __init__(self, name, store, folder, quick, jobs):
        self.name, self.store, self.folder, self.quick, self.jobs = name, store, folder, quick, jobs
        self.program = store.program
        self.lines, self.asked, self.files, self.texts = [], [], [], {}
        self.commands, self.seconds = {}, {}
        folder.mkdir(parents=True, exist_ok=True)

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
            raise StudyError(f"{label}: exit code {run.code}, not {expect}: {run.commandline}\n{run.message.strip()}")
        print(f"verify: {self.name}: {label} ({run.seconds:.0f} s)", flush=True)
        return run

    def runs(self, wanted, **keywords):
        """@param wanted  {label: (case, settings)};  @return {label: Run}, computed side by side (--jobs)

        Runs are started by the threads of the pool only: the main thread is the one that a signal stops anywhere."""
        for case, *_ in wanted.values():
            self.case_file(case)
        with ThreadPoolExecutor(self.jobs) as pool:
            futures = {label: pool.submit(self.get, label, *words, **keywords) for label, words in wanted.items()}
            return {label: future.result() for label, future in futures.items()}

    def case_file(self, case):
        """Path of a case and its name in commands. The text of a case becomes a file beside the tables."""
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
        `Known` miss within its bound: then the miss and its cause are told and count as missed, not as failed."""
        cause = f"{known.cause}; known: {known.bound}" if known and known.within else ""
        if known and not holds and not known.within:
            measured = f"{measured}; worse than known: {known.bound}"
        self.asked.append((what, asked, measured, bool(holds), cause))
        print(f"{'ok' if holds else 'MISS' if cause else 'FAIL':4}  {what}: {measured} (asked: {asked})", flush=True)

    def plot(self, name, draw):
        """draw(axes) with matplotlib into <study>_<name>.png; left out where matplotlib is missing."""
        try:
            import matplotlib
        except ImportError:
            print(f"verify: {self.name}: no matplotlib, no picture '{name}'")
            return
        matplotlib.use("Agg")
        from matplotlib import pyplot
        figure, axes = pyplot.subplots(figsize=(6.4, 4.2), layout="constrained")
        draw(axes)
        file = f"{self.name}_{name}.png"
        figure.savefig(self.folder / file, dpi=110)
        pyplot.close(figure)
        self.picture(file)

    def picture(self, file):
        """A picture the study has drawn itself into lab.folder."""
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
        """Rows that hold, that are missed for a known cause, that fail."""
        held = sum(holds for _, _, _, holds, _ in self.asked)
        missed = sum(not holds and bool(cause) for _, _, _, holds, cause in self.asked)
        return held, missed, len(self.asked) - held - missed

    def document(self, title, about, minutes, build):
        held, missed, failed = self.counts()
        verdict = f"{held} of {len(self.asked)} hold" + (f", {missed} missed for a known cause" if missed else "") + (
            f", **{failed} fail**" if failed else "")
        form = " --quick" if self.quick else ""
        lines = [f"# {title}", "", about, "", f"Verdict: {verdict}", "",
                 f"Command: `softwet verify {self.name}{form}`, {minutes:.2g} minutes of one core. {build}", ""]
        if self.asked:
            causes = list(dict.fromkeys(cause for *_, holds, cause in self.asked if cause and not holds))
            rows = [(what, asked, measured, "yes" if holds else f"**no** ({causes.index(cause) + 1})" if cause else "**no**")
                    for what, asked, measured, holds, cause in self.asked]
            columns, shown = ("what", "asked", "measured", "holds"), asked_rows(rows)
            lines += ["## Asked and measured", "", *markdown(columns, shown), ""]
            if len(shown) < len(rows):
                file = self.numbers(columns, rows, "asked")
                lines += [f"The other {len(rows) - len(shown)} rows hold; all are in [{file}]({file}).", ""]
            lines += [f"({i}) {cause}." for i, cause in enumerate(causes, 1)] + [""]
        lines += self.lines
        if self.commands:
            file = self.write_commands()
            lines += ["", f"The commands of all runs: [{file}]({file})."]
        return re.sub(r"\n{3,}", "\n\n", "\n".join(lines).strip()) + "\n"
