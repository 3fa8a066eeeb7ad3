#include "check/plane_findings.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace gxrod {
namespace {

constexpr double in_plane = 1e-9;
constexpr const char* names[3] = {"yz", "xz", "xy"};

// Forces along the normal, moments about the other axes; functions that are not known to vanish push.
template <class Load>
bool pushes_out(const Load& load, int normal) {
    if (load.frame == Frame::body) return !is_zero(load.force) || !is_zero(load.moment);
    for (int i = 0; i < 3; ++i) {
        if (i == normal && !load.force[i].is_zero()) return true;
        if (i != normal && !load.moment[i].is_zero()) return true;
    }
    return false;
}

// A magnetic moment along the rod, in a field that is surely along the plane, turns the rod in it.
bool pushes_out(const DistributedLoad& load, const MagneticField& field, int normal) {
    const bool is_along_rod = load.moment[1].is_zero() && load.moment[2].is_zero();
    return field.by_place || !field.uniform[normal].is_zero() || !is_along_rod;
}

// What acts within a rod whose axis y or z is along the normal stays in the plane if it stretches the rod and
// bends it about the normal; that is not looked into.
bool acts_within(const Model& model) { return !model.actuations.empty() || !model.tendons.empty(); }

std::string find_push(const Model& model, int normal) {
    for (const NodalLoad& load : model.loads) {
        if (load.motion_force || pushes_out(load, normal)) return load.key;
    }
    for (const DistributedLoad& load : model.distributed_loads) {
        if (load.field ? pushes_out(load, *load.field, normal) : pushes_out(load, normal)) return load.key;
    }
    if (!model.gravity.components()[normal].is_zero()) return "gravity";
    return "";
}

int find_normal(const Quat& axes, int normal) {
    const Mat3 columns = axes.toRotationMatrix();
    for (int i = 0; i < 3; ++i) {
        if (std::abs(std::abs(columns(normal, i)) - 1.0) < in_plane) return i;
    }
    return -1;
}

// Whether no entry of a section's matrix couples what stays in the plane with what leaves it; `across` is the
// section's axis along the normal.
bool couples(const Mat6& matrix, int across) {
    const Plane plane{across};
    for (int i = 0; i < 6; ++i) {
        for (int j = 0; j < 6; ++j) {
            if (plane.holds(i) != plane.holds(j) && matrix(i, j) != 0.0) return true;
        }
    }
    return false;
}

bool lies_in_plane(const Model& model, int normal) {
    const double height = model.nodes.front().position[normal];
    double size = std::abs(height);
    for (const Rod& rod : model.rods) size = std::max(size, rod.length);
    const auto is_in = [&](const Node& node) {
        return std::abs(node.position[normal] - height) <= in_plane * size && node.velocity[normal] == 0.0 &&
               node.angular_velocity.cross(Vec3::Unit(normal)).isZero(0.0);
    };
    if (!std::all_of(model.nodes.begin(), model.nodes.end(), is_in)) return false;
    for (const Rod& rod : model.rods) {
        const Section& section = model.sections[rod.section];
        for (const Quat& triad : rod.triads) {
            const int across = find_normal(triad, normal);
            if (across < 1 || couples(section.stiffness, across) || couples(section.mass, across))
                return false;
        }
    }
    if (!model.bushings.empty()) return false;  // they may push out
    for (const Spring& spring : model.springs) {
        for (const Anchor& end : spring.ends) {
            if (std::abs(find_place(model, end)[normal] - height) > in_plane * size) return false;
        }
    }
    if (!model.joints.empty() || !model.sleeves.empty()) return false;
    return std::all_of(model.supports.begin(), model.supports.end(), [&](const Support& support) {
        const int across = find_normal(support.axes, normal);
        if (across < 0) return false;
        for (int i = 0; i < 6; ++i) {
            if (Plane{across}.holds(i) && support.moved[i]) return false;
        }
        return true;
    });
}

}  // namespace

std::string find_push_out_of_plane(const Model& model) {
    if (!model.plane) return "";
    const std::string pusher = find_push(model, model.plane->normal);
    if (pusher.empty()) return "";
    return fmt::format(
        "{} pushes out of the plane {} of the deck, which holds against it; only reactions feel it",
        pusher,
        names[model.plane->normal]);
}

std::string suggest_plane(const Model& model) {
    if (model.plane || model.rods.empty() || !model.bodies.empty() || acts_within(model)) return "";
    for (const int normal : {2, 1, 0}) {
        if (!find_push(model, normal).empty() || !lies_in_plane(model, normal)) continue;
        return fmt::format(
            "all of this lies in a plane: plane = \"{}\" keeps it there, where it cannot buckle or vibrate "
            "out of "
            "it, with half of the unknowns",
            names[normal]);
    }
    return "";
}

}  // namespace gxrod
