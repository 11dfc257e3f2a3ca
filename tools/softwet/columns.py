"""What the columns of history.csv and interface.csv, and the fields of fields/*.hdf, are: as `softwet explain` has
them."""

from __future__ import annotations  # an older Python goes on as far as the choice of another one

import functools
import json
from dataclasses import dataclass

from .problem import Problem
from .program import ask


@dataclass(frozen=True)
class Column:
    """A column of a table, or a field.

    unit       as the documentation writes it; "" is a pure number. d is the dimension, 3 in axisymmetric scenes too
    dimension  2 or 3 where the column exists in domains of this dimension alone, else None
    needs      "fluid" or "solid" where its cells are empty without one, else None"""

    name: str
    unit: str
    meaning: str
    dimension: int | None = None
    needs: str | None = None


@functools.cache
def all_columns():
    return {table: {column["name"]: Column(**column) for column in about["columns"]}
            for table, about in json.loads(ask("explain", "--json")[0]).items()}


def columns(table="history"):
    """The columns that a table can have: {name: Column}, columns of further droplets under the name of the first one's.
    Raises Problem where there is no program to ask. @param table  history, interface or fields"""
    tables = all_columns()
    if table not in tables:
        raise Problem(f"there is no table '{table}'; choose among {', '.join(tables)}")
    return dict(tables[table])
