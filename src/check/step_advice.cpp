#include "check/step_advice.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <complex>
#include <numbers>

#include "check/summaries/model_summary.hpp"

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

// Steps in a period with which a scheme errs in it by some hundredths of a rad (docs/theory/newmark.md).
double steps_needed(Scheme scheme) {
    switch (scheme) {
        case Scheme::radau_5:
            return 4.0;
        case Scheme::gauss_4:
            return 5.0;
        case Scheme::sdirk_4:
        case Scheme::runge_kutta_4:
            return 8.0;
        case Scheme::newmark_simplified:
        case Scheme::newmark_ibrahimbegovic:
        case Scheme::generalized_alpha:
        case Scheme::energy_momentum:
            break;
    }
    return 20.0;
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
    if (has_contact) return step;  // which radau-5 does not take
    if (settings.scheme == Scheme::radau_5) return step + ", or accuracy = 1e-3 in its place";
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
    const double needed = steps_needed(settings.scheme);
    if (!settings.adaptive && step * needed > longest_period) {
        text += fmt::format("  {} needs some {} steps in a period that matters: {}\n",
                            name_of(settings.scheme),
                            needed,
                            advise_step(longest_period / needed, settings, has_contact));
    }
    const bool is_stiff = step * found.highest > resolved;
    if (settings.scheme == Scheme::sdirk_4 && is_stiff) {
        text +=
            "  sdirk-4 with these steps does not resolve the highest ones: if they are excited, reactions "
            "and accelerations lose their order and energy may grow; radau-5 keeps its order\n";
    }
    if (settings.scheme == Scheme::gauss_4 && is_stiff) {
        text +=
            "  gauss-4 with these steps does not resolve the highest ones and damps nothing: if they are "
            "excited, they ring; radau-5 damps them\n";
    }
    if (settings.scheme != Scheme::runge_kutta_4) return text;
    const double longest = find_explicit_limit(damping) / found.highest;
    text += fmt::format("  runge-kutta-4 is stable up to time steps of {:.3g}", longest);
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
    const double tolerable = cycle / steps_needed(settings.scheme);
    if (!(turn > tolerable)) return "";
    return fmt::format("  a step turns {} by {:.2g} rad, a turn in {:.2g} steps, at t = 0: {}\n",
                       fastest.name,
                       turn,
                       cycle / turn,
                       advise_step(tolerable / rate_of(fastest), settings, !model.contact.is_empty()));
}

}  // namespace gxrod
