#!/usr/bin/env python3
"""A wheel holds one program, for AVX2, and its libraries: the options of pyproject.toml compile each source once, and
what is installed has the libraries of the program and no others. usage: wheel.py SOFTWET

The program that is installed here is a small one in place of softwet, which takes long to compile."""

import collections
import json
import os
import pathlib
import re
import shutil
import subprocess
import sys
import tomllib

ROOT = pathlib.Path(os.environ["SOFTWET_SOURCE_DIR"])
WORK = pathlib.Path.cwd() / "work"
# Stands for the real one, which takes long to configure.
KOKKOS = """if(NOT TARGET Kokkos::kokkos)
  add_library(Kokkos::kokkos INTERFACE IMPORTED)
  add_custom_target(kokkoscore)
endif()
set(Kokkos_DEVICES SERIAL)
set(Kokkos_ARCH AVX2)
"""


def check(name, good, seen=""):
    print(f"{'ok' if good else 'FAIL':4}  {name} {'' if good else seen}")
    if not good:
        sys.exit(1)


shutil.rmtree(WORK, ignore_errors=True)
(WORK / "hdf5").mkdir(parents=True)
(WORK / "hdf5/CMakeLists.txt").write_text("")
(WORK / "KokkosConfig.cmake").write_text(KOKKOS)
(WORK / "KokkosConfigVersion.cmake").write_text("set(PACKAGE_VERSION 5.0.2)\nset(PACKAGE_VERSION_COMPATIBLE TRUE)\n")
project = tomllib.loads((ROOT / "pyproject.toml").read_text())
wheel = project["tool"]["scikit-build"]["cmake"]["define"]
check("a wheel is for AVX2", wheel["SOFTWET_ARCH"] == "x86-64-v3", wheel)
check("and has an HDF5 of its own", wheel["SOFTWET_OWN_HDF5"] == "ON", wheel)

options = {**wheel, "SOFTWET_UNITY": "1", "SOFTWET_SYSTEM_KOKKOS": "ON", "Kokkos_DIR": WORK, "FETCHCONTENT_SOURCE_DIR_HDF5": WORK / "hdf5",
           "CMAKE_EXPORT_COMPILE_COMMANDS": "ON", "CMAKE_BUILD_TYPE": "Release", "SKBUILD": "ON", "SKBUILD_DATA_DIR": WORK / "data"}


def configure(**more):
    words = [f"-D{key}={value}" for key, value in {**options, **more}.items()]
    return subprocess.run(["cmake", "-S", ROOT, "-B", WORK / "build", "-G", "Ninja", "-Wno-dev", *words], capture_output=True, text=True, timeout=900)


done = configure()
check("the options of a wheel configure", done.returncode == 0, done)

# A source of a configuration, such as 3x2, is compiled for each of them.
sources = collections.Counter()
for row in json.loads((WORK / "build/compile_commands.json").read_text()):
    configuration = tuple(re.findall(r"-DSOFTWET_(?:DIMENSION|DEGREE)=\d", row["command"]))
    sources[row["file"], configuration] += 1
cached = dict(re.findall(r"^(\w+):\w+=(.*)$", (WORK / "build/CMakeCache.txt").read_text(), re.MULTILINE))
configurations = set(cached["SOFTWET_CONFIGURATIONS"].split(";"))
check("it has all configurations", configurations == {"2x2", "rz2", "2x3", "rz3", "3x2"}, configurations)
check("sources are compiled", len(sources) > 200, len(sources))
check("each once", set(sources.values()) == {1}, [key for key, count in sources.items() if count > 1])
ninja = (WORK / "build/build.ninja").read_text()
check("and no second program is built", "x86-64-v4" not in ninja and cached["SOFTWET_AVX512_BESIDE"] == "OFF", cached)


# --- what is installed -----------------------------------------------------------------------------------------------
def install(source, *options):
    """Installs a program of this source in place of softwet."""
    (WORK / "small.cpp").write_text(source)
    padding = re.search(r'OLD_RPATH "([^"]*)"', (WORK / "build/cmake_install.cmake").read_text())
    subprocess.run(["c++", WORK / "small.cpp", "-o", WORK / "build/softwet", f"-Wl,-rpath,{padding[1]}", "-Wl,--disable-new-dtags", *options], check=True)
    shutil.rmtree(WORK / "wheel", ignore_errors=True)
    return subprocess.run(["cmake", "--install", WORK / "build", "--prefix", WORK / "wheel"], capture_output=True, text=True)


done = install("#include <cstdio>\n#include <omp.h>\nint main() { std::printf(\"%d\", omp_get_max_threads()); throw 1; }\n", "-fopenmp")
check("a wheel is installed", done.returncode == 0, done)
held = {path.name for path in (WORK / "wheel/lib").iterdir()}
check("it holds the libraries of the program", held == {"libgomp.so.1", "libstdc++.so.6", "libgcc_s.so.1"}, held)
check("and their licences", "# Licence of fmt" in (WORK / "wheel/copyright").read_text())
crypto = subprocess.run(["c++", "-x", "c++", "-", "-o", WORK / "crypto", "-l:libcrypto.so.3"], input="int main() {}", text=True, capture_output=True)
if crypto.returncode == 0:
    done = install("int main() { return 0; }\n", "-Wl,--no-as-needed", "-l:libcrypto.so.3")
    check("a library that softwet does not call is refused", done.returncode != 0 and "libcrypto.so.3" in done.stderr, done)

# --- a second program, where it is asked for -------------------------------------------------------------------------
done = configure(SOFTWET_AVX512_BESIDE="ON")
second = "\n".join(path.read_text() for path in (WORK / "build/avx512").rglob("*-cfgcmd.txt"))
check("a program for AVX-512 beside it", done.returncode == 0 and "-DSOFTWET_ARCH=x86-64-v4" in second, done)
check("with the same HDF5", {"-DSOFTWET_OWN_HDF5=ON", f"-DFETCHCONTENT_SOURCE_DIR_HDF5={WORK / 'hdf5'}"} <= set(re.split(r"[;']", second)), second)
check("and the same configurations", "-DSOFTWET_CONFIGURATIONS=2x2|rz2|2x3|rz3|3x2;" in second, second)  # | stands for ; until it is called
