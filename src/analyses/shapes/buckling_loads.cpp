#include "analyses/shapes/buckling_loads.hpp"

#include <algorithm>
#include <string>

#include "assembly/system_values.hpp"
#include "assembly/tendons/tendon_line.hpp"
#include "model/ties/ties.hpp"

namespace gxrod {

namespace {

void unload(JointCoordinate& one) {
    if (one.motion) one.motion = TimeFunction((*one.motion)(0.0));
    one.drive = TimeFunction();
    one.rest = TimeFunction(one.rest(0.0));
}

void unload(Tendon& tendon) {
    tendon.tension = TimeFunction();
    if (!tendon.winch) return;
    tendon.winch->shortening = TimeFunction(tendon.winch->shortening(0.0));
    tendon.winch->share = TimeFunction(tendon.winch->share(0.0));
    if (tendon.winch->length) tendon.winch->length = TimeFunction((*tendon.winch->length)(0.0));
}

// Its places within sections remain, so that elements are the same ones.
void unload(Actuation& actuation) {
    actuation.strain.fill(LineFunction());
    actuation.temperature = LineFunction();
    actuation.temperature_gradient.fill(LineFunction());
}

bool is_elastic(const Tendon& tendon) { return tendon.winch && tendon.winch->stiffness > 0.0; }

// By how much the increments stretch a tendon.
double compute_stretch(const TendonLine& line, const State& state, const std::vector<Vec6>& increments) {
    const Eigen::VectorXd gradient = line.compute_gradient(state.trial, state);
    double stretch = 0.0;
    Eigen::Index row = 0;
    for (const int node : line.nodes()) {
        stretch += gradient.segment<6>(row).dot(increments[static_cast<std::size_t>(node)]);
        row += 6;
    }
    return stretch;
}

}  // namespace

Model make_unloaded(Model model) {
    model.loads.clear();
    model.distributed_loads.clear();
    model.gravity = TimeVector(Vec3::Zero());
    for (Tendon& tendon : model.tendons) unload(tendon);
    for (Actuation& actuation : model.actuations) unload(actuation);
    for_each_coordinates(model,
                         [](std::size_t, const std::string&, JointCoordinate& turn, JointCoordinate& slide) {
                             unload(turn);
                             unload(slide);
                         });
    return model;
}

TautSystem::TautSystem(const System& system, const State& state, bool at_reference) : given_(&system) {
    const auto can_be_slack = [](const Tendon& tendon) { return tendon.winch && tendon.winch->pulls_only; };
    if (std::ranges::none_of(system.model().tendons, can_be_slack)) return;
    model_.emplace(system.model());
    const std::vector<TendonValues> values = SystemValues(system).compute_tendon_values(state, state.time);
    for (std::size_t i = 0; i < model_->tendons.size(); ++i) {
        if (!can_be_slack(model_->tendons[i])) continue;
        TendonWinch& winch = *model_->tendons[i].winch;
        winch.is_released = winch.is_released || (!at_reference && values[i].tension <= 0.0);
        winch.pulls_only = false;
    }
    own_.emplace(*model_, system.team(), touching_groups_of(system));
}

std::vector<double> compute_tensions(const System& system,
                                     const State& state,
                                     double time,
                                     const std::vector<Vec6>& increments) {
    const Model& model = system.model();
    const std::vector<TendonValues> values = SystemValues(system).compute_tendon_values(state, time);
    std::vector<double> tensions;
    for (std::size_t i = 0; i < model.tendons.size(); ++i) {
        const Tendon& tendon = model.tendons[i];
        tensions.push_back(values[i].tension);
        if (!is_elastic(tendon) || tendon.winch->is_released) continue;
        const TendonLine line(model, tendon);
        tensions[i] +=
            tendon.winch->stiffness * compute_stretch(line, state, increments) / line.start_length();
    }
    return tensions;
}

bool has_elastic_winch(const Model& model) { return std::ranges::any_of(model.tendons, is_elastic); }

Model set_elastic_tensions(const System& system, const State& state, const std::vector<double>& tensions) {
    Model model = system.model();
    for (std::size_t i = 0; i < model.tendons.size(); ++i) {
        if (!is_elastic(model.tendons[i])) continue;
        TendonWinch& winch = *model.tendons[i].winch;
        const TendonLine line(model, model.tendons[i]);
        const double start = line.start_length();
        winch.length.reset();
        winch.shortening = TimeFunction(tensions[i] * start / winch.stiffness -
                                        line.compute_length(state.trial, state) + start);
    }
    return model;
}

}  // namespace gxrod
