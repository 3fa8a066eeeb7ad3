#include "check/summaries/tendon_summary.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>

#include "assembly/system.hpp"
#include "assembly/tendons/tendon_line.hpp"
#include "model/evaluation_error.hpp"

namespace gxrod {
namespace {

std::string describe_course(const char* word, const TimeFunction& function) {
    // + 0: without −0
    if (function.is_constant()) return fmt::format("{} {:.6g}", word, function(0.0) + 0.0);
    return fmt::format("{} changes with t, {:.6g} at t = 1", word, function(1.0) + 0.0);
}

// "tension 3", or "shortening …", "length …".
std::string describe_pull(const Tendon& tendon) {
    if (!tendon.winch) return describe_course("tension", tendon.tension);
    const TendonWinch& winch = *tendon.winch;
    if (winch.is_released) return "released";
    std::string text = winch.length ? describe_course("length", *winch.length)
                                    : describe_course("shortening", winch.shortening);
    text += winch.stiffness == 0.0 ? ", does not stretch" : fmt::format(", EA {:.6g}", winch.stiffness);
    return text + (winch.pulls_only ? "" : ", pushes where it is too long");
}

// The place in the section just within an end, "(0.015, 0)"; "" where the path has no value.
std::string describe_offset(const Tendon& tendon, double s) {
    constexpr double round_off = 1e-6;  // of the offset: the place is not the end itself
    try {
        const Vec3 at = tendon.path(s).at;
        const auto component = [&](int i) { return std::abs(at[i]) < round_off * at.norm() ? 0.0 : at[i]; };
        return fmt::format("({:.6g}, {:.6g})", component(1), component(2));
    } catch (const EvaluationError&) {
        return "";
    }
}

// "at (y, z) = (0.015, 0)", or "at (y, z) = (0.015, 0) to (0.01, 0)".
std::string describe_offsets(const Tendon& tendon) {
    const double within = 1e-9 * (tendon.to - tendon.from);
    const std::string first = describe_offset(tendon, tendon.from + within);
    const std::string last = describe_offset(tendon, tendon.to - within);
    if (first.empty() || last.empty()) return "";
    return ", at (y, z) = " + first + (first == last ? "" : " to " + last);
}

// The angle by which the tendon turns on its way, at t = 0.
double find_turning(const Model& model, const TendonLine& line) {
    const State state = System(model).initial_state();
    const std::vector<TendonTangent> tangents = line.list_tangents(state.trial, state, false);
    double angle = 0.0;
    for (std::size_t i = 1; i < tangents.size(); ++i) {
        const Vec3 &from = tangents[i - 1].slope, &to = tangents[i].slope;
        angle += std::atan2(from.cross(to).norm(), from.dot(to));
    }
    return angle;
}

std::string describe_friction(const Model& model, const Tendon& tendon, const TendonLine& line) {
    if (!tendon.friction) return "";
    const CapstanFriction& friction = *tendon.friction;
    const double angle = find_turning(model, line);
    return fmt::format(
        "; friction {:.6g}, pulled at its {}: at t = 0 it turns by {:.4g}, which leaves {:.3g} % of the "
        "tension",
        friction.coefficient,
        friction.is_pulled_at_start ? "start" : "end",
        angle,
        100.0 * std::exp(-friction.coefficient * angle));
}

// "−p A …", or the gas, or the volume.
std::string describe_filling(const Tendon& chamber) {
    if (!chamber.winch) return describe_course("−p A", chamber.tension);
    if (chamber.winch->is_released) return "open";
    if (!chamber.winch->gas)
        return fmt::format("holds its volume, {:.6g} times its length: ", chamber.area) +
               describe_course("length", *chamber.winch->length);
    const ClosedGas& gas = *chamber.winch->gas;
    return fmt::format("gas of p Vⁿ, n {:.6g}, ambient {:.6g}, ", gas.exponent, gas.ambient) +
           describe_course("pressure", gas.pressure) +
           (gas.volume ? fmt::format(" in the volume {:.6g}", *gas.volume) : " in its volume at t = 0");
}

std::string describe_tendon(const Model& model, const Tendon& tendon, bool is_chamber) {
    const Rod& rod = model.rods[static_cast<std::size_t>(tendon.rod)];
    const bool is_whole = tendon.from == 0.0 && tendon.to == rod.length;
    const TendonLine line(model, tendon);
    return fmt::format("{} {}: in rod {}{}{}, {:.6g} long; {}{}\n",
                       is_chamber ? "chamber" : "tendon",
                       tendon.name,
                       rod.name,
                       is_whole ? "" : fmt::format(" from s = {:.6g} to {:.6g}", tendon.from, tendon.to),
                       describe_offsets(tendon),
                       line.start_length(),
                       is_chamber ? describe_filling(tendon) : describe_pull(tendon),
                       describe_friction(model, tendon, line));
}

std::string describe_input(const Input& input, const InputUses& uses) {
    const auto found = uses.find(input.name());
    const bool is_read = found != uses.end() && !found->second.empty();
    return fmt::format("input {}: {:.6g} at t = 0, between two values {}{}\n",
                       input.name(),
                       input(0.0),
                       input.hold() == InputHold::step ? "a step" : "a straight line",
                       is_read ? fmt::format("; read by {}", fmt::join(found->second, ", ")) : "");
}

}  // namespace

ItemList list_tendons(const Model& model, const DeckWords& words) {
    ItemList tendons{"tendons", {}};
    for (const Tendon& tendon : model.tendons)
        tendons.items.push_back(describe_tendon(model, tendon, words.chambers.contains(tendon.name)));
    return tendons;
}

ItemList list_inputs(const Model& model, const DeckWords& words) {
    ItemList inputs{"inputs", {}};
    for (const std::shared_ptr<Input>& input : model.inputs)
        inputs.items.push_back(describe_input(*input, words.uses));
    return inputs;
}

}  // namespace gxrod
