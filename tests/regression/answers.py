#!/usr/bin/env python3
"""What softwet says of itself: help, version, manual page and completion; and a reader that reads no further.
usage: answers.py SOFTWET"""

import os
import pathlib
import pty
import re
import select
import shutil
import subprocess
import sys

from _scene import check_true, environment, softwet

ROOT = pathlib.Path(os.environ["SOFTWET_SOURCE_DIR"])


def output(*words):
    return subprocess.run([softwet, *words], capture_output=True, text=True, check=True).stdout


def commands():
    return re.findall(r"^  (\w+) ", output("--help").partition("Subcommands:")[2], re.M)


def test_help_and_version():
    check_true("help", output("help") == output("--help"))
    for command in commands():
        check_true(f"help {command}", output("help", command) == output(command, "--help"), output("help", command))
    wrong = subprocess.run([softwet, "help", "rnu"], capture_output=True, text=True)
    check_true("help rnu", wrong.returncode == 1 and "'softwet run'" in wrong.stderr, wrong.stderr)
    check_true("version", output("version") == output("--version"), output("version"))


def test_manual():
    page = output("man")
    keys = re.findall(r"^([a-z]\S*\.\S+)$", output("explain"), re.M)
    check_true("keys that explain lists", len(keys) > 40, keys)
    for name in [*commands(), *keys]:
        check_true(f"the manual has {name}", re.search(rf"(^\.SS \"|\\fB){re.escape(name)}\b", page, re.M) is not None)
    for option in re.findall(r"^  (--\w+)", output("run", "--help"), re.M):
        check_true(f"the manual has {option}", option.replace("-", "\\-") in page)
    if shutil.which("groff"):
        done = subprocess.run(["groff", "-man", "-ww", "-Tascii"], input=page, capture_output=True, text=True)
        check_true("groff reads the manual without a warning", done.returncode == 0 and not done.stderr, done.stderr)


def completed(line, *files):
    """The words that bash offers at the end of the line."""
    folder = pathlib.Path("completion")
    shutil.rmtree(folder, ignore_errors=True)
    folder.mkdir()
    for file in files:
        (folder / file).touch()
    words = line.replace("=", " = ").split() + ([] if line[-1] not in " " else [""])  # bash takes "=" for a word
    program = 'source <("$0" completion bash); COMP_WORDS=("$@"); COMP_CWORD=$(($# - 1)); _softwet; printf "%s\\n" "${COMPREPLY[@]}"'
    done = subprocess.run(["bash", "-c", program, softwet, *words], cwd=folder, capture_output=True, text=True)
    check_true(f"'{line}' completes", not done.stderr, done.stderr)
    return set(done.stdout.split())


def test_completion():
    registered = subprocess.run(["bash", "-c", 'source <("$0" completion bash); complete -p softwet', softwet],
                                capture_output=True, text=True)
    check_true("registered", registered.stdout.strip() == "complete -F _softwet softwet", registered)
    expected = {
        "softwet ru": {"run"},
        "softwet help ru": {"run"},
        "softwet explain fluid.v": {"fluid.viscosity"},
        "softwet explain load.b": {"load.box"},
        "softwet explain history.mass_d": {"history.mass_drift"},
        "softwet run a.toml --set fluid.v": {"fluid.viscosity="},
        "softwet run a.toml --set=fluid.v": {"fluid.viscosity="},
        "softwet run a.toml --set fluid.wall_law=": {"gradient", "energy"},
        "softwet run a.toml --set fluid.wall_law=g": {"gradient"},
        "softwet run a.toml --over": {"--overwrite"},
        "softwet sweep a.toml --vary substrate.yo": {"substrate.young="},
        "softwet tradeoff a.toml --parameters substrate.yo": {"substrate.young="},
        "softwet run a.toml --threads ": set(),
    }
    for line, words in expected.items():
        check_true(f"'{line}'", completed(line) == words, completed(line))
    check_true("'softwet '", completed("softwet ") >= {*commands(), "--help"})
    found = completed("softwet run my", "my.toml", "my.txt")
    check_true("case files", found == {"my.toml"}, found)


# Names that a shell would take for something else. A pattern that was not quoted would find the name behind it.
NAMES = {"br[": ("br[1].toml", "br1.toml"), "st*": ("st*r.toml", "star.toml"), "qu?": ("qu?ry.toml", "query.toml"),
         "two ": ("two  blanks.toml", "two.toml"), "back\\": ("back\\slash.toml", "back.toml"), "it'": ("it's.toml", "it.toml"),
         'say"': ('say"so".toml', "say.toml"), "dol": ("dol$HOME.toml", "do.toml"), "bra": ("bra{a,b}.toml", "br.toml"),
         "semi": ("semi;colon.toml", "se.toml"), "til": ("til~de.toml", "ti.toml"), "dir[": ("dir[2]/", "dir2/")}


def touch(folder, names):
    shutil.rmtree(folder, ignore_errors=True)
    pathlib.Path(folder).mkdir()
    for name in names:
        path = pathlib.Path(folder, name)
        path.mkdir() if name.endswith("/") else path.touch()


def at_a_prompt(folder, typed):
    """The words that a command gets that is typed at the prompt of bash, then a tab, then return; over a
    pseudo-terminal."""
    process, terminal = pty.fork()
    if process == 0:
        os.chdir(folder)
        os.execvpe("bash", ["bash", "--norc", "--noprofile", "-i"], {**os.environ, "PS1": "", "TERM": "dumb", "HISTFILE": ""})

    def read_until(mark):
        said = b""
        while mark not in said:
            if not select.select([terminal], [], [], 900)[0]:
                break
            try:
                said += os.read(terminal, 4096)
            except OSError:  # the shell has ended
                break
        return said.decode(errors="replace")

    os.write(terminal, f"set +H; bind 'set enable-bracketed-paste off'; . <('{softwet}' completion bash); "
                       "softwet() { printf '<%s>' \"$@\"; echo 'E'ND; }; echo RE''ADY\n".encode())
    read_until(b"READY\r\n")
    os.write(terminal, typed.encode() + b"\t\n")
    said = read_until(b"END\r\n")
    os.close(terminal)
    os.waitpid(process, 0)
    return re.findall(r"<([^\n]*)>END", said)


def test_names():
    """Completion offers the names that are there, as they are."""
    for start, names in NAMES.items():
        touch("names", names)
        program = 'source <("$0" completion bash); COMP_WORDS=("$@"); COMP_CWORD=2; _softwet; printf "%s\n" "${COMPREPLY[@]}"'
        done = subprocess.run(["bash", "-c", program, softwet, "softwet", "run", start], cwd="names", capture_output=True, text=True)
        check_true(f"'{start}'", done.stdout.splitlines() == [names[0].rstrip("/")], done)
        quoted = re.sub(r"([^A-Za-z0-9])", r"\\\1", start)
        words = at_a_prompt("names", f"softwet run {quoted}")
        check_true(f"'{quoted}' at a prompt", words == [f"run><{names[0]}"], f"{words}")
    check_true("an entry of a list", completed("softwet run a.toml --set load[1].fo") == {"load[1].force="})
    check_true("of a list in a table", completed("softwet run a.toml --set substrate.branch[10].t") == {"substrate.branch[10].time="})
    check_true("and its words", completed("softwet run a.toml --set probe[1].operation=v") == {"value"})


def test_cut_output():
    """What `| head` does: the reader ends first. Nothing is complained about, and a run goes on."""
    def cut(line, end):
        program = f'{line} | (exec <&-; sleep {end}); exit "${{PIPESTATUS[0]}}"'
        return subprocess.run(["bash", "-c", program, softwet], capture_output=True, text=True, env=environment)

    for line in ('"$0" explain', '"$0" man', '"$0" verify --list', f'"{ROOT}/tools/sweep" --help'):
        done = cut(line, 1)
        check_true(f"{line}, cut: quiet", done.returncode in (0, 141) and not done.stderr, done)
    case = ROOT / "cases/solid_layer_2d.toml"
    done = cut(f'"$0" run "{case}" --set time.max_steps=3 --overwrite --out cut --threads 1 2>&1', 0)
    check_true("a run goes on", done.returncode == 0 and len(pathlib.Path("cut/history.csv").read_text().splitlines()) > 3, done)


def test_help_of_tools():
    """Commands that are programs of tools/ have the options of the programs, with the same words."""
    for name in ("verify", "sweep", "tradeoff", "status", "watch"):
        told = subprocess.run([softwet, name, "--help"], capture_output=True, text=True, env=environment).stdout
        tool = subprocess.run([str(ROOT / "tools" / name), "--help"], capture_output=True, text=True,
                              env={**environment, "COLUMNS": "400"}).stdout
        options = dict(re.findall(r"^ +(--[a-z-]+)(?: [^a-z ]\S*(?: or NAMES)?)? +(.*)$", tool, re.MULTILINE))
        options.pop("--softwet")
        there = {option for option in re.findall(r"^ +(--[a-z-]+)", told, re.MULTILINE)}
        check_true(f"options of {name}", set(options) == there and all(about in told for about in options.values()),
                   f"{sorted(options)} {sorted(there)}")


test_help_and_version()
test_help_of_tools()
test_manual()
test_completion()
test_names()
test_cut_output()
