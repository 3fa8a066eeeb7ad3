#include "results/results_size.hpp"

#include <cmath>

#include "model/sections/rods_in_fluid.hpp"
#include "model/settings/analysis_traits.hpp"
#include "model/settings/frame_interval.hpp"
#include "results/tables/step_columns.hpp"
#include "watch/quantities.hpp"

namespace gxrod {
namespace {

// Numbers of a row of each table of frames (results/tables/frame_table).
constexpr double numbers_of_point = 8.0 * 3.0 + 1.0;
constexpr double numbers_of_cell = 4.0 * 3.0 + 1.0;

double count_frame_numbers(const Model& model) {
    double cells = static_cast<double>(model.bodies.size());
    for (const Rod& rod : model.rods) cells += rod.element_count();
    const double of_point =
        numbers_of_point + (model.contact.is_empty() ? 0.0 : 4.0) + (has_rods_on_ground(model) ? 3.0 : 0.0);
    const double of_cell = numbers_of_cell + (has_rods_in_water(model) ? 1.0 : 0.0);
    return of_point * static_cast<double>(model.nodes.size()) + of_cell * cells;
}

double count_history_numbers(const OutputSettings& output) {
    double numbers = 1.0;
    for (const HistoryRequest& history : output.histories) {
        for (const Quantity* quantity : quantities_of(history)) numbers += quantity->columns;
    }
    return numbers;
}

double count_step_numbers(const OutputSettings& output, bool is_static) {
    return count_numbers(ledger_columns, is_static) + count_numbers(solver_columns, is_static) +
           count_history_numbers(output);
}

}  // namespace

ResultsSize estimate_results_size(const Model& model,
                                  const AnalysisSettings& analysis,
                                  const OutputSettings& output) {
    const bool has_times = is_timed(analysis) && (output.interval || !output.times.empty());
    const bool knows_steps = steps_of(analysis) > 0 || !has_steps(analysis);
    // A path may be over long before it has taken as many steps as it is allowed.
    if (is_path(analysis) || (!knows_steps && !has_times)) return {};
    ResultsSize size;
    size.steps = static_cast<double>(steps_of(analysis));
    if (has_times) {
        size.frames = output.interval ? 1.0 + std::ceil(end_of(analysis) / *output.interval)
                                      : 2.0 + static_cast<double>(output.times.size());
    } else {
        const long every = output.every > 0 ? output.every : choose_frame_interval(analysis);
        size.frames = 1.0 + std::ceil(size.steps / static_cast<double>(every));
    }
    double numbers = (size.steps + 1.0) * count_step_numbers(output, !is_timed(analysis));
    if (is_timed(analysis) && output.history_interval)
        numbers += end_of(analysis) / *output.history_interval * count_history_numbers(output);
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
