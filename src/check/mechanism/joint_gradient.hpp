#pragma once

#include <Eigen/Core>

#include "constraints/joints/joint_rows.hpp"
#include "constraints/joints/wide_rows.hpp"
#include "model/model.hpp"

namespace gxrod {

// The gradient of a joint's equations at t = 0, by (δr, δφ) of A, then of B.
JointMatrix compute_start_gradient(const Model& model, const Joint& joint);

// That of its turn and of its slide; no row for one that it has not.
Eigen::Matrix<double, Eigen::Dynamic, 12> compute_coordinate_gradients(const Model& model,
                                                                       const Joint& joint);

// Of equations over several nodes: by (δr, δφ) of each of these.
struct WideGradient {
    std::vector<int> nodes;
    Eigen::MatrixXd rows;
};
WideGradient compute_start_gradient(const Model& model, const WideRows& rows);

// Of the slide of a sleeve, by index in Model::sleeves, one row.
WideGradient compute_slide_gradient(const Model& model, int sleeve);

}  // namespace gxrod
