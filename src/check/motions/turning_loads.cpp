#include "check/motions/turning_loads.hpp"

#include <fmt/format.h>

#include <array>

#include "model/ties/ties.hpp"

namespace gxrod {

namespace {

constexpr std::array<double, 6> load_factors{0.0, 0.11, 0.37, 0.5, 0.83, 1.0};
constexpr double round_off = 1e-12;

bool is_along(const Vec3& vector, const Vec3& axis) {
    return axis.cross(vector).norm() <= round_off * vector.norm();
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

}  // namespace

std::string find_unsteady_load(const Model& model, const TurningFrame& frame) {
    if (!is_always_along(frame.axis, model.gravity)) {
        return "gravity is not along the axis of rotation: in a frame that turns it is not steady. Leave it "
               "out, "
               "or make the motion a dynamic analysis";
    }
    for (const NodalLoad& load : model.loads) {
        if (load.motion_force) {
            return fmt::format(
                "{} depends on where its point is and how fast it moves, as seen from space: in a frame that "
                "turns it is not steady. Make the motion a dynamic analysis",
                load.key);
        }
        if (!is_steady(load, frame.axis)) return describe(load.key);
    }
    for (const DistributedLoad& load : model.distributed_loads) {
        const double length = model.rods[static_cast<std::size_t>(load.rod)].length;
        if (!is_steady(load, length, frame.axis)) return describe(load.key);
    }
    const Surroundings& around = model.surroundings;
    const char* unsteady = nullptr;
    if (around.water && !around.water->current.is_still()) unsteady = "the current of fluid";
    if (around.water && !around.water->waves.empty()) unsteady = "a wave";
    if (around.air && !around.air->wind.is_still()) unsteady = "the wind of air";
    if (around.seabed) unsteady = "seabed";
    if (unsteady != nullptr) {
        return fmt::format(
            "{} does not turn: in a frame that turns it is not steady. Leave it out, or make the motion a "
            "dynamic analysis",
            unsteady);
    }
    const auto describe_tie = [](const std::string& tie, const char* where) {
        return fmt::format(
            "{} is tied to the ground{}, and the ground does not turn: in a frame that turns it is not "
            "steady. Tie it to a supported point, which turns, or make the motion a dynamic analysis",
            tie,
            where);
    };
    for (const Tie& tie : list_ties(model)) {
        const bool is_spring = tie.kind == TieKind::spring;
        for (const Anchor& end : tie.ends) {
            if (!end.is_ground() || (is_spring && is_along(end.arm - frame.through, frame.axis))) continue;
            return describe_tie(key_of(tie), is_spring ? " off the axis of rotation" : "");
        }
        if (tie.kind == TieKind::bushing && model.bushings[tie.index].carrier == BushingAxes::ground)
            return describe_tie(key_of(tie), " by its axes");
    }
    return "";
}

}  // namespace gxrod
