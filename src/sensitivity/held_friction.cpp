#include "sensitivity/held_friction.hpp"

#include <algorithm>
#include <cmath>
#include <string>

#include "assembly/tendons/capstan_tension.hpp"
#include "model/sections/kinked_law.hpp"
#include "model/ties/ties.hpp"
#include "state/joint_state.hpp"
#include "state/memory_slice.hpp"

namespace gxrod {

namespace {

// By what a slip point moves away from where the coordinate is; 0 where friction sticks.
double find_move(const Friction& friction, double coordinate, double slip) {
    const double stretch = coordinate - slip;
    if (!friction.acts() || std::abs(stretch) < (1.0 - at_its_limit) * friction.stick) return 0.0;
    return -std::copysign(friction.stick, stretch);
}

}  // namespace

HeldFriction::HeldFriction(const System& system, const State& state, double time)
    : moves_(state.memory.size(), 0.0) {
    find_slips(system, state, time);
    find_tensions(system, state, time);
}

void HeldFriction::find_slips(const System& system, const State& state, double time) {
    const Model& model = system.model();
    if (!has_joint_friction(model)) return;
    const std::vector<JointValues> values = system.joints().compute_joint_values(state, time);
    for_each_coordinates(
        model, [&](std::size_t joint, const std::string&, const auto& turn, const JointCoordinate& slide) {
            const MemorySlice slips = system.joints().memory_of(joint);
            const JointSlips before = read_slips(slips.of(state));
            moves_[slips.first] = find_move(turn.friction, values[joint].turn, before.turn);
            moves_[slips.first + 1] = find_move(slide.friction, values[joint].slide, before.slide);
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
                double& before = moved.memory[tendon.memory().first + i];
                before += direction * most;
                const double other = tendon.compute(state.trial, moved, time)[i];
                before -= direction * most;
                return std::abs(other - tensions[i]) <= at_its_limit * most;
            };
            const double direction = slips_to(-1.0) ? -1.0 : slips_to(1.0) ? 1.0 : 0.0;
            moves_[tendon.memory().first + i] = direction * most;
        }
    }
}

void HeldFriction::move(State& state) const {
    for (std::size_t i = 0; i < moves_.size(); ++i) state.memory[i] += moves_[i];
}

}  // namespace gxrod
