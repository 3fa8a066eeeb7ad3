#include "deck/build/sample_times.hpp"

#include <algorithm>

#include "model/analysis_traits.hpp"

namespace gxrod {

std::vector<double> sample_times(const AnalysisSettings& analysis, long most) {
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
