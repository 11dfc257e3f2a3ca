"""case.toml: the case with the values of the run."""

from .problem import Problem

ANEW = "is it cut? 'softwet check CASE' prints what belongs there"


class CaseTable(dict):
    """A table of a case.toml: a key that is not there is a Problem, since the file has every key of the case."""

    def __init__(self, path, table):
        self.path = path
        super().__init__((key, self.wrap(value)) for key, value in table.items())

    def wrap(self, value):
        if isinstance(value, list):
            return [self.wrap(entry) for entry in value]
        return CaseTable(self.path, value) if isinstance(value, dict) else value

    def __missing__(self, key):
        raise Problem(f"{self.path} has no '{key}': {ANEW}")


def read_case(folder):
    """The tables and keys of case.toml. @param folder  a pathlib.Path; raises Problem"""
    path = folder / "case.toml"
    if not path.is_file():
        raise Problem(f"{folder} is not an output folder of softwet run: it has no case.toml")
    try:
        import tomllib
    except ModuleNotFoundError as error:
        raise Problem(f"cannot read {path}: this needs Python 3.11 or newer; set SOFTWET_PYTHON to one") from error
    try:
        case = CaseTable(path, tomllib.loads(path.read_text(encoding="utf-8")))
    except (OSError, ValueError) as error:
        raise Problem(f"cannot read {path}: {error}; {ANEW}") from error
    for table in ("domain", "output"):  # the first and the last of each case: the file is whole
        case[table]
    return case
