#pragma once

#include <cstddef>
#include <string>

#include "model/problem.hpp"

// The stage of a deck that a study examines. Studies run the stages before it, too, and end with it.
namespace gxrod {

// Returns whether a study can refine a stage of this kind: it moves, by steps that its deck gives.
bool can_be_studied(const AnalysisSettings& analysis);

// Finds the stage of this name; for an empty name the last one that can be studied. Throws
// std::invalid_argument with what to do if there is no such stage or a study cannot refine it.
std::size_t find_studied_stage(const Problem& problem, const std::string& name);

// Removes the stages after this one.
void end_with_stage(std::size_t stage, Problem& problem);

// Returns the analysis of the last stage.
inline const AnalysisSettings& studied_analysis(const Problem& problem) {
    return problem.stages.back().analysis;
}

}  // namespace gxrod
