#include "elements/tie_values.hpp"

#include "elements/bushing_motion.hpp"
#include "elements/carried_bushing_motion.hpp"
#include "elements/spring_line.hpp"

namespace gxrod {

namespace {

// The motions of the nodes that carry the two ends; nullptr for the ground.
std::array<const NodeMotion*, 2> find_motions(const std::array<Anchor, 2>& ends,
                                              std::span<const NodeMotion> nodes) {
    const auto find = [&](const Anchor& end) -> const NodeMotion* {
        return end.is_ground() ? nullptr : &nodes[static_cast<std::size_t>(end.node)];
    };
    return {find(ends[0]), find(ends[1])};
}

SpringValues measure(const Spring& spring, const NodeMotion* a, const NodeMotion* b) {
    const SpringLine line = compute_spring_line(spring, a, b);
    return {line.length - spring.length, compute_axial_force(spring, line)};
}

BushingValues measure_between(const Bushing& bushing, const NodeMotion* a, const NodeMotion* b) {
    const BushingMotion motion = compute_bushing_motion(bushing, a, b);
    const Vec6 own = compute_bushing_force(bushing, motion);
    return {.axes = motion.axes,
            .displacement = motion.strain.head<3>(),
            .turn = motion.strain.tail<3>(),
            .force = own.head<3>(),
            .moment = take_to_rotation_vector(motion.turn, own.tail<3>())};
}

BushingValues measure(const Bushing& bushing, const NodeMotion* a, const NodeMotion* b) {
    if (bushing.has_axes_between()) return measure_between(bushing, a, b);
    const CarriedBushingMotion motion = compute_carried_motion(bushing, a, b);
    const Vec6 own = bushing.stiffness * motion.strain + bushing.damping * motion.rate;
    const Vec3 on_B = distribute_moment(bushing, motion, own.tail<3>())[1];
    return {.axes = motion.axes,
            .displacement = motion.strain.head<3>(),
            .turn = motion.strain.tail<3>(),
            .force = own.head<3>(),
            .moment = motion.axes.transpose() * on_B};
}

}  // namespace

TieValues compute_tie_values(const Model& model, std::span<const NodeMotion> nodes) {
    const auto measure_all = [&](const auto& ties, auto& values) {
        values.reserve(ties.size());
        for (const auto& tie : ties) {
            const auto [a, b] = find_motions(tie.ends, nodes);
            values.push_back(measure(tie, a, b));
        }
    };
    TieValues values;
    measure_all(model.springs, values.springs);
    measure_all(model.bushings, values.bushings);
    return values;
}

}  // namespace gxrod
