#include "report/model/load_arrows.hpp"

#include <algorithm>

#include "loads/distributed_load.hpp"
#include "loads/magnet.hpp"
#include "loads/motion_load.hpp"
#include "loads/nodal_load.hpp"

namespace gxrod {

namespace {

constexpr std::size_t most_arrows_along_rod = 16;

Vec6 turned(const Quat& turn, const Vec6& value) {
    Vec6 result;
    result << turn * value.head<3>(), turn * value.tail<3>();
    return result;
}

// What a load puts on a section whose axes were `axes` at t = 0, per length.
Vec6 compute_per_length(const DistributedLoad& load,
                        double s,
                        const Quat& axes,
                        const NodeMotion& motion,
                        double time,
                        double length) {
    Vec6 value = compute_load_per_length(load, time, s);
    if (load.by_motion) value += load.by_motion.value(time, s, find_point_motion(motion));
    if (load.frame == Frame::spatial) return value;
    Vec6 own = turned(load.frame == Frame::body ? motion.Lambda * axes : motion.Lambda, value);
    if (!load.field) return own;
    return compute_magnetic_load({*load.field, time, motion.r, own.tail<3>(), length});
}

void add_arrows_along_rod(const Model& model, const DistributedLoad& load, std::vector<LoadArrow>& arrows) {
    const Rod& rod = model.rods[load.rod];
    const std::size_t places = rod.arc_length.size();
    const std::size_t count = std::min(places, most_arrows_along_rod);
    const double size = rod.length / std::max(rod.element_count(), 1);
    for (std::size_t i = 0; i < count; ++i) {
        const std::size_t place = count < 2 ? 0 : i * (places - 1) / (count - 1);
        const double s = rod.arc_length[place];
        const Quat axes = rod.triads[place];
        arrows.push_back({load.key,
                          rod.element_nodes[place],
                          true,
                          [&load, s, axes, size](const NodeMotion& motion, double time) {
                              return compute_per_length(load, s, axes, motion, time, size);
                          }});
    }
}

}  // namespace

std::vector<LoadArrow> list_load_arrows(const Model& model) {
    std::vector<LoadArrow> arrows;
    for (const NodalLoad& load : model.loads) {
        arrows.push_back({load.key, load.node, false, [&load](const NodeMotion& motion, double time) {
                              return compute_load(load, motion, time);
                          }});
    }
    for (const DistributedLoad& load : model.distributed_loads) add_arrows_along_rod(model, load, arrows);
    return arrows;
}

}  // namespace gxrod
