#pragma once

#include <optional>

#include "model/settings/settings.hpp"

// The traits of an analysis that matter to models and decks.
namespace gxrod {

struct AnalysisTraits {
    const char* kind = "static";  // name in decks
    // Whether it takes steps in t that move the state; other kinds examine a given state.
    bool has_steps = true;
    // Whether t is time, and loads are as written; otherwise t is the load factor.
    bool is_timed = false;
    // Whether accelerations are integrated: every free motion needs inertia, and there are initial
    // velocities.
    bool needs_inertia = false;
    // Whether masses matter, though some motions may have none.
    bool uses_mass = false;
};

AnalysisTraits traits_of(const AnalysisSettings& analysis);

inline const char* kind_of(const AnalysisSettings& analysis) { return traits_of(analysis).kind; }
inline bool has_steps(const AnalysisSettings& analysis) { return traits_of(analysis).has_steps; }
inline bool is_path(const AnalysisSettings& analysis) {
    return std::holds_alternative<PathSettings>(analysis);
}
inline bool is_timed(const AnalysisSettings& analysis) { return traits_of(analysis).is_timed; }
// Returns the current load factor of a path that follows limit points.
std::optional<double> limit_load_factor_of(const AnalysisSettings& analysis);
inline bool needs_inertia(const AnalysisSettings& analysis) { return traits_of(analysis).needs_inertia; }

// Returns the end of t, which starts at 0: time or load factor. For a path, a possible end: its bound, or 1.
double end_of(const AnalysisSettings& analysis);
// Returns the number of steps if none is cut, for a path the largest number; 0 if it is not known beforehand,
// or there are no steps.
long steps_of(const AnalysisSettings& analysis);

}  // namespace gxrod
