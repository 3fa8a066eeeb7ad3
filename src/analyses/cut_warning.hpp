#pragma once

#include <cstdint>
#include <string>

#include "model/model.hpp"
#include "model/settings/settings.hpp"

namespace gxrod {

// How often steps had to be repeated with shorter ones.
struct StepCuts {
    std::int64_t steps = 0;      // that a run has gone through: of equal ones, those asked for
    std::int64_t cut_steps = 0;  // of these, each once
    std::int64_t cuts = 0;       // trials that failed
    std::int64_t by_error = 0;   // of these, because the estimated error was too large
};

// Whether these are more than a few; steps chosen by their error are cut for that as a matter of course.
bool are_worth_telling(const StepCuts& cuts);

// "412 of 1000 steps were cut, 903 times in all".
std::string count_cuts(const StepCuts& cuts);

// What makes Newton's method cut steps of this model, and what to try, as the end of a sentence: "; rod b is
// … times as stiff in …. Try …". Nothing that lets a run pass by where it is unstable.
std::string advise_on_cuts(const Model& model, const AnalysisSettings& analysis, bool is_unstable);

}  // namespace gxrod
