# Puts the pages of `gxrod report` together, at build time, as sources, so that the program needs no other file. Sets gxrod_page_sources.
find_program(GXROD_PYTHON python3 PATHS /usr/bin NO_DEFAULT_PATH REQUIRED)
file(GLOB_RECURSE gxrod_page_parts CONFIGURE_DEPENDS "${PROJECT_SOURCE_DIR}/apps/report/src/*"
  "${PROJECT_SOURCE_DIR}/apps/report/libraries/*")
foreach(page page batch study)
  list(APPEND gxrod_page_sources "${PROJECT_BINARY_DIR}/generated/${page}_template.cpp")
endforeach()
add_custom_command(OUTPUT ${gxrod_page_sources}
  COMMAND "${GXROD_PYTHON}" -B "${PROJECT_SOURCE_DIR}/apps/report/build-pages" "${PROJECT_BINARY_DIR}/generated"
  DEPENDS "${PROJECT_SOURCE_DIR}/apps/report/build-pages" ${gxrod_page_parts} VERBATIM)
