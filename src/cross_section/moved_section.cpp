#include "cross_section/moved_section.hpp"

#include <Eigen/LU>

namespace gxrod {
namespace {

// Strains (Γ, K), or velocities, about the section's own origin and axes by those about the new ones:
// Γ′ = Rᵀ (Γ + K × d), K′ = Rᵀ K.
Mat6 compute_move(const Mat3& turn, const PlanePoint& at) {
    Mat3 cross;
    cross << 0.0, -at.y(), at.x(), at.y(), 0.0, 0.0, -at.x(), 0.0, 0.0;  // d ×
    Mat6 move = Mat6::Zero();
    move.topLeftCorner<3, 3>() = move.bottomRightCorner<3, 3>() = turn.transpose();
    move.topRightCorner<3, 3>() = -turn.transpose() * cross;
    return move;
}

// Stresses in the new axes by those in the old ones.
Mat6 compute_stress_turn(const Mat3& turn) {
    constexpr int first[6]{0, 1, 2, 1, 0, 0}, second[6]{0, 1, 2, 2, 2, 1};
    Mat6 matrix;
    for (int j = 0; j < 6; ++j) {
        Mat3 unit = Mat3::Zero();
        unit(first[j], second[j]) = unit(second[j], first[j]) = 1.0;
        const Mat3 turned = turn * unit * turn.transpose();
        for (int i = 0; i < 6; ++i) matrix(i, j) = turned(first[i], second[i]);
    }
    return matrix;
}

void move_properties(const Mat3& turn, const PlanePoint& at, SectionProperties& properties) {
    const Mat6 move = compute_move(turn, at);
    const Eigen::Matrix2d plane = turn.bottomRightCorner<2, 2>();
    properties.stiffness = move.transpose() * properties.stiffness * move;
    properties.mass = move.transpose() * properties.mass * move;
    properties.thermal_strains = move.inverse() * properties.thermal_strains;
    properties.centroid = plane * properties.centroid + at;
    Eigen::Matrix2d moments;  // ∫ (y, z) ⊗ (y, z) dA
    moments << properties.second_moment_z, properties.product_moment, properties.product_moment,
        properties.second_moment_y;
    moments = plane * moments * plane.transpose();
    properties.second_moment_z = moments(0, 0);
    properties.second_moment_y = moments(1, 1);
    properties.product_moment = moments(0, 1);
}

}  // namespace

std::shared_ptr<const CrossSection> move_cross_section(std::shared_ptr<const CrossSection> section,
                                                       const PlanePoint& at,
                                                       double turn) {
    if (at.isZero(0.0) && turn == 0.0) return section;
    auto moved = std::make_shared<CrossSection>(*section);
    const Mat3 rotation(Eigen::AngleAxisd(turn, Vec3::UnitX()));
    const Eigen::Matrix2d plane = rotation.bottomRightCorner<2, 2>();
    for (PlanePoint& node : moved->mesh.nodes) node = plane * node + at;
    for (SharpCorner& corner : moved->mesh.sharp_corners) corner.at = plane * corner.at + at;
    for (SectionCell& cell : moved->mesh.cells) {
        const bool is_default = cell.walls.empty() && turn != 0.0;
        if (is_default) cell.walls.assign(cell.nodes.size(), PlanePoint::UnitX());
        for (PlanePoint& wall : cell.walls) wall = plane * wall;
    }
    // Resultants about the own origin by those about the new one: what strains map to, transposed and
    // inverted.
    const Mat6 resultants = compute_move(rotation, at).transpose().inverse();
    const Mat6 stresses = compute_stress_turn(rotation);
    for (StressPoint& point : moved->stresses.points) {
        point.at = plane * point.at + at;
        point.wall = plane * point.wall;
        point.stress_operator = stresses * point.stress_operator * resultants;
    }
    moved->gradient_strains =
        compute_move(rotation, at).inverse() * (section->properties.thermal_strains * at.transpose() +
                                                section->gradient_strains * plane.transpose());
    move_properties(rotation, at, moved->properties);
    return moved;
}

}  // namespace gxrod
