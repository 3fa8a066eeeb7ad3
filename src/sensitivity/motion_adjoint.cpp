#include "sensitivity/motion_adjoint.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "assembly/scatter.hpp"
#include "integrators/newmark.hpp"
#include "linear/eigen/pencil.hpp"
#include "linear/transposed_values.hpp"
#include "model/path_dependence.hpp"
#include "model/sticking.hpp"
#include "model/ties/ties.hpp"
#include "rotation/rotation_map.hpp"
#include "sensitivity/difference_at_zero.hpp"
#include "sensitivity/sensitivity_error.hpp"
#include "solvers/hidden_constraints.hpp"
#include "solvers/newton_steps.hpp"
#include "solvers/trial_rates.hpp"

namespace gxrod {

namespace {

[[noreturn]] void refuse(const std::string& what) {
    throw std::invalid_argument(what +
                                " cannot be gone back through by multipliers yet: carry derivatives along "
                                "instead, by `sensitivities`");
}

void check_model(const System& system, const Integrator& integrator) {
    const Model& model = system.model();
    if (!integrator.has_transposed_rates())
        refuse(
            "steps of other schemes than newmark-simplified, newmark-ibrahimbegovic and generalized-alpha");
    if (std::ranges::any_of(model.inputs, [](const auto& input) { return input->is_signal(); }))
        refuse("signals, which act by what they measure,");
    if (!model.contact.is_empty()) refuse("contact");
    const auto follows_force = [](const Joint& joint) {
        return joint.turn.friction.lever > 0.0 || joint.slide.friction.lever > 0.0;
    };
    if (std::ranges::any_of(model.joints, follows_force)) refuse("friction that grows with a joint's force");
    if (has_stops(model)) refuse("joints that can be slack, and stops,");
    if (!model.sleeves.empty()) refuse("sleeves");
}

bool moves(const Support& support, std::size_t first) {
    return support.moved[first] || support.moved[first + 1] || support.moved[first + 2];
}

// The components of a support's node, x y z or the turns, that it holds; global.
Vec3 take_held(const System& system, const Support& support, std::size_t first, const Vec3& vector) {
    const Mat3& axes = system.supports().axes(support.node);
    Vec3 own = axes.transpose() * vector;
    for (std::size_t i = 0; i < 3; ++i) {
        if (!support.holds(static_cast<int>(first + i))) own[static_cast<Eigen::Index>(i)] = 0.0;
    }
    return axes * own;
}

// Leaves out the rates that supports set, whatever the scheme has: the transpose of Supports::set_rates.
void leave_out_held_rates(const System& system, MotionGradient& rates) {
    const bool has_inertia = system.model().has_inertia;
    for (const Support& support : system.model().supports) {
        MotionGradient::OfNode& node = rates.nodes[static_cast<std::size_t>(support.node)];
        node.v -= take_held(system, support, 0, node.v);
        if (has_inertia) node.a -= take_held(system, support, 0, node.a);
        const bool is_turned = moves(support, 3);
        if (!is_turned && !support.holds_all(3)) continue;
        node.omega.setZero();
        if (has_inertia || !is_turned) node.alpha.setZero();
    }
}

// What supports hold stays where it was before the step: the transpose of that. What they move does not
// depend on it.
void keep_held(const System& system,
               const State& state,
               const MotionGradient& by_trial,
               MotionGradient& before) {
    for (const Support& support : system.model().supports) {
        const auto node = static_cast<std::size_t>(support.node);
        const MotionGradient::OfNode& by = by_trial.nodes[node];
        if (!moves(support, 0)) before.nodes[node].r += take_held(system, support, 0, by.r);
        // As place_next_to.
        if (moves(support, 3) || support.holds(3) + support.holds(4) + support.holds(5) < 2) continue;
        const Quat turn = exp_quaternion(state.trial[node].theta);
        before.nodes[node].phi += turn.conjugate() * take_held(system, support, 3, by.phi);
    }
}

// The change of the sum where the motions change from these.
double dot(const MotionGradient& by,
           const std::vector<NodeMotion>& motions,
           const std::vector<NodeMotion>& from) {
    double sum = 0.0;
    for (std::size_t i = 0; i < motions.size(); ++i) {
        const NodeMotion &here = motions[i], &there = from[i];
        const MotionGradient::OfNode& node = by.nodes[i];
        sum += node.r.dot(here.r - there.r) + node.phi.dot(log(here.Lambda * there.Lambda.conjugate())) +
               node.v.dot(here.v - there.v) + node.omega.dot(here.omega - there.omega) +
               node.a.dot(here.a - there.a) + node.alpha.dot(here.alpha - there.alpha);
    }
    return sum;
}

double dot(const MotionGradient& by, const std::vector<CarriedAcceleration>& carried) {
    double sum = 0.0;
    for (std::size_t i = 0; i < by.carried.size(); ++i)
        sum += by.carried[i].a.dot(carried[i].a) + by.carried[i].alpha.dot(carried[i].alpha);
    return sum;
}

double dot(const MotionGradient& by, const StateDirection& along) {
    double sum = dot(by, along.carried);
    for (std::size_t i = 0; i < by.nodes.size(); ++i) {
        const MotionGradient::OfNode& node = by.nodes[i];
        const StateDirection::OfNode& change = along.nodes[i];
        sum += node.r.dot(change.r) + node.phi.dot(change.phi) + node.v.dot(change.v) +
               node.omega.dot(change.omega) + node.a.dot(change.a) + node.alpha.dot(change.alpha);
    }
    return sum;
}

}  // namespace

MotionAdjoint::MotionAdjoint(const SteppedAnalysis& analysis,
                             const AnalysisSettings& settings,
                             const std::vector<VariedModels>& models,
                             std::vector<VariedInput> inputs)
    : sensitivities_(analysis, settings, models),
      start_(sensitivities_.find_start()),
      newton_(analysis.newton()),
      centre_(analysis.system().model(), 0.0),
      products_(centre_.held.model()),
      inputs_(std::move(inputs)),
      workspace_(centre_.system, start_.linear_solver),
      memory_(centre_.system),
      friction_(centre_.system),
      remembers_(depends_on_path(centre_.system.model())),
      by_numbers_(models.size(), 0.0),
      bends_(models.size()),
      by_inputs_(1, std::vector<double>(inputs_.size(), 0.0)) {
    check_model(centre_.system, sensitivities_.integrator());
    if (analysis.settled() != nullptr) refuse("actions that begin at once without inertia");
    const Integrator& integrator = sensitivities_.integrator();
    if (has_hidden_constraints(centre_.system) && !integrator.is_static())
        hidden_ = std::make_unique<HiddenAdjoint>(
            centre_.system, integrator, newton_, start_.linear_solver, find_part());
    sensitivities_.start();
}

// Forces with limits are curved, or have kinks, on a smaller scale than geometry.
double MotionAdjoint::find_part() const {
    return friction_.is_empty() ? find_part_of_quantity() : friction_.part();
}

double MotionAdjoint::find_part_of_quantity() const { return centre_.held.has_kinks() ? 1e-5 : 1e-3; }

void MotionAdjoint::step_back(const Stage& step,
                              const State& before,
                              const State& after,
                              const Quantity* quantity) {
    place(step, before, after);
    if (later_.nodes.empty()) {
        later_ = MotionGradient(base_);
        memory_later_ = MemoryGradient(base_);
    }
    MotionGradient gradient = later_, at_start(base_);
    MemoryGradient memory_at_start(base_);
    if (quantity != nullptr) add_gradient(step, *quantity, gradient);
    if (remembers_) {
        if (quantity != nullptr) add_gradient_by_memory(*quantity, gradient, at_start, memory_at_start);
        memory_.add_by_placements(base_, base_.trial_time, memory_later_, gradient);
        friction_.add_by_placements(base_, base_.trial_time, memory_later_, gradient);
    }
    factorize_transposed(step);
    if (hidden_) hidden_->transpose(step, base_, products_, workspace_, gradient, at_start);
    find_multipliers(step, gradient);
    add_by_numbers(step, quantity);
    add_by_inputs(step, quantity);
    std::vector<Vec6> xi(base_.trial.size());
    for (std::size_t i = 0; i < xi.size(); ++i)
        xi[i] = centre_.system.equations().increment_of(static_cast<int>(i), multipliers_);
    pass_back(step, xi, gradient, at_start);
    if (remembers_) pass_back_memory(step, xi, quantity, at_start, memory_at_start);
    later_ = std::move(at_start);
    memory_later_ = std::move(memory_at_start);
}

void MotionAdjoint::place(const Stage& step, const State& before, const State& after) {
    base_ = before;
    undo_trial(base_);
    centre_.system.forget_loads();
    products_.forget_loads();
    if (hidden_) {
        centre_.held.release();
        hidden_->repeat(step, base_, [&] { hold_pieces(); });
    } else {
        base_.trial_time = sensitivities_.integrator().stage_time(step);
        base_.trial = after.previous;
        base_.joints_trial = after.joints_previous;
        base_.carried_trial = after.carried_previous;
        for (std::size_t i = 0; i < base_.trial.size(); ++i)
            base_.trial[i].theta = log(base_.trial[i].Lambda * base_.previous[i].Lambda.conjugate());
    }
    for (std::size_t i = 0; i < sensitivities_.count(); ++i)
        sensitivities_.by(i).take_inputs(centre_.system.model());
    if (!hidden_) hold_pieces();
    if (!remembers_) return;
    committed_ = base_;
    centre_.system.commit(committed_, base_.trial_time);
}

void MotionAdjoint::hold_pieces() {
    if (!friction_.is_empty()) HeldFriction(centre_.system, base_, base_.trial_time).move(base_);
    if (!centre_.held.has_kinks()) return;
    centre_.held.release();
    centre_.held.note();
    centre_.system.compute_residual(base_, base_.trial_time, residual_);
    const Pieces pieces = centre_.held.pieces();
    centre_.held.hold(pieces);
    for (std::size_t i = 0; i < sensitivities_.count(); ++i) {
        for (VariedSystem* side : sensitivities_.by(i).sides()) side->held.hold(pieces);
    }
}

// (∂q/∂y)ᵀ by differences over what each node's motion has.
void MotionAdjoint::add_gradient(const Stage& step, const Quantity& quantity, MotionGradient& by_end) {
    const double part = find_part_of_quantity();
    State moved = base_;
    const bool has_rates = !sensitivities_.integrator().is_static() && centre_.system.model().has_inertia;
    const double per_time = has_rates ? 1.0 / step.time_step : 0.0;
    for (const int node : quantity.nodes) {
        const auto index = static_cast<std::size_t>(node);
        NodeMotion& trial = moved.trial[index];
        const NodeMotion start = trial;
        MotionGradient::OfNode& by = by_end.nodes[index];
        const auto differentiate = [&](Vec3& gradient, double size, const auto& move) {
            for (Eigen::Index k = 0; k < 3; ++k) {
                gradient[k] += differentiate_at_zero(
                    [&](double amount) {
                        move(Vec3(amount * Vec3::Unit(k)));
                        return quantity.value(centre_.system, moved, -1, -1);
                    },
                    part * size);
                trial = start;
            }
        };
        const double length = centre_.system.scale_groups().length_at(node);
        differentiate(by.r, length, [&](const Vec3& way) { trial.r = start.r + way; });
        differentiate(
            by.phi, 1.0, [&](const Vec3& spin) { trial.Lambda = exp_quaternion(spin) * start.Lambda; });
        if (!has_rates) continue;
        const double squared = per_time * per_time;
        differentiate(by.v, length * per_time, [&](const Vec3& way) { trial.v = start.v + way; });
        differentiate(by.omega, per_time, [&](const Vec3& way) { trial.omega = start.omega + way; });
        differentiate(by.a, length * squared, [&](const Vec3& way) { trial.a = start.a + way; });
        differentiate(by.alpha, squared, [&](const Vec3& way) { trial.alpha = start.alpha + way; });
    }
}

// Rotation vectors of the step are moved apart from placements, as `simo` elements measure by them.
void MotionAdjoint::add_gradient_by_memory(const Quantity& quantity,
                                           MotionGradient& by_end,
                                           MotionGradient& before,
                                           MemoryGradient& memory_before) {
    const double part = find_part_of_quantity();
    State moved = base_;
    const auto differentiate = [&](const auto& move, double size) {
        return differentiate_at_zero(
            [&](double amount) {
                move(amount);
                return quantity.value(centre_.system, moved, -1, -1);
            },
            size);
    };
    const RodMemory::Places places = memory_.list_places(base_, quantity.nodes);
    const std::vector<double> steps = memory_.list_steps(base_, base_.trial_time);
    for (const std::size_t i : places.numbers) {
        const double start = base_.memory[i];
        memory_before.numbers[i] +=
            differentiate([&](double amount) { moved.memory[i] = start + amount; }, steps[i]);
        moved.memory[i] = start;
    }
    for (const std::size_t i : places.sections) {
        const SectionHistory& start = base_.sections[i];
        SectionHistory& section = moved.sections[i];
        StateDirection::OfSection& by = memory_before.sections[i];
        for (Eigen::Index k = 0; k < 3; ++k) {
            by.phi[k] += differentiate(
                [&](double amount) {
                    section.Lambda = exp_quaternion(amount * Vec3::Unit(k)) * start.Lambda;
                },
                part);
            section = start;
            by.K[k] += differentiate([&](double amount) { section.K[k] = start.K[k] + amount; },
                                     part / centre_.system.length_scale());
            section = start;
        }
    }
    if (places.sections.empty()) return;
    for (const int node : quantity.nodes) {
        const auto index = static_cast<std::size_t>(node);
        const Vec3 start = base_.trial[index].theta;
        Vec3& theta = moved.trial[index].theta;
        Vec3 by_theta;
        for (Eigen::Index k = 0; k < 3; ++k) {
            by_theta[k] = differentiate([&](double amount) { theta[k] = start[k] + amount; }, part);
            theta = start;
        }
        transpose_turn(start, by_theta, by_end.nodes[index], before.nodes[index]);
    }
}

void MotionAdjoint::factorize_transposed(const Stage& step) {
    const System& system = centre_.system;
    if (hidden_) {
        values_ = hidden_->values();
    } else {
        sensitivities_.integrator().linearize(base_, step, workspace_.linearizations);
        system.compute_tangent(base_, base_.trial_time, workspace_.linearizations, values_);
    }
    workspace_.values = transpose_values(system.pattern(), values_);
    EquilibriumReport report;
    if (!factorize(system, workspace_, report))
        throw SensitivityError("the tangent of a step is singular: take a difference of whole runs");
}

void MotionAdjoint::find_multipliers(const Stage& step, const MotionGradient& by_equilibrium) {
    const System& system = centre_.system;
    MotionGradient rates = by_equilibrium, trial(base_), before(base_);
    leave_out_held_rates(system, rates);
    sensitivities_.integrator().transpose_rates(equilibrium(), step.time_step, rates, trial, before);
    std::vector<Vec6> nodal(base_.trial.size());
    for (std::size_t i = 0; i < nodal.size(); ++i) {
        const MotionGradient::OfNode& by = by_equilibrium.nodes[i];
        nodal[i] << by.r + trial.nodes[i].r, by.phi + trial.nodes[i].phi;
    }
    multipliers_ = gather(nodal, system.equations(), system.team());
    if (hidden_) {
        // Multipliers change by D (μ − G δ).
        Eigen::VectorXd rows = Eigen::VectorXd::Zero(multipliers_.size());
        put_rows(system, hidden_->by_multipliers(), rows);
        multipliers_ += multiply(system.pattern(), values_, rows);
        RowNumbers scaled = list_scales(system, values_);
        for (std::size_t i = 0; i < scaled.size(); ++i) scaled[i] *= hidden_->by_multipliers()[i];
        put_rows(system, scaled, multipliers_);
    }
    solve_transposed(system, values_, workspace_, multipliers_);
}

double MotionAdjoint::weigh(const Stage& step, VariedSystem& varied, const Weighed& what) {
    const System& system = varied.system;
    const State* state = &equilibrium();
    const double time = state->trial_time;
    const bool moves = system.supports().move();
    if (moves || hidden_ || what.start != nullptr) varied.state = *state;
    if (moves) {
        place_next_to(equilibrium(), time, varied);
        update_trial_rates(system, sensitivities_.integrator(), step, varied.state);
        state = &varied.state;
    }
    if (what.start != nullptr) {
        varied.state.memory = what.start->memory;
        varied.state.previous = what.start->previous;
        state = &varied.state;
    }
    system.compute_residual(*state, time, residual_);
    double sum = -multipliers_.dot(gather_residual(system, residual_, values_));
    if (hidden_) {
        sum += hidden_->weigh(step, system, base_, varied.state);
        state = &varied.state;
    }
    if (moves) sum += dot(later_, state->trial, base_.trial) + dot(later_, state->carried_trial);
    if (remembers_) {
        State end = *state;
        system.commit(end, time);
        sum += dot(memory_later_, end, committed_);
    }
    if (what.quantity != nullptr) sum += what.quantity->value(system, *state, what.number, what.side);
    return sum;
}

void MotionAdjoint::add_by_numbers(const Stage& step, const Quantity* quantity) {
    for (std::size_t i = 0; i < sensitivities_.count(); ++i) {
        const std::array<VariedSystem*, 4> sides = sensitivities_.by(i).sides();
        std::array<double, 4> values{};
        for (std::size_t k = 0; k < sides.size(); ++k)
            values[k] = weigh(step, *sides[k], {quantity, static_cast<int>(i), static_cast<int>(k)});
        const double near = (values[0] - values[1]) / (2.0 * sides[0]->amount);
        const double far = (values[2] - values[3]) / (2.0 * sides[2]->amount);
        by_numbers_[i] += (4.0 * near - far) / 3.0;
        if (!friction_.is_empty()) bends_[i].add(values, weigh(step, centre_, {quantity}));
    }
}

// (G9)
void MotionAdjoint::Bend::add(const std::array<double, 4>& values, double centre) {
    kinks += std::abs(values[2] + values[3] - 2.0 * centre - 4.0 * (values[0] + values[1] - 2.0 * centre));
    changes += std::abs(values[2] - values[3]);
}

// Friction at its limit has another derivative for each way that a number goes.
void MotionAdjoint::check_smoothness() const {
    constexpr double tolerable = 1e-6;
    for (const Bend& bend : bends_) {
        if (bend.kinks > tolerable * bend.changes)
            throw SensitivityError(
                "a derivative by multipliers does not exist, where friction reaches its limit: a kink; carry "
                "it along by `sensitivities`, or take another value of the number");
    }
}

// The input goes straight over the span; its ends are moved.
double MotionAdjoint::differentiate_by_input(const VariedInput& varied,
                                             const TimeSpan& span,
                                             const std::array<double, 2>& moves_ends,
                                             const std::function<double()>& function) {
    constexpr double part = 1e-3;
    Input& input = *centre_.system.model().inputs[varied.index];
    const InputState state = input.state();
    const double end = span.start + span.length;
    const double from = input(span.start), to = input(end);
    const double derivative = differentiate_at_zero(
        [&](double amount) {
            input.recall({1.0,
                          state.planned,
                          span.start,
                          from + moves_ends[0] * amount,
                          end,
                          to + moves_ends[1] * amount});
            centre_.system.forget_loads();
            return function();
        },
        part * varied.size);
    input.recall(state);
    centre_.system.forget_loads();
    return derivative;
}

void MotionAdjoint::add_by_inputs(const Stage& step, const Quantity* quantity) {
    const TimeSpan span{step.step_time, step.end_time - step.step_time};
    const auto function = [&] { return weigh(step, centre_, {quantity}); };
    by_inputs_.emplace_back(inputs_.size(), 0.0);
    std::vector<double>&at_end = by_inputs_[by_inputs_.size() - 2], &at_start = by_inputs_.back();
    for (std::size_t i = 0; i < inputs_.size(); ++i) {
        const Input& input = *centre_.system.model().inputs[inputs_[i].index];
        if (input.hold() == InputHold::step) {
            at_end[i] += differentiate_by_input(inputs_[i], span, {1.0, 1.0}, function);
            continue;
        }
        at_end[i] += differentiate_by_input(inputs_[i], span, {0.0, 1.0}, function);
        // The equilibrium is at the end; only rates of supports look back.
        if (centre_.system.supports().move())
            at_start[i] += differentiate_by_input(inputs_[i], span, {1.0, 0.0}, function);
    }
}

void MotionAdjoint::pass_back(const Stage& step,
                              const std::vector<Vec6>& xi,
                              const MotionGradient& by_equilibrium,
                              MotionGradient& before) {
    const System& system = centre_.system;
    const std::size_t count = base_.trial.size();
    RowNumbers p = take_rows(system, multipliers_);
    const RowNumbers scales = list_scales(system, values_);
    for (std::size_t i = 0; i < p.size(); ++i) p[i] *= scales[i];
    const auto transpose = [&](const NodeLinearization& by) {
        return products_.compute(equilibrium(), base_.trial_time, {}, by, xi, p);
    };
    const std::vector<Vec6> by_place = transpose({.placement = 1.0});
    MotionGradient rates = by_equilibrium;
    if (!sensitivities_.integrator().is_static()) {
        const std::vector<Vec6> by_rate = transpose({.rate = 1.0, .d_omega = Mat3::Identity()});
        const std::vector<Vec6> by_acceleration =
            transpose({.acceleration = 1.0, .d_alpha = Mat3::Identity()});
        for (std::size_t i = 0; i < count; ++i) {
            rates.nodes[i].v -= by_rate[i].head<3>();
            rates.nodes[i].omega -= by_rate[i].tail<3>();
            rates.nodes[i].a -= by_acceleration[i].head<3>();
            rates.nodes[i].alpha -= by_acceleration[i].tail<3>();
        }
    }
    leave_out_held_rates(system, rates);
    MotionGradient trial(base_);
    sensitivities_.integrator().transpose_rates(equilibrium(), step.time_step, rates, trial, before);
    for (std::size_t i = 0; i < count; ++i) {
        trial.nodes[i].r += by_equilibrium.nodes[i].r - by_place[i].head<3>();
        trial.nodes[i].phi += by_equilibrium.nodes[i].phi - by_place[i].tail<3>();
    }
    keep_held(system, equilibrium(), trial, before);
}

void MotionAdjoint::pass_back_memory(const Stage& step,
                                     const std::vector<Vec6>& xi,
                                     const Quantity* quantity,
                                     MotionGradient& before,
                                     MemoryGradient& memory_before) {
    const double time = base_.trial_time;
    memory_.add_by_memory(equilibrium(), time, xi, memory_later_, memory_before, before);
    if (hidden_) hidden_->subtract_by_memory(step, base_, memory_, memory_before, before);
    friction_.add_by_start(
        base_,
        time,
        [&](const State& start) { return weigh(step, centre_, {.quantity = quantity, .start = &start}); },
        memory_before,
        before);
}

void MotionAdjoint::end(const Quantity* quantity) {
    check_smoothness();
    const System& system = centre_.system;
    for (std::size_t i = 0; i < sensitivities_.count(); ++i) {
        const ForwardSensitivity& by = sensitivities_.by(i);
        if (!later_.nodes.empty())
            by_numbers_[i] += dot(later_, by.direction()) + dot(memory_later_, by.direction());
        if (quantity == nullptr) continue;
        by_numbers_[i] += by.differentiate([&](const System& one, const State& state, std::size_t side) {
            return std::vector{quantity->value(one, state, static_cast<int>(i), static_cast<int>(side))};
        })[0];
    }
    const auto start = [&] {
        State& state = centre_.state;
        state = system.initial_state();
        system.supports().place(0.0, state);
        system.joints().start(state);
        State ended;
        start_system(system, start_, state, ended);
        double sum = quantity != nullptr ? quantity->value(system, ended, -1, -1) : 0.0;
        if (!later_.nodes.empty())
            sum += dot(later_, state.previous, base_.previous) + dot(later_, state.carried_previous) +
                   dot(memory_later_, state, base_);
        return sum;
    };
    for (std::size_t i = 0; i < inputs_.size(); ++i)
        by_inputs_.back()[i] += differentiate_by_input(inputs_[i], {0.0, 0.0}, {1.0, 1.0}, start);
}

}  // namespace gxrod
