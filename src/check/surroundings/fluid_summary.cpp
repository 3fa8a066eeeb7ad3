#include "check/surroundings/fluid_summary.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "check/surroundings/line_words.hpp"
#include "environment/flow_profile.hpp"
#include "environment/sea.hpp"
#include "rotation/vector_text.hpp"

namespace gxrod {
namespace {

// So many waves are said one by one.
constexpr std::size_t most_single_waves = 3;
constexpr double degrees = 180.0 / M_PI;

// Of drag or added mass: "1.2 across, 0.02 along", or for each axis.
std::string describe_coefficients(const Vec3& c) {
    if (c.y() == c.z()) return fmt::format("{:.6g} across, {:.6g} along", c.y(), c.x());
    return fmt::format("{:.6g}, {:.6g}, {:.6g} along x, y, z", c.x(), c.y(), c.z());
}

struct Extent {
    double least, most;
};

template <class Value>
Extent find_range(const std::vector<const Section*>& sections, const Value& value) {
    Extent range{value(*sections.front()), value(*sections.front())};
    for (const Section* section : sections) {
        range.least = std::min(range.least, value(*section));
        range.most = std::max(range.most, value(*section));
    }
    return range;
}

std::string describe(const Extent& range) {
    constexpr double round_off = 1e-12;
    if (range.most - range.least <= round_off * std::max(std::abs(range.least), std::abs(range.most)))
        return fmt::format("{:.6g}", range.most);
    return fmt::format("{:.6g} … {:.6g}", range.least, range.most);
}

std::string describe_in_water(const Model& model,
                              const Rod& rod,
                              const std::vector<const Section*>& sections) {
    if (!model.surroundings.water || !model.surroundings.water->acts()) return "";
    const double density = model.surroundings.water->density_at(1.0);
    const double gravity = find_gravity(model);
    const Section& mean = model.sections[static_cast<std::size_t>(rod.section)];
    std::string text =
        fmt::format("  in water: displaced mass {:.6g}", density * mean.fluid->area * rod.length);
    if (gravity == 0.0) return text + "\n";
    const Extent weight =
        find_range(sections, [&](const Section& one) { return find_wet_weight(one, density, gravity); });
    text += fmt::format(", weight less buoyancy {} per length", describe(weight));
    if (weight.most < 0.0) return text + ": it floats\n";
    return text + (weight.least < 0.0 ? ": in parts it floats\n" : "\n");
}

std::string describe_on_ground(const Model& model, const std::vector<const Section*>& sections) {
    const double gravity = find_gravity(model);
    if (!model.surroundings.seabed || !model.surroundings.seabed->acts() || gravity == 0.0) return "";
    const double density = model.surroundings.water ? model.surroundings.water->density_at(1.0) : 0.0;
    const double stiffness = model.surroundings.seabed->stiffness;
    const Extent depth = find_range(sections, [&](const Section& one) {
        const double weight = find_wet_weight(one, density, gravity);
        return std::max(weight, 0.0) / (stiffness * one.fluid->diameter);
    });
    const Extent part = find_range(sections, [&](const Section& one) {
        const double weight = find_wet_weight(one, density, gravity);
        return std::max(weight, 0.0) / (stiffness * one.fluid->diameter * one.fluid->diameter);
    });
    return fmt::format(
        "  at rest on the ground: {} deep, {:.2g} of the diameter\n", describe(depth), part.most);
}

std::string describe_profile(const SpeedProfile& profile) {
    if (width_of(profile) > 1) {
        const auto describe_end = [&](std::size_t row) {
            return fmt::format(
                "{} at z = {:.6g}", in_parentheses(velocity_at_row(profile, row)), profile.heights[row]);
        };
        return describe_end(0) + " to " + describe_end(profile.heights.size() - 1);
    }
    return fmt::format("{:.6g} at z = {:.6g} to {:.6g} at z = {:.6g}, along {}",
                       profile.speeds.front(),
                       profile.heights.front(),
                       profile.speeds.back(),
                       profile.heights.back(),
                       in_parentheses(profile.direction));
}

std::string describe_flow(const Flow& flow, const char* what) {
    std::string text;
    if (flow.profile) text += fmt::format("; {} {}", what, describe_profile(*flow.profile));
    if (flow.field) text += fmt::format("; {} by place and time", what);
    return text;
}

// Of water or ground that is not there, or not wholly, in the first stage.
std::string describe_factor(const TimeFunction& factor) {
    if (factor.is_zero()) return ", not in the first stage";
    if (!factor.is_constant()) return ", times a factor";
    return factor(0.0) == 1.0 ? "" : fmt::format(", times {:.6g}", factor(0.0));
}

std::string describe_water(const Water& water) {
    std::string text = fmt::format("water: density {:.6g}", water.density) + describe_factor(water.factor);
    text += water.surface ? fmt::format(", surface at z = {:.6g}", *water.surface) : ", everywhere";
    if (water.depth) text += fmt::format(", {:.6g} deep for waves", *water.depth);
    return text + describe_flow(water.current, "current") + "\n";
}

std::string describe_wave(const WaveTrain& wave) {
    const double height = 2.0 * wave.amplitude;
    const double length = 2.0 * M_PI / wave.number;
    return fmt::format(
        "wave: height {:.6g}, period {:.6g}, number {:.6g}, length {:.6g}, steepness {:.3g}, towards {:.4g}° "
        "from x\n",
        height,
        2.0 * M_PI / wave.frequency,
        wave.number,
        length,
        height / length,
        wave.direction * degrees);
}

std::string describe_sea(const std::vector<WaveTrain>& waves) {
    const SeaMeasures sea = measure_sea(waves);
    const auto by_period = [](const WaveTrain& a, const WaveTrain& b) { return a.frequency < b.frequency; };
    const auto [longest, shortest] = std::ranges::minmax_element(waves, by_period);
    return fmt::format(
        "waves: {} components, significant height {:.6g}, mean period {:.6g}, zero-crossing period {:.6g}, "
        "steepness {:.3g}, periods {:.6g} to {:.6g}\n",
        waves.size(),
        sea.significant_height,
        sea.mean_period,
        sea.zero_crossing_period,
        sea.steepness,
        2.0 * M_PI / shortest->frequency,
        2.0 * M_PI / longest->frequency);
}

std::string describe_ground(const Seabed& ground) {
    std::string text = "ground: ";
    if (ground.grid) {
        text += fmt::format("a grid of {} × {} heights", ground.grid->x.size(), ground.grid->y.size());
    } else if (ground.normal.z() == 1.0) {
        text += fmt::format("z = {:.6g}", ground.point.z());
    } else {
        text += fmt::format(
            "a plane through {} across {}", in_parentheses(ground.point), in_parentheses(ground.normal));
    }
    text += fmt::format(", stiffness {:.6g}, damping {:.6g}", ground.stiffness, ground.damping);
    text += describe_factor(ground.factor);
    if (!ground.has_friction())
        return text + (ground.friction_stiffness > 0.0 ? ", friction in later stages\n" : ", no friction\n");
    return text + fmt::format(", friction {:.6g} along and {:.6g} across, sliding after stiffness {:.6g}\n",
                              ground.axial_friction,
                              ground.lateral_friction,
                              ground.friction_stiffness);
}

}  // namespace

double find_gravity(const Model& model) { return model.gravity(1.0).norm(); }

std::vector<const Section*> list_sections(const Model& model, const Rod& rod) {
    std::vector<const Section*> sections;
    for (const Section& section : rod.varying.at_nodes) sections.push_back(&section);
    if (sections.empty()) sections.push_back(&model.sections[static_cast<std::size_t>(rod.section)]);
    return sections;
}

double find_wet_weight(const Section& section, double water_density, double gravity) {
    return gravity * (section.mass(0, 0) - water_density * section.fluid->area);
}

std::string describe_fluid(const Section& section) {
    if (!section.fluid) return "";
    const SectionInFluid& fluid = *section.fluid;
    std::string text = fmt::format("  in fluids: diameter {:.6g}, area {:.6g}, drag {}, added mass {}\n",
                                   fluid.diameter,
                                   fluid.area,
                                   describe_coefficients(fluid.drag),
                                   describe_coefficients(fluid.added_mass));
    if (fluid.contents_density == 0.0) return text;
    return text + fmt::format(
                      "  contents: density {:.6g}, area {:.6g}, {:.6g} of the mass per length, "
                      "pressure {:.6g}\n",
                      fluid.contents_density,
                      fluid.contents_area,
                      fluid.contents_density * fluid.contents_area,
                      fluid.contents_pressure);
}

std::string describe_fluid(const Model& model, const Rod& rod) {
    const std::vector<const Section*> sections = list_sections(model, rod);
    if (!sections.front()->fluid) return "";
    return describe_in_water(model, rod, sections) + describe_on_ground(model, sections) +
           describe_line_at_rest(model, rod);
}

std::string describe_fluid(const Model& model, const Body& body) {
    if (!body.fluid) return "";
    std::string text = fmt::format("  in fluids: volume {:.6g}, {:.6g} high, drag areas {}\n",
                                   body.fluid->volume,
                                   body.fluid->height,
                                   in_parentheses(body.fluid->drag_area));
    if (!model.surroundings.water || !model.surroundings.water->acts()) return text;
    const double displaced = model.surroundings.water->density_at(1.0) * body.fluid->volume;
    return text + fmt::format("  in water: displaced mass {:.6g}{}\n",
                              displaced,
                              body.mass < displaced ? ": it floats" : "");
}

std::vector<std::string> list_surroundings(const Surroundings& surroundings) {
    std::vector<std::string> texts;
    if (const auto& water = surroundings.water) {
        texts.push_back(describe_water(*water));
        if (water->waves.size() > most_single_waves) {
            texts.push_back(describe_sea(water->waves));
        } else {
            for (const WaveTrain& wave : water->waves) texts.push_back(describe_wave(wave));
        }
    }
    if (const auto& air = surroundings.air)
        texts.push_back(
            fmt::format("air: density {:.6g}{}\n", air->density, describe_flow(air->wind, "wind")));
    if (surroundings.seabed) texts.push_back(describe_ground(*surroundings.seabed));
    return texts;
}

}  // namespace gxrod
