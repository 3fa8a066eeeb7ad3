#pragma once

#include <cstddef>
#include <memory>
#include <vector>

#include "assembly/constraint_request.hpp"
#include "assembly/contribution.hpp"
#include "assembly/equation_numbers.hpp"
#include "assembly/joints/joint_scales.hpp"
#include "assembly/node_groups.hpp"
#include "assembly/residual.hpp"
#include "assembly/scale_groups.hpp"
#include "constraints/joints/wide_rows.hpp"
#include "linear/sparse_pattern.hpp"
#include "model/model.hpp"
#include "state/joint_state.hpp"
#include "state/memory_slice.hpp"
#include "state/state.hpp"
#include "state/values/joint_values.hpp"

namespace gxrod {

// Equations over several nodes in a model's system of equations. They follow the same rules as joints between
// two nodes (JointAssembly, which owns this); their states, rows, values and work come after those of the
// joints.
class WideAssembly {
  public:
    explicit WideAssembly(const Model& model);

    bool empty() const { return rows_.empty(); }
    std::size_t count() const { return rows_.size(); }
    const WideRows& rows(std::size_t index) const { return *rows_[index]; }
    bool have_laws() const;
    bool are_driven() const;
    bool are_damped() const;
    bool have_friction_by_multipliers() const;

    // Appends the multipliers, each at the node that carries the fewest; `carried` counts by node.
    void attach(std::vector<int>& carried, std::vector<AttachedUnknowns>& attached) const;
    void add_groups(std::vector<NodeGroup>& groups) const;
    // Prepares the equations; both references must outlive this. `first_row` is the number of rows of joints.
    void lay_out(const Layout& layout, std::int64_t first_row, std::size_t first_memory);

    // These do the same as in JointAssembly; `rows` already has its size.
    std::size_t row_count() const;
    void compute_rows(const State& state,
                      double time,
                      const ConstraintRequest& request,
                      std::vector<double>& rows) const;
    void add_forces(const State& state,
                    double time,
                    ConstraintLevel level,
                    const ScaleGroups& groups,
                    Residual& residual) const;
    void subtract_ground_forces(const State& state, double time, std::vector<Vec6>& nodal) const;
    // Appends the mean of the diagonal at the nodes of each equation.
    void add_means(const State& state,
                   double time,
                   const std::vector<double>& values,
                   std::vector<JointScales>& means) const;
    // `scales` are those of all joints, these last; not used if `request` has values to scale as. nullptr:
    // forces of laws only, no equations.
    void add_tangents(const State& state,
                      double time,
                      const std::vector<NodeLinearization>& linearizations,
                      const ConstraintRequest& request,
                      const std::vector<JointScales>* scales,
                      std::vector<double>& values) const;
    void set_rows(const std::vector<double>& rows,
                  const std::vector<double>& values,
                  Eigen::VectorXd& vector) const;
    void advance_multipliers(const std::vector<Vec6>& increments,
                             const Eigen::VectorXd& solution,
                             const std::vector<double>& values,
                             State& state) const;

    // Append to the values of joints.
    void add_driving_forces(const State& state, double time, std::vector<Vec6>& forces) const;
    void add_coordinates(const std::vector<NodeMotion>& nodes,
                         double time,
                         const State& state,
                         std::vector<Vec6>& coordinates) const;
    void add_joint_values(const State& state, double time, std::vector<JointValues>& all) const;

    double compute_driving_power(const State& state, double time, const TimeSpan& step) const;
    double compute_strain_energy(const State& state, double time) const;
    double compute_damping_power(const State& state) const;
    double compute_damping_action(const State& state) const;
    double compute_slip_dissipation(const State& state) const;

    // The largest gap of these equations: relative to `length` for rows that are lengths.
    struct Gap {
        double size;
        std::size_t index;
    };
    Gap measure_gap(const std::vector<double>& rows, const State& state) const;
    void check_ranges(const State& state, double time) const;
    // Starts the trial state and the previous state of these joints.
    void start(State& state) const;
    // Commits these joints in the trial state, before it becomes the last accepted one.
    void commit(State& state) const;

  private:
    MemorySlice memory_of(std::size_t index) const {
        return {first_memory_ + numbers_of_joint * index, numbers_of_joint};
    }
    // Returns the size of the force that friction follows; 0 if none does.
    double held_force(const State& state, std::size_t index) const {
        const int held = rows_[index]->held_rows();
        return held == 0 ? 0.0 : kept_multipliers(state, index).head(held).norm();
    }
    WidePlace place(std::size_t index,
                    const std::vector<NodeMotion>& nodes,
                    double time,
                    const State& state) const {
        return {nodes,
                state,
                state.joints_previous[first_ + index],
                read_slips(memory_of(index).of(state)),
                time,
                held_force(state, index)};
    }
    WidePlace place(std::size_t index, const State& state, double time) const {
        return place(index, state.trial, time, state);
    }
    // Return the multipliers in the trial state, and the multipliers that act: zero for rows that do not
    // hold.
    Eigen::VectorXd kept_multipliers(const State& state, std::size_t index) const;
    Eigen::VectorXd multipliers(std::size_t index,
                                const WidePlace& place,
                                ConstraintLevel level = ConstraintLevel::position) const;
    bool hold(std::size_t index, const WidePlace& place, ConstraintLevel level) const;
    bool have_equation(std::size_t index,
                       int row,
                       const std::vector<int>& nodes,
                       const std::vector<double>& values) const;
    Eigen::VectorXd compute_force(const State& state,
                                  double time,
                                  std::size_t index,
                                  ConstraintLevel level) const;
    double scale_of_row(std::size_t index, int row, const std::vector<double>& values) const;
    Eigen::VectorXd compute_regularization(std::size_t index,
                                           const ConstraintRequest& request,
                                           const std::vector<JointScales>& scales) const;
    Eigen::MatrixXd compute_equations(const WidePlace& place,
                                      std::size_t index,
                                      const std::vector<NodeLinearization>& linearizations,
                                      const ConstraintRequest& request,
                                      const Eigen::VectorXd& D) const;
    // Adds the contribution of friction that follows the force held, as JointAssembly::add_held_tangent.
    void add_held_tangent(std::size_t index,
                          const WidePlace& place,
                          const Eigen::VectorXd& D,
                          Eigen::MatrixXd& matrix) const;
    void add_matrix(std::size_t index,
                    const std::vector<int>& nodes,
                    Eigen::MatrixXd& matrix,
                    std::vector<double>& values) const;
    template <class Compute>
    double sum_over(const State& state, double time, Compute&& compute) const;

    std::vector<std::unique_ptr<const WideRows>> rows_;
    std::size_t first_;  // number of joints before these
    const EquationNumbers* equations_ = nullptr;
    const SparsePattern* pattern_ = nullptr;
    double length_ = 1.0;
    std::size_t first_memory_ = 0;
    std::vector<std::int64_t> first_rows_;  // first row of each in Residual::rows
};

}  // namespace gxrod
