#pragma once

#include <string>
#include <vector>

#include "constraints/joints/joint_force.hpp"
#include "constraints/joints/sleeve_motion.hpp"
#include "constraints/joints/sleeve_turn.hpp"
#include "constraints/joints/wide_rows.hpp"
#include "model/model.hpp"

namespace gxrod {

// The equations of a sleeve, docs/theory/joints.md (J25) to (J28): b₁ · d = b₂ · d = 0, so that B's point is
// on the rod's line, for a motor s − s₀ = f(t), and three of SleeveTurn if B does not turn. b₁ and b₂ lie
// across the line at the sleeve's place in the last accepted step.
class SleeveRows : public WideRows {
  public:
    SleeveRows(const Model& model, const Sleeve& sleeve);

    const std::string& name() const override { return name_; }
    int count() const override { return lengths() + (sleeve_->holds_turn ? SleeveTurn::row_count : 0); }
    bool is_length(int row) const override { return row < lengths(); }
    std::vector<std::vector<int>> list_groups() const override;
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

    bool has_laws() const override;
    Eigen::VectorXd compute_law_force(const WidePlace& place) const override;
    Eigen::MatrixXd compute_law_tangent(const WidePlace& place,
                                        const std::vector<NodeLinearization>& linearizations) const override;
    int held_rows() const override { return sleeve_->slide.friction.lever > 0.0 ? 2 : 0; }
    Eigen::VectorXd compute_held_derivative(const WidePlace& place) const override;
    double compute_strain_energy(const WidePlace& place) const override;
    bool is_damped() const override;
    double compute_damping_power(const WidePlace& place) const override;
    double compute_damping_action(const WidePlace& place) const override;
    double compute_slip_dissipation(const WidePlace& place) const override;

    bool is_driven() const override;
    Vec6 compute_driving_forces(const WidePlace& place, const Eigen::VectorXd& multipliers) const override;
    Vec6 compute_coordinates(const WidePlace& place) const override;
    double compute_driving_power(const WidePlace& place,
                                 const Eigen::VectorXd& multipliers,
                                 const TimeSpan& step) const override;

    JointValues compute_joint_values(const WidePlace& place,
                                     const Eigen::VectorXd& multipliers) const override;

    // Throws EvaluationError beyond the ends of the rod.
    void check_range(const WidePlace& place) const override;

    double find_first_slip(const WidePlace& place) const override;
    double commit(const WidePlace& place, JointState& state) const override;

  private:
    // The present point and line, and the place of the line nearest to the point.
    struct Situation {
        SleeveMotion::Points points;
        double place = 0.0;
        Eigen::Matrix<double, 3, 2> across;

        SleeveMotion motion() const { return {points, place, across}; }
    };

    // The number of equations that are lengths; those of the turn follow.
    int lengths() const { return sleeve_->slide.motion ? 3 : 2; }
    bool has_node() const { return !sleeve_->point.is_ground(); }
    // The number of unknowns of the nodes that the equations couple.
    int unknowns(const Situation& at) const { return 6 * (at.points.piece->count + (has_node() ? 1 : 0)); }
    int first_node(const Situation& at) const { return at.points.piece->first; }
    VectorJet compute_point(const std::vector<NodeMotion>& nodes) const;
    void set_points(const std::vector<NodeMotion>& nodes, int piece, SleeveMotion::Points& points) const;
    double find_place(const std::vector<NodeMotion>& nodes,
                      double before,
                      SleeveMotion::Points& points) const;
    Situation find_situation(const WidePlace& place) const;
    // Returns axes of the force: the line's direction, and two across it that turn with the rod's section.
    Mat3 compute_force_axes(const Situation& at, const std::vector<NodeMotion>& nodes) const;
    ScalarJet compute_slide(const Situation& at, ConstraintLevel level) const;
    CoordinateForce compute_law(const Situation& at, const WidePlace& place) const;
    SleeveMotion::Weights weigh(const Eigen::VectorXd& multipliers) const;
    Vec3 compute_force_on_point(const Situation& at,
                                const WidePlace& place,
                                const Eigen::VectorXd& multipliers) const;

    // The turn of B, with the rates of its place that the level needs.
    SleeveTurn find_turn(const Situation& at, const WidePlace& place, ConstraintLevel level) const;
    Eigen::RowVectorXd compute_place_gradient(const Situation& at, const WidePlace& place) const;
    Eigen::MatrixXd compute_turn_change(const Situation& at,
                                        const WidePlace& place,
                                        const std::vector<NodeLinearization>& linearizations) const;

    // Take forces, and derivatives, from the points' positions to the nodes' unknowns.
    Eigen::VectorXd pull_back(const Situation& at,
                              const WidePlace& place,
                              const Eigen::VectorXd& forces) const;
    Eigen::MatrixXd pull_back_change(const Situation& at,
                                     const WidePlace& place,
                                     const SleeveMotion::Change& change,
                                     const std::vector<NodeLinearization>& linearizations) const;
    Eigen::MatrixXd pull_back_hessian(const Situation& at,
                                      const WidePlace& place,
                                      const SleeveMotion::Weights& weights) const;

    const Sleeve* sleeve_;
    std::string name_;  // "joint collar"
    const Rod* rod_;
    std::vector<int> nodes_;  // nodes of the rod, from start to end
    SmoothLine line_;
    Mat3 turn_axes_ = Mat3::Identity();  // of B at t = 0, if it does not turn
};

}  // namespace gxrod
