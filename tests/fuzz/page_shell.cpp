#include "report/page_template.hpp"

// A page without its scripts: they are the same in every report, and are most of its bytes.
namespace gxrod {

std::span<const std::string_view> page_template() {
    static constexpr std::string_view pieces[] = {"<html><!-- data --></html>"};
    return pieces;
}

}  // namespace gxrod
