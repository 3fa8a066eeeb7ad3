#pragma once

#include <Eigen/Core>

#include "constraints/joints/joint_rows.hpp"
#include "constraints/joints/wide_rows.hpp"
#include "model/model.hpp"

namespace gxrod {

// Computes the gradient of a joint's equations at t = 0, by (δr, δφ) of A, then of B.
JointMatrix compute_start_gradient(const Model& model, const Joint& joint);

// Computes the gradients of its turn and its slide, a row for each that it has.
Eigen::Matrix<double, Eigen::Dynamic, 12> compute_coordinate_gradients(const Model& model,
                                                                       const Joint& joint);

// The gradient of equations over several nodes, by (δr, δφ) of each of these nodes.
struct WideGradient {
    std::vector<int> nodes;
    Eigen::MatrixXd rows;
};
WideGradient compute_start_gradient(const Model& model, const WideRows& rows);

// Computes the gradient of a sleeve's slide, by index in Model::sleeves, one row.
WideGradient compute_slide_gradient(const Model& model, int sleeve);
// Computes the gradient of what the teeth of a gear resist, by index in Model::gears, one row.
WideGradient compute_mesh_gradient(const Model& model, int gear);

}  // namespace gxrod
