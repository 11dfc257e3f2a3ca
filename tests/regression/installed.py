#!/usr/bin/env python3
"""What cmake --install installs works from another place, and nothing else is installed. usage: installed.py SOFTWET"""

import os
import pathlib
import re
import shutil
import subprocess
import sys

BUILD = pathlib.Path(sys.argv[1]).resolve().parent
SOURCE = pathlib.Path(os.environ["SOFTWET_SOURCE_DIR"])
ENVIRONMENT = {name: value for name, value in os.environ.items() if name != "SOFTWET_TOOLS"}
LAYOUT = ("bin/softwet", "share/softwet/cases/tensotaxis_pull_2d.toml", "share/softwet/tools/plot",
          "share/softwet/tests/verification/studies/laplace.py", "share/man/man1/softwet.1",
          "share/bash-completion/completions/softwet", "share/doc/softwet/README.md", "share/doc/softwet/docs/installing.md",
          "share/doc/softwet/copyright")


def check(name, good, seen=""):
    print(f"{'ok' if good else 'FAIL':4}  {name} {'' if good else seen}")
    if not good:
        sys.exit(1)


def start(*words):
    return subprocess.run([str(word) for word in words], capture_output=True, text=True, timeout=900,
                          env={**ENVIRONMENT, "OMP_WAIT_POLICY": "passive"})


for folder in ("first", "second"):
    shutil.rmtree(folder, ignore_errors=True)
done = start("cmake", "--install", BUILD, "--prefix", pathlib.Path("first").resolve())
check("cmake --install", done.returncode == 0, done)
pathlib.Path("first").rename("second")  # the installation can be moved
prefix = pathlib.Path("second").resolve()
files = {str(path.relative_to(prefix)) for path in prefix.rglob("*") if not path.is_dir()}
for name in LAYOUT:
    check(name, name in files, sorted(files))
check("nothing of Kokkos", not [name for name in files if "kokkos" in name.lower()], files)
check("nothing that needs the sources", not files & {f"share/softwet/tools/{name}" for name in ("setup", "run", "test")})

softwet = prefix / "bin/softwet"
# The licence of every library that the program calls is in what is passed on.
LIBRARIES = {"hdf5": "HDF5", "fmt": "fmt", "muparser": "muParser", "gomp": "libgomp", "omp": "libgomp", "stdc++": "libstdc++", "gcc_s": "libgcc",
             "c": "glibc", "m": "glibc", "mvec": "glibc", "pthread": "glibc", "dl": "glibc",
             "mpi": "MPI", "cuda": "CUDA", "cudart": "CUDA"}
if shutil.which("readelf"):
    listed = subprocess.run(["readelf", "-d", softwet], capture_output=True, text=True, check=True).stdout
    called = re.findall(r"NEEDED.*\[(?:lib)?([a-z_+]+[0-9]?[a-z_+]*)[^\]]*\]", listed)
    copyright = (prefix / "share/doc/softwet/copyright").read_text()
    check("it calls libraries", len(called) >= 4, listed)
    for name in called:
        known = next((word for key, word in LIBRARIES.items() if name == key or name.startswith(key + "_")), "nothing" if name != "ld-linux" else "glibc")
        check(f"the licence of {name}", known in copyright, called)

copyright = (prefix / "share/doc/softwet/copyright").read_text()
for name in ("Kokkos", "Eigen", "toml++", "CLI11", "fmt", "muParser", "HDF5"):
    check(f"the licence text of {name}", f"# Licence of {name}\n" in copyright)
if (BUILD / "_deps/kokkos-src/LICENSE").exists():
    check("as its source has it", (BUILD / "_deps/kokkos-src/LICENSE").read_text() in copyright)

# The module shows where the installation is, wherever that is.
module = next(iter((prefix / "share/softwet/modulefiles/softwet").glob("*.*")))
check("the module has the version", f"VERSION {module.name} " in (SOURCE / "CMakeLists.txt").read_text(), module)
if shutil.which("tclsh"):
    pathlib.Path("module.tcl").write_text(f"""foreach word {{conflict module-whatis}} {{ proc $word args {{}} }}
proc prepend-path {{name value}} {{ puts "$name=$value" }}
set ModulesCurrentModulefile {module}
source {module}
""")
    done = start("tclsh", "module.tcl")
    paths = dict(line.split("=") for line in done.stdout.splitlines())
    check("the module", paths == {"PATH": f"{prefix}/bin", "PYTHONPATH": f"{prefix}/lib/python3/dist-packages"}, done)
    check("names paths that exist", all(pathlib.Path(path).is_dir() for path in paths.values()), paths)

# A package holds these libraries and no other: nothing that HDF5 brings along for files on servers (curl, OpenSSL,
# Kerberos, LDAP).
ALLOWED = {f"lib{name}" for name in ("c", "m", "mvec", "pthread", "dl", "rt", "resolv", "fmt", "muparser", "gomp", "omp", "stdc++", "gcc_s")}
if shutil.which("ldd") and shutil.which("objdump"):
    own = "SOFTWET_OWN_HDF5:BOOL=ON" in (BUILD / "CMakeCache.txt").read_text()
    for program in (softwet, "/bin/true", shutil.which("cmake")):
        done = start("cmake", f"-DPROGRAM={program}", "-P", SOURCE / "tools/cmake/package_libraries.cmake")
        refused = set(re.findall(r"\b(lib\S+?)[.]so", done.stderr))
        called = set(re.findall(r"\b(lib\S+?)[.]so\S* =>", start("ldd", program).stdout))
        check(f"packages refuse what they may not hold of {program}", (refused, done.returncode != 0) == (called - ALLOWED, bool(refused)),
              (refused, called))
        check("a program for packages calls nothing else", program != softwet or not own or not refused, refused)

done = start(softwet, "run", prefix / "share/softwet/cases/solid_layer_2d.toml", "--set", "time.max_steps=2", "--out", "out",
             "--overwrite", "--threads", "1")
check("run", done.returncode == 0 and pathlib.Path("out/history.csv").exists(), done)
(prefix / "share/softwet/tests/verification/studies/laplace.py").unlink()
done = start(softwet, "verify", "--list")
check("the studies are the installation's",
      done.returncode == 0 and "tensotaxis" in done.stdout and "laplace" not in done.stdout, done)
done = start(softwet, "sweep", prefix / "share/softwet/cases/solid_layer_2d.toml", "--vary", "substrate.poisson=0,0.3", "--dry-run")
check("sweep", done.returncode == 0 and "2" in done.stdout, done)
done = start(softwet, "tradeoff", prefix / "share/softwet/cases/solid_layer_2d.toml", "--parameters", "tolerance", "--dry-run")
check("tradeoff", done.returncode == 0 and "reference: waiting" in done.stdout, done)

done = start(softwet, "status", "out")
check("status", done.returncode == 0 and done.stdout.count("\n") == 1, done)

link = prefix / "lib/python3/dist-packages/softwet"
check("the link to the Python package can be moved too", link.is_symlink() and not os.path.isabs(os.readlink(link)), link)
ENVIRONMENT["PYTHONPATH"] = str(link.parent)
done = start(sys.executable, "-c", "import softwet; print(softwet.__file__)")
check("the Python package", done.returncode == 0 and done.stdout.strip() == str(link / "__init__.py"), done)
