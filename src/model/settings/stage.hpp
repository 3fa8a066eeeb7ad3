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

// The actions on a model, and its supports, in one stage.
struct Actions {
    TimeVector gravity{Vec3::Zero()};
    std::vector<NodalLoad> loads;
    std::vector<DistributedLoad> distributed_loads;
    std::vector<Support> supports;
    std::optional<TurningFrame> rotation = {};
    bool has_inertia = true;
    bool has_time = true;            // as Model::has_time
    std::vector<Joint> joints = {};  // the model's joints, with the actions on their coordinates
    std::vector<Sleeve> sleeves = {};
    std::vector<Actuation> actuations = {};
    std::vector<Tendon> tendons = {};  // the same in all stages; slack ones have a tension of zero
    // The same in all stages except currents, wind and waves.
    Surroundings surroundings = {};
    Contact contact = {};  // the same in all stages except the motions of obstacles
};

struct Problem;

struct StagePlan {
    std::string name;  // "" for the only stage of a deck with [analysis]
    AnalysisSettings analysis;
    Actions actions = {};  // by its own t, from 0; empty for the first stage, whose actions are in the model
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
Actions take_actions(Model& model);
void set_actions(Actions actions, Model& model);

// The common axis of results: t of the stages added up. Stages without time before the first one with time
// end at 0, each of length 1; with a path among them, whose arc length is not known beforehand, they begin at
// 0.
double find_axis_start(std::span<const StagePlan> stages);
// Returns the end of the stages on this axis; infinity with a path.
double find_axis_end(std::span<const StagePlan> stages);

}  // namespace gxrod
