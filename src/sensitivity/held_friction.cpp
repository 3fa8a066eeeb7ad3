#include "sensitivity/held_friction.hpp"

#include <algorithm>
#include <cmath>
#include <string>

#include "assembly/tendons/capstan_tension.hpp"
#include "model/sections/kinked_law.hpp"
#include "model/ties/ties.hpp"

namespace gxrod {

namespace {

// By what a slip point moves away from where the coordinate is; 0 where friction sticks.
double find_move(const Friction& friction, double coordinate, double slip) {
    const double stretch = coordinate - slip;
    if (!friction.acts() || std::abs(stretch) < (1.0 - at_its_limit) * friction.stick) return 0.0;
    return -std::copysign(friction.stick, stretch);
}

}  // namespace

HeldFriction::HeldFriction(const System& system, const State& state, double time) {
    find_slips(system, state, time);
    find_tensions(system, state, time);
}

void HeldFriction::find_slips(const System& system, const State& state, double time) {
    const Model& model = system.model();
    if (!has_joint_friction(model)) return;
    const std::vector<JointValues> values = system.joints().compute_joint_values(state, time);
    for_each_coordinates(
        model, [&](std::size_t joint, const std::string&, const auto& turn, const JointCoordinate& slide) {
            const JointState& before = state.joints_previous[joint];
            const Slip slip{joint,
                            find_move(turn.friction, values[joint].turn, before.turn_slip),
                            find_move(slide.friction, values[joint].slide, before.slide_slip)};
            if (slip.turn != 0.0 || slip.slide != 0.0) slips_.push_back(slip);
        });
}

// A tension that does not change where what it was before is lower, or higher, slips that way.
void HeldFriction::find_tensions(const System& system, const State& state, double time) {
    const std::vector<CapstanTension> tendons = list_capstan_tensions(system.model());
    State moved = tendons.empty() ? State{} : state;
    for (const CapstanTension& tendon : tendons) {
        const std::vector<double> tensions = tendon.compute(state.trial, state, time);
        double most = 0.0;
        for (const double tension : tensions) most = std::max(most, tension);
        for (std::size_t i = 0; i < tensions.size(); ++i) {
            const auto slips_to = [&](double direction) {
                tendon.memory(moved)[i] += direction * most;
                const double other = tendon.compute(state.trial, moved, time)[i];
                tendon.memory(moved)[i] -= direction * most;
                return std::abs(other - tensions[i]) <= at_its_limit * most;
            };
            const double direction = slips_to(-1.0) ? -1.0 : slips_to(1.0) ? 1.0 : 0.0;
            tensions_.push_back(direction * most);
        }
    }
}

void HeldFriction::move(State& state) const {
    for (const Slip& slip : slips_) {
        state.joints_previous[slip.joint].turn_slip += slip.turn;
        state.joints_previous[slip.joint].slide_slip += slip.slide;
    }
    const auto memory = std::span(state.law_memory).last(tensions_.size());
    for (std::size_t i = 0; i < tensions_.size(); ++i) memory[i] += tensions_[i];
}

}  // namespace gxrod
