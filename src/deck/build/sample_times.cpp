#include "deck/build/sample_times.hpp"

#include <algorithm>

namespace gxrod {

std::vector<double> sample_times(const AnalysisSettings& analysis, long most) {
    const auto* dynamic = std::get_if<DynamicSettings>(&analysis);
    const long steps = dynamic != nullptr ? dynamic->steps : std::get<StaticSettings>(analysis).steps;
    const double end_time = dynamic != nullptr ? dynamic->end_time : 1.0;
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
