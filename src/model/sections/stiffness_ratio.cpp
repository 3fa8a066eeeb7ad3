#include "model/sections/stiffness_ratio.hpp"

#include "numerics/eigenvalues.hpp"

#include <fmt/format.h>

#include <Eigen/Cholesky>

namespace gxrod {

std::optional<Mat3> compute_turning_stiffness(const Mat6& stiffness) {
    const Eigen::LLT<Mat3> forces(stiffness.topLeftCorner<3, 3>());
    if (forces.info() != Eigen::Success) return std::nullopt;
    const Mat3 coupling = stiffness.topRightCorner<3, 3>();
    return stiffness.bottomRightCorner<3, 3>() - coupling.transpose() * forces.solve(coupling);
}

namespace {

int find_axis(const Vec3& direction) {
    int axis = 0;
    direction.cwiseAbs().maxCoeff(&axis);
    return axis;
}

std::optional<StiffnessRatio> measure(const Section& section) {
    const std::optional<Mat3> stiffness = compute_turning_stiffness(section.stiffness);
    if (!stiffness) return std::nullopt;
    const SymmetricEigen principal = find_symmetric_eigen(*stiffness);
    const Eigen::VectorXd& values = principal.values;
    if (!(values[0] > 0.0)) return std::nullopt;
    return StiffnessRatio{.ratio = values[2] / values[0],
                          .stiff_axis = find_axis(principal.vectors.col(2)),
                          .soft_axis = find_axis(principal.vectors.col(0))};
}

}  // namespace

std::optional<StiffnessRatio> find_stiffness_ratio(const Model& model) {
    std::optional<StiffnessRatio> largest;
    std::vector<std::optional<StiffnessRatio>> of_sections(model.sections.size());
    for (std::size_t i = 0; i < model.sections.size(); ++i) of_sections[i] = measure(model.sections[i]);
    for (std::size_t i = 0; i < model.rods.size(); ++i) {
        std::optional<StiffnessRatio> ratio = of_sections[static_cast<std::size_t>(model.rods[i].section)];
        if (!ratio || (largest && ratio->ratio <= largest->ratio)) continue;
        ratio->rod = static_cast<int>(i);
        largest = ratio;
    }
    return largest;
}

std::string describe(const StiffnessRatio& ratio, const Model& model) {
    static constexpr std::array<const char*, 3> turns{"twist", "bending about y", "bending about z"};
    return fmt::format("rod {} is {:.2g} times as stiff in {} as in {}",
                       model.rods[static_cast<std::size_t>(ratio.rod)].name,
                       ratio.ratio,
                       turns[static_cast<std::size_t>(ratio.stiff_axis)],
                       turns[static_cast<std::size_t>(ratio.soft_axis)]);
}

}  // namespace gxrod
