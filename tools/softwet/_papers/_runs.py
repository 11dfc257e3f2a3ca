"""The runs of a paper: each is started once, and kept."""

import pathlib
import shlex
import shutil
import time

from softwet import Failure, Problem, program, open_sweep
from softwet import open as open_output
from softwet.definition import assignments, toml_file

CASES = pathlib.Path(__file__).resolve().parents[3] / "cases"
RESUMING = ("--along", "--vary")  # these commands go on by themselves, and take no --quiet


def settings(values):
    """The words of `--set` for a dict {key: number, text or list}."""
    return assignments(values)


class Runs:
    """Starts the program for a paper.

    folder  where the output folders are
    quick   whether the coarse variant is asked for"""

    def __init__(self, name, folder, quick):
        self.name, self.folder, self.quick = name, folder.absolute(), quick
        try:
            self.folder.mkdir(parents=True, exist_ok=True)
        except OSError as error:
            raise Problem(f"cannot make the folder {self.folder}: {error.strerror}") from error

    def case(self, name):
        """The path of a case of cases/."""
        return CASES / f"{name}.toml"

    def write_case(self, tables):
        """The path of a case that the paper makes itself: a dict of its tables, with its name."""
        path = self.folder / f"{tables['name']}.toml"
        path.write_text(toml_file(tables))
        return path

    def softwet(self, command, case, *words, out):
        """Starts `softwet COMMAND CASE WORDS --out FOLDER/OUT`, unless that is there and done. Where words or case have
        changed since, it is computed anew. @return the folder; raises Problem where it fails"""
        words, target = [str(word) for word in words], self.folder / out
        text, kept = self._text(command, case, words), self.folder / f"{out}.command"
        same = kept.is_file() and kept.read_text() == text
        resumes = any(word.partition("=")[0] in RESUMING for word in words)
        if same and done(target, command):
            return target
        if command == "sweep" and not same and (target / "sweep.json").is_file():
            shutil.rmtree(target)  # the folder of a sweep takes no other case
        if not resumes:
            words.append("--quiet")
        if target.exists() and not (same and resumes):
            words.append("--resume" if same and command == "run" and (target / "checkpoint.h5").is_file() else "--overwrite")
        kept.parent.mkdir(parents=True, exist_ok=True)
        kept.write_text(text)
        begin = time.monotonic()
        try:
            program.compute([command, str(case), *words, "--out", str(target)], lambda line: None)
        except Failure as failure:
            raise Problem(f"{self.name}: the run {out} failed: {failure}\n  its command: "
                          f"{shlex.join(['softwet', command, str(case), *words, '--out', str(target)])}") from failure
        print(f"{self.name}: {out}: {time.monotonic() - begin:.0f} s", flush=True)
        return target

    def _text(self, command, case, words):
        """What a result depends on."""
        return shlex.join([command, *words]) + "\n" + pathlib.Path(case).read_text()


def done(folder, command):
    """Whether an output folder, or the folder of a sweep, has all its results."""
    try:
        if command == "sweep":
            return all(member.status == "done" for member in open_sweep(folder))
        return open_output(folder).state == "done"
    except Problem:
        return False
