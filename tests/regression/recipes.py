#!/usr/bin/env python3
"""The recipes of tools/packaging and CITATION.cff can be read, name what exists, and agree with the sources.
usage: recipes.py SOFTWET

Spack's recipe runs with stand-ins for the classes of Spack. The CMake line of the conda recipe configures."""

import json
import os
import pathlib
import re
import shutil
import subprocess
import sys
import types

ROOT = pathlib.Path(os.environ["SOFTWET_SOURCE_DIR"])
RECIPES = ROOT / "tools/packaging"
BUILD = pathlib.Path(sys.argv[1]).resolve().parent
SOURCES = "\n".join(path.read_text() for path in (ROOT / "CMakeLists.txt", *sorted((ROOT / "tools/cmake").glob("*.cmake"))))
VERSION = re.search(r"project\(softwet VERSION (\S+)", SOURCES)[1]
KOKKOS = re.search(r"softwet_kokkos_version (\S+)\)\nset\(softwet_kokkos_sha256 (\w+)\)", SOURCES).groups()
OPTIONS = set(re.findall(r"(?:option|set)\((SOFTWET_\w+) [^\n]*(?:ON|OFF|CACHE)", SOURCES))


def check(name, good, seen=""):
    print(f"{'ok' if good else 'FAIL':4}  {name} {'' if good else seen}")
    if not good:
        sys.exit(1)


def kokkos_options():
    """Options that the source of Kokkos declares, where this build has it."""
    file = BUILD / "_deps/kokkos-src/cmake/kokkos_arch.cmake"
    if not file.is_file():
        return None
    text = file.read_text()
    names = re.findall(r"kokkos_arch_option\(\s*(\w+)", text, re.IGNORECASE)
    names += " ".join(re.findall(r"SUPPORTED_AMD_ARCHS ([^)]*)", text)).split()
    return {f"Kokkos_ARCH_{name}" for name in names} | {f"Kokkos_ENABLE_{name}" for name in ("CUDA", "HIP", "OPENMP", "SERIAL")}


def unknown(words):
    """The CMake options among these words that nothing declares."""
    known = kokkos_options()
    names = re.findall(r"-D(\w+)=", " ".join(words))
    return {name for name in names if (name.startswith("SOFTWET_") and name not in OPTIONS)
            or (name.startswith("Kokkos_") and known is not None and name not in known)
            or not name.startswith(("SOFTWET_", "Kokkos_", "CMAKE_", "FETCHCONTENT_SOURCE_DIR_KOKKOS"))}


class Spec:
    """A spec of Spack with these variants, for this target."""

    def __init__(self, target, **variants):
        self.target = target
        self.variants = {name: types.SimpleNamespace(value=value) for name, value in variants.items()}

    def satisfies(self, text):
        if text.startswith("target="):
            return text == f"target={self.target}:"
        return text[0] == "+" and bool(self.variants[text[1:]].value)

    def __getitem__(self, name):
        return types.SimpleNamespace(prefix=f"/opt/{name}")


class Package:
    """What the recipe uses of Spack's CMakePackage."""

    stage = types.SimpleNamespace(source_path="/stage")

    def define(self, name, value):
        return f"-D{name}={({True: 'ON', False: 'OFF'}[value]) if isinstance(value, bool) else value}"

    def define_from_variant(self, name, variant):
        return self.define(name, self.spec.variants[variant].value)


def spack_recipe():
    """The class of the recipe, and its declarations: names of directives with their arguments."""
    declared = []
    directives = ("license", "version", "variant", "conflicts", "generator", "depends_on", "extends", "resource")
    modules = {"spack": {}, "spack.package": {name: lambda *words, _name=name, **more: declared.append((_name, words, more)) for name in directives},
               "spack_repo": {}, "spack_repo.builtin": {}, "spack_repo.builtin.build_systems": {}}
    for file, name in (("cmake", "CMakePackage"), ("cuda", "CudaPackage"), ("rocm", "ROCmPackage")):
        modules[f"spack_repo.builtin.build_systems.{file}"] = {name: Package if file == "cmake" else type(name, (), {})}
    for name, names in modules.items():
        sys.modules[name] = types.ModuleType(name)
        vars(sys.modules[name]).update(names)
    path = RECIPES / "spack/packages/softwet/package.py"
    space = {"__file__": str(path)}
    exec(compile(path.read_text(), str(path), "exec"), space)
    return space["Softwet"], declared


# --- Spack -----------------------------------------------------------------------------------------------------------
Softwet, declared = spack_recipe()
variants = {words[0]: more for name, words, more in declared if name == "variant"}
check("Spack: it has its variants", {"mpi", "cuda_arch", "amdgpu_target", "configurations"} <= set(variants), variants)
check("Spack: its source is this repository", Softwet.git == f"file://{ROOT.resolve()}", Softwet.git)
resource = next(more for name, _, more in declared if name == "resource")
check("Spack: its Kokkos is the one of the sources", resource["sha256"] == KOKKOS[1] and KOKKOS[0] in resource["url"], resource)
plain = {"mpi": False, "cuda": False, "rocm": False, "cuda_arch": "none", "amdgpu_target": "none", "configurations": ("2x2", "3x2")}
expected = {(): {"-DSOFTWET_MPI=OFF", "-DSOFTWET_ARCH=x86-64-v3", "-DSOFTWET_CONFIGURATIONS=2x2;3x2"},
            (("mpi", True),): {"-DSOFTWET_MPI=ON"},
            **{(("cuda", True), ("cuda_arch", arch)): {"-DKokkos_ENABLE_CUDA=ON"} for arch in variants["cuda_arch"]["values"][1:]},
            **{(("rocm", True), ("amdgpu_target", arch)): {"-DKokkos_ENABLE_HIP=ON", "-DCMAKE_CXX_COMPILER=/opt/hip/bin/hipcc"}
               for arch in variants["amdgpu_target"]["values"][1:]}}
for changes, wanted in expected.items():
    package = Softwet()
    package.spec = Spec("x86_64_v3", **{**plain, **dict(changes)})
    words = package.cmake_args()
    check(f"Spack: CMake options with {dict(changes)}", wanted <= set(words) and not unknown(words), (words, unknown(words)))
architectures = set(re.search(r"names=\((VOLTA70[^)]*)\)", (ROOT / "tools/setup").read_text())[1].split())
package = Softwet()
for arch in variants["cuda_arch"]["values"][1:]:
    package.spec = Spec("x86_64_v3", **{**plain, "cuda": True, "cuda_arch": arch})
    names = re.findall(r"-DKokkos_ARCH_(\w+)=ON", " ".join(package.cmake_args()))
    check(f"Spack: the architecture of {arch}", len(names) == 1 and names[0] in architectures and names[0].endswith(arch), names)

# --- Apptainer -------------------------------------------------------------------------------------------------------
presets = {row["name"] for row in json.loads((ROOT / "CMakePresets.json").read_text())["configurePresets"]}
for path in sorted((RECIPES / "apptainer").glob("*.def")):
    text = path.read_text()
    posts = re.findall(r"^%(?:post|test|runscript|environment)\n((?:    .*\n|\n)*)", text, re.MULTILINE)
    check(f"{path.name}: two stages", re.findall(r"^Stage: (\w+)$", text, re.MULTILINE) == ["build", "final"] and text.count("%post") == 2, text)
    for post in posts:
        done = subprocess.run(["bash", "-n"], input=post, capture_output=True, text=True)
        check(f"{path.name}: shell syntax", done.returncode == 0, done)
    named = re.findall(r"SOFTWET_PRESET=(\w+)", text)
    check(f"{path.name}: presets exist", named and set(named) <= presets, named)
    check(f"{path.name}: the installed build is the preset", f"--install build/{named[0]} " in text, named)
    check(f"{path.name}: CMake options exist", not unknown([text]), unknown([text]))

# --- conda, CITATION.cff ---------------------------------------------------------------------------------------------
named = set(re.findall(r"`([^`]+)`", "\n".join(re.findall(r"^\| ([^|]*) \|", (RECIPES / "README.md").read_text(), re.MULTILINE))))
files = {str(path.relative_to(RECIPES)) for path in RECIPES.rglob("*") if path.is_file() and "__pycache__" not in path.parts} - {"README.md"}
check("the README names all files", named == files, named ^ files)
try:
    import yaml
except ImportError:
    sys.exit(print("the recipe of conda and CITATION.cff were not read: the Python module yaml is missing; on Debian: apt-get install python3-yaml"))

citation = yaml.safe_load((ROOT / "CITATION.cff").read_text())
check("CITATION.cff: title, version and date", citation["title"] and citation["version"] == VERSION
      and re.fullmatch(r"\d{4}-\d\d-\d\d", str(citation["date-released"])), citation)
check("Spack: its repository is named", yaml.safe_load((RECIPES / "spack/repo.yaml").read_text())["repo"]["namespace"] == "softwet")

recipe = yaml.safe_load((RECIPES / "conda/meta.yaml").read_text())
check("conda: the version", recipe["package"]["version"] == VERSION, recipe)
here, kokkos = recipe["source"]
check("conda: its source is this repository", (RECIPES / "conda" / here["path"]).resolve() == ROOT.resolve(), here)
check("conda: its Kokkos is the one of the sources", kokkos["sha256"] == KOKKOS[1] and KOKKOS[0] in kokkos["url"], kokkos)
for name in recipe["about"]["license_file"]:
    check(f"conda: {name} exists", (ROOT / pathlib.Path(name).relative_to(here["folder"])).is_file())
script = recipe["build"]["script"]
check("conda: CMake options exist", not unknown(script), unknown(script))
source = BUILD / "_deps/kokkos-src"
if source.is_dir():
    shutil.rmtree("conda", ignore_errors=True)
    work = pathlib.Path("conda").resolve()
    work.mkdir()
    (work / "softwet").symlink_to(ROOT)
    (work / "kokkos").symlink_to(source)
    done = subprocess.run(["bash", "-c", script[0]], cwd=work, capture_output=True, text=True, timeout=1200,
                          env={**os.environ, "SRC_DIR": str(work), "PREFIX": "/usr"})
    check("conda: its CMake line configures, and CMake uses all options", done.returncode == 0 and "not used by the project" not in done.stderr, done)
