# gxrod_set_instruction_sets(found source...): sources named …_lanes_<set>.cpp are compiled for that instruction set,
# apart from all others, and set `found` to them. What they leave to the linker must be theirs alone
# (tests/house/instruction_sets_test.py).
function(gxrod_set_instruction_sets found)
  set(lanes ${ARGN})
  list(FILTER lanes INCLUDE REGEX "_lanes_[a-z0-9]+\\.cpp$")
  foreach(source IN LISTS lanes)
    set(options "")
    if(source MATCHES "_avx2\\.cpp$" AND CMAKE_SYSTEM_PROCESSOR MATCHES "^(x86_64|AMD64)$")
      set(options "-mavx2")
    endif()
    set_source_files_properties("${source}" PROPERTIES SKIP_PRECOMPILE_HEADERS ON COMPILE_OPTIONS "${options}")
  endforeach()
  set(${found} "${lanes}" PARENT_SCOPE)
endfunction()
