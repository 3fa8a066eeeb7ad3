#include "model/settings/stage.hpp"

#include <algorithm>
#include <limits>
#include <utility>

#include "model/settings/analysis_traits.hpp"

namespace gxrod {

Actions take_actions(Model& model) {
    return {std::exchange(model.gravity, TimeVector(Vec3::Zero())),
            std::exchange(model.loads, {}),
            std::exchange(model.distributed_loads, {}),
            std::exchange(model.supports, {}),
            std::exchange(model.rotation, {}),
            std::exchange(model.has_inertia, true),
            std::exchange(model.has_time, true),
            model.joints,
            model.sleeves,
            std::exchange(model.actuations, {}),
            std::exchange(model.tendons, {}),
            std::exchange(model.surroundings, {}),
            std::exchange(model.contact, {})};
}

void set_actions(Actions actions, Model& model) {
    model.gravity = std::move(actions.gravity);
    model.loads = std::move(actions.loads);
    model.distributed_loads = std::move(actions.distributed_loads);
    model.supports = std::move(actions.supports);
    model.rotation = std::move(actions.rotation);
    model.has_inertia = actions.has_inertia;
    model.has_time = actions.has_time;
    model.joints = std::move(actions.joints);
    model.sleeves = std::move(actions.sleeves);
    model.actuations = std::move(actions.actuations);
    model.tendons = std::move(actions.tendons);
    model.surroundings = std::move(actions.surroundings);
    model.contact = std::move(actions.contact);
}

bool follows_limits(std::span<const StagePlan> stages) {
    return std::any_of(stages.begin(), stages.end(), [](const StagePlan& stage) {
        return limit_load_factor_of(stage.analysis).has_value();
    });
}

double find_axis_start(std::span<const StagePlan> stages) {
    double length = 0.0;
    for (const StagePlan& stage : stages) {
        if (!has_steps(stage.analysis)) continue;
        if (is_path(stage.analysis)) return 0.0;
        if (is_timed(stage.analysis)) return -length;
        length += end_of(stage.analysis);
    }
    return 0.0;
}

double find_axis_end(std::span<const StagePlan> stages) {
    double end = find_axis_start(stages);
    for (const StagePlan& stage : stages) {
        if (is_path(stage.analysis)) return std::numeric_limits<double>::infinity();
        if (has_steps(stage.analysis)) end += end_of(stage.analysis);
    }
    return end;
}

}  // namespace gxrod
