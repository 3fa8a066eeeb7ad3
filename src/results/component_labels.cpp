#include "results/component_labels.hpp"

namespace gxrod {

std::vector<std::string> list_component_labels(const std::string& quantity, std::size_t width) {
    if (width == 1) return {};
    if (width == 2) return {"y", "z"};
    if (width == 4) return {"w", "x", "y", "z"};
    if (width == 6) return {"xx", "yy", "zz", "yz", "xz", "xy"};
    if (quantity == "principal_stress") return {"1", "2", "3"};
    std::vector<std::string> labels{"x", "y", "z"};
    for (std::size_t i = 3; i < width; ++i) labels.push_back(std::to_string(i));
    return labels;
}

}  // namespace gxrod
