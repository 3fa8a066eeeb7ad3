#include "constraints/supports.hpp"

namespace gxrod {

std::vector<FixedComponents> compute_fixed_components(const Model& model) {
    std::vector<FixedComponents> fixed(model.nodes.size(), FixedComponents{});
    for (const Support& support : model.supports) {
        for (int i = 0; i < 6; ++i) {
            fixed[support.node][i] = fixed[support.node][i] || support.fixed[i];
        }
    }
    return fixed;
}

}  // namespace gxrod
