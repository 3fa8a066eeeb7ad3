#include "sensitivity/equilibrium_adjoint.hpp"

#include <algorithm>
#include <stdexcept>

#include "integrators/load_stepping.hpp"
#include "linear/transposed_values.hpp"
#include "model/ties/ties.hpp"
#include "rotation/rotation_map.hpp"
#include "solvers/newton_steps.hpp"

namespace gxrod {

namespace {

void check_memory(const Model& model) {
    const auto remembers = [](const Rod& rod) { return rod.kind == ElementKind::simo; };
    if (std::ranges::any_of(model.rods, remembers))
        throw std::invalid_argument(
            "the equilibrium of elements of kind \"simo\" depends on how it was reached: carry derivatives "
            "along instead, or take the element \"objective\"");
    const auto has_memory = [](const Section& section) {
        return section.law && section.law->memory_size() > 0;
    };
    if (std::ranges::any_of(model.sections, has_memory))
        throw std::invalid_argument(
            "an equilibrium of sections that remember depends on how it was reached: carry derivatives along "
            "instead");
    if (!model.contact.is_empty()) throw std::invalid_argument("there are no derivatives with contact yet");
    const auto rubs_in_path = [](const Tendon& tendon) { return tendon.friction.has_value(); };
    const std::optional<Seabed>& seabed = model.surroundings.seabed;
    if ((seabed && seabed->has_friction()) || has_joint_friction(model) ||
        std::ranges::any_of(model.tendons, rubs_in_path))
        throw std::invalid_argument(
            "an equilibrium with friction depends on how it was reached: carry derivatives along instead");
}

// Error of order h⁴.
template <class Function>
double differentiate_at_zero(const Function& f, double h) {
    const double near = (f(h) - f(-h)) / (2.0 * h);
    const double far = (f(2.0 * h) - f(-2.0 * h)) / (4.0 * h);
    return (4.0 * near - far) / 3.0;
}

}  // namespace

EquilibriumAdjoint::EquilibriumAdjoint(const System& system,
                                       const State& state,
                                       double time,
                                       LinearSolverKind linear_solver,
                                       const std::vector<int>& nodes,
                                       const Quantity& quantity)
    : system_(system), state_(state), time_(time), linear_solver_(linear_solver) {
    check_memory(system.model());
    undo_trial(state_);
    for (NodeMotion& motion : state_.trial) motion.theta.setZero();
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
    // What supports hold goes with the reference shape, or where they move; all else is free to choose.
    varied.start(LoadStepping(), {0.0, time_}, linear_solver_, false, false);
    varied.take_inputs(system_.model());
    Residual residual;
    int side = 0;
    std::array<double, 4> values{};
    varied.place_sides(state_);
    if (VariedSystem& one = *varied.sides()[0]; one.held.has_kinks()) {
        one.held.note();
        one.system.compute_residual(state_, time_, residual);
        const Pieces pieces = one.held.pieces();
        for (VariedSystem* side_system : varied.sides()) side_system->held.hold(pieces);
    }
    for (VariedSystem* one : varied.sides()) {
        undo_trial(one->state);
        one->system.supports().place(time_, one->state);
        one->system.compute_residual(one->state, time_, residual);
        values[static_cast<std::size_t>(side)] =
            quantity(one->system, one->state, side) -
            multipliers_.dot(gather_residual(one->system, residual, values_));
        ++side;
    }
    const double near = (values[0] - values[1]) / (2.0 * models.near.step);
    const double far = (values[2] - values[3]) / (2.0 * models.far.step);
    return (4.0 * near - far) / 3.0;
}

}  // namespace gxrod
