#include "results/results_size.hpp"

#include <cmath>

#include "model/analysis_traits.hpp"
#include "model/frame_interval.hpp"
#include "results/tables/quantity.hpp"
#include "results/tables/step_columns.hpp"

namespace gxrod {
namespace {

// Numbers of a row of each table of frames (results/tables/frame_table).
constexpr double numbers_of_point = 8.0 * 3.0 + 1.0;
constexpr double numbers_of_cell = 4.0 * 3.0 + 1.0;

double count_frame_numbers(const Model& model) {
    double cells = static_cast<double>(model.bodies.size());
    for (const Rod& rod : model.rods) cells += rod.element_count();
    return numbers_of_point * static_cast<double>(model.nodes.size()) + numbers_of_cell * cells;
}

double count_step_numbers(const OutputSettings& output, bool is_static) {
    double numbers =
        1.0 + count_numbers(ledger_columns, is_static) + count_numbers(solver_columns, is_static);
    for (const HistoryRequest& history : output.histories) {
        for (const Quantity quantity : history.quantities) {
            numbers += quantity_form(quantity, PointKind::rod).shape.columns;
        }
    }
    return numbers;
}

}  // namespace

ResultsSize estimate_results_size(const Model& model,
                                  const AnalysisSettings& analysis,
                                  const OutputSettings& output) {
    // A path may be over long before it has taken as many steps as it is allowed.
    if (has_steps(analysis) && (steps_of(analysis) == 0 || is_path(analysis))) return {};
    ResultsSize size;
    size.steps = static_cast<double>(steps_of(analysis));
    const long every = output.every > 0 ? output.every : choose_frame_interval(analysis);
    size.frames = 1.0 + std::ceil(size.steps / static_cast<double>(every));
    double numbers = (size.steps + 1.0) * count_step_numbers(output, !is_timed(analysis));
    if (output.compression == Compression::none) numbers += size.frames * count_frame_numbers(model);
    size.bytes = numbers * sizeof(double);
    return size;
}

ResultsSize estimate_results_size(const Model& model,
                                  std::span<const StagePlan> stages,
                                  const OutputSettings& output) {
    ResultsSize sum;
    for (const StagePlan& stage : stages) {
        OutputSettings own = output;
        own.every = stage.frame_interval;
        const ResultsSize size = estimate_results_size(model, stage.analysis, own);
        if (size.bytes == 0.0) return {};
        sum.steps += size.steps;
        sum.frames += size.frames;
        sum.bytes += size.bytes;
    }
    return sum;
}

}  // namespace gxrod
