"""Builds softwet with Spack: spack repo add tools/packaging/spack, then spack install softwet."""

from pathlib import Path

from spack_repo.builtin.build_systems.cmake import CMakePackage
from spack_repo.builtin.build_systems.cuda import CudaPackage
from spack_repo.builtin.build_systems.rocm import ROCmPackage

from spack.package import *

# What Kokkos calls the devices.
CUDA = {"70": "VOLTA70", "72": "VOLTA72", "75": "TURING75", "80": "AMPERE80", "86": "AMPERE86", "87": "AMPERE87", "89": "ADA89",
        "90": "HOPPER90", "100": "BLACKWELL100", "120": "BLACKWELL120"}
AMD = {"gfx90a": "AMD_GFX90A", "gfx942": "AMD_GFX942"}
# SOFTWET_ARCH of Spack's targets, the best one first.
X86 = {"x86_64_v4": "x86-64-v4", "x86_64_v3": "x86-64-v3"}


class Softwet(CMakePackage, CudaPackage, ROCmPackage):
    """Droplets on soft solids: Navier-Stokes-Korteweg and large deformations, in two and three dimensions."""

    git = f"file://{Path(__file__).resolve().parents[5]}"  # the repository that this recipe is part of

    license("BSD-3-Clause")

    version("main", branch="main")

    variant("mpi", default=False, description="Several processes compute a scene together")
    variant("cuda_arch", default="none", values=("none", *CUDA), multi=False, when="+cuda", description="Compute capability of the device")
    variant("amdgpu_target", default="none", values=("none", *AMD), multi=False, when="+rocm", description="Architecture of the device")
    variant("configurations", default="2x2,rz2,2x3,rz3,3x2", values=("2x2", "rz2", "2x3", "rz3", "3x2", "3x3"), multi=True,
            description="Dimension x degree; rz2 and rz3 for the coordinates (r, z)")
    conflicts("+cuda", when="cuda_arch=none", msg="softwet: name one device, as in cuda_arch=90")
    conflicts("+rocm", when="amdgpu_target=none", msg="softwet: name one device, as in amdgpu_target=gfx90a")
    conflicts("+cuda", when="+rocm", msg="softwet computes on devices of one kind")
    conflicts("%gcc@:10", msg="softwet needs g++ 11 or newer")

    generator("ninja")
    depends_on("c", type="build")
    depends_on("cxx", type="build")
    depends_on("cmake@3.25:", type="build")
    depends_on("hdf5~mpi")
    depends_on("eigen@3.4:3")
    depends_on("fmt@9:")
    depends_on("muparser@2.3:")
    depends_on("tomlplusplus@3.3:")
    depends_on("cli11@2.1:")
    depends_on("mpi", when="+mpi")
    depends_on("cuda@12.2:", when="+cuda")
    depends_on("hip@6.2:", when="+rocm")
    depends_on("rocthrust", when="+rocm")
    extends("python")
    depends_on("python@3.11:", type=("build", "run"))
    depends_on("py-numpy", type="run")
    depends_on("py-h5py", type="run")
    depends_on("py-matplotlib", type="run")

    # Version and checksum are the ones in tools/cmake/kokkos.cmake.
    resource(name="kokkos", url="https://github.com/kokkos/kokkos/releases/download/5.0.2/kokkos-5.0.2.tar.gz",
             sha256="188817bb452ca805ee8701f1c5adbbb4fb83dc8d1c50624566a18a719ba0fa5e", placement="kokkos")

    def cmake_args(self):
        spec = self.spec
        arguments = [self.define("SOFTWET_BUILD_TESTS", False),
                     self.define("FETCHCONTENT_SOURCE_DIR_KOKKOS", f"{self.stage.source_path}/kokkos"),
                     self.define("SOFTWET_CONFIGURATIONS", ";".join(spec.variants["configurations"].value)),
                     self.define_from_variant("SOFTWET_MPI", "mpi")]
        if spec.satisfies("+cuda"):
            name = CUDA[spec.variants["cuda_arch"].value]
            return [*arguments, self.define("Kokkos_ENABLE_CUDA", True), self.define(f"Kokkos_ARCH_{name}", True)]
        if spec.satisfies("+rocm"):
            name = AMD[spec.variants["amdgpu_target"].value]
            return [*arguments, self.define("Kokkos_ENABLE_HIP", True), self.define(f"Kokkos_ARCH_{name}", True),
                    self.define("CMAKE_CXX_COMPILER", f"{spec['hip'].prefix}/bin/hipcc")]
        for target, arch in X86.items():
            if spec.satisfies(f"target={target}:"):
                return [*arguments, self.define("SOFTWET_ARCH", arch)]
        return arguments

    def setup_run_environment(self, env):
        env.prepend_path("PYTHONPATH", f"{self.prefix}/lib/python3/dist-packages")
