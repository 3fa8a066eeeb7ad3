#include "check/findings/bushing_findings.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "check/summaries/joint_summary.hpp"

namespace gxrod {
namespace {

// The spin of B against A at t = 0.
Vec3 find_spin(const Model& model, const Bushing& bushing) {
    const auto of = [&](const Anchor& end) -> Vec3 {
        if (end.is_ground()) return Vec3::Zero();
        return model.nodes[static_cast<std::size_t>(end.node)].angular_velocity;
    };
    return of(bushing.ends[1]) - of(bushing.ends[0]);
}

// A joint that turns B against A by a motor, about an axis of space at t = 0; zero without one.
Vec3 find_driven_axis(const Model& model, const Bushing& bushing) {
    for (const Joint& joint : model.joints) {
        const bool is_driven = joint.turn.motion || !joint.turn.drive.is_zero();
        const std::array<int, 2> nodes{joint.a.anchor.node, joint.b.anchor.node};
        const bool same = nodes == std::array{bushing.ends[0].node, bushing.ends[1].node} ||
                          nodes == std::array{bushing.ends[1].node, bushing.ends[0].node};
        if (is_driven && same) return joint.a.axes.col(0);
    }
    return Vec3::Zero();
}

// The axis of the bushing, 0 to 2, that is free and next to this direction; -1 if the direction is resisted.
int find_free_axis(const Bushing& bushing, const Vec3& direction) {
    constexpr double much = 0.5;  // of the direction
    const Vec3 own = bushing.axes.conjugate() * direction;
    int axis = 0;
    const double largest = own.cwiseAbs().maxCoeff(&axis);
    return largest > much * own.norm() && bushing.leaves_turn_free(axis) ? axis : -1;
}

}  // namespace

std::vector<std::string> find_turning_bushings(const Model& model) {
    std::vector<std::string> sentences;
    for (const Bushing& bushing : model.bushings) {
        if (!bushing.has_axes_between()) continue;
        Vec3 direction = find_spin(model, bushing);
        if (direction.isZero(0.0)) direction = find_driven_axis(model, bushing);
        const int axis = direction.isZero(0.0) ? -1 : find_free_axis(bushing, direction);
        if (axis < 0) continue;
        sentences.push_back(fmt::format(
            "bushing {} lets {} turn against {} about its {}, and its axes turn half way with it: stiffness "
            "and "
            "damping then act in turned directions, and half a turn is the most; for a bearing give axes = "
            "\"ground\", or \"a\" or \"b\" for the end that does not spin",
            bushing.name,
            describe_anchor(model, bushing.ends[1]),
            describe_anchor(model, bushing.ends[0]),
            component_names[static_cast<std::size_t>(axis)]));
    }
    return sentences;
}

}  // namespace gxrod
