#pragma once

#include <span>
#include <string_view>

namespace gxrod {

// The page without its data, in pieces: apps/report/dist/page.html, which the build puts into the program.
std::span<const std::string_view> page_template();

// Where the data go in it.
inline constexpr std::string_view page_data_mark = "<!-- data -->";

}  // namespace gxrod
