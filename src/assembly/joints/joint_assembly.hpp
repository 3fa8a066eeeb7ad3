#pragma once

#include <Eigen/Core>
#include <array>
#include <bitset>
#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "assembly/constraint_request.hpp"
#include "assembly/contribution.hpp"
#include "assembly/equation_numbers.hpp"
#include "assembly/joints/wide_assembly.hpp"
#include "assembly/node_groups.hpp"
#include "assembly/residual.hpp"
#include "assembly/scale_groups.hpp"
#include "constraints/joints/joint_force.hpp"
#include "constraints/joints/joint_rows.hpp"
#include "linear/sparse_pattern.hpp"
#include "model/model.hpp"
#include "state/joint_state.hpp"
#include "state/memory_slice.hpp"
#include "state/state.hpp"
#include "state/values/joint_values.hpp"

namespace gxrod {

// The largest error of the equations of joints: relative to the length of their part, or in rad.
struct LargestGap {
    double size = 0.0;
    int joint = -1;
};

// The joints of a model, and gears between them, in its system of equations (docs/theory/joints.md); gears
// are counted behind the joints. Each joint's multipliers are attached to one of its nodes. With D the size
// of the tangent's diagonal at its nodes, G the gradient of its equations Φ and μ the unknown that stands for
// its multipliers, λ ← λ + D (μ − G δ), the system is
//   [K − ∂(Gᵀλ) + GᵀDG   −GᵀD] [δ]     [R − Gᵀλ]
//   [−DG                 −εD ] [μ] = − [−DΦ    ]
// so no pivot vanishes, in any unit and for any step, and redundant equations do no harm.
class JointAssembly : public Contribution {
  public:
    explicit JointAssembly(const Model& model);

    bool empty() const { return joints_.empty() && wide_.empty(); }
    std::size_t count() const { return joints_.size() + wide_.count(); }
    // The name of a joint or a gear in messages, "joint shaft", "gear stage", and the node at which its state
    // is reported.
    std::string name(int index) const;
    int shown_node(int index) const;
    const std::vector<AttachedUnknowns>& attached() const { return attached_; }
    std::vector<NodeGroup> node_groups() const;
    // Whether an equation of a joint is a length.
    bool is_length(int joint, int row) const {
        const auto index = static_cast<std::size_t>(joint);
        return index < joints_.size() ? joints_[index].is_length(row)
                                      : wide_.rows(index - joints_.size()).is_length(row);
    }
    // Whether all equations are linear in positions, so that velocities meet them where positions do.
    bool are_linear() const { return are_linear_; }

    // The numbers in State::memory: slip points, and whether the joint holds.
    std::size_t memory_count() const override { return numbers_of_joint * count(); }
    MemorySlice memory_of(std::size_t joint) const { return memory_.piece(joint, numbers_of_joint); }
    // Whether a joint holds in the last accepted state: it acts in the stage, and is not broken.
    bool holds(const State& state, std::size_t joint) const {
        return joint >= joints_.size() || read_hold(memory_of(joint).of(state)) == JointHold::holds;
    }
    // Whether joints have one-sided equations, and whether one has begun to hold in the step that ends with
    // the trial motions: what it stops loses energy.
    bool have_stops() const { return have_stops_; }
    bool has_just_stopped(const State& state) const;
    // Prepares the equations, once, when they are numbered.
    void lay_out(const Layout& layout) override;

    // Sets rows to the equations of the trial motions.
    void compute_rows(const State& state,
                      double time,
                      const ConstraintRequest& request,
                      std::vector<double>& rows) const;
    // Sets the rows of the residual, too.
    void subtract_forces(const State& state,
                         double time,
                         const ConstraintRequest& request,
                         Residual& residual) const override;
    // Subtracts the forces of joints to the ground on the nodes.
    void subtract_ground_forces(const State& state, double time, std::vector<Vec6>& nodal) const;
    // Adds to the values of a tangent after all other contributions. At the level of positions, equations and
    // multipliers are left out if the linearizations have no placement.
    void add_tangents(const State& state,
                      double time,
                      const ConstraintRequest& request,
                      const std::vector<NodeLinearization>& linearizations,
                      std::vector<double>& values) const override;
    // Sets the entries of a residual vector to −DΦ, with D from the values of the tangent.
    void set_rows(const std::vector<double>& rows,
                  const std::vector<double>& values,
                  Eigen::VectorXd& vector) const;
    // Advances the trial multipliers by the nodes' increments and the solution's μ. Trial motions are those
    // of the tangent.
    void advance_multipliers(const std::vector<Vec6>& increments,
                             const Eigen::VectorXd& solution,
                             const std::vector<double>& values,
                             State& state) const;

    // Computes the external forces that do work on each joint, in the ledger's order: motors and drives on
    // turn and slide, forces that move the rest of springs of turn and slide, 0, 0.
    std::vector<Vec6> compute_driving_forces(const State& state, double time) const;
    // Compute the coordinates that these forces move, in the same order, and their changes from the previous
    // motions to the trial ones at `time`.
    std::vector<Vec6> compute_coordinates(const std::vector<NodeMotion>& nodes,
                                          double time,
                                          const State& state) const;
    std::vector<Vec6> compute_movement(const State& state, double time) const;
    // Computes the power of these forces at the trial motions.
    double compute_driving_power(const State& state, double time, const TimeSpan& step) const;
    // Computes the energy of springs, limits and sticking friction at the trial motions.
    double compute_strain_energy(const State& state, double time) const;
    double compute_damping_power(const State& state) const;
    // Computes the dissipation of dampers for the step from the previous motions to the trial ones in a unit
    // of time.
    double compute_damping_action(const State& state) const;
    // Computes the dissipation of friction in that step.
    double compute_slip_dissipation(const State& state) const;
    bool is_damped() const { return is_damped_; }
    // Whether any friction depends on the force that a joint holds.
    bool have_friction_by_multipliers() const;
    // Starts friction at the beginning of a run: it slips where the joint moves. Joints that do not act in
    // the stage hold nothing.
    void start(State& state) const;
    // Releases the joints that do not act in the stage that begins, and lets others hold again. Throws
    // std::runtime_error if one of these is open.
    void begin_stage(State& state, double time) const;
    // The joints that have broken in this stage, with the time; and whether one did in the step that ended
    // with this state.
    struct Break {
        std::size_t joint;
        double time;
    };
    std::vector<Break> list_breaks(const State& state) const;
    bool has_just_broken(const State& state) const;

    // Computes the values of each joint at the trial motions.
    std::vector<JointValues> compute_joint_values(const State& state, double time) const;

    // Measures the largest error of rows that are lengths, and of rows that are turns.
    LargestGap measure_gap(const std::vector<double>& rows, const State& state) const;
    // Throws EvaluationError if a joint has no meaning at the trial motions, beyond the end of a rod or of a
    // curve.
    void check_ranges(const State& state, double time) const;
    // Makes turns and slips at the trial motions those of the last accepted step.
    void commit(State& state, double time) const override;

  private:
    struct Block {
        std::int64_t first;   // the entry in the block's first row and column
        std::int64_t stride;  // from column to column
    };
    // The places of a joint's matrix: by unknowns of A, of B and its own, column by column.
    struct Places {
        std::array<Block, 9> blocks{};
        std::vector<std::int64_t> slots;  // slots of all entries; empty if the blocks are enough
        std::int64_t first = 0;           // first of its equations
        std::int64_t first_diagonal = 0;  // slot of that equation's diagonal entry
        std::int64_t stride = 0;          // from one diagonal entry to the next
        std::array<std::int64_t, 12>
            diagonals{};  // slots of diagonal entries of A's and B's unknowns; −1 for none
    };
    static constexpr int most_unknowns = 12 + most_joint_rows;
    using Matrix = Eigen::Matrix<double, most_unknowns, most_unknowns>;
    // The coordinates that a joint leaves free; 0 if it has none.
    struct JointPlace {
        ScalarJet turn{}, slide{};
    };

    // Whether each row of a joint holds; the rows of open stops do not.
    using RowHolds = std::bitset<most_joint_rows>;
    RowHolds find_row_holds(const State& state, std::size_t joint, const ConstraintRequest& request) const;
    // The size that the gap of a stop is compared with: the model's length, or a radian.
    double measure_of(std::size_t joint, int row) const {
        return joints_[joint].is_length(row) ? length_ : 1.0;
    }
    // Measures the speed of both sides in a row's coordinate: the sum of what each has of it at most.
    double measure_speed(const JointMotions& at, std::size_t joint, int row) const;
    void let_go(State& state, std::size_t joint) const;
    // Computes the dissipation of contact in the joint's clearance, as compute_damping_action.
    double compute_contact_action(const State& state, std::size_t joint) const;
    // Whether the tangent with these values has the equation of a row.
    bool has_equation(std::size_t joint, int row, const std::vector<double>& values) const;
    JointPlace place_of(const std::vector<NodeMotion>& nodes, std::size_t joint, const State& state) const;
    JointInputs inputs_at(std::size_t joint, const State& state, double time) const;
    // The force that the joint's points hold, from its multipliers: its size, and the size's derivative by
    // them.
    struct HeldForce {
        double size = 0.0;
        JointVector by_multipliers;
    };
    HeldForce find_held_force(const State& state, std::size_t joint) const;
    // Whether the joint breaks when the trial state is accepted at `time`.
    bool breaks(const State& state, double time, std::size_t joint) const;
    // Adds the contribution of friction that depends on this force to the joint's matrix.
    void add_held_tangent(
        std::size_t joint, const State& state, double time, const JointVector& D, Matrix& matrix) const;
    JointSlips slips_before(const State& state, std::size_t joint) const {
        return read_slips(memory_of(joint).of(state));
    }
    const NodeMotion& motion(const std::vector<NodeMotion>& nodes, int node) const;
    JointMotions motions(const std::vector<NodeMotion>& nodes, std::size_t joint) const;
    JointVector multipliers(const State& state, std::size_t joint) const;
    // Returns those of rows that hold; others are 0.
    JointVector acting_multipliers(const State& state,
                                   std::size_t joint,
                                   const ConstraintRequest& request) const;
    // Computes the forces of a joint on the nodes of A and B.
    PairVector compute_force(const State& state,
                             double time,
                             std::size_t joint,
                             const JointVector& multipliers) const;
    PairVector compute_force(const State& state, double time, std::size_t joint) const {
        return compute_force(state, time, joint, multipliers(state, joint));
    }
    void add_equations(std::size_t joint,
                       const State& state,
                       const std::vector<NodeLinearization>& linearizations,
                       const ConstraintRequest& request,
                       const JointVector& D,
                       Matrix& matrix) const;
    Places find_places(std::size_t joint,
                       const EquationNumbers& equations,
                       const SparsePattern& pattern) const;
    std::vector<JointScales> compute_scales(const State& state,
                                            double time,
                                            const std::vector<double>& values) const;
    void add_matrix(std::size_t joint, Matrix& matrix, std::vector<double>& values) const;
    double scale_of_row(std::size_t joint, int row, const std::vector<double>& values) const;

    const Model* model_;
    const EquationNumbers* equations_ = nullptr;
    const ScaleGroups* groups_ = nullptr;
    const SparsePattern* pattern_ = nullptr;
    double length_ = 1.0;
    MemorySlice memory_;
    WideAssembly wide_;
    std::vector<JointRows> joints_;
    std::vector<JointForces> forces_;
    std::vector<AttachedUnknowns> attached_;
    std::vector<Places> places_;
    std::vector<std::int64_t>
        first_rows_;  // first row of each joint in Residual::rows, and the number of all
    bool are_linear_ = true;
    bool are_driven_ = false;
    bool have_forces_ = false;
    bool is_damped_ = false;
    bool have_stops_ = false;
};

}  // namespace gxrod
