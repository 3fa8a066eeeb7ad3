#include "face/sweep.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "model/settings/analysis_traits.hpp"
#include "sensitivity/motion_adjoint.hpp"

namespace gxrod {
namespace {

// The sum, state by state; rows are accepted states, the start first.
class RecordedSum {
  public:
    RecordedSum(const Problem& base,
                const std::vector<WeightedQuantity>& sum,
                const std::vector<VariedNumber>& variations,
                std::size_t rows)
        : base_(base), sum_(sum), variations_(variations), last_(rows - 1) {
        nodes_ = list_nodes(base, sum);
        for (const WeightedQuantity& one : sum) {
            const HistoryRequest& request = base.output.histories.at(one.history);
            const auto width = static_cast<std::size_t>(quantities_of(request).at(one.quantity)->columns);
            widths_.push_back(width);
            if (one.weights.size() != width && one.weights.size() != width * rows)
                throw std::invalid_argument("weights of history " + request.name + " are for " +
                                            std::to_string(one.weights.size() / width) + " states of " +
                                            std::to_string(rows));
        }
    }

    // What a state adds; nothing if it has no weight.
    std::optional<MotionAdjoint::Quantity> at(std::size_t row) const {
        bool counts = false;
        for (std::size_t i = 0; i < sum_.size(); ++i) {
            const double* weights = weights_of(i, row);
            counts =
                counts || (weights != nullptr &&
                           std::any_of(weights, weights + widths_[i], [](double w) { return w != 0.0; }));
        }
        if (!counts) return std::nullopt;
        return MotionAdjoint::Quantity{
            nodes_, [this, row](const System& system, const State& state, int number, int side) {
                return add_up(row, system, state, number, side);
            }};
    }

  private:
    const double* weights_of(std::size_t index, std::size_t row) const {
        const std::vector<double>& weights = sum_[index].weights;
        if (weights.size() == widths_[index]) return row == last_ ? weights.data() : nullptr;
        return weights.data() + row * widths_[index];
    }

    double add_up(std::size_t row, const System& system, const State& state, int number, int side) const {
        const Problem& problem =
            number < 0
                ? base_
                : variations_[static_cast<std::size_t>(number)].problems[static_cast<std::size_t>(side)];
        double total = 0.0;
        for (std::size_t i = 0; i < sum_.size(); ++i) {
            const double* weights = weights_of(i, row);
            if (weights == nullptr) continue;
            const std::vector<double> values =
                compute_history(problem, system, state, sum_[i].history, sum_[i].quantity);
            for (std::size_t k = 0; k < values.size(); ++k) total += weights[k] * values[k];
        }
        return total;
    }

    const Problem& base_;
    const std::vector<WeightedQuantity>& sum_;
    const std::vector<VariedNumber>& variations_;
    std::size_t last_;
    std::vector<std::size_t> widths_;
    std::vector<int> nodes_;
};

// Repeats the steps of a run, from any of the states that it keeps on its first way.
class Replay {
  public:
    Replay(const SteppedRun& run, const std::vector<StepCall>& calls)
        : original_(run), calls_(calls), run_(RunRequest{run.problem()}) {
        for (const std::shared_ptr<Input>& input : inputs()) states_.push_back(input->state());
        set_inputs(nullptr);
    }
    ~Replay() {
        set_inputs(&states_);
        original_.analysis().system().forget_loads();
    }
    Replay(const Replay&) = delete;

    SteppedRun& run() { return run_; }
    void start() {
        if (!run_.start()) throw std::runtime_error("the start of the run cannot be repeated");
    }
    // Takes all steps, and keeps the state before each `stride` of them.
    void go(std::size_t stride) {
        stride_ = stride;
        for (std::size_t step = 0; step < calls_.size(); ++step) {
            if (step % stride_ == 0) {
                points_.push_back(run_.save());
                begin(step);
            }
            take(step);
        }
        const std::vector<NodeMotion>& here = run_.analysis().state().previous;
        const std::vector<NodeMotion>& there = original_.analysis().state().previous;
        const auto equal = [](const NodeMotion& a, const NodeMotion& b) {
            return a.r == b.r && a.Lambda.coeffs() == b.Lambda.coeffs() && a.v == b.v;
        };
        if (run_.time() != original_.time() || !std::ranges::equal(here, there, equal))
            throw std::runtime_error(
                "the steps of the run cannot be repeated: it has returned to a state that another run saved, "
                "or "
                "that it saved before others");
    }
    // Goes back over a step, the last one first.
    void step_back(std::size_t step, MotionAdjoint& adjoint, const MotionAdjoint::Quantity* quantity) {
        if (step < first_) {
            const std::size_t point = step / stride_;
            run_.restore(points_[point]);
            begin(point * stride_);
            while (first_ + steps_.size() <= step) take(first_ + steps_.size());
        }
        set_inputs(&calls_[step].inputs);
        const std::size_t index = step - first_;
        adjoint.step_back(steps_[index], states_before_[index], states_before_[index + 1], quantity);
    }
    void end(MotionAdjoint& adjoint, const MotionAdjoint::Quantity* quantity) {
        set_inputs(nullptr);
        adjoint.end(quantity);
    }

  private:
    const std::vector<std::shared_ptr<Input>>& inputs() const { return original_.problem().model.inputs; }
    // The values of the deck without any.
    void set_inputs(const std::vector<InputState>* states) {
        for (std::size_t i = 0; i < inputs().size(); ++i) {
            InputState planned;
            planned.planned = inputs()[i]->state().planned;
            inputs()[i]->recall(states != nullptr ? (*states)[i] : planned);
        }
        run_.analysis().system().forget_loads();
    }
    void begin(std::size_t step) {
        first_ = step;
        steps_.clear();
        states_before_.clear();
        keep();
    }
    void keep() {
        State& kept = states_before_.emplace_back(run_.analysis().state());
        kept.trial.clear();
        kept.trial.shrink_to_fit();
    }
    void take(std::size_t step) {
        set_inputs(&calls_[step].inputs);
        if (calls_[step].landing) run_.land_on(*calls_[step].landing);
        if (!run_.step()) throw std::runtime_error("a step of the run cannot be repeated");
        if (run_.analysis().settled() != nullptr)
            throw std::invalid_argument(
                "actions that begin at once without inertia cannot be gone back through by multipliers yet: "
                "carry derivatives along instead, by `sensitivities`");
        steps_.push_back(run_.analysis().last_stage());
        keep();
    }

    const SteppedRun& original_;
    const std::vector<StepCall>& calls_;
    SteppedRun run_;
    std::vector<InputState> states_;
    std::size_t stride_ = 1;
    std::vector<RunCheckpoint> points_;
    // Of the steps since the last of these.
    std::size_t first_ = 0;
    std::vector<Stage> steps_;
    std::vector<State> states_before_;
};

// The largest value of an input in a run; 1 if it is always zero.
double find_size(const std::vector<StepCall>& calls, std::size_t input) {
    double size = 0.0;
    for (const StepCall& call : calls) {
        const InputState& state = call.inputs[input];
        size = std::max({size, std::abs(state.planned), std::abs(state.from), std::abs(state.to)});
    }
    return size > 0.0 ? size : 1.0;
}

}  // namespace

SweptGradient sweep_back(const SteppedRun& run,
                         const std::vector<StepCall>& calls,
                         const std::vector<WeightedQuantity>& sum,
                         const std::vector<VariedNumber>& variations,
                         const std::vector<std::size_t>& inputs) {
    const Problem& problem = run.problem();
    if (problem.stages.size() > 1)
        throw std::invalid_argument(
            "runs of several stages cannot be gone back through by multipliers yet: carry derivatives along "
            "instead, by `sensitivities`");
    Sensitivities::check_settings(problem.analysis());
    const RecordedSum recorded(problem, sum, variations, calls.size() + 1);
    std::vector<VariedModels> models;
    for (const VariedNumber& one : variations) models.push_back(one.models());
    std::vector<MotionAdjoint::VariedInput> varied_inputs;
    for (const std::size_t input : inputs) varied_inputs.push_back({input, find_size(calls, input)});

    Replay replay(run, calls);
    replay.start();
    MotionAdjoint adjoint(replay.run().analysis(), problem.analysis(), models, varied_inputs);
    const auto root = static_cast<std::size_t>(std::ceil(std::sqrt(static_cast<double>(calls.size()))));
    replay.go(std::max(root, std::size_t{1}));
    for (std::size_t step = calls.size(); step-- > 0;) {
        const auto quantity = recorded.at(step + 1);
        replay.step_back(step, adjoint, quantity ? &*quantity : nullptr);
    }
    const auto quantity = recorded.at(0);
    replay.end(adjoint, quantity ? &*quantity : nullptr);
    return {adjoint.by_numbers(), adjoint.by_inputs()};
}

}  // namespace gxrod
