#!/usr/bin/env python3
"""CMake names all missing libraries in one message, takes fetched ones where that is asked for, and builds HDF5 for
packages without what softwet does not call. usage: libraries.py SOFTWET"""

import json
import os
import pathlib
import shutil
import subprocess
import sys

ROOT = pathlib.Path(os.environ["SOFTWET_SOURCE_DIR"])
WORK = pathlib.Path.cwd() / "work"
# As CMake calls it: as the message calls it, its package in Debian, and a header and a source of its releases.
LIBRARIES = {"HDF5": ("HDF5", "libhdf5-dev", None, None),
             "tomlplusplus": ("toml++", "libtomlplusplus-dev", "include/toml++/toml.h", None),
             "CLI11": ("CLI11", "libcli11-dev", "include/CLI/CLI.hpp", None),
             "fmt": ("fmt", "libfmt-dev", "include/fmt/core.h", "src/format.cc"),
             "muparser": ("muParser", "libmuparser-dev", "include/muParser.h", "src/muParser.cpp"),
             "Eigen3": ("Eigen", "libeigen3-dev", "Eigen/Core", None),
             "MPI": ("MPI", "libopenmpi-dev", None, None),
             "GTest": ("GoogleTest", "libgtest-dev", None, None)}
HDF5 = """cmake_minimum_required(VERSION 3.18)
project(hdf5 C)
file(WRITE ${CMAKE_BINARY_DIR}/hdf5.c "int hdf5;")
add_library(hdf5 STATIC ${CMAKE_BINARY_DIR}/hdf5.c)
install(TARGETS hdf5 ARCHIVE DESTINATION ${HDF5_INSTALL_LIB_DIR})
file(WRITE ${CMAKE_BINARY_DIR}/hdf5.h "")
install(FILES ${CMAKE_BINARY_DIR}/hdf5.h DESTINATION include)
"""
KOKKOS = """if(NOT TARGET Kokkos::kokkos)
  add_library(Kokkos::kokkos INTERFACE IMPORTED)
endif()
set(Kokkos_DEVICES SERIAL)
set(Kokkos_ARCH AVX2)
"""
KOKKOS_VERSION = """set(PACKAGE_VERSION 5.0.2)
set(PACKAGE_VERSION_COMPATIBLE TRUE)
"""


def check(name, good, seen=""):
    print(f"{'ok' if good else 'FAIL':4}  {name} {'' if good else seen}")
    if not good:
        sys.exit(1)


def configure(folder, hidden, *options):
    words = [f"-DCMAKE_DISABLE_FIND_PACKAGE_{name}=ON" for name in hidden]
    done = subprocess.run(["cmake", "-S", ROOT, "-B", WORK / folder, "-G", "Ninja", "-Wno-dev", *words, *options],
                          capture_output=True, text=True, timeout=900)
    return done.returncode, done.stdout + done.stderr


def source(name):
    """A folder with what this library's release has, as far as the build looks at it."""
    for file in LIBRARIES[name][2:]:
        if file:
            path = WORK / name / file
            path.parent.mkdir(parents=True, exist_ok=True)
            path.write_text("")
    key = "EIGEN" if name == "Eigen3" else name.upper()
    return f"-DFETCHCONTENT_SOURCE_DIR_{key}={WORK / name}"


def commands(folder):
    return json.loads((WORK / folder / "compile_commands.json").read_text())


shutil.rmtree(WORK, ignore_errors=True)

# --- one message -----------------------------------------------------------------------------------------------------
code, text = configure("none", LIBRARIES, "-DSOFTWET_MPI=ON")
check("without libraries CMake ends", code != 0, text)
check("with one message", text.count("CMake Error") == 1, text)
for name, package, header, _ in LIBRARIES.values():
    lines = [line for line in text.splitlines() if line.strip().startswith(f"{name} (Debian: {package}")]
    check(f"which names {name}", len(lines) == 1, text)
    check("and whether it can be fetched", ("SOFTWET_FETCH" in lines[0]) == bool(header), lines)
install = next((line.split() for line in text.splitlines() if "apt-get install" in line), [])
check("one command installs all", {row[1] for row in LIBRARIES.values()} <= set(install), text)

code, text = configure("two", ["fmt", "GTest"], "-DSOFTWET_BUILD_CORE=OFF")
check("what is there is not named", code != 0 and "fmt (Debian" in text and "GoogleTest" in text and "toml" not in text and "Eigen" not in text, text)

# --- fetched ---------------------------------------------------------------------------------------------------------
fetched = [name for name, row in LIBRARIES.items() if row[2]]
hdf5 = WORK / "HDF5"
hdf5.mkdir()
(hdf5 / "CMakeLists.txt").write_text(HDF5)
(WORK / "KokkosConfig.cmake").write_text(KOKKOS)
(WORK / "KokkosConfigVersion.cmake").write_text(KOKKOS_VERSION)
options = ("-DSOFTWET_FETCH=ON", "-DSOFTWET_OWN_HDF5=ON", f"-DFETCHCONTENT_SOURCE_DIR_HDF5={hdf5}", "-DSOFTWET_BUILD_TESTS=OFF",
           "-DSOFTWET_SYSTEM_KOKKOS=ON", f"-DKokkos_DIR={WORK}", *map(source, fetched))
code, text = configure("fetched", {*fetched, "HDF5"}, *options)
check("fetched sources are enough", code == 0, text)
for name in fetched:
    headers = WORK / name / ("." if name == "Eigen3" else "include")
    check(f"{name} is taken from there", any(f"-isystem {headers}" in row["command"] for row in commands("fetched")), text)
compiled = {row["file"] for row in commands("fetched")}
check("those with sources are compiled", {str(WORK / "fmt/src/format.cc"), str(WORK / "muparser/src/muParser.cpp")} <= compiled, compiled)

# --- HDF5 of its own -------------------------------------------------------------------------------------------------
done = subprocess.run(["cmake", "--build", WORK / "fetched", "--target", "softwet_hdf5"], capture_output=True, text=True)
check("HDF5 is built", done.returncode == 0 and (WORK / "fetched/hdf5/lib/libhdf5.a").exists(), done)
cache = (WORK / "fetched/hdf5-build/CMakeCache.txt").read_text()
for option in ("BUILD_SHARED_LIBS", "HDF5_ENABLE_Z_LIB_SUPPORT", "HDF5_ENABLE_SZIP_SUPPORT", "HDF5_ENABLE_ROS3_VFD", "HDF5_ENABLE_PARALLEL"):
    check(f"without {option}", f"\n{option}:UNINITIALIZED=OFF" in cache or f"\n{option}:BOOL=OFF" in cache, cache)
check("and its headers are taken", any(f"-isystem {WORK}/fetched/hdf5/include" in row["command"] for row in commands("fetched")), text)

# --- another folder ---------------------------------------------------------------------------------------------------
shutil.rmtree(WORK / "fmt/include")
code, text = configure("fetched", fetched, *options)
check("another folder is refused by its name", code != 0 and f"{WORK / 'fmt'} is not the source of fmt" in " ".join(text.split()), text)
