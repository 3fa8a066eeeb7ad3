#pragma once

#include <functional>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include "model/model.hpp"
#include "model/settings/settings.hpp"

// Analyses one after the other, each from the state in which the last one leaves the model.
namespace gxrod {

// What acts on a model, and what holds it, in one stage.
struct Actions {
    TimeVector gravity{Vec3::Zero()};
    std::vector<NodalLoad> loads;
    std::vector<DistributedLoad> distributed_loads;
    std::vector<Support> supports;
    std::optional<TurningFrame> rotation = {};
    bool has_inertia = true;
    bool has_time = true;            // of Model::has_time
    std::vector<Joint> joints = {};  // those of the model, with what acts on their coordinates
    std::vector<Sleeve> sleeves = {};
    std::vector<Actuation> actuations = {};
    std::vector<Tendon> tendons = {};  // the same in all stages, those that are slack with a tension of zero
    // The same in all stages but for currents, wind and waves.
    Surroundings surroundings = {};
    Contact contact = {};  // the same in all stages but for the motions of obstacles
};

struct Problem;

struct StagePlan {
    std::string name;  // "" of the one stage of a deck that has [analysis]
    AnalysisSettings analysis;
    Actions actions = {};     // of its own t, from 0; empty of the first stage, whose actions the model has
    long frame_interval = 1;  // as OutputSettings::every
    // Where its t ends; of a path, once it has ended. Shared with what later stages hold at its value there.
    std::shared_ptr<double> end = {};
    // The problem with another value of what a sweep varies. Throws std::runtime_error if there is none.
    std::function<Problem(double value)> vary = {};
};

// Whether one of them follows limit points.
bool follows_limits(std::span<const StagePlan> stages);

// The model's own, which it has no longer, joints excepted.
Actions take_actions(Model& model);
void set_actions(Actions actions, Model& model);

// What follows one axis in the results: t of the stages added up. Stages without time before the first one
// with time end at 0, each of length 1; with a path among them, whose arc length is not known beforehand,
// they begin at 0.
double find_axis_start(std::span<const StagePlan> stages);
// Where they end on it; infinity with a path.
double find_axis_end(std::span<const StagePlan> stages);

}  // namespace gxrod
