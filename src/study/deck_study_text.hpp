#pragma once

#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "study/deck_study.hpp"

// What a study of a user's deck found, for readers and for programs.
namespace gxrod {

// Of `gxrod verify DECK`, in the order of its output.
std::string describe_plan(const std::vector<DeckVariant>& variants);
std::string run_head();
std::string describe_run(const VariantRun& run);
std::string describe_errors(const DeckStudy& study);
std::string describe_properties(const DeckStudy& study);

// In plain words: what can be trusted, and what to refine. A sentence each.
std::vector<std::string> judge(const DeckStudy& study);

// All of it. `with_curves`: the values of the deck as it is and its estimated errors over time, too, at some
// hundred samples.
nlohmann::ordered_json to_json(const DeckStudy& study, bool with_curves);

}  // namespace gxrod
