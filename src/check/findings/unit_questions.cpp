#include "check/findings/unit_questions.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <ranges>
#include <string_view>

#include "cross_section/cross_section.hpp"

namespace gxrod {
namespace {

struct Unit {
    std::string_view word;
    double size;  // in the unit of the SI
};

constexpr std::array<Unit, 9> length_units{{{"m", 1.0},
                                            {"mm", 1e-3},
                                            {"cm", 1e-2},
                                            {"dm", 0.1},
                                            {"km", 1e3},
                                            {"µm", 1e-6},
                                            {"um", 1e-6},
                                            {"in", 0.0254},
                                            {"ft", 0.3048}}};
constexpr std::array<Unit, 6> mass_units{
    {{"kg", 1.0}, {"g", 1e-3}, {"mg", 1e-6}, {"t", 1e3}, {"slug", 14.59390294}, {"lbm", 0.45359237}}};
constexpr std::array<Unit, 7> force_units{{{"N", 1.0},
                                           {"kN", 1e3},
                                           {"MN", 1e6},
                                           {"mN", 1e-3},
                                           {"lbf", 4.4482216152605},
                                           {"kip", 4448.2216152605},
                                           {"dyn", 1e-5}}};
constexpr std::array<Unit, 4> time_units{{{"s", 1.0}, {"ms", 1e-3}, {"min", 60.0}, {"h", 3600.0}}};

template <std::size_t count>
std::optional<double> find_unit(const std::array<Unit, count>& units, std::string_view word) {
    const auto found = std::ranges::find(units, word, &Unit::word);
    return found == units.end() ? std::nullopt : std::optional(found->size);
}

struct UsualRange {
    double least;
    double most;

    bool hold(double value) const { return value >= least && value <= most; }
};

constexpr UsualRange gravities{0.05, 100.0};  // of moons and planets, in m/s²
constexpr UsualRange wave_speeds{0.05, 3e4};  // of stretching, from gels to diamond, in m/s
constexpr UsualRange densities{0.5, 2.5e5};   // from foams to platinum, and ten times as much, in kg/m³
constexpr double steel_wave_speed = 5.2e3;    // m/s

class UnitQuestions {
  public:
    UnitQuestions(const Model& model, const std::string& text, const DeckUnits& units)
        : model_(model), text_(text), units_(units) {}

    std::vector<Finding> ask() {
        ask_of_gravity();
        for (const Section& section : model_.sections) {
            if (ask_of_stiffness(section) || ask_of_density(section)) break;
        }
        return std::move(findings_);
    }

  private:
    void ask_of_gravity() {
        const Vec3 gravity(model_.gravity.components()[0](1.0),
                           model_.gravity.components()[1](1.0),
                           model_.gravity.components()[2](1.0));
        const double unit = units_.length / (units_.time * units_.time);
        if (gravity.isZero(0.0) || !gravity.allFinite() || gravities.hold(gravity.norm() * unit)) return;
        add(fmt::format("gravity of {:.6g} is {:.3g} m/s² in \"{}\"; that of the earth is {:.6g} there",
                        gravity.norm(),
                        gravity.norm() * unit,
                        text_,
                        9.81 / unit));
    }

    bool ask_of_stiffness(const Section& section) {
        const double speed = std::sqrt(section.stiffness(0, 0) / section.mass(0, 0));
        const double unit = units_.length / units_.time;
        if (!std::isfinite(speed) || speed == 0.0 || wave_speeds.hold(speed * unit)) return false;
        add(fmt::format(
            "stretching runs along section {} at √(EA/ρA) = {:.3g}, {:.3g} m/s in \"{}\" (of steel {:.3g} "
            "m/s); are modulus and density in these units?",
            section.name,
            speed,
            speed * unit,
            text_,
            steel_wave_speed));
        return true;
    }

    // The area of a circle whose radius of gyration the section has.
    bool ask_of_density(const Section& section) {
        const Mat6& C = section.stiffness;
        const double area = section.shape ? section.shape->properties.area
                                          : 4.0 * std::numbers::pi * std::max(C(4, 4), C(5, 5)) / C(0, 0);
        const double density = section.mass(0, 0) / area;
        if (!units_.mass || !std::isfinite(density) || density == 0.0) return false;
        const double unit = *units_.mass / std::pow(units_.length, 3);
        if (densities.hold(density * unit)) return false;
        add(fmt::format(
            "section {} has a density of about {:.3g}, {:.3g} kg/m³ in \"{}\"; water has {:.3g} there",
            section.name,
            density,
            density * unit,
            text_,
            1000.0 / unit));
        return true;
    }

    void add(std::string message) { findings_.push_back({Severity::note, std::move(message)}); }

    const Model& model_;
    const std::string& text_;
    DeckUnits units_;
    std::vector<Finding> findings_;
};

}  // namespace

std::optional<DeckUnits> read_units(const std::string& text) {
    std::optional<double> length, time, mass, force;
    for (const auto part : std::views::split(text, ' ')) {
        const std::string_view whole(part.begin(), part.end());
        const std::string_view word = whole.substr(0, whole.find_first_of(",;"));
        const auto take = [&](std::optional<double>& unit, const auto& units) {
            if (!unit) unit = find_unit(units, word);
        };
        take(length, length_units);
        take(time, time_units);
        take(mass, mass_units);
        take(force, force_units);
    }
    if (!length) return std::nullopt;
    DeckUnits units{*length, time.value_or(1.0), mass};
    if (!mass && force) units.mass = *force * units.time * units.time / units.length;
    return units;
}

std::vector<Finding> question_units(const Model& model, const std::string& text) {
    const std::optional<DeckUnits> units = read_units(text);
    return units ? UnitQuestions(model, text, *units).ask() : std::vector<Finding>{};
}

}  // namespace gxrod
