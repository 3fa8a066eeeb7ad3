#include "state/values/bushing_values.hpp"

#include "state/bushing_motion.hpp"
#include "state/carried_bushing_motion.hpp"

namespace gxrod {

namespace {

BushingValues compute_values_between(const Bushing& bushing, const NodeMotion* a, const NodeMotion* b) {
    const BushingMotion motion = compute_bushing_motion(bushing, a, b);
    const Vec6 own = compute_bushing_force(bushing, motion);
    return {.axes = motion.axes,
            .displacement = motion.strain.head<3>(),
            .turn = motion.strain.tail<3>(),
            .force = own.head<3>(),
            .moment = take_to_rotation_vector(motion.turn, own.tail<3>())};
}

}  // namespace

BushingValues compute_bushing_values(const Bushing& bushing, const NodeMotion* a, const NodeMotion* b) {
    if (bushing.has_axes_between()) return compute_values_between(bushing, a, b);
    const CarriedBushingMotion motion = compute_carried_motion(bushing, a, b);
    const Vec6 own = bushing.stiffness * motion.strain + bushing.damping * motion.rate;
    const Vec3 on_B = distribute_moment(bushing, motion, own.tail<3>())[1];
    return {.axes = motion.axes,
            .displacement = motion.strain.head<3>(),
            .turn = motion.strain.tail<3>(),
            .force = own.head<3>(),
            .moment = motion.axes.transpose() * on_B};
}

}  // namespace gxrod
