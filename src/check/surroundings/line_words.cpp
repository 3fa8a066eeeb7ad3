#include "check/surroundings/line_words.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>

#include "check/surroundings/line_at_rest.hpp"
#include "check/surroundings/lowest_frequency.hpp"
#include "environment/current.hpp"
#include "model/evaluation_error.hpp"
#include "model/sections/element_lengths.hpp"
#include "model/settings/analysis_traits.hpp"

namespace gxrod {
namespace {

// Reduced velocities between which vortices lock in to a cylinder's lowest frequency across the flow.
constexpr double least_locked = 4.0;
constexpr double most_locked = 8.0;
// Of flow along a rod.
constexpr double zero_sine = 1e-9;
// Of larger models nothing is said: each rod is compared with all others.
constexpr std::size_t most_rods = 50;
// Times at which a current is asked for.
constexpr int most_times = 20;

bool is_estimated(const Model& model, const Rod& rod) {
    return model.rods.size() <= most_rods && model.surroundings.water && model.surroundings.water->acts() &&
           model.sections[static_cast<std::size_t>(rod.section)].fluid;
}

// √(EI/T) in terms of the length of the elements there, where it is smallest.
struct Layer {
    double length = 0.0;
    double elements = 0.0;
    std::size_t place = 0;  // entry of Rod::arc_length
};

std::optional<Layer> find_thinnest_layer(const Model& model, const Rod& rod, const LineAtRest& line) {
    const auto per_element = static_cast<std::size_t>(rod.order) + 1;
    std::optional<Layer> thinnest;
    for (const std::size_t place : {std::size_t{0}, line.first, line.last, rod.arc_length.size() - 1}) {
        const std::optional<double> length = find_boundary_layer(model, rod, line, place);
        if (!length) continue;
        const std::size_t first = place / per_element * per_element;
        const double element = rod.arc_length[first + per_element - 1] - rod.arc_length[first];
        if (!thinnest || *length / element < thinnest->elements)
            thinnest = Layer{*length, *length / element, place};
    }
    return thinnest;
}

// Sizes of elements along a rod that are small at its ends, or where it touches the ground: fractions of its
// length, and for how long about them.
class SmallNear {
  public:
    struct Place {
        double centre, flat;
    };
    SmallNear(std::vector<Place> places, double least) : places_(std::move(places)), least_(least) {}

    double at(double fraction) const {
        double size = 1.0;
        for (const auto& [centre, flat] : places_) {
            const double away = std::max(std::abs(fraction - centre) - flat, 0.0) / ramp;
            size = std::min(size, least_ + (1.0 - least_) * away);
        }
        return size;
    }
    // ∫ dx/size over the rod.
    double measure() const {
        constexpr int steps = 2000;
        double sum = 0.0;
        for (int i = 0; i < steps; ++i) sum += 1.0 / (steps * at((i + 0.5) / steps));
        return sum;
    }
    // "[[0, 0.1], [0.13, 1], [1, 1]]".
    std::string write() const {
        std::vector<double> fractions{0.0, 1.0};
        for (const auto& [centre, flat] : places_) {
            for (const double away : {-flat - ramp, -flat, flat, flat + ramp}) {
                const double fraction = std::round(100.0 * (centre + away)) / 100.0;
                if (fraction > 0.0 && fraction < 1.0) fractions.push_back(fraction);
            }
        }
        std::ranges::sort(fractions);
        const auto [first, last] = std::ranges::unique(fractions);
        fractions.erase(first, last);
        std::vector<std::string> rows;
        for (const double fraction : fractions)
            rows.push_back(fmt::format("[{:g}, {:.2g}]", fraction, at(fraction)));
        return fmt::format("[{}]", fmt::join(rows, ", "));
    }

  private:
    static constexpr double ramp = 0.13;
    std::vector<Place> places_;
    double least_;
};

// A spacing with which as many elements are half as long as the layer where a rod is held or leaves the
// ground.
std::string suggest_spacing(const Rod& rod, const LineAtRest& line, double layer) {
    constexpr double flat = 0.03;  // about where it leaves the ground, which stretch and currents move
    constexpr double smallest = 0.05;
    const auto round = [&](double s) { return std::round(100.0 * s / rod.length) / 100.0; };
    std::vector<SmallNear::Place> places;
    const bool leaves = line.first > 0, lands = line.last + 1 < line.arc_length.size();
    places.push_back(leaves ? SmallNear::Place{round(line.from), flat} : SmallNear::Place{0.0, 0.0});
    places.push_back(lands ? SmallNear::Place{round(line.to), flat} : SmallNear::Place{1.0, 0.0});
    for (const double size : {0.5, 0.3, 0.2, 0.1}) {
        const SmallNear spacing(places, size);
        if (size * spacing.measure() * rod.length / rod.element_count() <= 0.5 * layer)
            return spacing.write();
    }
    return SmallNear(places, smallest).write();
}

// The largest velocity of the current across a rod where it starts, at times up to an end.
double find_speed_across(const Model& model, const Rod& rod, double end) {
    const Water& water = *model.surroundings.water;
    if (water.current.is_still()) return 0.0;
    Current current(water.current, rod.length, "water");
    double largest = 0.0;
    for (int i = 0; i <= most_times; ++i) {
        try {
            current.move_to(end * i / most_times);
            for (std::size_t entry = 0; entry < rod.element_nodes.size(); ++entry) {
                const Vec3& place = model.nodes[static_cast<std::size_t>(rod.element_nodes[entry])].position;
                if (water.surface && place.z() > *water.surface) continue;
                const Vec3 u = current.at(place, {place.z()}, false).velocity;
                const double across = u.cross(rod.triads[entry] * Vec3::UnitX()).norm();
                if (across > zero_sine * u.norm()) largest = std::max(largest, across);
            }
        } catch (const EvaluationError&) {
            continue;  // between steps, where no function need have a value
        }
    }
    return largest;
}

double find_diameter(const Model& model, const Rod& rod) {
    return model.sections[static_cast<std::size_t>(rod.section)].fluid->diameter;
}

std::string describe_vortices(double reduced) {
    if (reduced < least_locked) return "";
    if (reduced <= most_locked)
        return fmt::format(
            ": within {:g} to {:g}, where vortices that the current sheds shake it, which is not "
            "computed",
            least_locked,
            most_locked);
    return fmt::format(
        ": above {:g}; vortices that the current sheds may shake it in higher modes, which is not "
        "computed",
        most_locked);
}

const char* describe_source(LineAtRest::Source source) {
    switch (source) {
        case LineAtRest::Source::hung:
            return "as it hangs at the start";
        case LineAtRest::Source::pulled:
            return "by the loads beyond each place";
        case LineAtRest::Source::unloaded:
            break;
    }
    return "";
}

}  // namespace

std::string describe_line_at_rest(const Model& model, const Rod& rod) {
    if (!is_estimated(model, rod)) return "";
    const std::optional<LineAtRest> line = find_line_at_rest(model, rod);
    if (!line) return "";
    std::string text;
    const auto [least, most] = std::ranges::minmax(line->tension);
    const bool has_tension = least != 0.0 || most != 0.0;
    if (has_tension) {
        text += fmt::format(
            "  at rest, {}: tension about {:.4g} to {:.4g}", describe_source(line->source), least, most);
        const std::optional<Layer> layer = find_thinnest_layer(model, rod, *line);
        if (layer && layer->length < rod.length)
            text += fmt::format(
                ", boundary layers √(EI/T) of {:.3g} = {:.2g} elements", layer->length, layer->elements);
        text += "\n";
    }
    const std::optional<double> frequency = find_lowest_frequency(model, rod, *line);
    if (!frequency) return text;
    text += fmt::format("  lowest frequency across it in water, of a beam {}: {:.4g}",
                        has_tension ? "under this tension" : "without tension",
                        *frequency);
    const double speed = find_speed_across(model, rod, 1.0);
    if (speed == 0.0) return text + "\n";
    const double reduced = speed / (*frequency * find_diameter(model, rod));
    return text +
           fmt::format("; the current, up to {:.4g} across it, has the reduced velocity U/(f D) = {:.3g}{}\n",
                       speed,
                       reduced,
                       describe_vortices(reduced));
}

std::string find_coarse_layer(const Model& model, const Rod& rod) {
    if (!is_estimated(model, rod)) return "";
    const std::optional<LineAtRest> line = find_line_at_rest(model, rod);
    const std::optional<Layer> layer = line ? find_thinnest_layer(model, rod, *line) : std::nullopt;
    if (!layer || layer->elements >= 1.0 || layer->length < find_diameter(model, rod)) return "";
    return fmt::format(
        "rod {}: √(EI/T), the length over which what holds it bends it, is {:.3g} at s = {:.4g}, "
        "{:.2g} of an element; where moments there matter, expected spacing = {} or the like",
        rod.name,
        layer->length,
        line->arc_length[layer->place],
        layer->elements,
        suggest_spacing(rod, *line, layer->length));
}

std::string find_vortices(const Model& model, const Rod& rod, const AnalysisSettings& analysis) {
    if (!is_estimated(model, rod)) return "";
    const std::optional<LineAtRest> line = find_line_at_rest(model, rod);
    const std::optional<double> frequency = line ? find_lowest_frequency(model, rod, *line) : std::nullopt;
    if (!frequency) return "";
    const double speed = find_speed_across(model, rod, end_of(analysis));
    const double reduced = speed / (*frequency * find_diameter(model, rod));
    if (reduced < least_locked) return "";
    return fmt::format("rod {}, a current of {:.4g} across it: the reduced velocity is {:.3g}{}",
                       rod.name,
                       speed,
                       reduced,
                       describe_vortices(reduced));
}

}  // namespace gxrod
