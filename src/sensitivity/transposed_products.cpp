#include "sensitivity/transposed_products.hpp"

#include <algorithm>

#include "assembly/joints/joint_scales.hpp"
#include "assembly/lanes/frame_columns.hpp"
#include "linear/eigen/pencil.hpp"
#include "sensitivity/tangent_linear_step.hpp"

namespace gxrod {

namespace {

// Calls visit(place in a vector of all unknowns, index among the rows).
template <class Visit>
void visit_rows(const System& system, const Visit& visit) {
    const std::vector<AttachedUnknowns>& attached = system.joints().attached();
    std::size_t index = 0;
    for (std::size_t i = 0; i < attached.size(); ++i) {
        for (std::int64_t k = 0; k < attached[i].count; ++k)
            visit(system.equations().of_attached(i) + k, index++);
    }
}

std::size_t count_rows(const System& system) {
    return static_cast<std::size_t>(system.equations().attached_count());
}

}  // namespace

RowNumbers take_rows(const System& system, const Eigen::VectorXd& vector) {
    RowNumbers rows(count_rows(system));
    visit_rows(system, [&](std::int64_t place, std::size_t index) { rows[index] = vector[place]; });
    return rows;
}

void put_rows(const System& system, const RowNumbers& rows, Eigen::VectorXd& vector) {
    visit_rows(system, [&](std::int64_t place, std::size_t index) { vector[place] = rows[index]; });
}

RowNumbers list_scales(const System& system, const std::vector<double>& values) {
    RowNumbers scales(count_rows(system));
    visit_rows(system, [&](std::int64_t place, std::size_t index) {
        scales[index] = -values[static_cast<std::size_t>(system.pattern().slot(place, place))] /
                        joint_scaling::regularization;
    });
    return scales;
}

void solve_transposed(const System& system,
                      const std::vector<double>& values,
                      SolverWorkspace& workspace,
                      Eigen::VectorXd& vector) {
    workspace.linear_solver->solve(vector);
    if (system.joints().empty()) return;
    constexpr int corrections = 2;
    Eigen::VectorXd rest = vector;
    for (int i = 0; i < corrections; ++i) {
        rest = take_regularization(system, values, rest);
        workspace.linear_solver->solve(rest);
        vector += rest;
    }
}

TransposedProducts::TransposedProducts(const Model& model)
    : model_(without_supports(model)), system_(model_) {
    if (system_.joints().empty()) return;
    unscaled_.assign(static_cast<std::size_t>(system_.pattern().nonzeros()), 0.0);
    visit_rows(system_, [&](std::int64_t place, std::size_t) {
        unscaled_[static_cast<std::size_t>(system_.pattern().slot(place, place))] =
            -joint_scaling::regularization;
    });
}

std::vector<Vec6> TransposedProducts::spread(const Eigen::VectorXd& vector) const {
    std::vector<Vec6> nodal(system_.equations().node_count());
    for (std::size_t i = 0; i < nodal.size(); ++i)
        nodal[i] = vector.segment<6>(system_.equations().first_of(static_cast<int>(i)));
    return nodal;
}

std::vector<Vec6> TransposedProducts::compute(const State& state,
                                              double time,
                                              const ConstraintRequest& request,
                                              const NodeLinearization& by,
                                              const std::vector<Vec6>& xi,
                                              const RowNumbers& p) {
    ConstraintRequest unscaled = request;
    if (!system_.joints().empty()) unscaled.scaled_as = &unscaled_;
    system_.compute_tangent(
        state, time, std::vector<NodeLinearization>(state.trial.size(), by), values_, unscaled);
    Eigen::VectorXd all = Eigen::VectorXd::Zero(system_.equations().count());
    for (std::size_t i = 0; i < xi.size(); ++i)
        all.segment<6>(system_.equations().first_of(static_cast<int>(i))) = xi[i];
    RowNumbers scaled = p;
    const RowNumbers scales = list_scales(system_, values_);
    for (std::size_t i = 0; i < p.size(); ++i) scaled[i] = scales[i] == 0.0 ? 0.0 : p[i] / scales[i];
    put_rows(system_, scaled, all);
    Eigen::VectorXd product = Eigen::VectorXd::Zero(all.size());
    system_.pattern().visit_entries([&](std::int64_t row, std::int64_t column, std::int64_t slot) {
        product[column] += values_[static_cast<std::size_t>(slot)] * all[row];
    });
    std::vector<Vec6> nodal = spread(product);
    forces_.assign(nodal.size(), Vec6::Zero());
    gradient_.assign(p.size(), 0.0);
    if (p.empty() || scales.front() == 0.0) return nodal;  // no equations
    // The matrix has GᵀDG, too, and its rows of Φ are −D G, its columns −GᵀD.
    gradient_ = take_rows(system_, product);
    for (std::size_t i = 0; i < p.size(); ++i)
        gradient_[i] = -gradient_[i] / scales[i] - joint_scaling::regularization * scaled[i];
    Eigen::VectorXd one = Eigen::VectorXd::Zero(all.size());
    put_rows(system_, gradient_, one);
    const std::vector<Vec6> added = spread(multiply(system_.pattern(), values_, one));
    put_rows(system_, scaled, one);
    forces_ = spread(multiply(system_.pattern(), values_, one));
    for (std::size_t i = 0; i < nodal.size(); ++i) {
        nodal[i] += added[i];
        forces_[i] = -forces_[i];
    }
    return nodal;
}

}  // namespace gxrod
