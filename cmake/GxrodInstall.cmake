# What `cmake --install` and CPack's Debian package hold: the program, gxrod-plot, the Python package, examples; the library, its headers and
# a CMake package by which other programs find it.
include(CMakePackageConfigHelpers)

set(gxrod_package_dir "${CMAKE_INSTALL_LIBDIR}/cmake/gxrod")
install(TARGETS gxrod RUNTIME DESTINATION ${CMAKE_INSTALL_BINDIR})
install(PROGRAMS apps/gxrod-plot DESTINATION ${CMAKE_INSTALL_BINDIR})
install(DIRECTORY apps/python/gxrod DESTINATION ${CMAKE_INSTALL_DATADIR}/gxrod/python
  FILES_MATCHING PATTERN "*.py" PATTERN __pycache__ EXCLUDE)
install(FILES "${PROJECT_BINARY_DIR}/python/gxrod/_version.py" DESTINATION ${CMAKE_INSTALL_DATADIR}/gxrod/python/gxrod)
install(FILES "${PROJECT_BINARY_DIR}/python/gxrod/_version.py" DESTINATION gxrod COMPONENT python EXCLUDE_FROM_ALL)
install(DIRECTORY docs/examples DESTINATION ${CMAKE_INSTALL_DATADIR}/gxrod)
install(FILES LICENSE README.md DESTINATION ${CMAKE_INSTALL_DOCDIR})

install(TARGETS gxrod_library EXPORT gxrod ARCHIVE DESTINATION ${CMAKE_INSTALL_LIBDIR})
install(DIRECTORY src/ DESTINATION ${CMAKE_INSTALL_INCLUDEDIR}/gxrod FILES_MATCHING PATTERN "*.hpp")
install(FILES "${PROJECT_BINARY_DIR}/generated/model/version.hpp" DESTINATION ${CMAKE_INSTALL_INCLUDEDIR}/gxrod/model)
install(EXPORT gxrod NAMESPACE gxrod:: FILE gxrod-targets.cmake DESTINATION ${gxrod_package_dir})
configure_file(cmake/gxrod-config.cmake "${PROJECT_BINARY_DIR}/generated/gxrod-config.cmake" COPYONLY)
write_basic_package_version_file("${PROJECT_BINARY_DIR}/generated/gxrod-config-version.cmake"
  COMPATIBILITY SameMinorVersion)
install(FILES "${PROJECT_BINARY_DIR}/generated/gxrod-config.cmake"
  "${PROJECT_BINARY_DIR}/generated/gxrod-config-version.cmake"
  cmake/FindSuiteSparse.cmake cmake/FindNettle.cmake cmake/FindLibdeflate.cmake cmake/FindLibcsv.cmake
  DESTINATION ${gxrod_package_dir})

set(CPACK_GENERATOR DEB)
set(CPACK_PACKAGE_CONTACT "the gxrod developers <gxrod@localhost>")
set(CPACK_PACKAGE_DESCRIPTION_SUMMARY "geometrically exact rod finite elements")
set(CPACK_PACKAGING_INSTALL_PREFIX "/usr")
set(CPACK_STRIP_FILES ON)
set(CPACK_DEBIAN_FILE_NAME DEB-DEFAULT)
set(CPACK_DEBIAN_PACKAGE_SECTION science)
set(CPACK_DEBIAN_PACKAGE_SHLIBDEPS ON)
set(CPACK_DEBIAN_PACKAGE_RECOMMENDS "python3, python3-numpy, python3-h5py, python3-matplotlib")
set(CPACK_DEBIAN_PACKAGE_SUGGESTS "cmake, libeigen3-dev, libfmt-dev, libtomlplusplus-dev, nlohmann-json3-dev,\
 libsuitesparse-dev, libhdf5-dev, nettle-dev, libdeflate-dev, libcsv-dev, libmuparser-dev")
include(CPack)
