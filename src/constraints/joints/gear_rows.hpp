#pragma once

#include <array>

#include "constraints/joints/joint_coordinate.hpp"
#include "constraints/joints/joint_force.hpp"
#include "constraints/joints/wide_rows.hpp"
#include "model/model.hpp"

namespace gxrod {

// The equation of a gear, docs/theory/joints.md (J24): ratio q₁ + q₂ = 0 for the coordinates of two joints.
// With the multiplier λ it exerts λ along q₂ on B of the second joint and ratio λ along q₁ on B of the first,
// the opposites on A. Its unit is that of q₂. Teeth that yield have no equation: λ is their push where ratio
// q₁
// + q₂ is beyond their bounds.
class GearRows : public WideRows {
  public:
    GearRows(const Model& model, const Gear& gear);

    const std::string& name() const override { return name_; }
    int count() const override { return has_laws() ? 0 : 1; }
    bool is_length(int row) const override;
    std::vector<std::vector<int>> list_groups() const override { return {nodes_}; }
    std::vector<int> list_nodes(const WidePlace& place) const override;

    Eigen::VectorXd compute_values(const WidePlace& place,
                                   ConstraintLevel level,
                                   const TimeSpan& step) const override;
    Eigen::MatrixXd compute_gradient(const WidePlace& place) const override;
    Eigen::MatrixXd compute_acceleration_derivative(
        const WidePlace& place, const std::vector<NodeLinearization>& linearizations) const override;
    Eigen::MatrixXd compute_force_derivative(const WidePlace& place,
                                             const Eigen::VectorXd& multipliers) const override;
    Eigen::VectorXd compute_ground_force(const WidePlace& place,
                                         const Eigen::VectorXd& multipliers) const override;
    JointValues compute_joint_values(const WidePlace& place,
                                     const Eigen::VectorXd& multipliers) const override;

    bool has_laws() const override { return is_acted_on(teeth_); }
    Eigen::VectorXd compute_law_force(const WidePlace& place) const override;
    Eigen::MatrixXd compute_law_tangent(const WidePlace& place,
                                        const std::vector<NodeLinearization>& linearizations) const override;
    double compute_strain_energy(const WidePlace& place) const override;
    bool is_damped() const override { return is_damped_by(teeth_); }
    double compute_damping_power(const WidePlace& place) const override;
    double compute_damping_action(const WidePlace& place) const override;

  private:
    // A factor times a coordinate, between A and B.
    struct Term {
        double factor;
        int joint;
        JointArms arms;
        std::array<int, 2> nodes;    // −1: the ground
        std::array<int, 2> columns;  // columns of these nodes among all columns; −1: the ground
        std::optional<JointTurn> turn;
        std::optional<LinkProduct> slide;
    };

    int find_column(int node);
    JointFrames frames_of(const Term& term, const WidePlace& place, ConstraintLevel level) const;
    void add_row(const Term& term, const PairRow& row, Eigen::MatrixXd& sum) const;
    // Computes ∂(ratio q₁ + q₂)/∂(δr, δφ), with an equation or without.
    Eigen::MatrixXd compute_row(const WidePlace& place) const;
    // Computes ratio q₁ + q₂ with its rates.
    ScalarJet compute_jet(const WidePlace& place, ConstraintLevel level) const;
    // Computes the derivatives of these by Newton's unknowns, each times its weight.
    Eigen::MatrixXd compute_change(const WidePlace& place,
                                   const std::vector<NodeLinearization>& linearizations,
                                   const ScalarJet& weights) const;
    // Computes the derivative of λ ∇(ratio q₁ + q₂) at a constant λ.
    Eigen::MatrixXd compute_turned(const WidePlace& place, double multiplier) const;
    CoordinateForce compute_push(const WidePlace& place) const;
    Eigen::Index size() const { return 6 * static_cast<Eigen::Index>(nodes_.size()); }

    std::string name_;
    std::vector<int> nodes_;
    std::array<Term, 2> terms_;
    JointCoordinate teeth_;  // empty if the teeth are rigid
};

}  // namespace gxrod
