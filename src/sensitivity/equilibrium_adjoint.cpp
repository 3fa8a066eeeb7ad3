#include "sensitivity/equilibrium_adjoint.hpp"

#include <algorithm>
#include <stdexcept>

#include "integrators/load_stepping.hpp"
#include "linear/transposed_values.hpp"
#include "model/path_dependence.hpp"
#include "model/ties/ties.hpp"
#include "rotation/rotation_map.hpp"
#include "sensitivity/difference_at_zero.hpp"
#include "sensitivity/held_stops.hpp"
#include "solvers/newton_steps.hpp"

namespace gxrod {

namespace {

void check_equilibrium(const Model& model) {
    if (depends_on_path(model))
        throw std::invalid_argument(
            "an equilibrium with elements \"simo\", sections that remember or friction depends on how it was "
            "reached: go back through the steps that led to it, or carry derivatives along");
    if (has_breaking_joint(model))
        throw std::invalid_argument(
            "an equilibrium after a joint has broken depends on how it was reached: take `breaks` out of the "
            "joints");
    if (!model.contact.is_empty())
        throw std::invalid_argument(
            "there are no derivatives of contact by multipliers yet: carry derivatives along instead");
}

}  // namespace

EquilibriumAdjoint::EquilibriumAdjoint(const System& system,
                                       const State& state,
                                       double time,
                                       LinearSolverKind linear_solver,
                                       const std::vector<int>& nodes,
                                       const Quantity& quantity)
    : system_(system), state_(state), time_(time) {
    check_equilibrium(system.model());
    undo_trial(state_);
    for (NodeMotion& motion : state_.trial) motion.theta.setZero();
    if (const HeldStops stops(system.model());
        !stops.empty() && stops.are_at_limit(state_, system.length_scale()))
        throw std::runtime_error("a joint is at its limit without a force: a kink, without a derivative");
    SolverWorkspace workspace(system, linear_solver);
    const Stage stage{0, 0.0, time, time};
    LoadStepping().linearize(state_, stage, workspace.linearizations);
    system.compute_tangent(state_, time, workspace.linearizations, values_);
    workspace.values = transpose_values(system.pattern(), values_);
    EquilibriumReport report;
    if (!factorize(system, workspace, report))
        throw std::runtime_error("the tangent of the equilibrium is singular");
    multipliers_ = find_gradient(nodes, quantity);
    workspace.linear_solver->solve(multipliers_);
    if (system.joints().empty()) return;
    // What their regularization leaves, as in a second iteration of what is carried along.
    Eigen::VectorXd rest = take_regularization(system, values_, multipliers_);
    workspace.linear_solver->solve(rest);
    multipliers_ += rest;
}

// (∂q/∂y)ᵀ in the system's unknowns.
Eigen::VectorXd EquilibriumAdjoint::find_gradient(const std::vector<int>& nodes,
                                                  const Quantity& quantity) const {
    constexpr double part = 1e-3;  // of the length of the node's part, or in rad
    std::vector<Vec6> nodal(state_.trial.size(), Vec6::Zero());
    State moved = state_;
    for (const int node : nodes) {
        const auto index = static_cast<std::size_t>(node);
        const NodeMotion start = state_.trial[index];
        for (int component = 0; component < 6; ++component) {
            const auto move = [&](double amount) {
                const Vec3 along = amount * Vec3::Unit(component % 3);
                NodeMotion& trial = moved.trial[index];
                if (component < 3)
                    trial.r = start.r + along;
                else
                    trial.Lambda = exp_quaternion(along) * start.Lambda;
                return quantity(system_, moved, -1);
            };
            const double size = component < 3 ? system_.scale_groups().length_at(node) : 1.0;
            nodal[index][component] = differentiate_at_zero(move, part * size);
            moved.trial[index] = start;
        }
    }
    return gather(nodal, system_.equations(), system_.team());
}

double EquilibriumAdjoint::differentiate(const VariedModels& models, const Quantity& quantity) const {
    ForwardSensitivity varied(system_, models);
    varied.take_inputs(system_.model());
    // Supports hold what they hold in the reference shape of each.
    varied.place_in_reference(state_);
    Residual residual;
    std::array<double, 4> values{};
    const std::array<VariedSystem*, 4> sides = varied.sides();
    if (VariedSystem& one = *sides[0]; one.held.has_kinks()) {
        one.held.note();
        one.system.compute_residual(state_, time_, residual);
        const Pieces pieces = one.held.pieces();
        for (VariedSystem* side : sides) side->held.hold(pieces);
    }
    for (std::size_t i = 0; i < sides.size(); ++i) {
        VariedSystem& one = *sides[i];
        place_next_to(state_, time_, one);
        one.system.compute_residual(one.state, time_, residual);
        values[i] = quantity(one.system, one.state, static_cast<int>(i)) -
                    multipliers_.dot(gather_residual(one.system, residual, values_));
    }
    const double near = (values[0] - values[1]) / (2.0 * models.near.step);
    const double far = (values[2] - values[3]) / (2.0 * models.far.step);
    return (4.0 * near - far) / 3.0;
}

}  // namespace gxrod
