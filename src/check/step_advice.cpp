#include "check/step_advice.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <complex>
#include <numbers>

#include "model/settings/scheme_card.hpp"

namespace gxrod {

namespace {

constexpr double cycle = 2.0 * std::numbers::pi;

// A step's part of a vibration, in rad, that a scheme of order 4 follows.
constexpr double resolved = 2.0;

// The largest ωΔt at which runge-kutta-4 damps a vibration of frequency ω and damping ratio zeta: where its
// |1 + z + z²/2 + z³/6 + z⁴/24| reaches 1 on the ray z = λΔt.
double find_explicit_limit(double zeta) {
    using Complex = std::complex<double>;
    // The faster of two real rates, in units of ω, or the angle of two complex ones.
    const Complex direction = zeta < 1.0 ? Complex(-zeta, std::sqrt(1.0 - zeta * zeta))
                                         : Complex(-zeta - std::sqrt(zeta * zeta - 1.0), 0.0);
    const auto grows = [&](double length) {
        const Complex z = length * direction;
        const Complex growth = 1.0 + z * (1.0 + z / 2.0 * (1.0 + z / 3.0 * (1.0 + z / 4.0)));
        return std::abs(growth) > 1.0 + 1e-12;
    };
    double stable = 1.0 / std::abs(direction);
    double unstable = 4.0 / std::abs(direction);
    while (unstable - stable > 1e-6 * stable) {
        const double middle = 0.5 * (stable + unstable);
        (grows(middle) ? unstable : stable) = middle;
    }
    return stable;
}

// "1/13.7", "2.55", "1852".
std::string describe_part(double part) {
    const double size = part < 1.0 ? 1.0 / part : part;
    const std::string text = size < 1000.0 ? fmt::format("{:.3g}", size) : fmt::format("{:.0f}", size);
    return part < 1.0 ? "1/" + text : text;
}

// What suits, of a deck whose steps are too long for its scheme.
std::string advise_step(double longest, const DynamicSettings& settings, bool has_contact) {
    std::string step = fmt::format("expected time_step = {:.2g}", longest);
    if (has_contact) return step;  // radau-5 may take many steps at each impact
    if (settings.scheme == accurate_scheme) return step + ", or accuracy = 1e-3 in its place";
    return step + ", or accuracy = 1e-3 in its place, which takes radau-5";
}

}  // namespace

std::string describe_steps(const MeshFrequencies& found,
                           double damping,
                           const DynamicSettings& settings,
                           bool has_contact) {
    const double step = settings.time_step();
    const double longest_period = cycle / found.lowest;
    std::string text;
    if (!settings.adaptive) {
        text += fmt::format("  a step of {:.4g} is {} of the longest period and {} of the shortest\n",
                            step,
                            describe_part(step / longest_period),
                            describe_part(step * found.highest / cycle));
    }
    const SchemeCard& card = card_of(settings.scheme);
    const double needed = card.steps_in_period;
    if (!settings.adaptive && step * needed > longest_period) {
        text += fmt::format("  {} needs some {} steps in a period that matters: {}\n",
                            card.word,
                            needed,
                            advise_step(longest_period / needed, settings, has_contact));
    }
    const bool is_stiff = step * found.highest > resolved;
    if (is_stiff && !card.if_unresolved.empty())
        text += fmt::format(
            "  {} with these steps does not resolve the highest ones{}\n", card.word, card.if_unresolved);
    if (!card.is_explicit) return text;
    const double longest = find_explicit_limit(damping) / found.highest;
    text += fmt::format("  {} is stable up to time steps of {:.3g}", card.word, longest);
    if (step > longest) {
        text +=
            fmt::format(": this deck's, {:.3g}, will fail; accuracy = 1e-3 in its place takes radau-5", step);
    }
    return text + "\n";
}

std::string describe_turning(const Model& model, const DynamicSettings& settings) {
    if (settings.adaptive || model.nodes.empty()) return "";
    const auto rate_of = [](const Node& node) { return node.angular_velocity.norm(); };
    const Node& fastest = *std::ranges::max_element(model.nodes, {}, rate_of);
    const double turn = settings.time_step() * rate_of(fastest);
    const double tolerable = cycle / card_of(settings.scheme).steps_in_period;
    if (!(turn > tolerable)) return "";
    return fmt::format("  a step turns {} by {:.2g} rad, a turn in {:.2g} steps, at t = 0: {}\n",
                       fastest.name,
                       turn,
                       cycle / turn,
                       advise_step(tolerable / rate_of(fastest), settings, !model.contact.is_empty()));
}

}  // namespace gxrod
