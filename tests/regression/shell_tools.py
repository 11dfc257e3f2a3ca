#!/usr/bin/env python3
"""tools/setup, tools/run and tools/test answer before they build, and a missing cmake gets one message that helps.
usage: shell_tools.py SOFTWET"""

import hashlib
import os
import pathlib
import re
import shutil
import signal
import subprocess
import sys
import tempfile
import time

ROOT = pathlib.Path(os.environ["SOFTWET_SOURCE_DIR"])
# Programs that the tools may use while nothing is installed; cmake, ninja and c++ are not among them.
PLAIN = ("bash", "env", "dirname", "sed", "mkdir", "cat", "nproc", "awk", "grep")
failures = []


def check(name, good, seen):
    if not good:
        failures.append(f"{name}: {seen}")


def script(path, text):
    path.parent.mkdir(parents=True, exist_ok=True)
    path.write_text("#!/usr/bin/env bash\n" + text)
    path.chmod(0o755)


def tree(folder):
    """A source tree of shell tools alone, whose program prints the environment it was started in."""
    (folder / "tools").mkdir(parents=True)
    for name in ("setup", "run", "test"):
        shutil.copy(ROOT / "tools" / name, folder / "tools" / name)
    (folder / "case.toml").write_text("")
    script(folder / "build/release/softwet", 'echo "places=${OMP_PLACES:-} words=$*"\n')
    return folder


def bare_path(folder, user, installed):
    """A PATH of a Debian machine on which nothing but PLAIN is installed, seen by this user."""
    folder.mkdir()
    for name in PLAIN:
        (folder / name).symlink_to(shutil.which(name))
    script(folder / "id", f"echo {user}\n")
    script(folder / "apt-get", "exit 100\n")
    script(folder / "dpkg-query", f"echo {'installed' if installed else 'not-installed'}\n")
    script(folder / "sudo", "exit 1\n")
    return str(folder)


def start(folder, *words, **environment):
    return subprocess.run([str(word) for word in words], cwd=folder, capture_output=True, text=True, timeout=900,
                          env={**os.environ, **environment})


def answers(folder):
    """Help and mistakes: nothing is set up."""
    for name in ("setup", "run", "test"):
        for word in ("--help", "-h"):
            done = start(folder, folder / "tools" / name, word, PATH="/usr/bin:/bin")
            check(f"{name} {word}", done.returncode == 0 and done.stdout.startswith(f"usage: tools/{name}"), done)
            check(f"{name} {word} sets nothing up", not (folder / "build/release.lock").exists(), "build/release.lock")
    mistakes = {"no case": ["run"], "missing case": ["run", "typo.toml"], "a folder": ["run", "tools"],
                "unknown option": ["setup", "--fast"]}
    for name, words in mistakes.items():
        done = start(folder, folder / "tools" / words[0], *words[1:])
        lines = done.stderr.splitlines()
        check(name, done.returncode == 1 and len(lines) == 1 and all(word in lines[0] for word in words[1:]), done)
        check(f"{name} sets nothing up", not (folder / "build/release.lock").exists(), "build/release.lock")


def missing_packages(root, folder):
    """One message on what to do, whether the packages, their installation or the whole package system is missing."""
    user = start(folder, folder / "tools/setup", "softwet", PATH=bare_path(root / "user", 1000, False))
    lines = user.stderr.splitlines()
    check("no root", user.returncode == 3 and len(lines) == 2 and "cmake ninja c++" in lines[0]
          and "apt-get install" in lines[1] and "libhdf5-dev" in lines[1], user)
    admin = start(folder, folder / "tools/setup", "softwet", PATH=bare_path(root / "admin", 0, False))
    check("root without network", admin.returncode == 3 and admin.stderr.count("cannot be built") == 1
          and "cmake ninja c++" in admin.stderr, admin)
    path = bare_path(root / "other", 1000, False)
    pathlib.Path(path, "dpkg-query").unlink()
    other = start(folder, folder / "tools/setup", "softwet", PATH=path)
    check("not Debian", other.returncode == 3 and "what Debian calls" in other.stderr and "ninja-build" in other.stderr, other)


def failed_configure(root, folder):
    """Packages are missing, cmake is there and fails: the remedy, and where its output is."""
    path = bare_path(root / "half", 1000, False)
    script(pathlib.Path(path, "cmake"), "echo no HDF5; exit 1\n")
    for name in ("ninja", "c++", "flock"):
        script(pathlib.Path(path, name), "")
    done = start(folder, folder / "tools/setup", "softwet", PATH=path, SOFTWET_CMAKE_ARGS="-DSOFTWET_SYSTEM_KOKKOS=ON")
    lines = done.stderr.splitlines()
    check("cmake fails", done.returncode == 3 and len(lines) == 2 and "configure_release.log" in lines[0]
          and "apt-get install" in lines[1], done)


def places(folder):
    """Threads are bound to cores where the system says which these are."""
    script(folder / "tools/setup", "")
    environment = {key: value for key, value in os.environ.items() if not key.startswith("OMP_")}
    line = ["tools/run", "case.toml", "--quiet"]
    done = subprocess.run(line, cwd=folder, capture_output=True, text=True, env=environment)
    known = os.access("/sys/devices/system/cpu/cpu0/topology/thread_siblings_list", os.R_OK)
    wanted = f"places={'cores' if known else ''} words=run case.toml --quiet"
    check("OMP_PLACES", done.stdout.strip() == wanted, done)
    hide = ["unshare", "--mount", "--map-root-user", "sh", "-c", 'mount -t tmpfs none /sys && exec "$@"', "sh"]
    if shutil.which("unshare") and subprocess.run([*hide, "true"], capture_output=True).returncode == 0:
        done = subprocess.run([*hide, *line], cwd=folder, capture_output=True, text=True, env=environment)
        check("OMP_PLACES without /sys", done.stdout.strip() == "places= words=run case.toml --quiet", done)


def picture(folder):
    """After a run its last state is plotted, where that works, and named; else nothing is said. The exit code is the
    run's, and a wish to stop reaches it."""
    script(folder / "tools/setup", "")
    script(folder / "build/release/softwet", """case "$*" in *--needs*) exit 0 ;; esac
mkdir -p "$FOLDER"
echo "{ \\"process\\": ${WRITER:-$$} }" >"$FOLDER/run.json"
[ -z "${WAITS:-}" ] || { trap 'exit 0' TERM; touch waits; while :; do sleep 0.1; done; }
exit "${CODE:-0}"
""")
    (folder / "case.toml").write_text('name = "a case"\n')
    script(folder / "tools/plot", 'echo "$@" >plot.txt\nexit "${PLOT:-0}"\n')
    line = [folder / "tools/run", "case.toml"]

    def plotted(name, words=(), code=0, **variables):
        (folder / "plot.txt").unlink(missing_ok=True)
        done = start(folder, *line, *words, **variables)
        check(f"picture, {name}: exit code", done.returncode == code, done)
        return (folder / "plot.txt").exists(), done.stderr

    check("picture", plotted("by its name", FOLDER="out/a case") == (True, "  picture:      out/a case/last.png\n"), "not named")
    check("its options", (folder / "plot.txt").read_text().strip() == "out/a case --last --out out/a case/last.png",
          (folder / "plot.txt").read_text())
    for words in (["--out", "here"], ["--out=here"]):
        check("picture in a folder", plotted("a folder", words, FOLDER="here") == (True, "  picture:      here/last.png\n"), words)
    check("no matplotlib", plotted("plot fails", FOLDER="out/a case", PLOT="1") == (True, ""), "something is said")
    check("a run that failed", plotted("it failed", code=2, FOLDER="out/a case", CODE="2") == (False, ""), "plotted")
    check("another run's folder", plotted("another folder", FOLDER="out/a case", WRITER="1") == (False, ""), "plotted")
    check("quiet", plotted("quiet", ["--quiet"], FOLDER="out/a case") == (False, ""), "plotted")
    for number in (signal.SIGTERM, signal.SIGINT):
        (folder / "waits").unlink(missing_ok=True)
        job = subprocess.Popen(line, cwd=folder, env={**os.environ, "FOLDER": "out/a case", "WAITS": "1"}, stderr=subprocess.PIPE)
        while not (folder / "waits").exists():
            time.sleep(0.02)
        job.send_signal(number)
        check(f"stopped by {number.name}", b"last.png" in job.communicate(timeout=60)[1] and job.returncode == 0, job.returncode)


def on_a_gpu(root, folder):
    """The program is built for the device of the machine; what is missing is reported in a sentence."""
    script(folder / "build/cuda/softwet", 'echo "words=$*"\n')
    path = bare_path(root / "gpu", 1000, False)
    for tool in ("head", "tr", "sha256sum", "cp", "mv", "rm"):
        pathlib.Path(path, tool).symlink_to(shutil.which(tool))
    pathlib.Path(path, "dpkg-query").unlink()
    run = [folder / "tools/run", "case.toml"]
    none = start(folder, *run, PATH=path, SOFTWET_PRESET="cuda")
    check("no driver", none.returncode == 3 and len(none.stderr.splitlines()) == 1 and "nvidia-smi" in none.stderr, none)
    script(pathlib.Path(path, "nvidia-smi"), 'case $* in *compute_cap*) echo "$CAPABILITY" ;; esac\n')
    none = start(folder, *run, PATH=path, SOFTWET_PRESET="cuda", CAPABILITY="8.0")
    check("no nvcc", none.returncode == 3 and len(none.stderr.splitlines()) == 1 and "nvcc 12.2" in none.stderr, none)
    for name in ("nvcc", "ninja", "c++", "flock"):
        script(pathlib.Path(path, name), "")
    script(pathlib.Path(path, "cmake"), 'case $1 in --preset) echo "$*" >cmake.txt ;; esac\n')

    def named(wanted, **variables):
        given = {"SOFTWET_PRESET": "cuda", "SOFTWET_CMAKE_ARGS": "-DFETCHCONTENT_SOURCE_DIR_KOKKOS=x", **variables}
        done = start(folder, *run, PATH=path, **given)
        seen = {word for word in (folder / "cmake.txt").read_text().split() if "ARCH" in word and word.endswith("=ON")}
        check(f"architecture of {variables}", done.returncode == 0 and done.stdout == "words=run case.toml\n" and seen == wanted,
              (done, seen))

    for capability, name in (("8.0", "AMPERE80"), ("8.6\n8.6", "AMPERE86"), ("9.0", "HOPPER90"), ("12.0", "BLACKWELL120")):
        named({f"-DKokkos_ARCH_{name}=ON"}, CAPABILITY=capability)
    named({"-DKokkos_ARCH_ADA89=ON"}, CAPABILITY="8.0", SOFTWET_CMAKE_ARGS="-DFETCHCONTENT_SOURCE_DIR_KOKKOS=x -DKokkos_ARCH_ADA89=ON")
    new = start(folder, *run, PATH=path, SOFTWET_PRESET="cuda", CAPABILITY="99.0",
                SOFTWET_CMAKE_ARGS="-DFETCHCONTENT_SOURCE_DIR_KOKKOS=x")
    check("a device that is not known", new.returncode == 3 and "99.0" in new.stderr and "Kokkos_ARCH_AMPERE80" in new.stderr, new)


def source_of_hdf5(root, folder):
    """The preset portable builds HDF5 from a file with the right checksum; without one CMake fetches it."""
    path = bare_path(root / "hdf5", 1000, True)
    for name in ("head", "tr", "sha256sum", "cp", "mv", "rm", "sort"):
        pathlib.Path(path, name).symlink_to(shutil.which(name))
    for name in ("ninja", "c++", "flock"):
        script(pathlib.Path(path, name), "")
    script(pathlib.Path(path, "cmake"), 'case $1 in --preset) echo "$*" >cmake.txt ;; esac\n')
    genuine = folder / "hdf5.tar.gz"
    genuine.write_text("the source")
    setup = folder / "tools/setup"
    setup.write_text(re.sub(r"(library=HDF5 .* sha256=)\w+", rf"\g<1>{hashlib.sha256(genuine.read_bytes()).hexdigest()}", setup.read_text()))
    (folder / "other.tar.gz").write_text("another one")

    def given(preset, file):
        shutil.rmtree(folder / "build/downloads", ignore_errors=True)
        done = start(folder, setup, "softwet", PATH=path, SOFTWET_PRESET=preset, SOFTWET_HDF5_TARBALL=file,
                     SOFTWET_CMAKE_ARGS="-DFETCHCONTENT_SOURCE_DIR_KOKKOS=x")
        found = [word.partition("=")[2] for word in (folder / "cmake.txt").read_text().split() if word.startswith("-DSOFTWET_HDF5_TARBALL=")]
        check(f"{preset} with '{file}' builds", done.returncode == 0, done)
        return found, done.stderr

    found, said = given("portable", "hdf5.tar.gz")
    check("the source of HDF5", len(found) == 1 and pathlib.Path(found[0]).read_text() == "the source", (found, said))
    found, said = given("portable", "other.tar.gz")
    check("another file", not found and "other.tar.gz is not HDF5" in said, (found, said))
    check("a build for one machine", given("release", "hdf5.tar.gz")[0] == [], "it was given a source of HDF5")


def what_a_case_needs(folder):
    """tools/run builds what a case needs: the first time by its file, then as the program says; and says what and how
    long."""
    program = folder / "build/release/softwet"
    script(program, "")
    answer = program.read_text()
    # In place of a build: the program appears; it lacks 3D until that is built.
    script(folder / "tools/setup", f"""echo "$*" >>setup.txt
mkdir -p build/release
cat >{program} <<'P'
{answer}case "$*" in *--needs*) case "$*" in *three*) grep -q 3x2 setup.txt && echo "3x2 built" || echo "3x2 missing" ;; *) echo "2x2 built" ;; esac ;;
*) echo "words=$*" ;; esac
P
chmod +x {program}
""")
    cases = {"plain.toml": ("", "2x2"), "three.toml": ("size = [1, 1, 0.5]\n", "3x2"), "cubic.toml": ("domain = { degree = 3 }\n", "2x3"),
             "axis.toml": ('size = [1, 0.5]\ncoordinates = "axisymmetric"\n', "rz2"), "comment.toml": ("# degree = 3\n", "2x2")}
    for name, (text, configuration) in cases.items():
        program.unlink(missing_ok=True)
        (folder / "setup.txt").unlink(missing_ok=True)
        (folder / name).write_text(text)
        done = start(folder, folder / "tools/run", name, "--quiet")
        calls = (folder / "setup.txt").read_text().splitlines()
        check(f"the first build of {name}", calls == [f"--with {configuration} softwet"] and "minutes on" in done.stderr, (calls, done))
        check(f"{name} runs", done.stdout == f"words=run {name} --quiet\n", done)
    (folder / "setup.txt").unlink()
    done = start(folder, folder / "tools/run", "three.toml")
    calls = (folder / "setup.txt").read_text().splitlines()
    check("a part is added", calls == ["softwet", "--with 3x2 softwet"] and "3D, degree 2" in done.stderr, (calls, done))
    wrong = start(folder, ROOT / "tools/setup", "--with", "4x2")
    check("a configuration that there is not", wrong.returncode == 1 and "4x2" in wrong.stderr and "3x2" in wrong.stderr, wrong)


with tempfile.TemporaryDirectory() as name:
    root = pathlib.Path(name)
    what_a_case_needs(tree(root / "needs"))
    on_a_gpu(root, tree(root / "a_gpu"))
    source_of_hdf5(root, tree(root / "of_hdf5"))
    answers(tree(root / "answers"))
    missing_packages(root, tree(root / "missing"))
    failed_configure(root, tree(root / "configure"))
    places(tree(root / "places"))
    picture(tree(root / "picture"))
for failure in failures:
    print(f"shell_tools: {failure}", file=sys.stderr)
sys.exit(1 if failures else 0)
