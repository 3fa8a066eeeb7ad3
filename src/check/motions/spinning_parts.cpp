#include "check/motions/spinning_parts.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <span>

#include "check/motions/turning_ties.hpp"
#include "elements/carried_bushing_motion.hpp"
#include "model/ties/ties.hpp"
#include "rotation/vector_text.hpp"

namespace gxrod {

namespace {

constexpr std::array<double, 6> spin_load_factors{0.0, 0.11, 0.37, 0.5, 0.83, 1.0};

// A vector along the axis, or zero.
bool is_along_axis(const Vec3& vector, const TurningFrame& frame) { return are_parallel(vector, frame.axis); }

// The functions below return "" if all is alike to all sides of the axis, else what is not and what to do.

// A section's x axis is the axis.
const char* find_flaw(const Section& section) {
    if (section.law) return "has a section with a law of its own, which is not followed in a spin";
    Mat6 damping = Mat6::Zero();
    if (section.kelvin_voigt_components) damping = section.kelvin_voigt_components->asDiagonal();
    for (const Mat6& matrix : {section.stiffness, section.mass, damping}) {
        if (!is_alike_about(Vec3::UnitX(), matrix))
            return "has a section that is not alike to all sides: EIy and EIz, GAy and GAz, rhoIy and rhoIz "
                   "must be "
                   "the same, centred";
    }
    if (!section.fluid) return "";
    const SectionInFluid& fluid = *section.fluid;
    const bool is_round = fluid.drag[1] == fluid.drag[2] && fluid.added_mass[1] == fluid.added_mass[2];
    return is_round ? "" : "has a section whose drag and added mass along y and z differ";
}

const char* find_flaw(const Model& model, const Rod& rod, const TurningFrame& frame) {
    const auto spins = [&](int node) { return frame.spins(node); };
    if (std::ranges::none_of(rod.nodes, spins)) return "";
    if (!std::ranges::all_of(rod.nodes, spins))
        return "is joined to what spins. Name it in rotation.spins, or let a bearing be between them";
    if (!rod.starts_free_of_stress()) return "spins, and has a stress-free shape of its own";
    const auto is_straight = [&](const Quat& triad) { return is_along_axis(triad * Vec3::UnitX(), frame); };
    if (!std::ranges::all_of(rod.triads, is_straight))
        return "spins, and is not straight along rotation.axis at t = 0";
    std::vector<std::span<const Section>> lists{
        {&model.sections[static_cast<std::size_t>(rod.section)], std::size_t{1}}};
    if (rod.has_varying_sections())
        lists = {rod.varying.at_forces, rod.varying.at_masses, rod.varying.at_nodes};
    for (const auto& sections : lists) {
        for (const Section& section : sections) {
            if (const char* cause = find_flaw(section); *cause != '\0') return cause;
        }
    }
    return "";
}

const char* find_flaw(const Body& body, const TurningFrame& frame) {
    if (!frame.spins(body.node)) return "";
    if (body.fluid) return "spins in water or air, which is not followed";
    const Vec3 axis = body.attitude.conjugate() * frame.axis;
    if (!are_parallel(body.centre_of_mass, axis)) return "spins, and its centre of mass is off its axis";
    Mat6 inertia = Mat6::Zero();
    inertia.bottomRightCorner<3, 3>() = body.inertia;
    return is_alike_about(axis, inertia) ? ""
                                         : "spins, and its inertia is not alike to all sides of its axis";
}

bool turns_with_part(Frame of_load) { return of_load != Frame::spatial; }

template <class Evaluate>
bool stays_along(const Vec3& axis, const Evaluate& evaluate) {
    return std::ranges::all_of(spin_load_factors, [&](double t) { return are_parallel(evaluate(t), axis); });
}

bool is_steady_on_spin(const NodalLoad& load, const TurningFrame& frame) {
    if (!frame.spins(load.node) || !turns_with_part(load.frame)) return true;
    const Quat axes = load.frame == Frame::body ? load.axes : Quat::Identity();
    const auto is_along = [&](const std::array<TimeFunction, 3>& functions) {
        return stays_along(axes.conjugate() * frame.axis,
                           [&](double t) { return Vec3(functions[0](t), functions[1](t), functions[2](t)); });
    };
    return is_along(load.force) && is_along(load.moment);
}

bool is_steady_on_spin(const DistributedLoad& load, const Model& model, const TurningFrame& frame) {
    const Rod& rod = model.rods[static_cast<std::size_t>(load.rod)];
    if (!frame.spins(rod.nodes.front())) return true;
    if (load.field) return false;
    if (!turns_with_part(load.frame)) return true;
    const Vec3 axis = load.frame == Frame::body ? Vec3::UnitX() : frame.axis;
    for (const double part : spin_load_factors) {
        const double s = part * rod.length;
        for (const auto& functions : {load.force, load.moment}) {
            const auto value = [&](double t) {
                return Vec3(functions[0](t, s), functions[1](t, s), functions[2](t, s));
            };
            if (!stays_along(axis, value)) return false;
        }
    }
    return true;
}

std::string find_unsteady_load_of_spin(const Model& model, const TurningFrame& frame) {
    const auto describe = [](const std::string& key) {
        return key + " turns with a part that spins, and is not along its axis. Fix it in space, or make";
    };
    const auto follows = [](const std::string& key) {
        return key + " depends on how a part turns that spins. Leave that out, or make";
    };
    for (const NodalLoad& load : model.loads) {
        if (!is_steady_on_spin(load, frame)) return describe(load.key);
        if (load.by_motion.turns && frame.spins(load.node)) return follows(load.key);
    }
    for (const DistributedLoad& load : model.distributed_loads) {
        if (!is_steady_on_spin(load, model, frame)) return describe(load.key);
        const Rod& rod = model.rods[static_cast<std::size_t>(load.rod)];
        if (load.by_motion.turns && frame.spins(rod.nodes.front())) return follows(load.key);
    }
    const auto is_on_spin = [&](int rod) {
        return frame.spins(model.rods[static_cast<std::size_t>(rod)].nodes.front());
    };
    for (const Actuation& actuation : model.actuations) {
        if (is_on_spin(actuation.rod))
            return actuation.key + " acts within a rod that spins, which is not followed. Make";
    }
    for (const Tendon& tendon : model.tendons) {
        if (is_on_spin(tendon.rod))
            return fmt::format("tendon.{} is in a rod that spins, which is not followed. Make", tendon.name);
    }
    const Surroundings& around = model.surroundings;
    if (around.water && around.water->acts() && !around.water->waves.empty())
        return "a wave is not steady. Leave it out, or make";
    if (around.seabed && around.seabed->has_friction())
        return "friction of seabed is not steady. Leave it out, or make";
    return "";
}

// Whether the ends of a tie that spin are on the axis of what carries them.
bool are_centred(std::span<const Anchor> ends, const TurningFrame& frame) {
    return std::ranges::all_of(
        ends, [&](const Anchor& end) { return !frame.spins(end.node) || is_along_axis(end.arm, frame); });
}

int count_spinning(std::span<const Anchor> ends, const TurningFrame& frame) {
    return static_cast<int>(
        std::ranges::count_if(ends, [&](const Anchor& end) { return frame.spins(end.node); }));
}

// Between two parts, of which one spins or both do.
const char* find_flaw(const Bushing& bushing, const TurningFrame& frame) {
    const BushingTurn turn = find_bushing_turn(bushing);
    const bool is_axial =
        turn.kind == BushingTurn::Kind::spin ||
        (turn.kind == BushingTurn::Kind::swing && is_along_axis(bushing.axes * Vec3::Unit(turn.axis), frame));
    const Vec3 axis = bushing.axes.conjugate() * frame.axis;
    const bool is_alike = is_alike_about(axis, bushing.stiffness) && is_alike_about(axis, bushing.damping);
    if (count_spinning(bushing.ends, frame) == 2) {
        const bool is_at_rest = bushing.carrier == BushingAxes::ground;
        if (!is_at_rest && !is_alike) return "spins, and is not alike to all sides";
        return turn.kind != BushingTurn::Kind::swing || is_axial
                   ? ""
                   : "spins, and resists tilts about one direction alone";
    }
    if (!is_axial)
        return "holds the spin, or resists tilts about one direction across the axis alone. Leave the "
               "stiffness "
               "about the axis out";
    if (bushing.has_axes_between())
        return "has axes half way between what spins and what does not. Let what does not spin carry them: "
               "axes = "
               "\"ground\"";
    const bool is_carried_by_spin = (carries_axes(bushing, 0) && frame.spins(bushing.ends[0].node)) ||
                                    (carries_axes(bushing, 1) && frame.spins(bushing.ends[1].node));
    if (is_carried_by_spin && !is_alike)
        return "has axes that spin, and is not alike to all sides. Let what does not spin carry them: axes = "
               "\"ground\"";
    return "";
}

const char* find_flaw(const Joint& joint, bool do_both_spin, const TurningFrame& frame) {
    const TurningJointCard& card = turning_card_of(joint.kind);
    if (card_of(joint.kind).has_axis_b)
        return "turns once a revolution between what spins. Take a ball or a weld";
    if (!card.is_alike)
        return "does not hold all directions alike. Take a hinge along the axis, a ball or a weld";
    if (card.holds_turn && !do_both_spin) return "holds the spin. Take a hinge or a cylinder along the axis";
    if (!card.has_axis) return "";
    if (!is_along_axis(joint.a.axes.col(0), frame))
        return "has an axis other than that of the spin. Take the axis of the spin, or a ball";
    if (!do_both_spin && depends_on_turn(joint.turn))
        return "has a spring, friction, limits or a motor on the turn against what spins. Leave a damping or "
               "a drive";
    return "";
}

const char* find_flaw(const Model& model, const Gear& gear, const TurningFrame& frame) {
    for (const GearSide& side : gear.sides) {
        const Joint& joint = model.joints[static_cast<std::size_t>(side.joint)];
        const std::array<Anchor, 2> ends{joint.a.anchor, joint.b.anchor};
        if (side.is_turn && count_spinning(ends, frame) == 1)
            return "couples a turn against what spins. Leave it out";
    }
    return "";
}

const char* find_flaw(const Model& model, const Tie& tie, const TurningFrame& frame) {
    if (tie.kind == TieKind::gear) return find_flaw(model, model.gears[tie.index], frame);
    const int count = count_spinning(tie.ends, frame);
    if (count == 0) return "";
    if (!are_centred(tie.ends, frame))
        return "is tied to a part that spins, off its axis. Tie it to the axis";
    if (tie.kind == TieKind::bushing) return find_flaw(model.bushings[tie.index], frame);
    if (tie.kind == TieKind::joint) return find_flaw(model.joints[tie.index], count == 2, frame);
    return "";
}

std::string find_unsteady_part(const Model& model, const TurningFrame& frame) {
    for (const Rod& rod : model.rods) {
        if (const char* cause = find_flaw(model, rod, frame); *cause != '\0')
            return fmt::format(
                "rod.{} {}. Let a frame turn (without rotation.spins), or make", rod.name, cause);
    }
    for (const Body& body : model.bodies) {
        if (const char* cause = find_flaw(body, frame); *cause != '\0')
            return fmt::format(
                "body.{} {}. Let a frame turn (without rotation.spins), or make", body.name, cause);
    }
    for (const Support& support : model.supports) {
        if (frame.spins(support.node) && (support.moved[3] || support.moved[4] || support.moved[5]))
            return fmt::format("a support turns {}, which spins. Fix it there, or make",
                               model.nodes[static_cast<std::size_t>(support.node)].name);
    }
    return "";
}

std::string find_unsteady_tie_of_spin(const Model& model, const TurningFrame& frame) {
    for (const Tie& tie : list_ties(model)) {
        if (const char* cause = find_flaw(model, tie, frame); *cause != '\0')
            return fmt::format("{} {}, or make", key_of(tie), cause);
    }
    return "";
}

}  // namespace

std::string find_unsteady_spin(const Model& model, const TurningFrame& frame) {
    std::string cause = find_unsteady_part(model, frame);
    if (cause.empty()) cause = find_unsteady_load_of_spin(model, frame);
    if (cause.empty()) cause = find_unsteady_tie_of_spin(model, frame);
    return cause.empty() ? "" : cause + " the motion a dynamic analysis";
}

}  // namespace gxrod
