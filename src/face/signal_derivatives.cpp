#include "face/signal_derivatives.hpp"

#include <fmt/format.h>

#include <Eigen/QR>
#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "assembly/contact/contacts.hpp"
#include "face/derivatives.hpp"
#include "model/settings/analysis_traits.hpp"
#include "sensitivity/sensitivity_error.hpp"

namespace gxrod {
namespace {

std::size_t find_quantity_of(const HistoryRequest& request, const SignalPlan::Measure& measure) {
    const auto found = std::ranges::find(request.quantities, measure.quantity);
    return static_cast<std::size_t>(found - request.quantities.begin());
}

// The next guess of x where f(x) = x, f affine, from all trials: of the affine combinations of these the one
// whose f(x) − x is least. Exact after as many trials as x has numbers, and one.
std::vector<double> guess_next(const std::vector<std::vector<double>>& tried,
                               const std::vector<std::vector<double>>& found,
                               const std::vector<double>& scales) {
    const auto rows = static_cast<Eigen::Index>(scales.size());
    const auto columns = static_cast<Eigen::Index>(tried.size()) - 1;
    const auto rest = [&](std::size_t trial, std::size_t i) {
        return (found[trial][i] - tried[trial][i]) / scales[i];
    };
    const std::size_t last = tried.size() - 1;
    std::vector<double> next = found[last];
    if (columns == 0) return next;
    Eigen::MatrixXd matrix(rows, columns);
    Eigen::VectorXd right(rows);
    for (Eigen::Index i = 0; i < rows; ++i) {
        const auto row = static_cast<std::size_t>(i);
        right[i] = -rest(last, row);
        for (Eigen::Index k = 0; k < columns; ++k)
            matrix(i, k) = rest(static_cast<std::size_t>(k), row) - rest(last, row);
    }
    const Eigen::VectorXd parts = matrix.completeOrthogonalDecomposition().solve(right);
    for (std::size_t i = 0; i < next.size(); ++i) {
        for (Eigen::Index k = 0; k < columns; ++k)
            next[i] += parts[k] * (found[static_cast<std::size_t>(k)][i] - found[last][i]);
    }
    return next;
}

}  // namespace

SignalDerivatives::SignalDerivatives(const SteppedRun& run, const std::vector<VariedNumber>& variations)
    : run_(run), variations_(variations), plans_(list_signals(run.problem())) {
    const std::vector<HistoryRequest>& histories = run.problem().output.histories;
    for (const SignalPlan* plan : plans_) {
        std::size_t& quantity = quantities_.emplace_back(0);
        if (!plan->measure) continue;
        const HistoryRequest& request = histories[plan->measure->history];
        quantity = find_quantity_of(request, *plan->measure);
        if (part_of(*quantities_of(request)[quantity]) == SnapshotPart::reactions &&
            Contacts(run.analysis().system()).are_impulses())
            throw std::invalid_argument(
                fmt::format("signal {} measures a reaction, which has no derivative where contact is an "
                            "impulse of a step; let it measure the force in the rod next to the support",
                            plan->name));
    }
    for (const VariedNumber& variation : variations_) {
        std::vector<std::array<const SignalPlan*, 4>>& varied = varied_.emplace_back(plans_.size());
        for (std::size_t side = 0; side < 4; ++side) {
            const std::vector<const SignalPlan*> plans = list_signals(variation.problems[side]);
            for (std::size_t i = 0; i < plans.size(); ++i) varied[i][side] = plans[i];
        }
    }
    rates_.assign(variations_.size(), std::vector<Rates>(plans_.size()));
    pieces_.resize(plans_.size());
    end_pieces_.resize(plans_.size());
    ends_.resize(plans_.size());
}

void SignalDerivatives::follow(Sensitivities& carried) {
    carried_ = &carried;
    carried.set_inputs(this);
}

SignalDerivatives::Base SignalDerivatives::note_base() const {
    const double time = run_.analysis().state().time;
    Base base{{time, run_.stages().axis_start() + time}, run_.signal_states(), {}};
    for (const SignalPlan* plan : plans_) base.inputs.push_back(plan->input->state());
    return base;
}

void SignalDerivatives::note_before() { before_ = note_base(); }

void SignalDerivatives::begin_stage() {
    for (std::vector<Rates>& rates : rates_) {
        for (Rates& one : rates) one.from = one.to;
    }
    place_all(note_base().inputs);
}

bool SignalDerivatives::has_acted(std::size_t signal) const {
    const SignalState& state = before_.states[signal];
    return is_timed(run_.stages().settings()) &&
           (state.is_started == 0.0 || state.time != before_.times.axis);
}

bool SignalDerivatives::has_continuous() const {
    return is_timed(run_.stages().settings()) &&
           std::ranges::any_of(plans_, [](const SignalPlan* plan) { return plan->is_continuous; });
}

SignalState SignalDerivatives::move(const SignalState& state, const Rates& rates, double amount) {
    SignalState moved = state;
    moved.measured += amount * rates.measured;
    moved.filtered += amount * rates.filtered;
    moved.integral += amount * rates.integral;
    return moved;
}

void SignalDerivatives::place(std::size_t number,
                              std::size_t side,
                              const std::vector<InputState>& inputs) const {
    const VariedSystem& varied = *carried_->by(number).sides()[side];
    for (std::size_t i = 0; i < plans_.size(); ++i) {
        Input& input = *varied_[number][i][side]->input;
        InputState state = inputs[i];
        state.planned = input.state().planned;
        state.from += varied.amount * rates_[number][i].from;
        state.to += varied.amount * rates_[number][i].to;
        input.recall(state);
    }
    varied.system.forget_loads();
}

void SignalDerivatives::place_all(const std::vector<InputState>& inputs) const {
    for (std::size_t number = 0; number < variations_.size(); ++number) {
        for (std::size_t side = 0; side < 4; ++side) place(number, side, inputs);
    }
}

double SignalDerivatives::differentiate(std::size_t number, const std::array<double, 4>& values) const {
    const double step = variations_[number].step;
    const double near = (values[0] - values[1]) / (2.0 * step);
    const double far = (values[2] - values[3]) / (4.0 * step);
    return (4.0 * near - far) / 3.0;
}

// As ForwardSensitivity::check_smoothness.
void SignalDerivatives::check_smoothness(std::size_t number,
                                         std::size_t signal,
                                         const std::array<double, 4>& values,
                                         double centre) {
    constexpr double tolerable = 1e-4;  // of the derivative
    constexpr double round_off = 1e-10;
    const double far = values[2] + values[3] - 2.0 * centre, near = values[0] + values[1] - 2.0 * centre;
    const double kink = std::abs(far - 4.0 * near);
    double size = std::abs(centre);
    for (const double value : values) size = std::max(size, std::abs(value));
    const double change = std::max(std::abs(values[0] - values[1]), std::abs(values[2] - values[3]));
    if (kink <= std::max(tolerable * change, round_off * size)) return;
    carried_->by(number).end(
        fmt::format("it does not exist from t = {:.6g} on, where signal {} has a kink or jumps; take another "
                    "value of the number, or a difference of whole runs",
                    run_.time(),
                    plans_[signal]->name));
}

// At the ends of the last step, or at the start.
void SignalDerivatives::measure() {
    for (std::size_t number = 0; number < variations_.size(); ++number) {
        const std::array<VariedSystem*, 4> sides = carried_->by(number).sides();
        for (std::size_t i = 0; i < plans_.size(); ++i) {
            if (!plans_[i]->measure) continue;
            const SignalPlan::Measure& measure = *plans_[i]->measure;
            std::array<double, 4> values{};
            for (std::size_t side = 0; side < 4; ++side)
                values[side] = compute_history(variations_[number].problems[side],
                                               sides[side]->system,
                                               sides[side]->ended,
                                               measure.history,
                                               quantities_[i])[measure.column];
            rates_[number][i].measured = differentiate(number, values);
        }
    }
}

std::vector<SignalDerivatives::Rates> SignalDerivatives::act_on(std::size_t number,
                                                                std::size_t side,
                                                                const Base& after) {
    place(number, side, before_.inputs);
    const double amount = carried_->by(number).sides()[side]->amount;
    std::vector<Rates> values;
    for (std::size_t i = 0; i < plans_.size(); ++i) {
        const SignalPlan& plan = *varied_[number][i][side];
        SignalState state = move(before_.states[i], rates_[number][i], amount);
        if (has_acted(i)) {
            const double time = before_.times.stage;
            const double value = compute_signal(plan, before_.times, state, pieces_[i]);
            if (plan.is_continuous) {
                const double from = before_.inputs[i].is_set != 0.0 ? (*plan.input)(time) : value;
                plan.input->lead(time, from, time, from);
            } else {
                plan.input->set(value, time, after.inputs[i].to_time);
            }
        }
        const InputState course = plan.input->state();
        values.push_back({state.measured, state.filtered, state.integral, course.from, course.to});
    }
    return values;
}

// (G23)
void SignalDerivatives::act() {
    const Base after = note_base();
    std::vector<SignalState> states = before_.states;
    for (std::size_t i = 0; i < plans_.size(); ++i) {
        pieces_[i].reset();
        if (has_acted(i)) compute_signal(*plans_[i], before_.times, states[i], pieces_[i]);
    }
    for (std::size_t number = 0; number < variations_.size(); ++number) {
        RatesOfSides sides;
        for (std::size_t side = 0; side < 4; ++side) sides[side] = act_on(number, side, after);
        for (std::size_t i = 0; i < plans_.size(); ++i) {
            const auto values_of = [&](double Rates::*part) {
                return std::array{sides[0][i].*part, sides[1][i].*part, sides[2][i].*part, sides[3][i].*part};
            };
            Rates& rates = rates_[number][i];
            const double slope = rates.to - rates.from;
            if (!plans_[i]->is_continuous && has_acted(i))
                check_smoothness(number, i, values_of(&Rates::to), after.inputs[i].to);
            for (double Rates::*part : {&Rates::filtered, &Rates::integral, &Rates::from, &Rates::to})
                rates.*part = differentiate(number, values_of(part));
            // It goes on as it went before.
            if (plans_[i]->is_continuous && has_acted(i)) rates.to = rates.from + slope;
        }
    }
    trials_.assign(variations_.size(), {});
    place_all(after.inputs);
}

std::vector<double> SignalDerivatives::find_ends(std::size_t number,
                                                 std::size_t side,
                                                 const Base& after) const {
    const double amount = carried_->by(number).sides()[side]->amount;
    std::vector<double> ends(plans_.size(), 0.0);
    for (std::size_t i = 0; i < plans_.size(); ++i) {
        const SignalPlan& plan = *varied_[number][i][side];
        if (!plan.is_continuous) continue;
        SignalState state = move(after.states[i], rates_[number][i], amount);
        std::optional<SignalPiece> piece = end_pieces_[i];
        ends[i] = compute_signal(plan, after.times, state, piece);
        const InputState course = plan.input->state();
        const double end = ends[i] - (ends_[i] - after.inputs[i].to);
        plan.input->lead(course.from_time, course.from, course.to_time, end);
    }
    return ends;
}

// (G25)
bool SignalDerivatives::follow_number(std::size_t number, const Base& after) {
    constexpr double met = 1e-9;
    constexpr double round_off = 1e-13;
    Trials& trials = trials_[number];
    if (trials.is_done || !carried_->by(number).kink().empty()) return false;
    std::array<std::vector<double>, 4> ends;
    for (std::size_t side = 0; side < 4; ++side) ends[side] = find_ends(number, side, after);
    std::vector<double> tried, found, scales;
    bool is_met = true;
    for (std::size_t i = 0; i < plans_.size(); ++i) {
        const std::array<double, 4> values{ends[0][i], ends[1][i], ends[2][i], ends[3][i]};
        tried.push_back(plans_[i]->is_continuous ? rates_[number][i].to : 0.0);
        found.push_back(differentiate(number, values));
        const double floor = round_off * after.states[i].largest / variations_[number].step;
        scales.push_back(std::max({met * std::abs(found[i]), floor, std::numeric_limits<double>::min()}));
        is_met = is_met && std::abs(found[i] - tried[i]) <= scales[i];
        if (plans_[i]->is_continuous) check_smoothness(number, i, values, ends_[i]);
    }
    trials.is_done = is_met;
    if (is_met) return false;
    trials.ends.push_back(tried);
    trials.found.push_back(found);
    if (trials.ends.size() > plans_.size() + 5)
        throw SensitivityError(fmt::format(
            "the derivative of the continuous signals cannot be found at t = {:.6g}: take shorter "
            "steps or smaller gains",
            run_.time()));
    const std::vector<double> next = guess_next(trials.ends, trials.found, scales);
    for (std::size_t i = 0; i < plans_.size(); ++i) {
        if (plans_[i]->is_continuous) rates_[number][i].to = next[i];
    }
    return true;
}

bool SignalDerivatives::follow() {
    measure();
    if (!has_continuous()) return false;
    const Base after = note_base();
    for (std::size_t i = 0; i < plans_.size(); ++i) {
        SignalState state = after.states[i];
        end_pieces_[i].reset();
        if (plans_[i]->is_continuous)
            ends_[i] = compute_signal(*plans_[i], after.times, state, end_pieces_[i]);
    }
    bool has_changed = false;
    for (std::size_t number = 0; number < variations_.size(); ++number)
        has_changed = follow_number(number, after) || has_changed;
    place_all(after.inputs);
    return has_changed;
}

std::vector<double> SignalDerivatives::record() const {
    std::vector<double> record;
    for (const std::vector<Rates>& rates : rates_) {
        for (const Rates& one : rates)
            record.insert(record.end(), {one.measured, one.filtered, one.integral, one.from, one.to});
    }
    return record;
}

void SignalDerivatives::recall(const std::vector<double>& record) {
    auto next = record.begin();
    for (std::vector<Rates>& rates : rates_) {
        for (Rates& one : rates) {
            for (double Rates::*part :
                 {&Rates::measured, &Rates::filtered, &Rates::integral, &Rates::from, &Rates::to})
                one.*part = *next++;
        }
    }
    place_all(note_base().inputs);
}

}  // namespace gxrod
