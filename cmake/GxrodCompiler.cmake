# Compiler flags, as one interface target that the library, the program and the tests share.
add_library(gxrod_compiler INTERFACE)

target_compile_options(gxrod_compiler INTERFACE
  -Wall -Wextra -Wpedantic -Wshadow -Wconversion -Wno-sign-conversion -Wnon-virtual-dtor -Woverloaded-virtual
  # g++ 12 sees overlapping copies in "text" + std::string where there are none (GCC bug 105651).
  $<$<CXX_COMPILER_ID:GNU>:-Wno-restrict>
  # g++ 13 and later see a reference into a temporary argument wherever one is returned.
  $<$<AND:$<CXX_COMPILER_ID:GNU>,$<VERSION_GREATER_EQUAL:$<CXX_COMPILER_VERSION>,13>>:-Wno-dangling-reference>)
# g++ first looks for memory to use again when it holds a gigabyte: a tenth less time, a quarter of a gigabyte more memory.
target_compile_options(gxrod_compiler INTERFACE $<$<CXX_COMPILER_ID:GNU>:--param=ggc-min-heapsize=1000000>)
if(GXROD_WARNINGS_AS_ERRORS)
  target_compile_options(gxrod_compiler INTERFACE -Werror)
endif()
# AddressSanitizer and UndefinedBehaviorSanitizer for a target. Null pointers end in the former's report, misaligned ones in
# Eigen's assertions: to check both at every access as well takes a third of the build's time.
function(gxrod_sanitize target)
  get_target_property(type ${target} TYPE)
  set(scope PRIVATE)
  if(type STREQUAL "INTERFACE_LIBRARY")
    set(scope INTERFACE)
  endif()
  target_compile_options(${target} ${scope}
    -fsanitize=address,undefined -fno-sanitize=null,alignment -fno-sanitize-recover=undefined
    -fno-omit-frame-pointer -O1)
  target_link_options(${target} ${scope} -fsanitize=address,undefined)
endfunction()

if(GXROD_SANITIZE STREQUAL "thread")
  target_compile_options(gxrod_compiler INTERFACE -fsanitize=thread -fno-omit-frame-pointer -O1)
  target_link_options(gxrod_compiler INTERFACE -fsanitize=thread)
elseif(GXROD_SANITIZE)
  gxrod_sanitize(gxrod_compiler)
endif()
