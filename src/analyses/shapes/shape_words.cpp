#include "analyses/shapes/shape_words.hpp"

#include <fmt/format.h>

#include <array>

#include "check/summaries/direction_words.hpp"

namespace gxrod {

namespace {

constexpr std::array<const char*, 6> strains{
    "extension", "shear along y", "shear along z", "torsion", "bending about y", "bending about z"};

// Of the strain energy, or of that of one strain: what has less is not named.
constexpr double worth_a_word = 0.25;

// The rods that hold much of the energy of one strain.
std::string name_rods(const Model& model, const Shape& shape, int strain, double sum) {
    std::string names;
    int named = 0;
    for (std::size_t rod = 0; rod < model.rods.size(); ++rod) {
        if (shape.energy_shares[rod][strain] < worth_a_word * sum) continue;
        names += (named++ > 0 ? " and " : "") + model.rods[rod].name;
    }
    return named > 0 ? names : "many rods";
}

}  // namespace

std::string describe_shape(const System& system, const State& state, const Shape& shape) {
    std::vector<Vec6> direction = shape.nodes;
    for (Vec6& motion : direction) motion.head<3>() /= system.length_scale();
    std::string rigid = describe_rigid_direction(system, state, direction);
    if (!rigid.empty()) return rigid;
    Vec6 sums = Vec6::Zero();
    for (const Vec6& shares : shape.energy_shares) sums += shares;
    std::string words;
    while (true) {
        int strain = 0;
        const double sum = sums.maxCoeff(&strain);
        if (sum < worth_a_word && !words.empty()) return words;
        if (!words.empty()) words += ", ";
        words += fmt::format("{} of {}", strains[strain], name_rods(system.model(), shape, strain, sum));
        sums[strain] = 0.0;
    }
}

}  // namespace gxrod
