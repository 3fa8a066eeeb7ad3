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

// The first chamber whose pressure follows its volume.
std::string find_gas(const Model& model) {
    const auto has_gas = [](const Tendon& tendon) {
        return tendon.winch && tendon.winch->gas && !tendon.winch->is_released;
    };
    const auto found = std::ranges::find_if(model.tendons, has_gas);
    return found == model.tendons.end() ? "" : found->name;
}

// The first tendon whose tension depends on the way to it.
std::string find_rubbing_tendon(const Model& model) {
    const auto rubs = [](const Tendon& tendon) {
        return tendon.friction && tendon.friction->coefficient > 0.0;
    };
    const auto found = std::ranges::find_if(model.tendons, rubs);
    return found == model.tendons.end() ? "" : found->name;
}

// The first actuation of a rod whose sections do not respond in proportion.
std::string find_bent_actuation(const Model& model) {
    for (const Actuation& actuation : model.actuations) {
        const Rod& rod = model.rods[static_cast<std::size_t>(actuation.rod)];
        const Section& section = rod.has_varying_sections()
                                     ? rod.varying.at_forces.front()
                                     : model.sections[static_cast<std::size_t>(rod.section)];
        if (section.law) return actuation.key + " does to sections with a law";
    }
    return "";
}

// Whether anything acts that a factor multiplies.
bool grows(const Model& model) {
    const auto acts = [](const auto& load) { return load.acts(); };
    const auto is_moved = [](const Support& support) { return support.moved != std::array<bool, 6>{}; };
    const auto is_pulled = [](const Tendon& tendon) {
        return tendon.winch ? !tendon.winch->is_released : !tendon.tension.is_zero();
    };
    return !model.gravity.is_zero() || std::ranges::any_of(model.loads, acts) ||
           std::ranges::any_of(model.distributed_loads, acts) ||
           std::ranges::any_of(model.supports, is_moved) || !model.actuations.empty() ||
           std::ranges::any_of(model.tendons, is_pulled) || has_joint_drive(model);
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
    const std::string rubbing = find_rubbing_tendon(model);
    if (!rubbing.empty()) return leave_out("how the friction of tendon." + rubbing + " changes its tension");
    const std::string gas = find_gas(model);
    if (!gas.empty()) return leave_out("how the gas in chamber." + gas + " changes its pressure");
    const std::string bent = find_bent_actuation(model);
    if (!bent.empty()) return leave_out("what " + bent);
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
        "nothing acts that a buckling factor could multiply: no load, gravity, tendon, actuation, or move of "
        "a support or joint{}",
        taut.empty() ? "" : "; the force of spring." + taut + " belongs to the state, and does not grow");
}

std::string find_moved_obstacle(const Model& model) {
    for (const Obstacle& obstacle : model.contact.obstacles) {
        if (obstacle.motion)
            return fmt::format(
                "buckling factors would leave out the move of obstacle {}: move it in a stage of kind "
                "static before",
                obstacle.name);
    }
    return "";
}

}  // namespace gxrod
