# gxrod_set_instruction_sets(found source...): sources named …_lanes_<set>.cpp are compiled for that instruction set,
# apart from all others, and set `found` to them. What they leave to the linker must be theirs alone
# (tests/house/instruction_sets_test.py). Kernels of elements are made of many small functions of lanes, which g++ is
# to inline however large a kernel becomes: with its own limits damped sections took up to a fifth more instructions.
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
    set_source_files_properties("${source}" PROPERTIES SKIP_PRECOMPILE_HEADERS ON COMPILE_OPTIONS "${options}")
  endforeach()
  set(${found} "${lanes}" PARENT_SCOPE)
endfunction()
