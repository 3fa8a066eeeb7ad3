#include "check/findings/shape_findings.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "cross_section/cross_section.hpp"

// docs/theory/cross_sections.md, "What it leaves out" and (CS7).
namespace gxrod {
namespace {

constexpr double most_reach = 0.05;      // of restrained warping, compared with the length of the rod
constexpr double most_curvature = 0.05;  // times the size of the section
constexpr double most_twist = 0.03;

// The shape of a rod, where it varies that of its start.
const CrossSection* find_shape(const Model& model, const Rod& rod) {
    if (rod.has_varying_sections()) return rod.varying.at_nodes.front().shape.get();
    return model.sections[static_cast<std::size_t>(rod.section)].shape.get();
}

double measure_size(const CrossSection& shape) {
    double size = 0.0;
    for (const PlanePoint& node : shape.mesh.nodes)
        size = std::max(size, 2.0 * (node - shape.properties.centroid).norm());
    return size;
}

struct LargestTurn {
    double curvature = 0.0, twist = 0.0;
};

// Of the start, between neighbouring nodes of elements.
LargestTurn find_largest_turn(const Rod& rod) {
    LargestTurn largest;
    const auto per_element = static_cast<std::size_t>(rod.order) + 1;
    for (std::size_t i = 0; i + 1 < rod.triads.size(); ++i) {
        if ((i + 1) % per_element == 0) continue;
        const Quat turn = rod.triads[i].conjugate() * rod.triads[i + 1];
        const Vec3 vector = Eigen::AngleAxisd(turn).angle() * Eigen::AngleAxisd(turn).axis();
        const double length = rod.arc_length[i + 1] - rod.arc_length[i];
        largest.curvature = std::max(largest.curvature, std::hypot(vector.y(), vector.z()) / length);
        largest.twist = std::max(largest.twist, std::abs(vector.x()) / length);
    }
    return largest;
}

}  // namespace

std::vector<Finding> question_shapes(const Model& model) {
    std::vector<Finding> findings;
    const auto note = [&](std::string text) { findings.push_back({Severity::note, std::move(text)}); };
    for (const Rod& rod : model.rods) {
        const CrossSection* shape = find_shape(model, rod);
        if (shape == nullptr) continue;
        const double reach = shape->properties.warping_length();
        if (reach > most_reach * rod.length) {
            const double slenderness = rod.length / reach;
            note(fmt::format(
                "rod {}: where the warping of {} is held, as at a clamp, this reaches {:.3g} along the rod, "
                "which is {:.5g} long; held at one end it twists {:.0f} % less than computed",
                rod.name,
                shape->source,
                reach,
                rod.length,
                100.0 * std::tanh(slenderness) / slenderness));
        }
        if (!rod.starts_free_of_stress()) continue;
        const double size = measure_size(*shape);
        const LargestTurn turn = find_largest_turn(rod);
        if (turn.curvature * size > most_curvature)
            note(fmt::format(
                "rod {}: its section is {:.2g} of the radius of curvature; coupling and stress of that order "
                "are left out",
                rod.name,
                turn.curvature * size));
        if (turn.twist * size > most_twist)
            note(
                fmt::format("rod {}: twist times the size of its section is {:.2g}; coupling and stress of "
                            "that order are "
                            "left out",
                            rod.name,
                            turn.twist * size));
    }
    return findings;
}

}  // namespace gxrod
