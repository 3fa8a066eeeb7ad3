#include "check/findings/plane_findings.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "environment/flow_profile.hpp"
#include "model/ties/ties.hpp"

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

// The axis along the normal, or −1.
int find_normal(const Quat& axes, int normal) {
    const Mat3 columns = axes.toRotationMatrix();
    for (int i = 0; i < 3; ++i) {
        if (std::abs(std::abs(columns(normal, i)) - 1.0) < in_plane) return i;
    }
    return -1;
}

// The section axis of a rod, y or z, that is along the normal all along; −1 if there is no such axis.
int find_normal(const Rod& rod, int normal) {
    const int across = find_normal(rod.triads.front(), normal);
    const auto is_same = [&](const Quat& triad) { return find_normal(triad, normal) == across; };
    return across > 0 && std::ranges::all_of(rod.triads, is_same) ? across : -1;
}

bool pushes_out(const Actuation& actuation, int across) {
    const Plane plane{across};
    for (int i = 0; i < 6; ++i) {
        if (plane.holds(i) && !actuation.strain[i].is_zero()) return true;
    }
    // Heat that rises along y bends about z, along z about y.
    return (plane.holds(5) && !actuation.temperature_gradient[0].is_zero()) ||
           (plane.holds(4) && !actuation.temperature_gradient[1].is_zero());
}

bool pushes_out(const Tendon& tendon, const Rod& rod, int across) {
    return std::ranges::any_of(list_force_points(rod), [&](double s) {
        if (s <= tendon.from || s >= tendon.to) return false;
        const TendonPlace place = tendon.path(s);
        return place.at[across] != 0.0 || place.slope[across] != 0.0;
    });
}

// Whether the curve of a rod's rest, if it has one, leaves the plane across this section axis.
bool curves_outside(const Rod& rod, int across) {
    if (rod.rest_positions.empty()) return false;
    const Vec3 normal = rod.rest_triads.front() * Vec3(Vec3::Unit(across));
    const Vec3& first = rod.rest_positions.front();
    const bool is_flat = std::ranges::all_of(rod.rest_positions, [&](const Vec3& position) {
        return std::abs(normal.dot(position - first)) <= in_plane * rod.length;
    });
    const auto is_along = [&](const Quat& triad) {
        return (triad * Vec3(Vec3::Unit(across)) - normal).norm() <= in_plane;
    };
    return !is_flat || !std::ranges::all_of(rod.rest_triads, is_along);
}

// Whether a rod's rest, seen from its start, bends or twists it out of the plane.
bool rests_outside(const Rod& rod, int across) {
    const Plane plane{across};
    const bool is_bent_out = std::ranges::any_of(rod.rest_strains, [&](const Vec6& strain) {
        for (int i = 3; i < 6; ++i) {
            if (plane.holds(i) && std::abs(strain[i]) * rod.length > in_plane) return true;
        }
        return false;
    });
    return is_bent_out || curves_outside(rod, across);
}

// Of what acts within rods.
std::string find_inner_push(const Model& model, int normal) {
    for (const Actuation& actuation : model.actuations) {
        const int across = find_normal(model.rods[static_cast<std::size_t>(actuation.rod)], normal);
        if (across < 0 || pushes_out(actuation, across)) return actuation.key;
    }
    for (const Tendon& tendon : model.tendons) {
        const Rod& rod = model.rods[static_cast<std::size_t>(tendon.rod)];
        const int across = find_normal(rod, normal);
        if (across < 0 || pushes_out(tendon, rod, across)) return "tendon." + tendon.name;
    }
    for (const Rod& rod : model.rods) {
        if (rod.starts_free_of_stress()) continue;
        const int across = find_normal(rod, normal);
        if (across < 0 || rests_outside(rod, across)) return "rod." + rod.name + ".rest";
    }
    return "";
}

// A flow whose direction changes turns about z through all between, or has components.
bool leaves_plane(const SpeedProfile& profile, int normal) {
    for (std::size_t row = 0; row < profile.heights.size(); ++row) {
        const Vec3 velocity = velocity_at_row(profile, row);
        if (std::abs(velocity[normal]) > in_plane * velocity.norm()) return true;
        if (width_of(profile) == 2 && normal != 2 && row > 0 &&
            profile.speeds[2 * row + 1] != profile.speeds[2 * row - 1])
            return true;
    }
    return false;
}

// A field by where the nodes are, at some times.
bool pushes_out(const Flow& flow, const std::vector<Node>& nodes, int normal) {
    if (flow.profile && width_of(*flow.profile) == 1) {
        if (std::abs(flow.profile->direction[normal]) > in_plane) return true;
    } else if (flow.profile && leaves_plane(*flow.profile, normal)) {
        return true;
    }
    if (!flow.field) return false;
    return std::ranges::any_of(std::array{0.0, 0.5, 1.0}, [&](double time) {
        return std::ranges::any_of(nodes, [&](const Node& node) {
            const Vec3 velocity = flow.field(time, node.position);
            return std::abs(velocity[normal]) > in_plane * velocity.norm();
        });
    });
}

// Waves along the normal, or in a plane that is level.
bool pushes_out(const WaveTrain& wave, int normal) {
    const Vec3 direction(std::cos(wave.direction), std::sin(wave.direction), 0.0);
    return normal == 2 || std::abs(direction[normal]) > in_plane;
}

// Of what surrounds the model.
std::string find_outer_push(const Model& model, int normal) {
    const auto& [water, air, seabed] = model.surroundings;
    if (water && pushes_out(water->current, model.nodes, normal)) return "fluid.current";
    if (water &&
        std::ranges::any_of(water->waves, [&](const WaveTrain& wave) { return pushes_out(wave, normal); }))
        return "wave";
    if (air && pushes_out(air->wind, model.nodes, normal)) return "air.wind";
    if (seabed && (seabed->grid || std::abs(seabed->normal[normal]) > in_plane)) return "seabed";
    return "";
}

std::string find_push(const Model& model, int normal) {
    for (const NodalLoad& load : model.loads) {
        if (load.by_motion || pushes_out(load, normal)) return load.key;
    }
    for (const DistributedLoad& load : model.distributed_loads) {
        if (load.by_motion) return load.key;
        if (load.field ? pushes_out(load, *load.field, normal) : pushes_out(load, normal)) return load.key;
    }
    if (!model.gravity.components()[normal].is_zero()) return "gravity";
    if (std::string outer = find_outer_push(model, normal); !outer.empty()) return outer;
    return find_inner_push(model, normal);
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
    const auto is_out = [&](const Anchor& end) {
        return std::abs(find_place(model, end)[normal] - height) > in_plane * size;
    };
    if (any_element_tie(model, [&](const auto& tie) { return std::ranges::any_of(tie.ends, is_out); }))
        return false;
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
    if (model.plane || model.rods.empty() || !model.bodies.empty()) return "";
    // What a field does in time is not known.
    const auto& [water, air, seabed] = model.surroundings;
    if ((water && water->current.field) || (air && air->wind.field)) return "";
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
