#pragma once

#include <array>

#include "constraints/joints/joint_coordinate.hpp"
#include "constraints/joints/wide_rows.hpp"
#include "model/model.hpp"

namespace gxrod {

// The equation of a gear, docs/theory/joints.md (J24): ratio q₁ + q₂ = 0 for the coordinates of two joints.
// With the multiplier λ it exerts λ along q₂ on B of the second joint and ratio λ along q₁ on B of the first,
// the opposites on A. Its unit is that of q₂.
class GearRows : public WideRows {
  public:
    GearRows(const Model& model, const Gear& gear);

    const std::string& name() const override { return name_; }
    int count() const override { return 1; }
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
    Eigen::Index size() const { return 6 * static_cast<Eigen::Index>(nodes_.size()); }

    std::string name_;
    std::vector<int> nodes_;
    std::array<Term, 2> terms_;
};

}  // namespace gxrod
