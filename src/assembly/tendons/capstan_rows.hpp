#pragma once

#include <memory>
#include <vector>

#include "assembly/tendons/capstan_tension.hpp"
#include "constraints/joints/wide_rows.hpp"

namespace gxrod {

// Adds the terms of tendon friction to the tangent. Elements differentiate their forces at a given tension;
// these rows add the derivative of the tension by the nodes in between. They have no equations and no forces,
// which elements add (DriveValues).
class CapstanRows : public WideRows {
  public:
    explicit CapstanRows(CapstanTension tension) : tension_(std::move(tension)) {}

    const std::string& name() const override { return tension_.name(); }
    int count() const override { return 0; }
    bool is_length(int /*row*/) const override { return true; }
    std::vector<std::vector<int>> list_groups() const override { return {tension_.nodes()}; }
    std::vector<int> list_nodes(const WidePlace& /*place*/) const override { return tension_.nodes(); }

    Eigen::VectorXd compute_values(const WidePlace& /*place*/,
                                   ConstraintLevel /*level*/,
                                   const TimeSpan& /*step*/) const override {
        return {};
    }
    Eigen::MatrixXd compute_gradient(const WidePlace& /*place*/) const override {
        return Eigen::MatrixXd(0, size());
    }
    Eigen::MatrixXd compute_acceleration_derivative(
        const WidePlace& /*place*/, const std::vector<NodeLinearization>& /*linearizations*/) const override {
        return Eigen::MatrixXd(0, size());
    }
    Eigen::MatrixXd compute_force_derivative(const WidePlace& /*place*/,
                                             const Eigen::VectorXd& /*multipliers*/) const override {
        return Eigen::MatrixXd::Zero(size(), size());
    }

    bool has_laws() const override { return true; }
    Eigen::VectorXd compute_law_force(const WidePlace& /*place*/) const override {
        return Eigen::VectorXd::Zero(size());
    }
    Eigen::MatrixXd compute_law_tangent(const WidePlace& place,
                                        const std::vector<NodeLinearization>& linearizations) const override;

    JointValues compute_joint_values(const WidePlace& /*place*/,
                                     const Eigen::VectorXd& /*multipliers*/) const override {
        return {};
    }

  private:
    Eigen::Index size() const { return 6 * static_cast<Eigen::Index>(tension_.nodes().size()); }

    CapstanTension tension_;
};

// The tendons of a model with friction, in its order.
std::vector<std::unique_ptr<const WideRows>> list_capstan_rows(const Model& model);

}  // namespace gxrod
