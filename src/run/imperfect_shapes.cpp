#include "run/imperfect_shapes.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "analyses/shapes/buckling_loads.hpp"
#include "run/run.hpp"

namespace gxrod {

namespace {

// Runs the perfect structure with an analysis of shapes in place of the first stage.
template <class Record>
Record find_shapes_of(const Problem& problem, const AnalysisSettings& analysis, const char* what) {
    Problem perfect = problem;
    perfect.stages.resize(1);
    perfect.stages.front().analysis = analysis;
    perfect.output.histories.clear();
    perfect.signals.clear();
    const RunSummary summary = run_analysis(RunRequest{perfect});
    if (summary.shapes.empty()) throw std::runtime_error(fmt::format("no {} mode: {}", what, summary.reason));
    Record record = std::get<Record>(summary.shapes.front().record);
    if (!record.failure.empty())
        throw std::runtime_error(fmt::format("no {} mode: {}", what, record.failure));
    return record;
}

std::vector<Vec6> find_buckling_mode(const Problem& problem, int mode) {
    const auto record = find_shapes_of<BucklingRecord>(problem, BucklingSettings{.count = mode}, "buckling");
    const auto index = static_cast<std::size_t>(mode) - 1;
    if (index >= record.factors.size())
        throw std::runtime_error(
            fmt::format("the loads have {} buckling modes of a positive factor", record.factors.size()));
    return record.factors[index].shape.nodes;
}

// As many modes as a stage finds if the deck does not say how many: shapes depend on it in their last digits.
std::vector<Vec6> find_vibration_mode(const Problem& problem, int mode) {
    Problem unloaded = problem;  // in motions gravity and loads act at once
    unloaded.model = make_unloaded(std::move(unloaded.model));
    ModesSettings settings;
    settings.count = std::max(settings.count, mode);
    const auto record = find_shapes_of<ModesRecord>(unloaded, settings, "vibration");
    const auto index = static_cast<std::size_t>(mode) - 1;
    if (index >= record.modes.size())
        throw std::runtime_error(fmt::format("the structure has {} modes of vibration", record.modes.size()));
    return record.modes[index].shape.nodes;
}

}  // namespace

std::vector<Vec6> find_imperfect_mode(const Problem& problem, ModeKind kind, int mode) {
    std::vector<Vec6> shape =
        kind == ModeKind::buckling ? find_buckling_mode(problem, mode) : find_vibration_mode(problem, mode);
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
