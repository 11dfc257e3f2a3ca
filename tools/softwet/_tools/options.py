"""The options of a command, as commands.toml declares them for the command line of softwet too."""

import argparse
import pathlib
import tomllib

from .messages import fail

PACKAGE = pathlib.Path(__file__).resolve().parent.parent
KINDS = {"path": pathlib.Path, "integer": int, "number": float, "list": lambda text: text.split(",")}


def parse(command, about):
    """What the command line says. @param about  the docstring of the program: a line or two of usage, a blank line,
    what it does
    @return  an attribute for each option; `softwet` is the path of the program"""
    declared = tomllib.loads((PACKAGE / "commands.toml").read_text())["command"]
    options = next(entry["option"] for entry in declared if entry["name"] == command)
    parser = argparse.ArgumentParser(prog=f"tools/{command}", description=about.partition("\n\n")[2], allow_abbrev=False)
    parser.error = fail
    alone = [option for option in options if option.get("alone")]
    group = parser.add_mutually_exclusive_group() if alone else None
    for option in options:
        add(group if option in alone else parser, option)
    add_program(parser)
    arguments = parser.parse_args()
    for option in options:
        check_range(option, vars(arguments).get(option["name"].lstrip("-").replace("-", "_")))
    return arguments


def check_range(option, value):
    """Refuses a number that the option does not take."""
    low, high = option.get("least"), option.get("most")
    if low is not None and value is not None and not low <= value <= high:
        fail(f"{option['name']} {value}: must be in [{low}, {high}]; it is the {option['help'].partition(';')[0]}")


def add_program(parser):
    parser.add_argument("--softwet", type=pathlib.Path, metavar="PROGRAM",
                        help="the program; default: SOFTWET_PROGRAM, else that of the installation or of the build")


def add(parser, option):
    """An option as argparse has it."""
    name, words = option["name"], {"help": option["help"].replace("%", "%%")}
    if not name.startswith("--"):
        some = {"nargs": "+" if option.get("required") else "*"} if option.get("several") else {}
        return parser.add_argument(name.lower(), metavar=name, type=KINDS.get(option.get("kind"), str), **words, **some)
    if "value" not in option:
        return parser.add_argument(name, action="store_true", **words)
    kept = {"action": "append", "default": []} if option.get("repeatable") else {"default": default_of(option)}
    return parser.add_argument(name, metavar=option["value"], type=KINDS.get(option.get("kind"), str),
                               choices=option.get("choices"), **words, **kept)


def default_of(option):
    """The value without the option, of the kind that the option has."""
    return pathlib.Path(option["default"]) if option.get("kind") == "path" and "default" in option else option.get("default")
