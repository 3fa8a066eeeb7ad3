#include "check/surroundings/surroundings_findings.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "check/surroundings/fluid_summary.hpp"
#include "check/surroundings/line_at_rest.hpp"
#include "check/surroundings/line_words.hpp"
#include "environment/ground.hpp"
#include "environment/sea.hpp"
#include "model/sections/element_lengths.hpp"

namespace gxrod {
namespace {

constexpr double steepest = 1.0 / 7.0;   // at which waves of deep water break, H/λ (Michell 1893)
constexpr double highest = 0.78;         // at which those of shallow water do, H/d (McCowan 1894)
constexpr double least_steps = 10.0;     // a period
constexpr double least_elements = 10.0;  // a wave length
constexpr double deepest = 0.2;          // in the ground, of the diameter
constexpr std::size_t most_single_waves = 3;

// A wave, or the mean one of a sea.
struct TypicalWave {
    std::string name;
    double height;  // significant of a sea
    double period;
    double length;
};

std::vector<TypicalWave> list_typical(const std::vector<WaveTrain>& waves) {
    std::vector<TypicalWave> typical;
    if (waves.size() > most_single_waves) {
        const SeaMeasures sea = measure_sea(waves);
        if (sea.steepness == 0.0) return {};
        return {{"the mean wave of the sea",
                 sea.significant_height,
                 sea.mean_period,
                 sea.significant_height / sea.steepness}};
    }
    for (const WaveTrain& wave : waves) {
        if (wave.amplitude == 0.0) continue;
        typical.push_back({fmt::format("the wave of height {:.4g}", 2.0 * wave.amplitude),
                           2.0 * wave.amplitude,
                           2.0 * M_PI / wave.frequency,
                           2.0 * M_PI / wave.number});
    }
    return typical;
}

class Examination {
  public:
    Examination(const Model& model, const AnalysisSettings& analysis) : model_(model), analysis_(analysis) {}

    std::vector<Finding> examine() {
        if (model_.surroundings.water && model_.surroundings.water->acts()) {
            for (const TypicalWave& wave : list_typical(model_.surroundings.water->waves)) {
                examine_height(wave);
                examine_steps(wave);
                examine_elements(wave);
            }
            note_depth();
        }
        examine_ground();
        examine_held_points();
        note_idle_ground();
        for (const Rod& rod : model_.rods) {
            note(find_coarse_layer(model_, rod));
            note(find_vortices(model_, rod, analysis_));
        }
        return std::move(findings_);
    }

  private:
    void add(Severity severity, std::string message) { findings_.push_back({severity, std::move(message)}); }

    // Whether there is ground in the first stage.
    bool has_ground() const { return model_.surroundings.seabed && model_.surroundings.seabed->acts(); }

    void note(std::string message) {
        if (!message.empty()) add(Severity::note, std::move(message));
    }

    void examine_height(const TypicalWave& wave) {
        const double steepness = wave.height / wave.length;
        if (steepness > steepest) {
            return add(Severity::warning,
                       fmt::format("{} and period {:.4g} has the length {:.4g} and the steepness {:.3g}; "
                                   "waves break at 1/7",
                                   wave.name,
                                   wave.period,
                                   wave.length,
                                   steepness));
        }
        const std::optional<double>& depth = model_.surroundings.water->depth;
        if (!depth || wave.height <= highest * *depth) return;
        add(Severity::warning,
            fmt::format(
                "{} is too high for the depth {:.4g}; waves break at {} of it", wave.name, *depth, highest));
    }

    void examine_steps(const TypicalWave& wave) {
        const auto* timed = std::get_if<DynamicSettings>(&analysis_);
        if (timed == nullptr || timed->adaptive || timed->steps == 0) return;
        const double steps = wave.period / timed->time_step();
        if (steps >= least_steps) return;
        add(Severity::warning,
            fmt::format("{} has the period {:.4g}, {:.3g} steps; expected time_step = {:.2g} or less",
                        wave.name,
                        wave.period,
                        steps,
                        wave.period / (2.0 * least_steps)));
    }

    void examine_elements(const TypicalWave& wave) {
        for (const Rod& rod : model_.rods) {
            if (!model_.sections[static_cast<std::size_t>(rod.section)].fluid) continue;
            const double length = find_element_lengths(rod).most;
            if (length * least_elements <= wave.length || rod.length < wave.length) continue;
            add(Severity::warning,
                fmt::format("{} has the length {:.4g}, {:.3g} elements of rod {}; expected {} elements or "
                            "more, where it lies along the waves or near the surface",
                            wave.name,
                            wave.length,
                            wave.length / length,
                            rod.name,
                            std::ceil(least_elements * length / wave.length * rod.element_count())));
        }
    }

    // A depth of the deck that is not that of the ground.
    void note_depth() {
        const auto& [water, air, seabed] = model_.surroundings;
        if (!water->depth || !water->surface || !seabed || seabed->grid || seabed->normal.z() != 1.0) return;
        const double depth = *water->surface - seabed->point.z();
        if (std::abs(depth - *water->depth) <= 0.01 * *water->depth) return;
        add(Severity::warning,
            fmt::format("waves feel the depth {:.6g}, and the ground is {:.6g} below the surface",
                        *water->depth,
                        depth));
    }

    // A ground of which only its depth counts.
    void note_idle_ground() {
        const bool touches = std::ranges::any_of(model_.rods, [&](const Rod& rod) {
            return model_.sections[static_cast<std::size_t>(rod.section)].fluid.has_value();
        });
        if (!model_.surroundings.seabed || touches) return;
        add(Severity::warning,
            "[seabed] says how deep waves are and holds nothing up: it acts on rods whose section has "
            "`fluid`; "
            "bodies do not touch it");
    }

    void examine_ground() {
        const double gravity = find_gravity(model_);
        if (!has_ground() || gravity == 0.0) return;
        const double density = model_.surroundings.water ? model_.surroundings.water->density_at(1.0) : 0.0;
        for (const Rod& rod : model_.rods) {
            const std::vector<const Section*> sections = list_sections(model_, rod);
            if (!sections.front()->fluid) continue;
            double deepest_part = 0.0;
            for (const Section* section : sections) {
                const double diameter = section->fluid->diameter;
                const double weight = find_wet_weight(*section, density, gravity);
                deepest_part = std::max(
                    deepest_part, weight / (model_.surroundings.seabed->stiffness * diameter * diameter));
            }
            if (deepest_part <= deepest) continue;
            add(Severity::warning,
                fmt::format(
                    "rod {} lies {:.2g} of its diameter deep in the ground by its weight alone; expected "
                    "a stiffness of [seabed] of {:.2g} or more",
                    rod.name,
                    deepest_part,
                    model_.surroundings.seabed->stiffness * deepest_part / (0.5 * deepest)));
        }
    }

    // Points that a support holds deeper in the ground than the line rests next to them, where it bends up.
    void examine_held_points() {
        if (!has_ground()) return;
        const double density = model_.surroundings.water ? model_.surroundings.water->density_at(1.0) : 0.0;
        const double gravity = find_gravity(model_);
        std::vector<bool> is_known(model_.nodes.size(), false);
        for (const Rod& rod : model_.rods) {
            if (!list_sections(model_, rod).front()->fluid) continue;
            for (std::size_t entry = 0; entry < rod.element_nodes.size(); ++entry) {
                const auto node = static_cast<std::size_t>(rod.element_nodes[entry]);
                if (is_known[node]) continue;
                is_known[node] = true;
                const Section& section = section_at_entry(model_, rod, entry);
                const double weight = std::max(find_wet_weight(section, density, gravity), 0.0);
                examine_held_point(rod.element_nodes[entry], section.fluid->diameter, weight);
            }
        }
    }

    void examine_held_point(int node, double diameter, double weight) {
        const Seabed& seabed = *model_.surroundings.seabed;
        const Node& point = model_.nodes[static_cast<std::size_t>(node)];
        const GroundAt ground = find_ground(seabed, point.position);
        const double at_rest = 0.5 * diameter - weight / (seabed.stiffness * diameter);
        const double excess = at_rest - ground.gap;
        if (excess <= deepest * diameter || !is_held_along(model_, node, ground.normal)) return;
        add(Severity::warning,
            fmt::format(
                "{} is held {:.4g} deeper in the ground than the line next to it rests: lines touch the "
                "ground with their surface, half a diameter from the axis, so it is bent and pushed "
                "there; expected z = {:.6g} of this point, or the ground as much lower",
                point.name,
                excess,
                point.position.z() + excess / ground.normal.z()));
    }

    const Model& model_;
    const AnalysisSettings& analysis_;
    std::vector<Finding> findings_;
};

}  // namespace

std::vector<Finding> examine_surroundings(const Model& model, const AnalysisSettings& analysis) {
    return Examination(model, analysis).examine();
}

}  // namespace gxrod
