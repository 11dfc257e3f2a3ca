"""Cases: from a file or from Python, checked by the program, and computed by it."""

import contextlib
import copy
import json
import math
import numbers
import os
import pathlib
import tempfile

from . import program
from .case import CaseTable
from .problem import Problem
from .run import Run
from .sweep import Sweep


def toml_text(value):
    """The TOML text of a number, a text, or a list of them."""
    if hasattr(value, "tolist"):  # of numpy
        value = value.tolist()
    if isinstance(value, bool):
        return "true" if value else "false"
    if isinstance(value, numbers.Integral):
        return str(int(value))
    if isinstance(value, numbers.Real):
        value = float(value)
        return repr(value) if math.isfinite(value) else str(value)
    if isinstance(value, (str, os.PathLike)):
        return json.dumps(os.fspath(value), ensure_ascii=False).replace("\x7f", "\\u007f")
    if isinstance(value, (list, tuple)):
        return "[" + ", ".join(map(toml_text, value)) + "]"
    if isinstance(value, dict):
        return "{ " + ", ".join(f"{json.dumps(str(key))} = {toml_text(entry)}" for key, entry in value.items()) + " }"
    raise Problem(f"{value!r} is of the type {type(value).__name__}; values of a case are numbers, texts, lists and tables")


def toml_file(tables):
    """The text of a case file with these tables: a dict of keys, dicts and lists of dicts."""
    lines, below = [], []
    for name, value in tables.items():
        entries = value if isinstance(value, (list, tuple)) else [value]
        if not entries or not all(isinstance(entry, dict) for entry in entries):
            lines.append(f"{name} = {toml_text(value)}")
            continue
        for entry in entries:
            below.append(f"[[{name}]]" if entries is value else f"[{name}]")
            below += [f"{key} = {toml_text(inner)}" for key, inner in entry.items()]
    return "\n".join([*lines, *below]) + "\n"


def assignments(sets):
    """The options --set of a dict of settings. A text stands as it would on the command line: "1/256", "kick_drift"."""
    words = []
    for key, value in sets.items():
        words += ["--set", f"{key}={value if isinstance(value, str) else toml_text(value)}"]
    return words


def values_of(vary):
    """The options --vary of {key: values}: a list of values, or a text as on the command line, "0:0.45:4"."""
    words = []
    for key, values in vary.items():
        if not isinstance(values, str):
            values = ",".join(value if isinstance(value, str) else toml_text(value).replace(" ", "") for value in values)
        words += ["--vary", f"{key}={values}"]
    return words


class Case:
    """A case that `softwet check` has accepted.

    source    the path of a case file, a dict of its tables, or another Case
    sets      settings {key: value}, as --set: {"time.end": 10, "load[0].ramp": 2, "fluid.viscosity": "1/64"}

    case["fluid"]["viscosity"]   any key, with every default filled in
    case.text                    the same as a case file
    case.warnings                what the program says of it: a list of sentences
    case.run(...)                computes it, see softwet.run
    case.sweep(vary, ...)        computes it for several values, see softwet.sweep

    What is computed is what was checked: a dict or a file that changes later, and another working folder, change
    nothing. Paths of tables are relative to the folder of the file, and for a dict to the working folder. What is wrong
    with a case raises softwet.Failure."""

    def __init__(self, source, sets=None):
        if isinstance(source, Case):
            self._source, self.sets = source._source, {**source.sets, **copy.deepcopy(sets or {})}
        elif isinstance(source, (dict, str, os.PathLike)):
            self._source, self.sets = Source(source), copy.deepcopy(dict(sets or {}))
        else:
            raise Problem(f"{source!r} is not a case: give the path of a file, a dict of tables, or a softwet.Case")
        self.text, lines = self._with_words(lambda words: program.ask("check", "--resolved", *words))
        self.warnings = program.sentences(lines, program.WARNING)
        import tomllib
        self._tables = CaseTable("the case", tomllib.loads(self.text))
        if earlier := self._tables.get("initial", {}).get("from"):
            self.sets["initial.from"] = toml_text(os.path.abspath(earlier))

    def __repr__(self):
        return f"<softwet.Case {self['name']}>"

    def __getitem__(self, key):
        return self._tables[key]

    def __contains__(self, key):
        return key in self._tables

    def __iter__(self):
        return iter(self._tables)

    def __len__(self):
        return len(self._tables)

    def keys(self):
        """Names of the tables and of the keys beside them, so that dict(case) has them all."""
        return self._tables.keys()

    def run(self, out=None, threads=None, progress=True, overwrite=False, resume=False):
        """Computes the case: see softwet.run. @return Run"""
        folder = pathlib.Path(out if out is not None else f"out/{self['name']}")
        options = ["--out", str(folder)]
        options += ["--threads", str(threads)] if threads is not None else []
        options += [option for option, wish in (("--overwrite", overwrite), ("--resume", resume), ("--quiet", not progress))
                    if wish]
        tell = program.tell_on_stderr if progress else lambda line: None
        self._with_words(lambda words: program.compute(["run", *words, *options], tell))
        return Run(folder.absolute())

    def sweep(self, vary, out=None, jobs=1, threads=None, columns=None, progress=True, retry=False):
        """Computes the case for all combinations of values: see softwet.sweep. @return Sweep"""
        if not vary:
            raise Problem("nothing to vary; give keys and their values, for example {'substrate.poisson': [0, 0.15, 0.3]}")
        folder = pathlib.Path(out if out is not None else f"out/{self['name']}_sweep")
        options = [*values_of(vary), "--out", str(folder), "--jobs", str(jobs)]
        options += ["--threads", str(threads)] if threads is not None else []
        options += ["--columns", ",".join(columns)] if columns else []
        options += ["--retry"] if retry else []
        tell = program.tell_on_stderr if progress else lambda line: None
        try:
            self._with_words(lambda words: program.compute(["sweep", *words, *options], tell))
        except program.Failure as failure:
            if failure.code != 2 or not (folder / "sweep.csv").is_file():
                raise
            program.tell_on_stderr(f"{program.WARNING}{failure}")  # what a member came to is a result
        return Sweep(folder.absolute())

    def _with_words(self, action):
        """Does something with the words of a command line that name the case. A failure names the source as the user
        did."""
        with self._source.file() as path:
            try:
                return action([path, *assignments(self.sets)])
            except program.Failure as failure:
                raise program.Failure(failure.code, str(failure).replace(path, self._source.name)) from None


class Source:
    """The text of a case, and the folder to which its tables are relative.

    given  the path of a file, which is read here, or a dict of tables"""

    def __init__(self, given):
        self._path = None
        if isinstance(given, dict):
            self.name, self._text, self._folder = "the case", toml_file(given), os.getcwd()
            return
        self.name, self._path = os.fspath(given), os.path.abspath(given)
        self._text, self._folder = _text_of(self._path), os.path.dirname(self._path)

    @contextlib.contextmanager
    def file(self):
        """A path with the text: the user's file while it still holds that text, else a file beside it."""
        if self._path is not None and _text_of(self._path) == self._text:
            yield self._path
            return
        try:
            file = tempfile.NamedTemporaryFile("w", dir=self._folder, prefix=".case_", suffix=".toml", encoding="utf-8", newline="")
        except OSError as error:
            raise Problem(f"cannot write the case into the folder {self._folder}, where its tables are: {error}") from error
        with file:
            file.write(self._text)
            file.flush()
            yield file.name


def _text_of(path):
    """The text of a file; None where there is none to read, which the program reports."""
    try:
        with open(path, encoding="utf-8", newline="") as file:
            return file.read()
    except (OSError, UnicodeDecodeError):
        return None


def run(case, out=None, sets=None, threads=None, progress=True, overwrite=False, resume=False):
    """Computes a case with the program and returns its output folder.

    case       path of a case file, dict of its tables, or softwet.Case
    out        output folder; default: out/<name of the case>
    sets       settings {key: value}, as --set
    threads    number of threads; default: as for the program
    progress   prints what the program says to stderr as it comes
    overwrite  replaces a result in the folder;  resume  goes on from its checkpoint
    @return    Run. Where the case is wrong or the run fails, softwet.Failure has the sentence of the program and its
    exit
               code. Ctrl-C stops the run after its step; its checkpoint is there when KeyboardInterrupt comes out."""
    return Case(case, sets).run(out, threads, progress, overwrite, resume)


def sweep(case, vary=None, out=None, sets=None, jobs=1, threads=None, columns=None, progress=True, retry=False):
    """Computes a case for all combinations of values with the program, as `softwet sweep`, and returns the folder. The
    same call again goes on: it computes what is missing, and values may be added.

    case, sets  as of softwet.run
    vary      {key: values}: a list, or a text as on the command line, {"substrate.poisson": "0:0.45:4"}
    out       folder of the sweep; default: out/<name of the case>_sweep
    jobs      number of runs at once;  threads  of each run
    columns   columns of history.csv whose last values the table gets
    progress  prints how the members stand;  retry  computes failed members again
    @return   Sweep; pandas.DataFrame(sweep.table) has a row for each member. A member that fails is there with this
    status.
              What is wrong with the case or the values raises softwet.Failure."""
    return Case(case, sets).sweep(vary, out, jobs, threads, columns, progress, retry)
