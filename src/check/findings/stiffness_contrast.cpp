#include "check/findings/stiffness_contrast.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <limits>

#include "model/sections/stiffness_ratio.hpp"
#include "numerics/eigenvalues.hpp"

namespace gxrod {
namespace {

// Up to here Newton's method was seen to converge as it does without round-off: of 200 cantilevers that carry
// stiff rods, at random, the first to fail had 0.01.
constexpr double tolerable = 0.003;

const Mat6& stiffness_of(const Model& model, const Rod& rod) {
    return model.sections[static_cast<std::size_t>(rod.section)].stiffness;
}

double find_shortest_element(const Rod& rod) {
    const auto per_element = static_cast<std::size_t>(rod.order) + 1;
    double shortest = std::numeric_limits<double>::infinity();
    for (std::size_t first = 0; first < rod.arc_length.size(); first += per_element) {
        shortest = std::min(shortest, rod.arc_length[first + per_element - 1] - rod.arc_length[first]);
    }
    return shortest;
}

// The largest and the smallest principal stiffness.
std::pair<double, double> find_extremes(const Eigen::MatrixXd& stiffness) {
    if (stiffness.isDiagonal(0.0)) return {stiffness.diagonal().maxCoeff(), stiffness.diagonal().minCoeff()};
    const Eigen::VectorXd values = find_symmetric_eigen(stiffness).values;
    return {values[values.size() - 1], values[0]};
}

// Of a rod whose sizes these are: what round-off makes of no strain in the shortest element, and what bends
// it by about a radian.
struct RodForces {
    double force_round_off, bending_force;
    double moment_round_off, bending_moment;  // or twists
};

RodForces compute_forces(const Model& model, const Rod& rod, double size) {
    const Mat6& stiffness = stiffness_of(model, rod);
    const Mat3 turning = compute_turning_stiffness(stiffness).value_or(stiffness.bottomRightCorner<3, 3>());
    const double rounding = std::numeric_limits<double>::epsilon() / find_shortest_element(rod);
    const auto [stiffest, softest] = find_extremes(turning);
    return {find_extremes(stiffness.topLeftCorner<3, 3>()).first * (rounding * size),
            find_extremes(turning.bottomRightCorner<2, 2>()).second / (rod.length * rod.length),
            stiffest * rounding,
            softest / rod.length};
}

bool lacks_stiffness(const Model& model, const ModelPart& part) {
    return std::any_of(part.rods.begin(), part.rods.end(), [&](int rod) {
        return stiffness_of(model, model.rods[static_cast<std::size_t>(rod)]).diagonal().minCoeff() <= 0.0;
    });
}

bool has_any(const ModelPart& part, std::span<const std::int64_t> nodes) {
    return nodes.empty() || std::any_of(nodes.begin(), nodes.end(), [&](std::int64_t node) {
               return std::binary_search(part.nodes.begin(), part.nodes.end(), node);
           });
}

double find_size(const Model& model, const ModelPart& part) {
    double size = 0.0;
    for (const int node : part.nodes) {
        size = std::max(size, model.nodes[static_cast<std::size_t>(node)].position.lpNorm<Eigen::Infinity>());
    }
    return size;
}

void add_rod(int rod, double round_off, double bending, StiffnessContrast& contrast) {
    if (round_off > contrast.round_off) {
        contrast.stiff_rod = rod;
        contrast.round_off = round_off;
    }
    if (bending > 0.0 && (contrast.soft_rod < 0 || bending < contrast.bending)) {
        contrast.soft_rod = rod;
        contrast.bending = bending;
    }
}

bool is_intolerable(const StiffnessContrast& contrast) {
    return contrast.soft_rod >= 0 && contrast.round_off > tolerable * contrast.bending;
}

}  // namespace

std::vector<StiffnessContrast> find_stiffness_contrasts(const Model& model,
                                                        const std::vector<ModelPart>& parts) {
    std::vector<StiffnessContrast> contrasts;
    for (const ModelPart& part : parts) {
        const double size = find_size(model, part);
        StiffnessContrast of_forces;
        StiffnessContrast of_moments{.is_of_moments = true};
        for (const int index : part.rods) {
            const RodForces forces = compute_forces(model, model.rods[static_cast<std::size_t>(index)], size);
            add_rod(index, forces.force_round_off, forces.bending_force, of_forces);
            add_rod(index, forces.moment_round_off, forces.bending_moment, of_moments);
        }
        // One for each part: where forces are lost, moments do not matter.
        if (is_intolerable(of_forces)) {
            contrasts.push_back(of_forces);
        } else if (is_intolerable(of_moments)) {
            contrasts.push_back(of_moments);
        }
    }
    return contrasts;
}

std::optional<StiffnessContrast> find_contrast_at(const Model& model, std::span<const std::int64_t> nodes) {
    std::vector<ModelPart> parts = find_parts(model);
    std::erase_if(
        parts, [&](const ModelPart& part) { return !has_any(part, nodes) || lacks_stiffness(model, part); });
    const std::vector<StiffnessContrast> contrasts = find_stiffness_contrasts(model, parts);
    if (contrasts.empty()) return std::nullopt;
    return contrasts[0];
}

std::string describe(const StiffnessContrast& contrast, const Model& model) {
    const auto name = [&](int rod) { return model.rods[static_cast<std::size_t>(rod)].name; };
    const std::string soft =
        contrast.stiff_rod == contrast.soft_rod ? "it" : "rod " + name(contrast.soft_rod);
    const char* quantity = contrast.is_of_moments ? "moment" : "force";
    return fmt::format(
        "rod {} is too stiff compared with what bends {} for numbers of 16 digits: round-off of its {}s is "
        "about {:.2g}, a {} that bends {} about {:.2g}",
        name(contrast.stiff_rod),
        soft,
        quantity,
        contrast.round_off,
        quantity,
        soft,
        contrast.bending);
}

std::string advise(const StiffnessContrast& contrast) {
    return fmt::format("{} up to {:.1g} of what {}, or longer elements",
                       contrast.is_of_moments ? "the largest of GJ, EIy and EIz" : "EA, GAy and GAz",
                       tolerable * contrast.bending / contrast.round_off,
                       contrast.is_of_moments ? "it is" : "they are");
}

}  // namespace gxrod
