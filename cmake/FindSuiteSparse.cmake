# Finds the parts of SuiteSparse that gxrod uses, since Debian ships SuiteSparse without a CMake package.
#
# Components: KLU, UMFPACK, CHOLMOD, AMD, COLAMD, BTF, SuiteSparseConfig.
# Targets:    SuiteSparse::<component>, one for each component asked for.
include(FindPackageHandleStandardArgs)

set(SuiteSparse_KLU_NAMES klu.h klu)
set(SuiteSparse_UMFPACK_NAMES umfpack.h umfpack)
set(SuiteSparse_CHOLMOD_NAMES cholmod.h cholmod)
set(SuiteSparse_AMD_NAMES amd.h amd)
set(SuiteSparse_COLAMD_NAMES colamd.h colamd)
set(SuiteSparse_BTF_NAMES btf.h btf)
set(SuiteSparse_SuiteSparseConfig_NAMES SuiteSparse_config.h suitesparseconfig)

foreach(component IN LISTS SuiteSparse_FIND_COMPONENTS)
  list(GET SuiteSparse_${component}_NAMES 0 header)
  list(GET SuiteSparse_${component}_NAMES 1 library)
  find_path(SuiteSparse_${component}_INCLUDE_DIR ${header} PATH_SUFFIXES suitesparse)
  find_library(SuiteSparse_${component}_LIBRARY ${library})
  mark_as_advanced(SuiteSparse_${component}_INCLUDE_DIR SuiteSparse_${component}_LIBRARY)
  if(SuiteSparse_${component}_INCLUDE_DIR AND SuiteSparse_${component}_LIBRARY)
    set(SuiteSparse_${component}_FOUND TRUE)
    if(NOT TARGET SuiteSparse::${component})
      add_library(SuiteSparse::${component} UNKNOWN IMPORTED)
      set_target_properties(SuiteSparse::${component} PROPERTIES
        IMPORTED_LOCATION "${SuiteSparse_${component}_LIBRARY}"
        INTERFACE_INCLUDE_DIRECTORIES "${SuiteSparse_${component}_INCLUDE_DIR}")
    endif()
  endif()
endforeach()

find_package_handle_standard_args(SuiteSparse HANDLE_COMPONENTS REQUIRED_VARS SuiteSparse_KLU_LIBRARY)
