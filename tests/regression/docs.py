#!/usr/bin/env python3
"""The pages of the documentation are true: their commands work, their links lead somewhere, the reference is up to
date.
usage: docs.py SOFTWET [PAGE...]   with the names of pages, the commands of these alone

A block of commands in README.md, docs/*.md and docs/development/*.md starts with ```console. A comment before it says
how it is run here:
  <!-- run: KEY=VALUE ... -->        as it stands, with these settings (--set) for softwet run, steady, check, sweep and
  tradeoff
  <!-- run: check KEY=VALUE ... -->  only checked: softwet check instead of run, --dry-run for the last two, no tools
  <!-- run: no, REASON -->           not at all
The comment <!-- file: NAME --> before a block makes a file of it. The blocks of a page run one after the other in a
folder that holds cases/ and tools/. tools/run stands for softwet run; tools/setup and tools/test are left out. python3
is the one that runs this test, and finds the package softwet."""

import importlib.util
import os
import pathlib
import re
import shlex
import shutil
import subprocess
import sys

from _scene import environment, softwet

ROOT = pathlib.Path(os.environ["SOFTWET_SOURCE_DIR"])
# README.md, docs/*.md and the pages of docs/development; what commands write has no commands
PAGES = [ROOT / "README.md", *sorted((ROOT / "docs").glob("*.md")), *sorted((ROOT / "docs/development").glob("*.md"))]
FILE = re.compile(r"<!-- file: (\S+) -->\n```\w*\n(.*?)```", re.DOTALL)
BLOCK = re.compile(r"(?:<!-- run:(?P<how>[^\n]*?)-->\n)?```console\n(?P<text>.*?)```", re.DOTALL)
SECONDS = 900  # for one command
failures = []

environment = {**environment, "OMP_NUM_THREADS": "1", "PYTHONPATH": str(ROOT / "tools"), "PYTHONDONTWRITEBYTECODE": "1",
               "PATH": f"{pathlib.Path(softwet).parent}{os.pathsep}{os.environ['PATH']}"}
try:
    import matplotlib  # noqa: F401
    left_out = {"tools/setup", "tools/test"}
except ImportError:
    print("no matplotlib: tools that draw are left out")
    left_out = {"tools/setup", "tools/test", "tools/plot", "tools/report", "tools/figures", "tools/figures3d",
                "tools/papers"}
if importlib.util.find_spec("pyvista") is None:
    print("no pyvista: pictures in 3D are left out")
    left_out |= {"tools/figures3d"}


def expect(name, condition, detail=""):
    """Prints what holds and what does not; all failures are reported before the test ends."""
    print(f"{'ok' if condition else 'FAIL':4}  {name} {'' if condition else detail}")
    if not condition:
        failures.append(name)


def commands(text):
    """The commands of a block, as lists of words; a line that ends in a backslash goes on in the next one."""
    for line in text.replace("\\\n", " ").splitlines():
        words = shlex.split(line, comments=True)
        if words:
            yield words


def with_settings(words, settings, checked_only):
    """What is started for a command of a page; empty where it is left out."""
    if words[0] == "tools/run":
        words = ["softwet", "run", *words[1:]]
    if words[0] in left_out or (checked_only and words[0] != "softwet"):
        return []
    if words[0] == "python3":
        return [] if "tools/plot" in left_out else [sys.executable, *words[1:]]
    if words[0].startswith("tools/"):
        return [sys.executable, str(ROOT / words[0]), *words[1:]]
    if "--picture" in words and "tools/plot" in left_out:
        words = words[:words.index("--picture")] + words[words.index("--picture") + 2:]
    sets = [word for setting in settings for word in ("--set", setting)]
    command = words[1] if words[0] == "softwet" else ""
    if command == "run" and checked_only:
        case = [word for word in words[2:] if word not in ("--resume", "--overwrite")]
        while "--out" in case:
            del case[case.index("--out"):case.index("--out") + 2]
        return ["softwet", "check", *case, *sets]
    computed = ["--threads", "1", "--quiet", *sets]
    extra = {"run": computed, "steady": computed, "check": sets, "sweep": sets, "tradeoff": sets,
             "converge": ["--threads", "1", *sets]}.get(command, [])
    dry = ["--dry-run"] if command in ("sweep", "tradeoff", "converge") and checked_only and "--table" not in words else []
    return [*words, *extra, *dry]


def run_page(page):
    """Runs the blocks of a page in a fresh folder."""
    folder = pathlib.Path(page.stem).resolve()
    shutil.rmtree(folder, ignore_errors=True)
    folder.mkdir()
    for name in ("cases", "tools"):
        (folder / name).symlink_to(ROOT / name)
    for name, text in FILE.findall(page.read_text()):
        (folder / name).write_text(text)
    for block in BLOCK.finditer(page.read_text()):
        first = block["text"].splitlines()[0]
        expect(f"{page.name}: the block '{first}' says how it is run", block["how"] is not None)
        if block["how"] is None:
            continue
        how = block["how"].strip()
        if how.startswith("no,"):
            continue
        settings = how.split()
        checked_only = settings[:1] == ["check"]
        for words in commands(block["text"]):
            started = with_settings(words, settings[1:] if checked_only else settings, checked_only)
            if not started:
                continue
            result = subprocess.run(started, cwd=folder, env=environment, capture_output=True, text=True,
                                    timeout=SECONDS)
            expect(f"{page.name}: {shlex.join(words)}", result.returncode == 0,
                   f"exit code {result.returncode}\n{result.stderr[-2000:]}")


def help_of(*command):
    return subprocess.run([softwet, *command, "--help"], capture_output=True, text=True, env=environment).stdout


def code_of(text):
    """What a page shows as code: blocks, indented or fenced, and pieces of a line."""
    blocks = re.findall(r"^```\w*\n(.*?)^```", text, re.DOTALL | re.MULTILINE)
    indented = re.findall(r"^ {4}\S.*$", text, re.MULTILINE)
    return [*(line for block in blocks for line in block.replace("\\\n", " ").splitlines()), *indented,
            *re.findall(r"(?<!`)`([^`\n]+)`(?!`)", text)]


def check_options(pages):
    """Every `softwet COMMAND --option` of a page exists."""
    known, asked = help_of(), {}
    for page in pages:
        for code in code_of(page.read_text()):
            found = re.match(r"(?:exec )?softwet ([a-z]+)\b([^#|;]*)", code.strip())
            if not found:
                continue
            command, rest = found.groups()
            expect(f"{page.relative_to(ROOT)}: softwet {command} exists",
                   re.search(rf"^ +{command}\b", known, re.MULTILINE) is not None, code)
            if command not in asked:
                asked[command] = help_of(command)
            for option in re.findall(r"(?<!\S)--[a-z-]+", rest):
                expect(f"{page.relative_to(ROOT)}: softwet {command} has {option}",
                       re.search(rf"{option}\b(?!-)", asked[command]) is not None, code)


def check_links(pages):
    """Every relative link leads to a file or folder of the repository."""
    for page in pages:
        text = re.sub(r"```.*?```", "", page.read_text(), flags=re.DOTALL)
        for target in re.findall(r"\]\(([^)\s]+)\)", text):
            if re.match(r"[a-z]+:|#", target):
                continue
            there = (page.parent / target.partition("#")[0]).exists()
            expect(f"{page.relative_to(ROOT)}: link to {target}", there)


def check_front_page():
    """Every page of docs/ has its place in docs/README.md."""
    front = (ROOT / "docs/README.md").read_text()
    for page in PAGES[1:]:
        name = page.relative_to(ROOT / "docs").as_posix()
        expect(f"docs/README.md leads to {name}", name == "README.md" or f"]({name})" in front)


every_page = [path for folder in ("", "cases", "docs", "kernels", "src", "tests", "tools")
              for path in sorted((ROOT / folder).glob("**/*.md" if folder else "*.md"))]
check_links(every_page)
check_front_page()
check_options([page for page in every_page if "verification" not in page.parts])
reference = subprocess.run([softwet, "explain", "--markdown"], capture_output=True, text=True, check=True).stdout
expect("docs/reference.md is what 'softwet explain --markdown' prints; write it again with that command",
       (ROOT / "docs/reference.md").read_text() == reference)
for page in PAGES:
    if not sys.argv[2:] or page.name in sys.argv[2:]:
        run_page(page)
for failure in failures:
    print(f"docs: {failure}", file=sys.stderr)
sys.exit(1 if failures else 0)
