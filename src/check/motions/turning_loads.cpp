#include "check/motions/turning_loads.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include "check/motions/spinning_parts.hpp"
#include "check/motions/turning_ties.hpp"
#include "environment/current.hpp"
#include "rotation/vector_text.hpp"

namespace gxrod {

namespace {

constexpr std::array<double, 6> load_factors{0.0, 0.11, 0.37, 0.5, 0.83, 1.0};
constexpr double round_off_of_loads = 1e-12;
constexpr double by_place_round_off = 1e-8;

bool is_along(const Vec3& vector, const Vec3& axis) {
    return axis.cross(vector).norm() <= round_off_of_loads * vector.norm();
}

template <class Evaluate>
bool is_always_along(const Vec3& axis, const Evaluate& evaluate) {
    for (const double t : load_factors) {
        if (!is_along(evaluate(t), axis)) return false;
    }
    return true;
}

bool is_steady(const NodalLoad& load, const Vec3& axis) {
    if (load.frame != Frame::spatial) return true;
    for (const auto& functions : {load.force, load.moment}) {
        const auto value = [&](double t) { return Vec3(functions[0](t), functions[1](t), functions[2](t)); };
        if (!is_always_along(axis, value)) return false;
    }
    return true;
}

bool is_steady(const DistributedLoad& load, double length, const Vec3& axis) {
    if (load.field) {
        const auto value = [&](double t) { return load.field->at(t, Vec3::Zero()); };
        return !load.field->by_place && is_always_along(axis, value);
    }
    if (load.frame != Frame::spatial) return true;
    for (const double part : load_factors) {
        const double s = part * length;
        for (const auto& functions : {load.force, load.moment}) {
            const auto value = [&](double t) {
                return Vec3(functions[0](t, s), functions[1](t, s), functions[2](t, s));
            };
            if (!is_always_along(axis, value)) return false;
        }
    }
    return true;
}

std::string describe(const std::string& key) {
    return fmt::format(
        "{} is fixed in space and not along the axis of rotation: in a frame that turns it is not steady. "
        "Let it "
        "follow, or make the motion a dynamic analysis",
        key);
}

// A place as far from a point of the axis as the model reaches or nearer, and a velocity there.
struct Sample {
    Vec3 place, velocity;
};

std::vector<Sample> list_samples(const TurningFrame& frame, double length) {
    std::vector<Sample> samples;
    const auto direction = [](int i, double stretch) {
        return Vec3(std::sin(1.0 + stretch * i),
                    std::cos(0.3 + 2.3 * stretch * i),
                    std::sin(2.0 - 3.1 * stretch * i));
    };
    for (int i = 0; i < 24; ++i) {
        const double size = length * std::pow(3.0, i % 4 - 3.0);
        samples.push_back(
            {frame.through + size * direction(i, 1.7), size * frame.speed(1.0) * direction(i, 0.9)});
    }
    return samples;
}

// Whether a vector by time, place and velocity turns with place and velocity about the axis.
template <class Evaluate>
bool turns_along(const TurningFrame& frame, double length, const Evaluate& evaluate) {
    for (const Sample& sample : list_samples(frame, length)) {
        for (const double t : load_factors) {
            const Vec3 value = evaluate(t, sample.place, sample.velocity);
            for (const double angle : {0.8, 2.9}) {
                const Quat turn(Eigen::AngleAxisd(angle, frame.axis));
                const Vec3 place = frame.through + turn * (sample.place - frame.through);
                const Vec3 change = evaluate(t, place, turn * sample.velocity) - turn * value;
                if (!(change.norm() <= by_place_round_off * value.norm())) return false;
            }
        }
    }
    return true;
}

double measure_extent(const Model& model, const TurningFrame& frame) {
    double extent = 0.0;
    for (const Node& node : model.nodes) extent = std::max(extent, (node.position - frame.through).norm());
    return extent > 0.0 ? extent : 1.0;
}

// Of what of a load depends on the motion; `length` of the rod, 0 at a point.
std::string find_unsteadiness(const MotionLoad& load,
                              double length,
                              const Model& model,
                              const TurningFrame& frame) {
    if (!load) return "";
    if (load.turns)
        return "depends on how its point has turned since t = 0: in a frame that turns it is not steady. "
               "Leave "
               "that out, or make the motion a dynamic analysis";
    for (const double part : load_factors) {
        for (const Eigen::Index first : {0, 3}) {
            const auto value = [&](double t, const Vec3& place, const Vec3& velocity) {
                return Vec3(load.value(t, part * length, {place, velocity}).segment<3>(first));
            };
            if (turns_along(frame, measure_extent(model, frame), value)) continue;
            return fmt::format(
                "depends on where its point is and how fast it moves, not alike to all sides of the axis of "
                "rotation {}: in a frame that turns it is not steady. Make it so, or make the motion a "
                "dynamic "
                "analysis",
                in_brackets(frame.axis));
        }
    }
    return "";
}

std::string find_unsteady_force(const Model& model, const TurningFrame& frame) {
    for (const NodalLoad& load : model.loads) {
        if (!is_steady(load, frame.axis)) return describe(load.key);
        const std::string why = find_unsteadiness(load.by_motion, 0.0, model, frame);
        if (!why.empty()) return load.key + " " + why;
    }
    for (const DistributedLoad& load : model.distributed_loads) {
        const double length = model.rods[static_cast<std::size_t>(load.rod)].length;
        if (!is_steady(load, length, frame.axis)) return describe(load.key);
        const std::string why = find_unsteadiness(load.by_motion, length, model, frame);
        if (!why.empty()) return load.key + " " + why;
    }
    return "";
}

bool is_steady(const Flow& flow, const Model& model, const TurningFrame& frame) {
    const double extent = measure_extent(model, frame);
    const Flow by_height{.profile = flow.profile};
    Current current(by_height, extent, "fluid");
    const auto velocity = [&](double t, const Vec3& place, const Vec3&) {
        current.move_to(t);
        Vec3 sum = current.at(place, {.z = place.z()}, false).velocity;
        if (flow.field) sum += flow.field(t, place);
        return sum;
    };
    return flow.is_still() || turns_along(frame, extent, velocity);
}

std::string find_unsteady_surroundings(const Model& model, const TurningFrame& frame) {
    const Surroundings& around = model.surroundings;
    const bool is_upright = are_parallel(Vec3::UnitZ(), frame.axis);
    const char* unsteady = nullptr;
    if (around.water && around.water->acts()) {
        if (!is_steady(around.water->current, model, frame)) unsteady = "the current of fluid";
        if (around.water->surface && !is_upright) unsteady = "the surface of fluid";
        if (!around.water->waves.empty()) unsteady = "a wave";
    }
    if (around.air && !is_steady(around.air->wind, model, frame)) unsteady = "the wind of air";
    if (around.seabed && around.seabed->acts()) {
        const Seabed& bed = *around.seabed;
        if (bed.grid || bed.has_friction() || !are_parallel(bed.normal, frame.axis)) unsteady = "seabed";
    }
    if (unsteady == nullptr) return "";
    return fmt::format(
        "{} is not alike to all sides of the axis of rotation {}: in a frame that turns it is not steady. "
        "Leave it "
        "out, or make the motion a dynamic analysis",
        unsteady,
        in_brackets(frame.axis));
}

bool is_on_axis(const Vec3& point, const TurningFrame& frame) {
    const Vec3 from_axis = point - frame.through;
    return frame.axis.cross(from_axis).norm() <= by_place_round_off * std::max(from_axis.norm(), 1.0);
}

// Obstacles rest in space, and what turns slides on them.
std::string find_unsteady_obstacle(const Model& model, const TurningFrame& frame) {
    for (const Obstacle& obstacle : model.contact.obstacles) {
        const PlaneShape* plane = obstacle.plane();
        const bool is_alike = plane != nullptr
                                  ? are_parallel(plane->normal, frame.axis)
                                  : obstacle.mesh() == nullptr &&
                                        std::ranges::all_of(obstacle.points(), [&](const Vec3& point) {
                                            return is_on_axis(point, frame);
                                        });
        if (is_alike && !obstacle.motion && obstacle.friction == 0.0) continue;
        return fmt::format(
            "obstacle {} {}: in a frame that turns about {} what touches it is not steady. Leave it out, or "
            "make "
            "the motion a dynamic analysis",
            obstacle.name,
            !is_alike         ? "is not alike to all sides of the axis of rotation"
            : obstacle.motion ? "moves"
                              : "rubs",
            in_brackets(frame.axis));
    }
    return "";
}

}  // namespace

std::string find_unsteady_action(const Model& model, const TurningFrame& frame) {
    if (frame.is_at_rest()) return find_unsteady_spin(model, frame);
    if (!is_always_along(frame.axis, model.gravity)) {
        return fmt::format(
            "gravity is not along the axis of rotation {}: in a frame that turns it is not steady. Leave it "
            "out and "
            "excite a response by it, once a revolution, or make the motion a dynamic analysis",
            in_brackets(frame.axis));
    }
    std::string cause = find_unsteady_force(model, frame);
    if (cause.empty()) cause = find_unsteady_surroundings(model, frame);
    if (cause.empty()) cause = find_unsteady_tie(model, frame);
    if (cause.empty()) cause = find_unsteady_obstacle(model, frame);
    return cause;
}

}  // namespace gxrod
