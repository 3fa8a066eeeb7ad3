#pragma once

#include <array>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "model.hpp"
#include "run/stepped_run.hpp"
#include "sensitivity/sensitivities.hpp"
#include "state_views.hpp"
#include "watch/history_watch.hpp"

namespace gxrod::python {

class Driven;

// A checkpoint with the derivatives there, for the simulation that has them.
struct SavedState : RunCheckpoint {
    std::shared_ptr<const Sensitivities::Record> derivatives = {};
    const Driven* owner = nullptr;
};

// A simulation with all that it refers to.
class Driven {
  public:
    // What is kept in memory of each accepted step.
    struct Kept {
        bool ledger = true;
        std::vector<std::size_t> histories = {};
    };

    // Models for the derivatives by a number: for it plus and minus a step, plus and minus twice the step.
    struct Varied {
        std::array<const BuiltModel*, 4> models;
        double step;
    };

    // Writes to a results file if `results` is not empty.
    Driven(const BuiltModel& model,
           const std::string& results,
           int threads,
           Kept kept,
           const std::vector<Varied>& varied);

    SteppedRun& simulation() { return *simulation_; }
    const SteppedRun& simulation() const { return *simulation_; }
    const Problem& problem() const { return problem_; }
    StateViews& views() { return views_; }
    const std::vector<NodeMotion>& nodes() const { return simulation_->analysis().state().previous; }

    bool start();
    bool step();
    // Until the time is reached exactly, or so many steps are done, or the run ends; the number of steps.
    long advance(std::optional<double> until, long most_steps);
    SavedState save() const;
    void restore(const SavedState& saved);

    // A quantity of a history at the accepted state: so many numbers.
    std::vector<double> compute_history(std::size_t history, std::size_t quantity);
    // Names of the quantities of a history.
    std::vector<std::string> list_quantities(std::size_t history) const;

    // The derivative of a quantity of a history by a number. Throws std::logic_error if it is not known:
    // after a return to a state that was saved without it.
    std::vector<double> differentiate_history(std::size_t number, std::size_t history, std::size_t quantity);

    // A quantity of a history, and what its numbers count.
    struct Weighted {
        std::size_t history, quantity;
        std::vector<double> weights;
    };
    // Derivatives of a weighted sum at the accepted equilibrium, by multipliers. Throws std::invalid_argument
    // for what has none.
    std::vector<double> find_gradient(const std::vector<Weighted>& sum, const std::vector<Varied>& varied);

    // Of each accepted step, the start included: times, quantities of a history, ledgers.
    const std::vector<double>& times() const { return times_; }
    const std::vector<double>& records(std::size_t history, std::size_t quantity) const {
        return histories_.at(history).records.at(quantity);
    }
    int width(std::size_t history, std::size_t quantity) const {
        return histories_.at(history).quantities.at(quantity)->columns;
    }
    const std::vector<LedgerRow>& ledgers() const { return ledgers_; }

  private:
    struct Recorded {
        HistoryWatch watch;
        std::vector<const Quantity*> quantities;
        std::vector<std::vector<double>> records;  // of its quantities
    };

    // One step, with what is carried along; false if there is none.
    bool take_step();
    // The nodes on whose motion a history depends.
    std::vector<int> list_nodes(std::size_t history) const;
    // A quantity of a history of a problem with the histories of this one, at trial motions.
    std::vector<double> compute_at(const Problem& problem,
                                   const System& system,
                                   const State& state,
                                   std::size_t history,
                                   std::size_t quantity) const;
    // An accepted state, as the run records it.
    void note(const Snapshot& snapshot, const LedgerRow& ledger);
    void compute(std::size_t history,
                 std::size_t quantity,
                 const Snapshot& snapshot,
                 std::vector<double>& to);

    Problem problem_;
    std::unique_ptr<SteppedRun> simulation_;
    StateViews views_;
    std::vector<Recorded> histories_;
    Kept kept_;
    std::vector<std::unique_ptr<const Problem>> varied_;
    std::unique_ptr<Sensitivities> sensitivities_;
    bool has_derivatives_ = true;  // of the state at hand
    std::vector<double> times_;
    std::vector<LedgerRow> ledgers_;
};

}  // namespace gxrod::python
