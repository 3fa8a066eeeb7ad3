#pragma once

#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "study/deck_study.hpp"

// Outcome of a study of a user's deck, for readers and for programs.
namespace gxrod {

// Texts of `gxrod verify DECK`, in the order of its output.
std::string describe_plan(const std::vector<DeckVariant>& variants);
std::string run_head();
std::string describe_run(const VariantRun& run);
std::string describe_errors(const DeckStudy& study);
std::string describe_properties(const DeckStudy& study);

// Says in sentences which results can be trusted, and what to refine.
std::vector<std::string> judge(const DeckStudy& study);

// Returns the whole study. `with_curves` adds the values of the unchanged deck and its estimated errors over
// time, at some hundred samples.
nlohmann::ordered_json to_json(const DeckStudy& study, bool with_curves);

}  // namespace gxrod
