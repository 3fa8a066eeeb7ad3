# Every library that gxrod builds on. docs/dependencies.md gives the licence and the reason of each.

# find_package, with the Debian package named when something is missing.
macro(gxrod_find name debian_package)
  find_package(${name} ${ARGN} QUIET)
  if(NOT ${name}_FOUND)
    message(FATAL_ERROR "gxrod needs ${name}. On Debian: apt install ${debian_package}")
  endif()
endmacro()

gxrod_find(Eigen3 libeigen3-dev 3.4 NO_MODULE)
gxrod_find(Spectra libspectra-dev)
gxrod_find(SuiteSparse libsuitesparse-dev COMPONENTS KLU UMFPACK CHOLMOD BTF AMD COLAMD SuiteSparseConfig)
gxrod_find(HDF5 libhdf5-dev COMPONENTS C)
gxrod_find(Nettle nettle-dev)
gxrod_find(Libcsv libcsv-dev)
gxrod_find(tomlplusplus libtomlplusplus-dev)
gxrod_find(CLI11 libcli11-dev)
gxrod_find(muparser libmuparser-dev)
gxrod_find(fmt libfmt-dev)
gxrod_find(nlohmann_json nlohmann-json3-dev)
if(GXROD_TESTS)
  gxrod_find(Catch2 catch2 2.13)
endif()
