#include "model/settings/frame_interval.hpp"

#include <cmath>

#include "model/settings/analysis_traits.hpp"

namespace gxrod {

long choose_frame_interval(const AnalysisSettings& analysis) {
    const long steps = steps_of(analysis);
    if (steps == 0) return has_steps(analysis) && !is_path(analysis) ? 0 : 1;
    for (long decade = 1;; decade *= 10) {
        for (const long every : {decade, 2 * decade, 5 * decade}) {
            if (steps / every <= default_frames) return every;
        }
    }
}

bool is_frame_time(double before, double after, double end_time) {
    const auto part = [end_time](double time) {
        return std::floor(static_cast<double>(default_frames) * (time / end_time));
    };
    return part(after) > part(before);
}

}  // namespace gxrod
