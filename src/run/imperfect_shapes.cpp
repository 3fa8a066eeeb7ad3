#include "run/imperfect_shapes.hpp"

#include <fmt/format.h>

#include <cmath>
#include <stdexcept>

#include "run/run.hpp"

namespace gxrod {

std::vector<Vec6> find_buckling_mode(const Problem& problem, int mode) {
    Problem perfect = problem;
    perfect.stages.resize(1);
    perfect.stages.front().analysis = BucklingSettings{.count = mode};
    perfect.output.histories.clear();
    perfect.signals.clear();
    const RunSummary summary = run_analysis(RunRequest{perfect});
    if (summary.shapes.empty()) throw std::runtime_error("no buckling mode: " + summary.reason);
    const auto& record = std::get<BucklingRecord>(summary.shapes.front().record);
    if (!record.failure.empty()) throw std::runtime_error("no buckling mode: " + record.failure);
    const auto index = static_cast<std::size_t>(mode) - 1;
    if (index >= record.factors.size())
        throw std::runtime_error(
            fmt::format("the loads have {} buckling modes of a positive factor", record.factors.size()));
    std::vector<Vec6> shape = record.factors[index].shape.nodes;
    double largest = 0.0;
    for (const Vec6& node : shape) {
        for (int i = 0; i < 3; ++i) {
            if (std::abs(node[i]) > std::abs(largest) * (1.0 + 1e-6)) largest = node[i];
        }
    }
    if (largest < 0.0) {
        for (Vec6& node : shape) node = -node;
    }
    return shape;
}

}  // namespace gxrod
