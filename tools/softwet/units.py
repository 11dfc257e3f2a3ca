"""The units of the laboratory, in which results are shown where the case has a table [laboratory]. The program writes the unit of each
column into units.json; without that file all numbers are in the units of the case. Needs nothing but Python."""

import json
import re

from .problem import Problem

NAMES = ("laboratory", "dimensionless")  # of the option --units


class Units:
    """The unit in which each column is shown.

    named  whether these are units of a laboratory
    scales  what 1 is in the case, in SI units: length, time, density, stress; {} in the units of the case"""

    def __init__(self, told=None):
        self.tables = told or {}
        self.named = bool(told)
        self.scales = self.tables.get("one_unit_in_si", {})

    def of(self, column, table="history"):
        """The unit of a column, and how much of it one unit of the case is: ("um", 500.0); ("", 1.0) for pure numbers, degrees, and
        in the units of the case. Columns of further droplets have a number at their end."""
        known = self.tables.get(table, {})
        found = known.get(column) or known.get(re.sub(r"_\d+$", "", column))
        return (found["unit"], found["factor"]) if found else ("", 1.0)

    def name(self, column, table="history"):
        """" um" behind a number; empty where there is none."""
        unit = self.of(column, table)[0]
        return f" {unit}" if unit else ""

    def shown(self, columns, table="history"):
        """Columns, or the cells of a row, in these units. @param columns  {name: number or array}"""
        return {name: self.times(values, self.of(name, table)[1]) for name, values in columns.items()}

    @staticmethod
    def times(values, factor):
        if factor == 1:
            return values
        return [value * factor for value in values] if isinstance(values, list) else values * factor


OF_THE_CASE = Units()


class Table(dict):
    """Columns in units of the laboratory: {name: array}, with .unit[name]; degrees and pure numbers have the unit ""."""

    def __init__(self, columns, units, table):
        super().__init__(units.shown(columns, table))
        self.unit = {name: units.of(name, table)[0] for name in columns}


def read_units(folder):
    """The units of an output folder: those of the case where it has no units.json. @param folder  a pathlib.Path;  raises Problem"""
    path = folder / "units.json"
    try:
        told = json.loads(path.read_text(encoding="utf-8"))
        for table in ("history", "interface", "fields"):
            for about in told[table].values():
                float(about["factor"]), str(about["unit"])
        return Units(told)
    except FileNotFoundError:
        return OF_THE_CASE
    except (OSError, ValueError, KeyError, TypeError, AttributeError) as error:
        raise Problem(f"cannot read {path}: {error}; is it cut? compute the case again with --overwrite") from error


def chosen_units(folder, asked):
    """The units for an option --units. @param asked  of NAMES, or None for those of the laboratory where there are some"""
    units = read_units(folder)
    if asked == "laboratory" and not units.named:
        raise Problem(f"--units laboratory: {folder} has the units of the case alone, for its case has no table [laboratory]; "
                      "'softwet units ... --case FILE' writes such a case")
    return OF_THE_CASE if asked == "dimensionless" else units
