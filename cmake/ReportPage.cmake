# Writes a source that holds a page of `gxrod report`, so that the program needs no other file. `name` is the function
# of report/page_template.hpp that returns it.
function(gxrod_embed_report_page page name output)
  set_property(DIRECTORY APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS "${page}")
  # As hexadecimal digits first: CMake's lists and brackets do not survive scripts.
  file(READ "${page}" digits HEX)
  string(LENGTH "${digits}" length)
  set(pieces "")
  set(piece_length 32768)
  foreach(first RANGE 0 ${length} ${piece_length})
    string(SUBSTRING "${digits}" ${first} ${piece_length} piece)
    string(REGEX REPLACE "(..)" "\\\\x\\1" piece "${piece}")
    string(APPEND pieces "        \"${piece}\",\n")
  endforeach()
  set(text
"#include \"report/page_template.hpp\"

namespace gxrod {

std::span<const std::string_view> ${name}() {
    static const std::string_view pieces[] = {
${pieces}    };
    return pieces;
}

}  // namespace gxrod
")
  file(CONFIGURE OUTPUT "${output}" CONTENT "@text@" @ONLY)
endfunction()
