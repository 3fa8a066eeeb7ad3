#include "analyses/stiffness_contrast.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <limits>

namespace gxrod {
namespace {

// Up to here Newton's method was seen to converge as it does without round-off.
constexpr double tolerable = 0.1;

struct RodForce {
    int rod = -1;
    double force = 0.0;
};

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

// What round-off of positions of this size makes of no strain in the shortest element.
double compute_round_off(const Model& model, const Rod& rod, double size) {
    const double strain = std::numeric_limits<double>::epsilon() * size / find_shortest_element(rod);
    return stiffness_of(model, rod).diagonal().head<3>().maxCoeff() * strain;
}

// A force at the end of a rod that bends it by about a radian.
double compute_bending_force(const Model& model, const Rod& rod) {
    return stiffness_of(model, rod).diagonal().tail<2>().minCoeff() / (rod.length * rod.length);
}

double measure(const Model& model, const ModelPart& part) {
    double size = 0.0;
    for (const int node : part.nodes) {
        size = std::max(size, model.nodes[static_cast<std::size_t>(node)].position.lpNorm<Eigen::Infinity>());
    }
    return size;
}

std::string describe(const Model& model, const RodForce& stiff, const RodForce& soft) {
    const auto name = [&](const RodForce& of) { return model.rods[static_cast<std::size_t>(of.rod)].name; };
    const std::string soft_name = stiff.rod == soft.rod ? "it" : "rod " + name(soft);
    return fmt::format(
        "rod {} is too stiff beside what bends {} for numbers of 16 digits: round-off of its forces is "
        "about {:.2g}, a force that bends {} about {:.2g}; expected EA, GAy and GAz up to {:.1g} of what "
        "they are, or longer elements",
        name(stiff),
        soft_name,
        stiff.force,
        soft_name,
        soft.force,
        tolerable * soft.force / stiff.force);
}

}  // namespace

std::vector<std::string> find_stiffness_contrasts(const Model& model, const std::vector<ModelPart>& parts) {
    std::vector<std::string> sentences;
    for (const ModelPart& part : parts) {
        const double size = measure(model, part);
        RodForce stiff;
        RodForce soft{-1, std::numeric_limits<double>::infinity()};
        for (const int index : part.rods) {
            const Rod& rod = model.rods[static_cast<std::size_t>(index)];
            const double round_off = compute_round_off(model, rod, size);
            const double bending = compute_bending_force(model, rod);
            if (round_off > stiff.force) stiff = {index, round_off};
            if (bending < soft.force) soft = {index, bending};
        }
        if (stiff.force > tolerable * soft.force) sentences.push_back(describe(model, stiff, soft));
    }
    return sentences;
}

}  // namespace gxrod
