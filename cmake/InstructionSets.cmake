# Sets gxrod_narrowest_set and gxrod_widest_set: baseline, avx2 or avx512. With GXROD_INSTRUCTION_SETS=native both are
# the widest that this machine has.
set(gxrod_instruction_sets baseline avx2 avx512)
set(gxrod_narrowest_set baseline)
set(gxrod_widest_set avx512)
if(NOT CMAKE_SYSTEM_PROCESSOR MATCHES "^(x86_64|AMD64)$")
  set(gxrod_widest_set baseline)
elseif(GXROD_INSTRUCTION_SETS STREQUAL "native")
  execute_process(COMMAND "${CMAKE_CXX_COMPILER}" -march=native -dM -E -x c++ /dev/null OUTPUT_VARIABLE macros)
  set(gxrod_widest_set baseline)
  if(macros MATCHES "__AVX512F__" AND macros MATCHES "__AVX512CD__" AND macros MATCHES "__AVX512DQ__"
      AND macros MATCHES "__AVX512VL__" AND macros MATCHES "__FMA__")
    set(gxrod_widest_set avx512)
  elseif(macros MATCHES "__AVX2__")
    set(gxrod_widest_set avx2)
  endif()
  set(gxrod_narrowest_set ${gxrod_widest_set})
elseif(NOT GXROD_INSTRUCTION_SETS STREQUAL "all")
  message(FATAL_ERROR "GXROD_INSTRUCTION_SETS: expected \"all\" or \"native\", not \"${GXROD_INSTRUCTION_SETS}\"")
endif()

# gxrod_is_built(kernels set result): whether the source <kernels>_lanes_<set>.cpp serves a set that is built: its own, or
# a wider one for which there are no such kernels.
function(gxrod_is_built kernels set result)
  list(FIND gxrod_instruction_sets ${set} number)
  list(FIND gxrod_instruction_sets ${gxrod_narrowest_set} narrowest)
  list(FIND gxrod_instruction_sets ${gxrod_widest_set} widest)
  set(serves_to ${number})
  math(EXPR next "${number} + 1")
  while(next LESS 3)
    list(GET gxrod_instruction_sets ${next} wider)
    if(EXISTS "${kernels}_lanes_${wider}.cpp")
      break()
    endif()
    set(serves_to ${next})
    math(EXPR next "${next} + 1")
  endwhile()
  if(number LESS_EQUAL widest AND serves_to GREATER_EQUAL narrowest)
    set(${result} ON PARENT_SCOPE)
  else()
    set(${result} OFF PARENT_SCOPE)
  endif()
endfunction()

# gxrod_set_instruction_sets(found source...): sources named …_lanes_<set>.cpp are compiled for that instruction set,
# apart from all others, and set `found` to them. What they leave to the linker must be theirs alone
# (tests/house/instruction_sets_test.py). Kernels of elements are made of many small functions of lanes, which g++ is
# to inline however large a kernel becomes: with its own limits damped sections took up to a fifth more instructions.
# They are built from the narrowest to the widest of the sets that GXROD_INSTRUCTION_SETS asks for.
function(gxrod_set_instruction_sets found)
  set(lanes ${ARGN})
  list(FILTER lanes INCLUDE REGEX "_lanes_[a-z0-9]+\\.cpp$")
  set(inlining "")
  if(CMAKE_CXX_COMPILER_ID STREQUAL "GNU")
    set(inlining "--param=inline-unit-growth=400" "--param=large-unit-insns=100000"
      "--param=large-function-growth=2000" "--param=large-stack-frame-growth=20000"
      "--param=max-inline-insns-auto=300" "--param=max-inline-insns-single=1000")
  endif()
  foreach(source IN LISTS lanes)
    set(options "")
    if(source MATCHES "/elements/lanes/")
      set(options ${inlining})
    endif()
    if(CMAKE_SYSTEM_PROCESSOR MATCHES "^(x86_64|AMD64)$")
      if(source MATCHES "_avx2\\.cpp$")
        list(APPEND options "-mavx2")
      elseif(source MATCHES "_avx512\\.cpp$")
        # Eigen's headers ask for FMA; products and sums are not contracted all the same. What g++ 12 calls
        # uninitialized are the undefined registers of its own headers.
        list(APPEND options "-mavx512f" "-mavx512cd" "-mavx512dq" "-mavx512vl" "-mfma" "-Wno-uninitialized"
          "$<$<CXX_COMPILER_ID:GNU>:-Wno-maybe-uninitialized>")
      endif()
    endif()
    string(REGEX REPLACE "_lanes_.*" "" kernels "${source}")
    string(REGEX REPLACE ".*_lanes_([a-z0-9]+)\\.cpp$" "\\1" set "${source}")
    gxrod_is_built("${kernels}" ${set} is_built)
    if(NOT is_built)
      list(REMOVE_ITEM lanes "${source}")
      continue()
    endif()
    set_source_files_properties("${source}" PROPERTIES SKIP_PRECOMPILE_HEADERS ON COMPILE_OPTIONS "${options}")
  endforeach()
  set(${found} "${lanes}" PARENT_SCOPE)
endfunction()
