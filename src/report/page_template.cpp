#include "report/page_template.hpp"

namespace gxrod {

namespace {

constexpr std::string_view data_mark = "<!-- data -->";

}  // namespace

PageShell::PageShell(std::span<const std::string_view> pieces) {
    for (const std::string_view piece : pieces) before += piece;
    const std::size_t mark = before.find(data_mark);
    after = before.substr(mark + data_mark.size());
    before.resize(mark);
}

}  // namespace gxrod
