#include "deck/output/sample_times.hpp"

#include <algorithm>

#include "model/settings/analysis_traits.hpp"

namespace gxrod {
namespace {

// Load factors between the bounds that the deck gives.
std::vector<double> sample_path(const PathSettings& path, const AnalysisSettings& analysis) {
    constexpr long parts = 100;
    const double from = path.least_load.value_or(0.0);
    const double to = path.greatest_load || !path.least_load ? end_of(analysis) : 0.0;
    std::vector<double> times;
    for (long i = 0; i <= parts; ++i) {
        const double part = static_cast<double>(i) / static_cast<double>(parts);
        times.push_back((1.0 - part) * from + part * to);
    }
    return times;
}

}  // namespace

std::vector<double> sample_times(const AnalysisSettings& analysis, long most) {
    if (const auto* path = std::get_if<PathSettings>(&analysis)) return sample_path(*path, analysis);
    const auto* dynamic = std::get_if<DynamicSettings>(&analysis);
    const long steps = std::max(1L, dynamic != nullptr ? dynamic->steps : steps_of(analysis));
    const double end_time = end_of(analysis);
    const long samples = std::min(steps, most);
    std::vector<double> times;
    times.reserve(static_cast<std::size_t>(samples) + 1);
    for (long i = 0; i <= samples; ++i) {
        const long step = i * (steps / samples) + i * (steps % samples) / samples;
        times.push_back(end_time * (static_cast<double>(step) / static_cast<double>(steps)));
    }
    return times;
}

}  // namespace gxrod
