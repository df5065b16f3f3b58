"""A Spack recipe, to be put into packages/clogflow/ of a repository of your own.

Tested: that it is Python, and that it names what CMakeLists.txt looks for (tests/install/recipes). Not tested: a build by Spack.
There is no published archive: `spack develop clogflow@0.2.0` with the sources, or `url`/`git` of your own copy.
OpenFOAM, which only `clogflow case`'s Allrun calls, is a variant: the versions that Spack builds (v19xx and later of
openfoam.com) are not those of the tests (docs/install.md).
"""

from spack.package import *


class Clogflow(CMakePackage):
    """Clogging of suspensions in constrictions: one-way coupled CFD-DEM, ensembles of seeds, statistics of bursts and arrests."""

    version("0.2.0")

    variant("openfoam", default=True, description="solve flows")
    variant("figures", default=True, description="figures, report and the Python package")

    depends_on("cmake@3.25:", type="build")
    depends_on("ninja", type="build")
    depends_on("pkgconfig", type="build")
    depends_on("eigen@3.4:")
    depends_on("fmt@9:")
    depends_on("nlohmann-json@3.11:")
    depends_on("tomlplusplus@3.2:")
    depends_on("hdf5@1.10: ~mpi")
    depends_on("cli11@2.3:")
    depends_on("mpi")
    depends_on("boost@1.74: +math")
    depends_on("openfoam@1912:", when="+openfoam", type="run")
    depends_on("python@3.11:", when="+figures", type="run")
    depends_on("py-numpy", when="+figures", type="run")
    depends_on("py-h5py", when="+figures", type="run")
    depends_on("py-matplotlib", when="+figures", type="run")
    depends_on("py-pandas", when="+figures", type="run")

    conflicts("%gcc@:11", msg="C++20 as of g++ 12")

    generator = "Ninja"
    build_targets = ["clog"]
    install_targets = ["install"]

    def cmake_args(self):
        return [self.define("BUILD_TESTING", False), self.define("CLOG_UNITY", True)]

    def setup_run_environment(self, env):
        env.prepend_path("PYTHONPATH", self.prefix.share.clogflow.python)
        # Figures take Debian's interpreter unless told.
        if "+figures" in self.spec:
            env.set("CLOG_PYTHON", self.spec["python"].command.path)
