#include "report/load_arrows.hpp"

#include "loads/distributed_load.hpp"
#include "loads/nodal_load.hpp"

namespace gxrod {

namespace {

constexpr std::size_t most_arrows_along_rod = 16;

Vec6 turned(const Quat& turn, const Vec6& value) {
    Vec6 result;
    result << turn * value.head<3>(), turn * value.tail<3>();
    return result;
}

void add_arrows_along_rod(const Model& model, const DistributedLoad& load, std::vector<LoadArrow>& arrows) {
    const Rod& rod = model.rods[load.rod];
    const std::size_t places = rod.arc_length.size();
    const std::size_t count = std::min(places, most_arrows_along_rod);
    for (std::size_t i = 0; i < count; ++i) {
        const std::size_t place = count < 2 ? 0 : i * (places - 1) / (count - 1);
        const double s = rod.arc_length[place];
        const Quat axes = rod.triads[place];
        arrows.push_back({load.key,
                          rod.element_nodes[place],
                          true,
                          [&load, s, axes](const NodeMotion& motion, double time) {
                              Vec6 value = compute_load_per_length(load, time, s);
                              if (load.frame == Frame::spatial) return value;
                              const bool in_axes = load.frame == Frame::body;
                              return turned(in_axes ? motion.Lambda * axes : motion.Lambda, value);
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
