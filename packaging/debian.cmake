# `cpack -G DEB` in the build folder makes clogflow_VERSION_ARCH.deb from what is built: nothing is built for it.
set(CPACK_GENERATOR DEB)
set(CPACK_PACKAGE_NAME clogflow)
set(CPACK_PACKAGE_CONTACT "clogflow contributors <clogflow@localhost.invalid>")
set(CPACK_PACKAGE_DESCRIPTION_SUMMARY "clogging of suspensions in constrictions: CFD-DEM, ensembles, statistics")
set(CPACK_DEBIAN_PACKAGE_DESCRIPTION
"One-way coupled CFD-DEM: OpenFOAM computes the steady flow through a
constriction once, a discrete-element solver pushes frictional spheres
through its neck over ensembles of random seeds, and the statistics of
bursts and arrests come out as tables, figures and one page.

The program is clogflow; the package holds example scenes, the Python
package clogflow and the documentation too.")
set(CPACK_PACKAGING_INSTALL_PREFIX /usr)
set(CPACK_PACKAGE_FILE_NAME clogflow)  # of the staging folder
set(CPACK_DEBIAN_FILE_NAME DEB-DEFAULT)
set(CPACK_DEBIAN_PACKAGE_SECTION science)
set(CPACK_DEBIAN_PACKAGE_SHLIBDEPS ON)
# A flow needs openfoam, several ranks openmpi-bin, figures and the page the rest: runs and statistics do without.
set(CPACK_DEBIAN_PACKAGE_RECOMMENDS
  "openfoam, openmpi-bin, python3-numpy, python3-h5py, python3-matplotlib, python3-pandas, libjs-three")
set(CPACK_DEBIAN_PACKAGE_SUGGESTS "ffmpeg, paraview")
set(CPACK_INSTALL_CMAKE_PROJECTS "${PROJECT_BINARY_DIR};clogflow;ALL;/")
set(CPACK_PRE_BUILD_SCRIPTS ${PROJECT_SOURCE_DIR}/packaging/debian_tree.cmake)
include(CPack)
