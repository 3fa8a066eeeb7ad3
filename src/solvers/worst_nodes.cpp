#include "solvers/worst_nodes.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "solvers/newton_steps.hpp"

namespace gxrod {

std::vector<WorstNode> find_worst_nodes(const System& system, const Residual& residual, std::size_t count) {
    const NodeScales scales = system.scale_groups().compute_scales(residual);
    const Eigen::VectorXd values = gather(residual.nodal, system.equations());
    std::vector<WorstNode> worst;
    for (std::int64_t i = 0; i < values.size(); ++i) {
        if (values[i] == 0.0) continue;
        const EquationNumbers::Unknown unknown = system.equations().unknown(i);
        const int node = unknown.node;
        const int component = unknown.component;
        double size = std::abs(values[i]) / scales.of(node).of(component);
        if (!std::isfinite(size)) size = std::numeric_limits<double>::infinity();
        if (worst.empty() || worst.back().node != node) worst.push_back({node, component, 0.0});
        if (size > worst.back().residual) worst.back() = {node, component, size};
    }
    std::stable_sort(worst.begin(), worst.end(), [](const WorstNode& a, const WorstNode& b) {
        return a.residual > b.residual;
    });
    worst.resize(std::min(count, worst.size()));
    return worst;
}

std::string name_place(const Model& model, int node, int component) {
    const std::string& name = model.nodes[node].name;
    return component < 0 ? name : fmt::format("{} ({})", name, component_names[component]);
}

}  // namespace gxrod
