#!/usr/bin/env python3
"""The version: from the tag and the commits since, from an archive made by git, else that of CMakeLists.txt.
usage: version.py SOFTWET"""

import os
import pathlib
import shutil
import subprocess
import sys
import tempfile

ROOT = pathlib.Path(os.environ["SOFTWET_SOURCE_DIR"])
NAMES = {f"GIT_{role}_{what}": "nobody" for role in ("AUTHOR", "COMMITTER") for what in ("NAME", "EMAIL")}


def git(folder, *words):
    done = subprocess.run(["git", "-C", folder, *words], capture_output=True, text=True, check=True,
                          env={**os.environ, **NAMES, "GIT_CONFIG_GLOBAL": os.devnull})
    return done.stdout.strip()


def version(folder):
    """What the script writes for the sources in this folder."""
    (folder.parent / "in").write_text("@SOFTWET_VERSION@ @SOFTWET_COMMIT@")
    definitions = {"SOURCE_DIR": folder, "PROJECT_VERSION": "0.0.9", "INPUT": folder.parent / "in",
                   "OUTPUT": folder.parent / "out"}
    words = [f"-D{name}={value}" for name, value in definitions.items()]
    subprocess.run(["cmake", *words, "-P", folder / "tools/cmake/version.cmake"], check=True)
    return (folder.parent / "out").read_text().strip()


def check(name, found, wanted):
    print(f"{'ok' if found == wanted else 'FAIL':4}  {name}: {found} (expected {wanted})")
    if found != wanted:
        sys.exit(1)


with tempfile.TemporaryDirectory() as name:
    source = pathlib.Path(name).resolve() / "source"
    for file in ("tools/cmake/version.cmake", "tools/cmake/archive.txt", ".gitattributes"):
        (source / file).parent.mkdir(parents=True, exist_ok=True)
        shutil.copy(ROOT / file, source / file)
    check("neither git nor an archive", version(source), "0.0.9 unknown")
    git(source, "init", "--quiet")
    git(source, "add", ".")
    git(source, "commit", "--quiet", "--message", "one")
    commit = git(source, "rev-parse", "--short=12", "HEAD")
    check("no tag", version(source), f"0.0.9 {commit}")
    git(source, "tag", "other")
    git(source, "tag", "v1.2.3")
    check("at a tag", version(source), f"1.2.3 {commit}")
    (source / ".gitattributes").open("a").write("# changed\n")
    check("changed files", version(source), f"1.2.3 {commit}-dirty")
    git(source, "commit", "--quiet", "--all", "--message", "two")
    commit = git(source, "rev-parse", "--short=12", "HEAD")
    check("a commit later", version(source), f"1.2.3+1 {commit}")

    archive = source / "unpacked"  # inside a repository that is not its own
    archive.mkdir()
    packed = subprocess.run(["git", "-C", source, "archive", "HEAD"], capture_output=True, check=True).stdout
    subprocess.run(["tar", "x", "-C", archive], input=packed, check=True)
    check("an archive", version(archive), f"1.2.3+1 {commit}")
