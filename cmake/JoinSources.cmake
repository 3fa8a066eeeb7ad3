# gxrod_join_sources(targets source...): if GXROD_JOIN_SOURCES names one of the targets, or is "all", these sources are
# compiled in the groups that join-sources finds, so that what they include is read, instantiated and compiled once for
# each group. Groups are kept from one configuration to the next.
function(gxrod_join_sources targets)
  set(wanted "")
  foreach(target IN LISTS targets)
    if(TARGET ${target} AND (GXROD_JOIN_SOURCES STREQUAL "all" OR target IN_LIST GXROD_JOIN_SOURCES))
      list(APPEND wanted ${target})
    endif()
  endforeach()
  if(NOT wanted)
    return()
  endif()
  list(GET targets 0 first)
  find_program(GXROD_PYTHON python3 PATHS /usr/bin NO_DEFAULT_PATH REQUIRED)
  execute_process(COMMAND "${GXROD_PYTHON}" -B "${PROJECT_SOURCE_DIR}/cmake/join-sources"
    --keep "${PROJECT_BINARY_DIR}/${first}.groups" ${ARGN}
    OUTPUT_VARIABLE groups OUTPUT_STRIP_TRAILING_WHITESPACE COMMAND_ERROR_IS_FATAL ANY)
  string(REPLACE "\n" ";" groups "${groups}")
  foreach(line IN LISTS groups)
    string(REGEX MATCH "^([0-9]+) (.*)$" line "${line}")
    set_source_files_properties("${CMAKE_MATCH_2}" PROPERTIES UNITY_GROUP "${first}_${CMAKE_MATCH_1}")
  endforeach()
  foreach(target IN LISTS wanted)
    set_target_properties(${target} PROPERTIES UNITY_BUILD ON UNITY_BUILD_MODE GROUP)
    # Inlined otherwise, g++ 12 sees values of std::optional, and Eigen's, used before they are set, and copies of texts
    # out of bounds.
    target_compile_options(${target} PRIVATE $<$<CXX_COMPILER_ID:GNU>:-Wno-maybe-uninitialized;-Wno-array-bounds;
      -Wno-stringop-overflow;-Wno-stringop-overread>)
  endforeach()
endfunction()

# gxrod_precompile_for_groups(target header...): where the target's sources are compiled in groups, reads what most of the
# groups include once, headers of gxrod too. Not for single sources: a change of one of these headers compiles all again.
function(gxrod_precompile_for_groups target)
  if(NOT GXROD_JOIN_SOURCES STREQUAL "all")
    return()
  endif()
  foreach(header IN LISTS ARGN)
    foreach(folder src tests)
      if(EXISTS "${PROJECT_SOURCE_DIR}/${folder}/${header}")
        set(header "${PROJECT_SOURCE_DIR}/${folder}/${header}")
      endif()
    endforeach()
    target_precompile_headers(${target} PRIVATE "${header}")
  endforeach()
endfunction()

# Without CMake's "#pragma GCC system_header", in whose reach there are no warnings.
set(CMAKE_PCH_PROLOGUE "")
