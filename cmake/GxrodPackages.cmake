# Debian packages, by cpack: gxrod, python3-gxrod, libgxrod-dev, each a component; and the sources as one archive, by the
# target package_source. docs/howto/develop.md says how.

# What each Debian package has besides: its copyright, the changelogs. Debian wants them compressed.
function(gxrod_compress file result)
  set_property(DIRECTORY APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS "${file}")
  execute_process(COMMAND gzip -9nc "${file}" OUTPUT_FILE "${result}" COMMAND_ERROR_IS_FATAL ANY)
endfunction()
set(gxrod_debian "${PROJECT_BINARY_DIR}/generated/debian")
string(TIMESTAMP gxrod_package_date "%a, %d %b %Y %H:%M:%S +0000" UTC)
set(CPACK_DEBIAN_PACKAGE_RELEASE 1)
# Whoever makes the packages, as Debian's tools know it.
set(CPACK_PACKAGE_CONTACT "the gxrod developers <gxrod@localhost>")
if(DEFINED ENV{DEBEMAIL} AND DEFINED ENV{DEBFULLNAME})
  set(CPACK_PACKAGE_CONTACT "$ENV{DEBFULLNAME} <$ENV{DEBEMAIL}>")
endif()
configure_file(cmake/debian/changelog "${gxrod_debian}/changelog" @ONLY)
gxrod_compress("${gxrod_debian}/changelog" "${gxrod_debian}/changelog.Debian.gz")
gxrod_compress("${PROJECT_SOURCE_DIR}/CHANGELOG.md" "${gxrod_debian}/changelog.gz")
foreach(page gxrod/gxrod gxrod-plot gxrod-import)
  get_filename_component(name ${page} NAME)
  gxrod_compress("${PROJECT_SOURCE_DIR}/apps/${page}.1" "${gxrod_debian}/${name}.1.gz")
endforeach()

function(gxrod_debian_package component name section description)
  install(FILES cmake/debian/copyright "${gxrod_debian}/changelog.gz" "${gxrod_debian}/changelog.Debian.gz"
    DESTINATION ${CMAKE_INSTALL_DATADIR}/doc/${name} COMPONENT ${component} EXCLUDE_FROM_ALL)
  string(TOUPPER ${component} upper)
  set(CPACK_DEBIAN_${upper}_PACKAGE_NAME ${name} PARENT_SCOPE)
  set(CPACK_DEBIAN_${upper}_PACKAGE_SECTION ${section} PARENT_SCOPE)
  set(CPACK_DEBIAN_${upper}_DESCRIPTION "${description}" PARENT_SCOPE)
  set(CPACK_COMPONENTS_ALL ${CPACK_COMPONENTS_ALL} ${component} PARENT_SCOPE)
endfunction()
set(gxrod_about "gxrod computes the statics and dynamics of geometrically exact rods,
and of the rigid bodies and joints among them: cables, slender robots,
blades, trusses of flexible rods.")

gxrod_debian_package(program gxrod science "geometrically exact rod finite elements
${gxrod_about} A model is a text;
its results are one HDF5 file, which Python and ParaView read.

This package has the program, its documentation and its examples.")
install(FILES "${gxrod_debian}/gxrod.1.gz" DESTINATION ${CMAKE_INSTALL_MANDIR}/man1 COMPONENT program)
# Gmsh's library is loaded when a deck names a mesh or a profile.
set(CPACK_DEBIAN_PROGRAM_PACKAGE_RECOMMENDS "python3-gxrod, libgmsh4.8 | libgmsh4.13 | libgmsh4.12t64")

gxrod_debian_package(debian_python python3-gxrod python "geometrically exact rod finite elements (Python 3)
${gxrod_about}

This package has the Python package, which drives runs step by step and
reads results, gxrod-plot, which draws them, and gxrod-import, which
writes blades of other programs as decks.")
set(gxrod_debian_modules lib/python3/dist-packages)  # below the prefix
gxrod_install_python(${gxrod_debian_modules} debian_python EXCLUDE_FROM_ALL)
foreach(script gxrod-plot gxrod-import)
  file(READ apps/${script} gxrod_script)
  string(REPLACE "#!/usr/bin/env python3" "#!/usr/bin/python3" gxrod_script "${gxrod_script}")
  file(WRITE "${gxrod_debian}/${script}" "${gxrod_script}")
  install(PROGRAMS "${gxrod_debian}/${script}" DESTINATION ${CMAKE_INSTALL_BINDIR} COMPONENT debian_python EXCLUDE_FROM_ALL)
  install(FILES "${gxrod_debian}/${script}.1.gz" DESTINATION ${CMAKE_INSTALL_MANDIR}/man1 COMPONENT debian_python)
endforeach()
set(CPACK_DEBIAN_DEBIAN_PYTHON_PACKAGE_DEPENDS "python3 (>= 3.11), python3-numpy")
if(GXROD_PYTHON_MODULE)
  install(TARGETS gxrod_core LIBRARY DESTINATION ${gxrod_debian_modules}/gxrod COMPONENT debian_python EXCLUDE_FROM_ALL)
  get_directory_property(minor DIRECTORY apps/python DEFINITION Python_VERSION_MINOR)
  math(EXPR next "${minor} + 1")
  set(CPACK_DEBIAN_DEBIAN_PYTHON_PACKAGE_DEPENDS "python3 (>= 3.${minor}), python3 (<< 3.${next}), python3-numpy")
endif()
set(CPACK_DEBIAN_DEBIAN_PYTHON_PACKAGE_RECOMMENDS "python3-h5py, python3-matplotlib, python3-pandas, gxrod")
set(CPACK_DEBIAN_DEBIAN_PYTHON_PACKAGE_SUGGESTS "python3-scipy, python3-xarray, python3-yaml")
set(CPACK_DEBIAN_DEBIAN_PYTHON_PACKAGE_CONTROL_EXTRA
  "${PROJECT_SOURCE_DIR}/cmake/debian/postinst;${PROJECT_SOURCE_DIR}/cmake/debian/prerm")

gxrod_debian_package(development libgxrod-dev libdevel "geometrically exact rod finite elements (library)
${gxrod_about}

This package has the library, its headers and a CMake package, for
programs of one's own.")
set(CPACK_DEBIAN_DEVELOPMENT_PACKAGE_DEPENDS "libeigen3-dev, libfmt-dev, libtomlplusplus-dev, nlohmann-json3-dev,\
 libsuitesparse-dev, libhdf5-dev, nettle-dev, libdeflate-dev, libcsv-dev, libmuparser-dev")

set(CPACK_VERBATIM_VARIABLES ON)
set(CPACK_GENERATOR DEB)
set(CPACK_PACKAGE_DESCRIPTION_SUMMARY "")  # each package has its own
set(CPACK_DEBIAN_COMPRESSION_TYPE xz)
set(CPACK_DEB_COMPONENT_INSTALL ON)
set(CPACK_COMPONENTS_GROUPING IGNORE)
set(CPACK_STRIP_FILES ON)
set(CPACK_INSTALL_DEFAULT_DIRECTORY_PERMISSIONS
  OWNER_READ OWNER_WRITE OWNER_EXECUTE GROUP_READ GROUP_EXECUTE WORLD_READ WORLD_EXECUTE)
set(CPACK_DEBIAN_FILE_NAME DEB-DEFAULT)
set(CPACK_DEBIAN_PACKAGE_SHLIBDEPS ON)
set(CPACK_DEBIAN_PACKAGE_CONTROL_STRICT_PERMISSION ON)

set(CPACK_SOURCE_GENERATOR TGZ)
set(CPACK_SOURCE_PACKAGE_FILE_NAME "gxrod-${PROJECT_VERSION}")
# As .gitignore has them, and what git and CMake keep. From the source tree's root, which may itself be in a folder of such a name.
string(REGEX REPLACE "([][+.*()^$?|\\\\])" "\\\\\\1" gxrod_root "${PROJECT_SOURCE_DIR}")
set(CPACK_SOURCE_IGNORE_FILES "^${gxrod_root}/(build|results|\\.git)(/|$)" "^${gxrod_root}/.*\\.vtkhdf$"
  "^${gxrod_root}/(.*/)?(__pycache__|node_modules|\\.pytest_cache|\\.cache)(/|$)" "^${PROJECT_BINARY_DIR}/")
include(CPack)
