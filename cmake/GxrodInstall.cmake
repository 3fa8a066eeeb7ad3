# What `cmake --install` puts where: the program, gxrod-plot, gxrod-import, the Python package, the documentation with its examples; the
# library, its headers and a CMake package by which other programs find it. What is for wheels or for Debian's packages
# alone is EXCLUDE_FROM_ALL; packages are made of components (GxrodPackages.cmake).
include(CMakePackageConfigHelpers)

set(gxrod_share "${CMAKE_INSTALL_DATADIR}/gxrod")
install(TARGETS gxrod RUNTIME DESTINATION ${CMAKE_INSTALL_BINDIR} COMPONENT program)
install(TARGETS gxrod_fmu LIBRARY DESTINATION lib/gxrod COMPONENT program)
# All pages, so that those of the examples find their pictures and what they link to.
install(DIRECTORY docs/ DESTINATION ${gxrod_share} COMPONENT program
  PATTERN __pycache__ EXCLUDE PATTERN "*.vtkhdf" EXCLUDE PATTERN "*.json" EXCLUDE
  REGEX "/docs/(site|verification/book)$" EXCLUDE REGEX "/docs/(verification|performance)/[^/]*\\.py$" EXCLUDE)
install(FILES LICENSE README.md DESTINATION ${CMAKE_INSTALL_DOCDIR} COMPONENT texts)

# gxrod_install_python(FOLDER COMPONENT [EXCLUDE_FROM_ALL]): the Python package, but for its compiled part.
function(gxrod_install_python folder component)
  install(DIRECTORY apps/python/gxrod DESTINATION "${folder}" COMPONENT ${component} ${ARGN}
    FILES_MATCHING PATTERN "*.py" PATTERN "*.pyi" PATTERN py.typed PATTERN __pycache__ EXCLUDE)
  install(FILES "${PROJECT_BINARY_DIR}/python/gxrod/_version.py" DESTINATION "${folder}/gxrod" COMPONENT ${component} ${ARGN})
endfunction()
gxrod_install_python(${gxrod_share}/python python_files)
install(PROGRAMS apps/gxrod-plot apps/gxrod-import DESTINATION ${CMAKE_INSTALL_BINDIR} COMPONENT python_files)
if(SKBUILD)
  # The wheel: scikit-build-core itself adds the files of apps/python/gxrod and makes gxrod-plot and gxrod-import (pyproject.toml).
  install(FILES "${PROJECT_BINARY_DIR}/python/gxrod/_version.py" DESTINATION gxrod COMPONENT python EXCLUDE_FROM_ALL)
  install(TARGETS gxrod RUNTIME DESTINATION "${SKBUILD_SCRIPTS_DIR}" COMPONENT python EXCLUDE_FROM_ALL)
endif()

set(gxrod_package_dir "${CMAKE_INSTALL_LIBDIR}/cmake/gxrod")
install(TARGETS gxrod_library EXPORT gxrod ARCHIVE DESTINATION ${CMAKE_INSTALL_LIBDIR} COMPONENT development)
install(DIRECTORY src/ DESTINATION ${CMAKE_INSTALL_INCLUDEDIR}/gxrod COMPONENT development FILES_MATCHING PATTERN "*.hpp")
install(FILES "${PROJECT_BINARY_DIR}/generated/model/version.hpp" DESTINATION ${CMAKE_INSTALL_INCLUDEDIR}/gxrod/model
  COMPONENT development)
install(EXPORT gxrod NAMESPACE gxrod:: FILE gxrod-targets.cmake DESTINATION ${gxrod_package_dir} COMPONENT development)
configure_file(cmake/gxrod-config.cmake "${PROJECT_BINARY_DIR}/generated/gxrod-config.cmake" COPYONLY)
write_basic_package_version_file("${PROJECT_BINARY_DIR}/generated/gxrod-config-version.cmake"
  COMPATIBILITY SameMinorVersion)
install(FILES "${PROJECT_BINARY_DIR}/generated/gxrod-config.cmake"
  "${PROJECT_BINARY_DIR}/generated/gxrod-config-version.cmake"
  cmake/FindSuiteSparse.cmake cmake/FindNettle.cmake cmake/FindLibdeflate.cmake cmake/FindLibcsv.cmake
  DESTINATION ${gxrod_package_dir} COMPONENT development)
