#pragma once

#include <Eigen/Core>
#include <array>
#include <optional>

#include "constraints/joints/cam_distance.hpp"
#include "constraints/joints/joint_coordinate.hpp"
#include "model/joint.hpp"
#include "state/constraint_level.hpp"

namespace gxrod {

// The largest number of equations of a joint.
constexpr int most_joint_rows = 6;

using JointVector = Eigen::Matrix<double, Eigen::Dynamic, 1, 0, most_joint_rows, 1>;
// A matrix by (δr, δφ) of A, then of B.
using JointMatrix = Eigen::Matrix<double, Eigen::Dynamic, 12, Eigen::RowMajor, most_joint_rows, 12>;

// A coordinate that a motor prescribes, and its derivatives by time.
struct PrescribedCoordinate {
    double value = 0.0;
    double rate = 0.0;
    double acceleration = 0.0;
};

// The coordinates that motors prescribe at the time of an equilibrium.
struct JointMotors {
    PrescribedCoordinate turn, slide;
};

// The errors of a joint: the largest |Φ| of its lengths, and of its turns and products of unit vectors.
struct JointGap {
    double length = 0.0;
    double angle = 0.0;
};

// The place of a one-sided equation has the distance of its coordinate from the nearer bound, positive
// inside, the rate at which it comes nearer, and the sign of its multiplier when the bound holds.
struct StopPlace {
    double gap = 0.0;
    double approach = 0.0;
    double sign = 0.0;
};

// The equations Φ = 0 of one joint, docs/theory/joints.md (J6) to (J11) and (J37), each with a multiplier λ:
// the joint exerts Gᵀλ on the nodes of A and B, G = ∂Φ/∂(δr, δφ); for a point's equations λ is the force of A
// on B. Lengths are in the deck's unit, turns and products of unit vectors are not scaled. Turns of any
// number are possible: `turn_before` is the turn at the last accepted step. A joint that does not act in the
// stage has no equations. Stops are one-sided: Φ is then the coordinate less the nearer bound, (J30).
class JointRows {
  public:
    explicit JointRows(const Joint& joint);

    int count() const { return count_; }
    // Whether a row is a length, so that its multiplier is a force; otherwise it is a turn, with a moment.
    bool is_length(int row) const { return rows_[row].is_length; }
    // Whether Φ = 0 only states that nodes have the same positions and rotations as each other or the ground,
    // so that rates satisfy it where positions do.
    bool is_linear() const { return is_linear_; }
    // The rows of motors; −1 without a motor.
    int turn_motor_row() const { return find_motor_row(Motor::turn); }
    int slide_motor_row() const { return find_motor_row(Motor::slide); }
    // Whether there are one-sided rows, and whether a row is one.
    bool has_stops() const { return has_stops_; }
    bool is_stop(int row) const { return rows_[row].lower || rows_[row].upper; }
    StopPlace find_stop(int row, const JointMotions& motions, double turn_before) const;
    // The coordinates that the joint leaves free, prescribed or not.
    const JointCoordinates& coordinates() const { return coordinates_; }
    // The distance of a cam's roller from its curve; nullopt of other joints.
    const std::optional<CamDistance>& cam() const { return cam_; }

    // Computes Φ, Φ̇ or Φ̈.
    JointVector compute_values(const JointMotions& motions,
                               double turn_before,
                               const JointMotors& motors,
                               ConstraintLevel level) const;
    JointGap compute_gap(const JointMotions& motions, double turn_before, const JointMotors& motors) const;

    // Computes the frames that the functions below may share; only the derivatives of Φ̈ need more than
    // positions.
    JointFrames compute_frames(const JointMotions& motions, ConstraintLevel level) const {
        return {motions, arms_, level};
    }
    // Computes G.
    JointMatrix compute_gradient(const JointFrames& frames) const;
    // Computes ∂Φ̈/∂(Newton's unknowns), by placement, rate and acceleration.
    JointMatrix compute_acceleration_derivative(const JointFrames& frames,
                                                const JointLinearizations& linearizations) const;
    // Computes Gᵀλ.
    PairVector compute_force(const JointFrames& frames, const JointVector& multipliers) const;
    // Computes ∂(Gᵀλ)/∂(δr, δφ).
    PairMatrix compute_force_derivative(const JointFrames& frames, const JointVector& multipliers) const;

    JointMatrix compute_gradient(const JointMotions& motions) const {
        return compute_gradient(compute_frames(motions, ConstraintLevel::position));
    }
    JointMatrix compute_acceleration_derivative(const JointMotions& motions,
                                                const JointLinearizations& linearizations) const {
        return compute_acceleration_derivative(compute_frames(motions, ConstraintLevel::acceleration),
                                               linearizations);
    }
    PairMatrix compute_force_derivative(const JointMotions& motions, const JointVector& multipliers) const {
        return compute_force_derivative(compute_frames(motions, ConstraintLevel::position), multipliers);
    }

  private:
    enum class Motor { none, turn, slide };

    // An equation Φ = factor u · w + turn_factor ψ + cam_factor D + constant − motor's coordinate.
    struct Row {
        bool is_length = false;
        double factor = 1.0;
        LinkProduct product = {};
        double turn_factor = 0.0;
        double cam_factor = 0.0;
        double constant = 0.0;
        Motor motor = Motor::none;
        std::optional<double> lower = {}, upper = {};  // bounds of a stop
    };

    int find_motor_row(Motor motor) const;
    void add(const Row& row) { rows_[count_++] = row; }
    void add_kind(const Joint& joint);
    void add_loose(const Joint& joint);
    void add_points();
    void add_aligned_axes(const Joint& joint);
    void add_equal_axes(const Joint& joint);
    void add_across(const Joint& joint);
    void add_distance(const Joint& joint);
    void add_cam(const Joint& joint);
    void add_held(const Joint& joint);
    void add_motors(const Joint& joint);
    void add_stops(const Joint& joint);
    static double find_bound(const Row& row, double coordinate);
    double compute_prescribed(const Row& row, const JointMotors& motors, ConstraintLevel level) const;

    JointReaction compute_reaction(const JointFrames& frames, const JointVector& multipliers) const;

    JointArms arms_;
    JointCoordinates coordinates_;
    std::optional<CamDistance> cam_;
    std::array<Row, most_joint_rows> rows_;
    int count_ = 0;
    bool is_linear_ = false;
    bool has_stops_ = false;
};

}  // namespace gxrod
