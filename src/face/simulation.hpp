#pragma once

#include <filesystem>
#include <limits>
#include <map>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "assembly/state_matrices.hpp"
#include "face/sweep.hpp"
#include "face/value.hpp"
#include "linear/sparse_pattern.hpp"
#include "model/problem.hpp"
#include "run/stepped_run.hpp"
#include "watch/history_watch.hpp"

namespace gxrod {

// An accepted state to return to: Simulation::save makes it, Simulation::restore returns to it.
struct Checkpoint : RunCheckpoint {
    // Derivatives there, for the simulation that has them.
    std::shared_ptr<const Sensitivities::Record> derivatives = {};
    const Simulation* owner = nullptr;

    double time() const { return record.axis_start + record.steps.time; }
};

// The matrices of small motions, and the pattern that they share: that of the system, and of rods that touch.
struct SmallMotionMatrices {
    SparsePattern pattern;
    StateMatrices values;
};

// A quantity of a history, by index in the deck's histories and in the history's quantities.
struct RecordedQuantity {
    std::size_t history;
    std::size_t quantity;
};

// A run of a problem, step by step through all its stages:
//
//     gxrod::Simulation run(gxrod::Deck("swing.toml").build());
//     double lowest = run["tip"].position.y();
//     while (run.step()) lowest = std::min(lowest, run["tip"].position.y());
//
// It starts at t = 0, with the accepted state there. Simulations share nothing: each can have a thread of its
// own.
class Simulation {
  public:
    struct Options {
        std::filesystem::path results = {};  // the results file to write; none if empty
        int threads = 1;                     // that share the work of a step; they change no result
        // Names of histories, and "ledger": what is kept in memory of each step. Without it, all of them.
        std::optional<std::vector<std::string>> record = {};
        // Numbers of the deck by which derivatives are carried along.
        std::vector<VariedNumber> sensitivities = {};
    };

    // Builds the system and finds the state at t = 0. Throws ConvergenceError or EvaluationError if it cannot
    // start, UnknownNameError if a history to keep is not there, FileError if the file cannot be written.
    explicit Simulation(Problem&& problem) : Simulation(std::move(problem), Options{}) {}
    Simulation(Problem&& problem, Options options);
    // Completes the results file, as `close` does.
    virtual ~Simulation();
    Simulation(const Simulation&) = delete;
    Simulation& operator=(const Simulation&) = delete;

    // Takes the next accepted step. False if the run is at its end. Throws ConvergenceError if the step
    // fails, EvaluationError if a function of the deck gives no number; the state stays the last accepted
    // one.
    bool step();
    // Steps until a time is reached exactly, or so many steps are done, or the run ends. Returns the number
    // of steps. Throws as `step` does.
    long advance(std::optional<double> until, long most_steps = std::numeric_limits<long>::max());
    // Steps to the end of the run.
    const RunSummary& run();
    // Ends the run as one that was interrupted.
    void interrupt();
    // Ends the run, and completes the summary and the results file.
    void close() { run_->close(); }

    // Returns the time of the last accepted step, on the axis that stages share; in statics the load factor.
    double time() const { return run_->time(); }
    // Returns where the next step ends if it is not cut.
    double next_time() const;
    bool finished() const { return run_->has_ended(); }
    // Returns the name of the current stage; "" without [[stage]].
    std::string stage() const { return run_->stages().name(); }
    const RunSummary& summary() const { return run_->summary(); }
    const Problem& problem() const { return problem_; }

    // Returns what the [[history]] of this name records, at the last accepted state. Throws UnknownNameError.
    Values operator[](const std::string& history);
    // Returns the motions of all nodes at the last accepted state, valid until the next step.
    std::span<const NodeMotion> nodes() const { return run_->analysis().state().previous; }
    // Returns energies and momenta at the last accepted state.
    LedgerRow ledger() const { return run_->analysis().ledger_row(); }
    const SolverRow& last_step() const { return run_->analysis().solver_row(); }
    // Computes stiffness, damping and mass about the last accepted state.
    SmallMotionMatrices matrices() const;

    // Sets an input of the deck; it counts from the next step on. One that holds "linear" has the value at
    // the end of that step, or of that `advance`. Throws UnknownNameError, std::invalid_argument if it is not
    // finite.
    void set(const std::string& input, double value);
    double input(const std::string& name) const;

    // Saves the last accepted state. Throws std::logic_error on a path that has met critical points.
    Checkpoint save() const;
    // Returns to a state that a simulation of the same deck has saved; all that follows is equal to the last
    // bit. Throws std::invalid_argument if it is of another model, std::logic_error if this one writes
    // results.
    void restore(const Checkpoint& checkpoint);

    // Return quantities of histories by index, and what was kept of each step, t = 0 included.
    std::vector<std::string> list_quantities(std::size_t history) const;
    std::vector<double> compute(std::size_t history, std::size_t quantity);
    // Computes several quantities at the last accepted state, one after the other.
    std::vector<double> compute(const std::vector<RecordedQuantity>& quantities);
    int width(std::size_t history, std::size_t quantity) const {
        return histories_.at(history).quantities.at(quantity)->columns;
    }
    const std::vector<double>& records(std::size_t history, std::size_t quantity) const {
        return histories_.at(history).records.at(quantity);
    }
    const std::vector<double>& times() const { return times_; }
    const std::vector<LedgerRow>& ledgers() const { return ledgers_; }
    // Returns the numbers of a quantity of all steps, one step after the other.
    const std::vector<double>& records(const std::string& history, const std::string& quantity) const;

    // Return the names of the numbers by which derivatives are carried along, and a derivative by one of
    // them.
    std::vector<std::string> numbers() const;
    std::vector<double> differentiate(std::size_t number, std::size_t history, std::size_t quantity) const;

    // Finds derivatives by multipliers: of an equilibrium as find_gradient; of what was recorded as
    // sweep_back, for inputs by their names, too. Throws as these do, and UnknownNameError.
    SweptGradient find_gradient(const std::vector<WeightedQuantity>& sum,
                                const std::vector<VariedNumber>& variations,
                                const std::vector<std::string>& inputs = {}) const;

    // Returns the run itself, for all that has no name here.
    SteppedRun& stepped_run() { return *run_; }
    const SteppedRun& stepped_run() const { return *run_; }

  private:
    struct Recorded {
        HistoryWatch watch;
        std::vector<const Quantity*> quantities;
        std::vector<std::vector<double>> records;  // of its quantities
    };

    void add_histories();
    void choose_records(const std::optional<std::vector<std::string>>& names);
    void set_inputs(double until);
    bool take_step(std::optional<double> landing = std::nullopt);
    void complete();
    void throw_if_failed() const;
    // Keeps what is asked for of an accepted state.
    void note(const Snapshot& snapshot, const LedgerRow& ledger);
    void add_row(std::size_t history,
                 std::size_t quantity,
                 const Snapshot& snapshot,
                 std::vector<double>& to);

    Problem problem_;
    bool writes_;
    std::unique_ptr<SteppedRun> run_;
    std::unique_ptr<Derivatives> derivatives_;  // nullptr without sensitivities
    std::vector<Recorded> histories_;
    bool keeps_ledger_ = true;
    std::vector<std::size_t> kept_;  // histories
    std::vector<double> times_;
    std::vector<LedgerRow> ledgers_;
    std::vector<StepCall> calls_;            // of all steps
    std::map<std::string, double> pending_;  // inputs, until the next step
};

}  // namespace gxrod
