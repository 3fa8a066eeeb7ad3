#pragma once

#include <span>
#include <string>
#include <string_view>

namespace gxrod {

// Returns pages without their data, in pieces, which apps/report/build-pages makes when the program is built.
std::span<const std::string_view> page_template();
std::span<const std::string_view> batch_template();
std::span<const std::string_view> study_template();

// The text before and after the data of a page.
struct PageShell {
    std::string before, after;

    explicit PageShell(std::span<const std::string_view> pieces);
    std::size_t size() const { return before.size() + after.size(); }
};

}  // namespace gxrod
