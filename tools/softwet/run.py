"""The output folder of a run."""

import json
import pathlib
from functools import cached_property

from . import record as records
from .case import read_case
from .problem import Problem
from .table import ByTime, read_table
from .units import Table, read_units

PARTS = {"fluid": "fluid", "solid": "substrate"}  # part of the scene, and its table in the case


class Run:
    """An output folder of `softwet run`. Files are read when they are asked for, and once: open the folder again to
    see what a run has written since.

    folder  its path;  every error is a Problem"""

    def __init__(self, folder):
        self.folder = pathlib.Path(folder)
        try:
            there = (self.folder / "case.toml").is_file()
        except OSError as error:  # a name that the file system does not take
            raise Problem(f"{folder} is not an output folder of softwet run: {error.strerror}") from error
        if not there:
            inside = min((path.parent for path in self.folder.glob("*/case.toml")), default=None)
            told = f"; folders of a sweep or of states of rest lie in it: give one of them, for example {inside}" if inside else ""
            raise Problem(f"{folder} is not an output folder of softwet run: it has no case.toml{told}")

    def __repr__(self):
        return f"softwet.open({str(self.folder)!r})"

    @cached_property
    def case(self):
        """case.toml: a dict of its tables, with every key of the case."""
        return read_case(self.folder)

    @cached_property
    def record(self):
        """run.json as a dict: version, machine, costs, how the run stands; {} before the run has written it."""
        return records.read_record(self.folder)

    @property
    def state(self):
        """running, done, stopped, failed; `died` where run.json says running and no process holds the folder."""
        return records.state(self.folder, self.record)

    @cached_property
    def history(self):
        """history.csv: {column: array of one number per row}; an empty cell is nan."""
        return read_table(self.folder / "history.csv", "t", growing=True)

    @cached_property
    def units(self):
        """The units in which the run is shown: of the laboratory where its case has a table [laboratory], else of the case."""
        return read_units(self.folder)

    def in_units(self, columns=None, table="history"):
        """Columns in um, ms, mm/s, kPa, mN/m and the like: {name: array}, and their units as .unit[name].
        @param columns  {name: array}, for example run.interface[t]; None: the history
        @param table  which table they are of: history, interface or fields
        Raises Problem where the case has no table [laboratory]."""
        if not self.units.named:
            raise Problem(f"{self.folder} has the units of the case alone, for its case has no table [laboratory]; "
                          "'softwet units ... --case FILE' writes such a case")
        return Table(self.history if columns is None else columns, self.units, table)

    @cached_property
    def interface(self):
        """interface.csv: {field time: {column: array of one number per point of the wall}}, x fastest."""
        import numpy
        table = read_table(self.folder / "interface.csv", "time", growing=True)
        times = numpy.unique(table["time"])
        rows = {float(t): {name: values[table["time"] == t] for name, values in table.items()} for t in times}
        return ByTime(rows, f"rows of {self.folder / 'interface.csv'}")

    # --- fields

    @cached_property
    def dimension(self):
        """2 or 3."""
        return len(self.case["domain"]["size"])

    @cached_property
    def parts(self):
        """What the scene has of "fluid" and "solid"."""
        return [part for part, table in PARTS.items() if table in self.case]

    @property
    def times(self):
        """Times of the field files, rising; a time counts when the files of all parts are there."""
        return sorted(self._files)

    def need_times(self):
        """As `times`, but raises Problem where there are none."""
        if not self._files:
            begun = any(self._series(part).is_file() for part in self.parts)
            remedy = " yet" if begun else "; give the case output.fields.times or output.fields.every"
            raise Problem(f"{self.folder / 'fields'} holds no field files{remedy}")
        return self.times

    def time(self, wanted):
        """The field time that `wanted` means; raises Problem where there is none."""
        self.need_times()
        return self._files.time(wanted)

    def fields(self, time, part="fluid"):
        """One part of the scene at a field time. @param part  "fluid" or "solid"; @return Field; raises Problem"""
        from .field import Field
        if part not in self.parts:
            raise Problem(f"{self.folder} has no part {part!r}, only {' and '.join(self.parts)}")
        found = self.time(time)
        *across, all_rows = self.case["domain"]["elements"]
        *widths, height = self.case["domain"]["size"]
        low, high = self.vertical(part)
        return Field(self._files[found][part], found, part, [*across, round(all_rows * (high - low) / height)],
                     [*[0.0] * len(across), low], [*widths, high])

    def vertical(self, part):
        """Lowest and highest reference position of a part: the wall is at the thickness of the substrate, or at 0."""
        wall = self.case["substrate"]["thickness"] if "substrate" in self.case else 0.0
        return (0.0, wall) if part == "solid" else (wall, self.case["domain"]["size"][-1])

    def _series(self, part):
        return self.folder / "fields" / f"{part}.hdf.series"

    @cached_property
    def _files(self):
        """{time: {part: path}} of the field files that the .series list."""
        series = {part: self._series(part) for part in self.parts}
        missing = [path for path in series.values() if not path.is_file()]
        if missing and len(missing) < len(series):
            raise Problem(f"there is no {missing[0]}, but the case writes one; compute the case again with --overwrite")
        found = {}
        for part, path in series.items() if not missing else ():
            for time, name in read_series(path):
                found.setdefault(time, {})[part] = path.parent / name
        whole = {time: files for time, files in found.items() if len(files) == len(series)}  # a run may be writing now
        return ByTime(whole, "fields")


def read_series(path):
    """[(time, name)] of the field files that a .series lists."""
    try:
        return [(float(entry["time"]), str(entry["name"])) for entry in json.loads(path.read_text())["files"]]
    except (OSError, ValueError, KeyError, TypeError) as error:
        raise Problem(f"cannot read {path}: {error}; is it cut? compute the case again with --overwrite") from error
