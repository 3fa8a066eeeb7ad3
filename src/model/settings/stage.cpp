#include "model/settings/stage.hpp"

#include <algorithm>
#include <limits>
#include <utility>

#include "model/settings/analysis_traits.hpp"

namespace gxrod {

StageActions take_actions(Model& model) {
    Actions& actions = model;
    return {std::exchange(actions, {}), model.joints, model.sleeves};
}

void set_actions(StageActions actions, Model& model) {
    model.joints = std::move(actions.joints);
    model.sleeves = std::move(actions.sleeves);
    static_cast<Actions&>(model) = std::move(actions);
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
