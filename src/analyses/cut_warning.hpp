#pragma once

#include <cstdint>
#include <string>

#include "model/model.hpp"
#include "model/settings/settings.hpp"

namespace gxrod {

// Counts of steps that were repeated with shorter ones.
struct StepCuts {
    std::int64_t steps = 0;      // steps that a run has completed; with equal steps, the steps asked for
    std::int64_t cut_steps = 0;  // cut steps, each counted once
    std::int64_t cuts = 0;       // failed trials
    std::int64_t by_error = 0;   // trials that failed because the estimated error was too large
};

// Whether the cuts are worth a warning; steps chosen by their error are cut for that error as a matter of
// course.
bool are_worth_telling(const StepCuts& cuts);

// Counts cuts in words, as in "412 of 1000 steps were cut, 903 times in all".
std::string count_cuts(const StepCuts& cuts);

// Says why Newton's method cuts steps of this model and what to try, as the end of a sentence: "; rod b is …
// times as stiff in …. Try …". Suggests nothing that would let an unstable run continue.
std::string advise_on_cuts(const Model& model, const AnalysisSettings& analysis, bool is_unstable);

}  // namespace gxrod
