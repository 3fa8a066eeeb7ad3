#include "check/surroundings/line_at_rest.hpp"

#include <algorithm>
#include <cmath>

#include "check/surroundings/fluid_summary.hpp"
#include "model/ties/ties.hpp"

namespace gxrod {
namespace {

// Sines and changes of slope that are round-off.
constexpr double zero_angle = 1e-6;

Vec3 tangent_at(const Rod& rod, std::size_t entry) { return rod.triads[entry] * Vec3::UnitX(); }

const Node& node_at(const Model& model, const Rod& rod, std::size_t entry) {
    return model.nodes[static_cast<std::size_t>(rod.element_nodes[entry])];
}

// Weight less buoyancy per length, a vector.
Vec3 find_weight(const Model& model, const Rod& rod, std::size_t entry) {
    const Section& section = section_at_entry(model, rod, entry);
    double mass = section.mass(0, 0);
    const auto& water = model.surroundings.water;
    const bool is_wet = water && water->acts() && section.fluid &&
                        (!water->surface || node_at(model, rod, entry).position.z() < *water->surface);
    if (is_wet) mass -= water->density_at(1.0) * section.fluid->area;
    return mass * model.gravity(1.0);
}

bool is_single_line(const Rod& rod) {
    return rod.nodes.size() == static_cast<std::size_t>(rod.element_count()) * rod.order + 1;
}

// Whether something else than supports, loads and bodies acts at a node of a rod.
bool is_shared(const Model& model, const Rod& rod, int node) {
    const auto is_at = [node](const Anchor& anchor) { return anchor.node == node; };
    const auto has_end = [&](const Tie& tie) { return std::ranges::any_of(tie.ends, is_at); };
    return std::ranges::any_of(list_ties(model), has_end) ||
           std::ranges::any_of(model.rods, [&](const Rod& other) {
               return &other != &rod && std::ranges::find(other.nodes, node) != other.nodes.end();
           });
}

double slope_at(const Rod& rod, std::size_t entry) {
    const Vec3 t = tangent_at(rod, entry);
    return t.z() / std::hypot(t.x(), t.y());
}

// Of a line that hangs, stretched or not, dz/dx grows with the length free of stress by its weight over the
// level part of its tension; on the ground it is 0.
bool hang(const Model& model, const Rod& rod, LineAtRest& line) {
    const bool starts_free = rod.rest_strains.empty() && rod.rest_positions.empty();
    if (starts_free || !(find_weight(model, rod, 0).z() < 0.0)) return false;
    const std::vector<double>& s = rod.arc_length;
    // Ends of the intervals of what hangs, and of what may before; the longest is meant, as an end that is a
    // little above the ground comes down to it.
    std::vector<std::size_t> curved, run;
    for (std::size_t i = 1; i < s.size(); ++i) {
        const double change = slope_at(rod, i) - slope_at(rod, i - 1);
        if (!std::isfinite(change) || change < -zero_angle) return false;
        if (change > zero_angle * (s[i] - s[i - 1]) / rod.length) {
            run.push_back(i);
        } else if (s[i] > s[i - 1]) {
            run.clear();
        }
        if (run.size() > curved.size()) curved = run;
    }
    if (curved.size() < 3) return false;
    line.first = curved.front() - 1;
    line.last = curved.back();
    const bool leaves = line.first > 0, lands = line.last + 1 < s.size();
    double weight = 0.0, rise = 0.0;
    // Where it leaves the ground an interval is curved in part.
    for (std::size_t k = leaves ? 1 : 0; k + (lands ? 1 : 0) < curved.size(); ++k) {
        const std::size_t i = curved[k];
        rise += slope_at(rod, i) - slope_at(rod, i - 1);
        weight +=
            0.5 * (find_weight(model, rod, i) + find_weight(model, rod, i - 1)).norm() * (s[i] - s[i - 1]);
    }
    const double level = weight / rise;
    const auto find_ground = [&](std::size_t i) {
        return s[i] - slope_at(rod, i) * level / find_weight(model, rod, i).norm();
    };
    if (leaves) line.from = find_ground(line.first + 1);
    if (lands) line.to = find_ground(line.last - 1);
    for (std::size_t i = 0; i < s.size(); ++i)
        line.tension.push_back(level * std::hypot(1.0, slope_at(rod, i)));
    line.source = LineAtRest::Source::hung;
    return true;
}

// Whether all that acts is known: by the load factor, or the same at all times.
bool are_loads_known(const Model& model) {
    const auto is_known = [&](const auto& functions) {
        return std::ranges::all_of(functions, [](const auto& function) { return function.is_constant(); });
    };
    const auto is_load_known = [&](const auto& load) { return !load.by_motion && is_known(load.force); };
    const auto is_even = [](const DistributedLoad& load) {
        return !load.by_motion && std::ranges::all_of(load.force, [](const LineFunction& function) {
            return function.is_constant() || function.form().in_time == InTime::constant;
        });
    };
    return !model.has_time || (std::ranges::all_of(model.loads, is_load_known) &&
                               std::ranges::all_of(model.distributed_loads, is_even));
}

// The loads on a node, and the weight of bodies there.
Vec3 find_load(const Model& model, int node) {
    Vec3 sum = Vec3::Zero();
    for (const NodalLoad& load : model.loads) {
        if (load.node != node) continue;
        const Vec3 force(load.force[0](1.0), load.force[1](1.0), load.force[2](1.0));
        sum += load.frame == Frame::body ? load.axes * force : force;
    }
    for (const Body& body : model.bodies) {
        if (body.node != node) continue;
        double mass = body.mass;
        if (model.surroundings.water && body.fluid)
            mass -= model.surroundings.water->density_at(1.0) * body.fluid->volume;
        sum += mass * model.gravity(1.0);
    }
    return sum;
}

// Per length.
Vec3 find_load_along(const Model& model, const Rod& rod, std::size_t entry) {
    Vec3 sum = find_weight(model, rod, entry);
    for (const DistributedLoad& load : model.distributed_loads) {
        if (&model.rods[static_cast<std::size_t>(load.rod)] != &rod || load.field) continue;
        const double s = rod.arc_length[entry];
        const Vec3 force(load.force[0](1.0, s), load.force[1](1.0, s), load.force[2](1.0, s));
        sum += load.frame == Frame::body ? rod.triads[entry] * force : force;
    }
    return sum;
}

// From an end that nothing holds along the rod: what is beyond a place pulls there.
bool pull(const Model& model, const Rod& rod, LineAtRest& line) {
    const std::size_t last = rod.arc_length.size() - 1;
    const bool from_end = !is_held_along(model, rod.nodes.back(), tangent_at(rod, last));
    const bool holds_start = is_held_along(model, rod.nodes.front(), tangent_at(rod, 0));
    if (from_end != holds_start) return false;
    const double sign = from_end ? 1.0 : -1.0;
    const auto entry = [&](std::size_t i) { return from_end ? last - i : i; };
    Vec3 beyond = Vec3::Zero();
    line.tension.resize(last + 1);
    for (std::size_t i = 0; i <= last; ++i) {
        const std::size_t at = entry(i);
        const bool is_new = i == 0 || rod.element_nodes[at] != rod.element_nodes[entry(i - 1)];
        if (i > 0) {
            beyond += 0.5 * std::abs(rod.arc_length[at] - rod.arc_length[entry(i - 1)]) *
                      (find_load_along(model, rod, at) + find_load_along(model, rod, entry(i - 1)));
        }
        if (is_new) beyond += find_load(model, rod.element_nodes[at]);
        line.tension[at] = sign * beyond.dot(tangent_at(rod, at));
    }
    line.source = LineAtRest::Source::pulled;
    return true;
}

bool is_straight(const Rod& rod) {
    const Vec3 start = tangent_at(rod, 0);
    return std::ranges::all_of(rod.triads, [&](const Quat& triad) {
        return start.cross(triad * Vec3::UnitX()).norm() < zero_angle;
    });
}

}  // namespace

const Section& section_at_entry(const Model& model, const Rod& rod, std::size_t entry) {
    return rod.has_varying_sections() ? rod.varying.at_nodes[entry]
                                      : model.sections[static_cast<std::size_t>(rod.section)];
}

const Support* find_support_of(const Model& model, int node) {
    const auto found =
        std::ranges::find_if(model.supports, [&](const Support& support) { return support.node == node; });
    return found == model.supports.end() ? nullptr : &*found;
}

bool is_held_along(const Model& model, int node, const Vec3& direction) {
    const auto resists = [&](const Vec3& axis) { return std::abs(axis.dot(direction)) > zero_angle; };
    if (const Support* support = find_support_of(model, node)) {
        const Mat3 axes = support->axes.toRotationMatrix();
        for (int i = 0; i < 3; ++i)
            if (support->holds(i) && resists(axes.col(i))) return true;
    }
    return model.plane && resists(Vec3::Unit(model.plane->normal));
}

std::optional<LineAtRest> find_line_at_rest(const Model& model, const Rod& rod) {
    if (!is_single_line(rod) || is_shared(model, rod, rod.nodes.front()) ||
        is_shared(model, rod, rod.nodes.back()))
        return std::nullopt;
    LineAtRest line;
    line.arc_length = rod.arc_length;
    line.last = rod.arc_length.size() - 1;
    line.to = rod.arc_length.back();
    if (hang(model, rod, line)) return line;
    line.first = 0;
    line.last = rod.arc_length.size() - 1;
    if (!are_loads_known(model)) return std::nullopt;
    if (pull(model, rod, line)) return line;
    if (!is_straight(rod)) return std::nullopt;
    line.tension.assign(rod.arc_length.size(), 0.0);
    return line;
}

std::optional<double> find_boundary_layer(const Model& model,
                                          const Rod& rod,
                                          const LineAtRest& line,
                                          std::size_t place) {
    const Section& section = section_at_entry(model, rod, place);
    const double bending = std::min(section.stiffness(4, 4), section.stiffness(5, 5));
    if (!(line.tension[place] > 0.0)) return std::nullopt;
    return std::sqrt(bending / line.tension[place]);
}

}  // namespace gxrod
