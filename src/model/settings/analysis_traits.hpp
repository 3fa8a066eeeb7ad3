#pragma once

#include <optional>

#include "model/settings/settings.hpp"

// What an analysis asks of a model and of its deck, whatever its kind.
namespace gxrod {

struct AnalysisTraits {
    const char* kind = "static";  // as decks say it
    // Takes steps in t that move the state; other kinds look at the state that they are given.
    bool has_steps = true;
    // t is time, and loads are as they are written; otherwise it is the load factor.
    bool is_timed = false;
    // Accelerations are integrated: every free motion needs inertia, and there are initial velocities.
    bool needs_inertia = false;
    // Masses matter, though some motions may have none.
    bool uses_mass = false;
};

AnalysisTraits traits_of(const AnalysisSettings& analysis);

inline const char* kind_of(const AnalysisSettings& analysis) { return traits_of(analysis).kind; }
inline bool has_steps(const AnalysisSettings& analysis) { return traits_of(analysis).has_steps; }
inline bool is_path(const AnalysisSettings& analysis) {
    return std::holds_alternative<PathSettings>(analysis);
}
inline bool is_timed(const AnalysisSettings& analysis) { return traits_of(analysis).is_timed; }
// Of a path that follows limit points, where it is now.
std::optional<double> limit_load_factor_of(const AnalysisSettings& analysis);
inline bool needs_inertia(const AnalysisSettings& analysis) { return traits_of(analysis).needs_inertia; }

// Where t ends, which starts at 0: the time, or the load factor. Of a path, where it may end: its bound,
// or 1.
double end_of(const AnalysisSettings& analysis);
// How many steps it takes to get there if none is cut, of a path at most; 0 if that is not known beforehand,
// or there are none.
long steps_of(const AnalysisSettings& analysis);

}  // namespace gxrod
