#include "check/findings/plausibility.hpp"

#include <fmt/format.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <string>
#include <variant>

#include "check/findings/shape_findings.hpp"
#include "check/mesh_frequencies.hpp"
#include "check/static_scale.hpp"
#include "check/summaries/rod_lines.hpp"
#include "environment/ground.hpp"
#include "model/evaluation_error.hpp"
#include "model/settings/analysis_traits.hpp"
#include "model/ties/ties.hpp"
#include "rotation/vector_text.hpp"

namespace gxrod {
namespace {

using PlaceBox = Eigen::AlignedBox3d;

constexpr double most_sizes = 100.0;          // between an obstacle and the model
constexpr double most_density_ratio = 100.0;  // between a rod or body and water; of gold it is 19
constexpr double most_friction = 2.0;
constexpr double most_offset = 10.0;           // of a tendon, in sizes of the section
constexpr double largest_damping_ratio = 2.0;  // of critical
constexpr double least_piece = 0.2;            // of a line of rods; shorter ones buckle with the others
constexpr double most_speed = 2.0;             // along a rod, compared with waves of stretching

std::string describe(const PlaceBox& box) {
    return in_parentheses(box.min(), 4) + " to " + in_parentheses(box.max(), 4);
}

// About the centre of mass of a solid circle a diameter: four radii of gyration.
double size_of(const Section& section) {
    const Mat6& C = section.stiffness;
    if (!(C(0, 0) > 0.0)) return 0.0;
    return 4.0 * std::sqrt(std::max(C(4, 4), C(5, 5)) / C(0, 0));
}

class Questions {
  public:
    explicit Questions(const Model& model) : model_(model) {
        for (const Node& node : model.nodes) box_.extend(node.position);
        size_ = box_.isEmpty() ? 0.0 : box_.diagonal().norm();
    }

    std::vector<Finding> ask(const std::vector<StagePlan>& stages) {
        ask(describe_thick_rods(model_));
        const std::string scale = describe_static_scale(model_, stages.front().analysis);
        ask(scale);
        if (scale.empty() && vibrates(stages.front().analysis)) ask_of_speed(end_of(stages.front().analysis));
        ask_of_ground();
        ask_of_water();
        for (const Obstacle& obstacle : model_.contact.obstacles) ask_of_size(obstacle);
        ask_of_frictions();
        for (const Tendon& tendon : model_.tendons) ask_of_offset(tendon);
        if (std::ranges::any_of(stages, [](const StagePlan& stage) { return vibrates(stage.analysis); }))
            ask_of_damping();
        const auto buckles = [](const StagePlan& stage) {
            return std::holds_alternative<BucklingSettings>(stage.analysis);
        };
        if (std::ranges::any_of(stages, buckles)) ask_of_waves();
        return std::move(findings_);
    }

  private:
    void ask(std::string question) {
        if (!question.empty()) findings_.push_back({Severity::note, std::move(question)});
    }

    static bool vibrates(const AnalysisSettings& analysis) {
        const auto* dynamic = std::get_if<DynamicSettings>(&analysis);
        return dynamic != nullptr && dynamic->has_inertia;
    }

    // A velocity along a rod strains it by about its part of that of waves of stretching: of steel these are
    // 5000 m/s fast.
    void ask_of_speed(double end_time) {
        std::vector<double> driven(model_.nodes.size(), 0.0);
        for (const Support& support : model_.supports)
            driven[static_cast<std::size_t>(support.node)] = find_speed(support, end_time);
        for (const Rod& rod : model_.rods) {
            const Section& section = model_.sections[static_cast<std::size_t>(rod.section)];
            const double wave_speed = std::sqrt(section.stiffness(0, 0) / section.mass(0, 0));
            if (rod.nodes.empty() || !(wave_speed > 0.0) || !std::isfinite(wave_speed)) continue;
            Vec3 mean = Vec3::Zero();
            for (const int node : rod.nodes)
                mean += velocity_of(node) / static_cast<double>(rod.nodes.size());
            double speed = 0.0;
            for (const int node : rod.nodes) {
                speed = std::max(
                    {speed, (velocity_of(node) - mean).norm(), driven[static_cast<std::size_t>(node)]});
            }
            if (speed <= most_speed * wave_speed) continue;
            return ask(
                fmt::format("places of rod {} move at {:.3g} against each other, {:.3g} times as fast as "
                            "stretching runs along it ({:.3g}); are moduli, masses and lengths in one set "
                            "of units (pascals with metres)?",
                            rod.name,
                            speed,
                            speed / wave_speed,
                            wave_speed));
        }
    }

    const Vec3& velocity_of(int node) const { return model_.nodes[static_cast<std::size_t>(node)].velocity; }

    // The mean speed of a moved support over a part of the time, where it is largest.
    static double find_speed(const Support& support, double end_time) {
        constexpr int parts = 50;
        double largest = 0.0;
        try {
            Vec3 before = Vec3::Zero();
            for (int i = 0; i <= parts; ++i) {
                const double time = end_time * i / parts;
                const Vec3 now(support.motion[0](time), support.motion[1](time), support.motion[2](time));
                if (i > 0) largest = std::max(largest, (now - before).norm() * parts / end_time);
                before = now;
            }
        } catch (const EvaluationError&) {
            return largest;
        }
        return largest;
    }

    // More than a diameter deep, as what lies on the ground is not.
    void ask_of_ground() {
        const std::optional<Seabed>& seabed = model_.surroundings.seabed;
        if (!seabed || !seabed->acts() || model_.nodes.empty()) return;
        double diameter = 0.0;
        for (const Section& section : model_.sections)
            diameter = std::max(diameter, section.fluid ? section.fluid->diameter : 0.0);
        double highest = -std::numeric_limits<double>::infinity();
        for (const Node& node : model_.nodes)
            highest = std::max(highest, find_ground(*seabed, node.position).gap);
        if (highest >= -diameter) return;
        ask(fmt::format(
            "the whole model is under the ground of [seabed], by {:.4g} or more; is the ground where "
            "it should be?",
            -highest));
    }

    void ask_of_water() {
        const std::optional<Water>& water = model_.surroundings.water;
        if (!water || !(water->density > 0.0)) return;
        std::string densest;
        double density = 0.0;
        const auto compare = [&](const std::string& name, double mass, double volume) {
            if (!(volume > 0.0) || mass / volume <= density) return;
            density = mass / volume;
            densest = name;
        };
        for (const Section& section : model_.sections) {
            if (section.fluid) compare("section " + section.name, section.mass(0, 0), section.fluid->area);
        }
        for (const Body& body : model_.bodies) {
            if (body.fluid) compare("body " + body.name, body.mass, body.fluid->volume);
        }
        if (density <= most_density_ratio * water->density) return;
        ask(fmt::format(
            "the density of [fluid], {:.4g}, is 1/{:.3g} of that of {}, {:.4g}; are both in one set "
            "of units (water: 1000 kg/m³, 1 t/m³, 1e-9 t/mm³)?",
            water->density,
            density / water->density,
            densest,
            density));
    }

    // Long cylinders stand for endless ones, so that it is the radius that can be too large.
    void ask_of_size(const Obstacle& obstacle) {
        if (obstacle.plane() != nullptr || !(size_ > 0.0)) return;
        PlaceBox box;
        const auto extend = [&](const auto& shape) {
            for (const Vec3& point : shape.points()) box.extend(point);
        };
        std::visit(extend, obstacle.shape);
        if (box.isEmpty()) return;
        const RoundShape* round = obstacle.round();
        if (round != nullptr) {
            box.min().array() -= round->radius;
            box.max().array() += round->radius;
        }
        const double small = box.diagonal().norm();
        const double large = round != nullptr ? 2.0 * round->radius : small;
        const bool is_large = large > most_sizes * size_;
        if (!is_large && small * most_sizes >= size_) return;
        ask(fmt::format(
            "obstacle {} is {} times as large as the model: its box is {}, the model's {}; are both in one "
            "unit of length?",
            obstacle.name,
            is_large ? fmt::format("{:.3g}", large / size_) : fmt::format("1/{:.3g}", size_ / small),
            describe(box),
            describe(box_)));
    }

    void ask_of_friction(const std::string& of, double coefficient) {
        if (!(coefficient > most_friction)) return;
        ask(fmt::format("the coefficient of friction of {} is {:.4g}; most pairs of materials have 0.05 to 1",
                        of,
                        coefficient));
    }

    void ask_of_frictions() {
        const Contact& contact = model_.contact;
        ask_of_friction("[contact]", contact.friction);
        for (const Obstacle& obstacle : contact.obstacles) {
            // Those that have none of their own have that of [contact].
            if (obstacle.friction != contact.friction)
                ask_of_friction("obstacle " + obstacle.name, obstacle.friction);
        }
        for (const ContactException& exception : contact.exceptions)
            ask_of_friction("a [[contact.pair]]", exception.friction.value_or(0.0));
        if (const std::optional<Seabed>& seabed = model_.surroundings.seabed;
            seabed && seabed->has_friction())
            ask_of_friction("[seabed]", std::max(seabed->axial_friction, seabed->lateral_friction));
        for (const Tendon& tendon : model_.tendons) {
            if (tendon.friction) ask_of_friction("tendon " + tendon.name, tendon.friction->coefficient);
        }
        for_each_coordinates(
            model_,
            [this](std::size_t, const std::string& name, const auto& /*turn*/, const JointCoordinate& slide) {
                ask_of_friction("joint " + name, slide.friction.lever);
            });
    }

    void ask_of_offset(const Tendon& tendon) {
        const Rod& rod = model_.rods[static_cast<std::size_t>(tendon.rod)];
        const double size = size_of(model_.sections[static_cast<std::size_t>(rod.section)]);
        constexpr int places = 10;
        double offset = 0.0;
        try {
            for (int i = 0; i <= places; ++i) {
                const double s = tendon.from + (tendon.to - tendon.from) * i / places;
                offset = std::max(offset, tendon.path(s).at.norm());
            }
        } catch (const EvaluationError&) {
            return;
        }
        if (!(size > 0.0) || offset <= most_offset * size) return;
        ask(fmt::format(
            "tendon {} passes {:.4g} from the line of rod {}, {:.3g} times the size of its section "
            "(about {:.3g}); are both in one unit of length?",
            tendon.name,
            offset,
            rod.name,
            offset / size,
            size));
    }

    // Elements of order 1 that meet at the angles of a half wave of n of them: its load is (tan x/x)² times
    // the exact one, x = π/(2 n).
    void ask_of_waves() {
        constexpr int fewest = 8;
        std::vector<std::string> names;
        int elements = fewest;
        const std::vector<double> lines = measure_lines(model_);
        for (std::size_t i = 0; i < model_.rods.size(); ++i) {
            const Rod& rod = model_.rods[i];
            const bool is_piece = rod.length < least_piece * lines[i];
            if (rod.order > 1 || rod.element_count() >= fewest || is_piece) continue;
            names.push_back(rod.name);
            elements = std::min(elements, rod.element_count());
        }
        if (names.empty()) return;
        const double x = std::numbers::pi / (2.0 * elements);
        const std::string more = names.size() == 1 ? "" : fmt::format(" (and {} more)", names.size() - 1);
        ask(fmt::format(
            "rod {}{} has few elements of order 1 for a half wave of buckling along it: {} of them make "
            "its load {} too high; order = 2, or {} elements or more, would not",
            names.front(),
            more,
            elements,
            elements == 1 ? "far" : fmt::format("{:.2g} %", 100.0 * (std::pow(std::tan(x) / x, 2) - 1.0)),
            fewest));
    }

    void ask_of_damping() {
        constexpr std::size_t most_nodes = 20'000;
        const auto is_damped = [](const Section& section) { return section.kelvin_voigt > 0.0; };
        if (std::ranges::none_of(model_.sections, is_damped) || model_.nodes.size() > most_nodes) return;
        const std::optional<MeshFrequencies> found = find_mesh_frequencies(model_);
        if (!found) return;
        for (const Section& section : model_.sections) {
            // Components can be damped for themselves: the least of them damps what the lowest mode does.
            const double time = section.kelvin_voigt_components ? section.kelvin_voigt_components->minCoeff()
                                                                : section.kelvin_voigt;
            const double ratio = 0.5 * time * found->lowest;
            if (ratio <= largest_damping_ratio) continue;
            ask(fmt::format(
                "kelvin_voigt of section {}, {:.4g}, damps the lowest mode, of {:.4g} cycles per time, "
                "by {:.3g} of critical; it is a time, of a damping ratio ζ there ζ/(π f): {:.3g} for "
                "ζ = 0.01",
                section.name,
                time,
                found->lowest / (2.0 * std::numbers::pi),
                ratio,
                0.02 / found->lowest));
        }
    }

    const Model& model_;
    PlaceBox box_;
    double size_ = 0.0;
    std::vector<Finding> findings_;
};

}  // namespace

std::vector<Finding> question_model(const Model& model, const std::vector<StagePlan>& stages) {
    std::vector<Finding> findings = Questions(model).ask(stages);
    std::ranges::move(question_shapes(model), std::back_inserter(findings));
    return findings;
}

}  // namespace gxrod
