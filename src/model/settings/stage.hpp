#pragma once

#include <functional>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include "model/model.hpp"
#include "model/settings/settings.hpp"

// Stages: analyses one after the other, each from the state in which the last one leaves the model.
namespace gxrod {

// The actions in one stage, with the model's joints and sleeves as they act in it.
struct StageActions : Actions {
    std::vector<Joint> joints;
    std::vector<Sleeve> sleeves;
};

struct Problem;

struct StagePlan {
    std::string name;  // "" for the only stage of a deck with [analysis]
    AnalysisSettings analysis;
    // Actions as functions of the stage's own t, from 0; empty for the first stage, whose actions are in
    // the model.
    StageActions actions = {};
    long frame_interval = 1;  // as OutputSettings::every
    // The end of its t; for a path, set once it has ended. Shared with later stages that hold values from
    // there.
    std::shared_ptr<double> end = {};
    // Builds the problem with another value of a sweep's parameter. Throws std::runtime_error if there is
    // none.
    std::function<Problem(double value)> vary = {};
};

// Whether one of the stages follows limit points.
bool follows_limits(std::span<const StagePlan> stages);

// Moves the actions out of the model, except joints, which it keeps.
StageActions take_actions(Model& model);
void set_actions(StageActions actions, Model& model);

// The common axis of results: t of the stages added up. Stages without time before the first one with time
// end at 0, each of length 1; with a path among them, whose arc length is not known beforehand, they begin at
// 0.
double find_axis_start(std::span<const StagePlan> stages);
// Returns the end of the stages on this axis; infinity with a path.
double find_axis_end(std::span<const StagePlan> stages);

}  // namespace gxrod
