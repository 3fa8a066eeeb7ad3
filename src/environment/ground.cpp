#include "environment/ground.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <cstddef>

namespace gxrod {

namespace {

// Where a coordinate is between two lines of a grid.
struct Cell {
    std::size_t index;
    double fraction;  // from there to the next line
    double width;     // of the cell, or infinite beyond the edges, where nothing varies
    bool is_inside;
};

Cell find_cell(const std::vector<double>& lines, double at) {
    const auto next = std::upper_bound(lines.begin() + 1, lines.end() - 1, at);
    const auto index = static_cast<std::size_t>(next - lines.begin()) - 1;
    const double width = lines[index + 1] - lines[index];
    const double fraction = (at - lines[index]) / width;
    return {index, std::clamp(fraction, 0.0, 1.0), width, fraction >= 0.0 && fraction <= 1.0};
}

// A height with its derivatives; those of second order but ∂²z/∂x∂y vanish.
struct Height {
    double z, by_x, by_y, by_xy;
};

Height interpolate(const GroundGrid& grid, double x, double y) {
    const Cell i = find_cell(grid.x, x), j = find_cell(grid.y, y);
    const double* const row = grid.z.data() + i.index + j.index * grid.x.size();
    const double* const next_row = row + grid.x.size();
    const double z00 = row[0], z10 = row[1], z01 = next_row[0], z11 = next_row[1];
    const double u = i.fraction, v = j.fraction;
    const double per_x = i.is_inside ? 1.0 / i.width : 0.0, per_y = j.is_inside ? 1.0 / j.width : 0.0;
    return {(1.0 - v) * ((1.0 - u) * z00 + u * z10) + v * ((1.0 - u) * z01 + u * z11),
            ((1.0 - v) * (z10 - z00) + v * (z11 - z01)) * per_x,
            ((1.0 - u) * (z01 - z00) + u * (z11 - z10)) * per_y,
            (z11 - z10 - z01 + z00) * per_x * per_y};
}

GroundAt find_grid_ground(const GroundGrid& grid, const Vec3& position) {
    const Height height = interpolate(grid, position[0], position[1]);
    const Vec3 upright(-height.by_x, -height.by_y, 1.0);  // ∇(z − z_b)
    const double above = position[2] - height.z;
    const double flatness = 1.0 / upright.norm();  // n_z
    // The columns of ∂(∇(z − z_b))/∂x_j are across it in part; n changes by what is.
    Mat3 upright_gradient = Mat3::Zero();
    upright_gradient(0, 1) = upright_gradient(1, 0) = -height.by_xy;
    GroundAt ground;
    ground.normal = flatness * upright;
    ground.normal_gradient =
        flatness * (upright_gradient - ground.normal * (ground.normal.transpose() * upright_gradient));
    ground.gap = above * flatness;
    ground.gap_gradient = ground.normal + above * ground.normal_gradient.row(2).transpose();
    return ground;
}

// Turned by an angle about z.
Vec3 turn(double angle, const Vec3& v) { return Eigen::AngleAxisd(angle, Vec3::UnitZ()) * v; }

GroundAt find_turned_ground(const GroundGrid& grid, const Vec3& position) {
    GroundAt ground = find_grid_ground(grid, turn(-grid.turn, position));
    const Mat3 axes = Eigen::AngleAxisd(grid.turn, Vec3::UnitZ()).toRotationMatrix();
    ground.normal = axes * ground.normal;
    ground.gap_gradient = axes * ground.gap_gradient;
    ground.normal_gradient = axes * ground.normal_gradient * axes.transpose();
    return ground;
}

}  // namespace

GroundAt find_ground(const Seabed& seabed, const Vec3& position) {
    if (seabed.grid)
        return seabed.grid->turn == 0.0 ? find_grid_ground(*seabed.grid, position)
                                        : find_turned_ground(*seabed.grid, position);
    return {seabed.normal.dot(position - seabed.point), seabed.normal, seabed.normal, Mat3::Zero()};
}

}  // namespace gxrod
