#include "sensitivity/held_stops.hpp"

#include <algorithm>
#include <cmath>

namespace gxrod {

HeldStops::HeldStops(const Model& model) : model_(&model) {
    for (std::size_t joint = 0; joint < model.joints.size(); ++joint) {
        if (!model.joints[joint].has_stops()) continue;
        const JointRows rows(model.joints[joint]);
        for (int row = 0; row < rows.count(); ++row) {
            if (rows.is_stop(row)) places_.push_back({joint, static_cast<std::size_t>(row), rows});
        }
    }
}

bool HeldStops::are_equal(const std::vector<JointState>& a, const std::vector<JointState>& b) const {
    return std::ranges::all_of(places_, [&](const Place& place) {
        return (a[place.joint].multipliers[place.row] == 0.0) ==
               (b[place.joint].multipliers[place.row] == 0.0);
    });
}

void HeldStops::copy(const std::vector<JointState>& from, std::vector<JointState>& to) const {
    for (const Place& place : places_)
        to[place.joint].multipliers[place.row] = from[place.joint].multipliers[place.row];
}

bool HeldStops::are_at_limit(const State& state, double length) const {
    constexpr double closed = 1e-9;  // of the length, or in rad
    const auto motion = [&](int node) {
        return node < 0 ? NodeMotion{} : state.trial[static_cast<std::size_t>(node)];
    };
    return std::ranges::any_of(places_, [&](const Place& place) {
        if (state.joints_trial[place.joint].multipliers[place.row] != 0.0) return false;
        const Joint& joint = model_->joints[place.joint];
        const int row = static_cast<int>(place.row);
        const StopPlace stop =
            place.rows.find_stop(row,
                                 {motion(joint.a.anchor.node), motion(joint.b.anchor.node)},
                                 state.joints_previous[place.joint].turn);
        return std::abs(stop.gap) <= closed * (place.rows.is_length(row) ? length : 1.0);
    });
}

}  // namespace gxrod
