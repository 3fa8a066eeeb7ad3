#include "check/findings/buckling_findings.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "model/ties/ties.hpp"

namespace gxrod {

namespace {

std::string leave_out(const std::string& what) {
    return fmt::format(
        "buckling factors would leave out {}: raise it in a stage of kind static with small steps, "
        "whose stability is counted",
        what);
}

// The first rod whose wall the pressures of what is in it and around it stretch.
std::string find_pressed_section(const Model& model) {
    if (model.surroundings.is_empty()) return "";
    for (const Rod& rod : model.rods) {
        const Section& section = rod.has_varying_sections()
                                     ? rod.varying.at_forces.front()
                                     : model.sections[static_cast<std::size_t>(rod.section)];
        if (!section.fluid || section.fluid->poisson == 0.5) continue;
        const Section& mean = model.sections[static_cast<std::size_t>(rod.section)];
        return mean.name.empty() ? "of rod " + rod.name : "section " + mean.name;
    }
    return "";
}

// Whether anything acts that a factor multiplies.
bool grows(const Model& model) {
    const auto is_load = [](const NodalLoad& load) { return load.has_force() || !is_zero(load.moment); };
    const auto is_line_load = [](const DistributedLoad& load) {
        return !is_zero(load.force) || !is_zero(load.moment);
    };
    const auto is_moved = [](const Support& support) { return support.moved != std::array<bool, 6>{}; };
    return !model.gravity.is_zero() || std::ranges::any_of(model.loads, is_load) ||
           std::ranges::any_of(model.distributed_loads, is_line_load) ||
           std::ranges::any_of(model.supports, is_moved) || has_joint_drive(model);
}

// A spring that pulls or pushes at t = 0; "" without one.
std::string find_taut_spring(const Model& model) {
    constexpr double round_off = 1e-12;
    for (const Spring& spring : model.springs) {
        const double length = (find_place(model, spring.ends[1]) - find_place(model, spring.ends[0])).norm();
        const double force = std::abs(compute_elastic_tension(spring, length));
        if (force > round_off * find_stiffness(spring) * std::max(length, spring.length)) return spring.name;
    }
    return "";
}

}  // namespace

std::string find_reason_against_factors(const Model& model) {
    if (!model.tendons.empty()) return leave_out("what tendon." + model.tendons.front().name + " does");
    if (!model.actuations.empty()) return leave_out("what " + model.actuations.front().key + " does");
    const std::string pressed = find_pressed_section(model);
    if (!pressed.empty()) {
        return fmt::format(
            "buckling factors would leave out the pressures of contents and water, which stretch the "
            "wall of {} (fluid.poisson below 1/2): take poisson = 0.5, which leaves no strain, or a "
            "stage of kind static with small steps, whose stability is counted",
            pressed);
    }
    if (grows(model)) return "";
    const std::string taut = find_taut_spring(model);
    return fmt::format(
        "nothing acts that a buckling factor could multiply: no load, gravity, or move of a support "
        "or joint{}",
        taut.empty() ? "" : "; the force of spring." + taut + " belongs to the state, and does not grow");
}

}  // namespace gxrod
