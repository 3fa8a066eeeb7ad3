#pragma once

#include <exception>
#include <memory>
#include <string>
#include <vector>

#include "face/variation.hpp"
#include "run/stepped_run.hpp"
#include "sensitivity/sensitivities.hpp"

namespace gxrod {

class SignalDerivatives;

// Computes a quantity of a history of `problem` from a system and its trial motions.
std::vector<double> compute_history(const Problem& problem,
                                    const System& system,
                                    const State& state,
                                    std::size_t history,
                                    std::size_t quantity);

// Derivatives of histories by numbers of the deck, carried along from step to step.
class Derivatives {
  public:
    // `run` must outlive it, and so must its problem. Throws std::invalid_argument if the run has none.
    Derivatives(const SteppedRun& run, std::vector<VariedNumber> variations);
    ~Derivatives();

    void start();
    // Must be called before each step, and after it has been accepted.
    void note_before();
    void advance();
    // Must be called when the run has entered another stage, before its first step. If there is no derivative
    // at its start, the next advance throws what this has found.
    void enter_stage();

    std::vector<std::string> numbers() const;
    // Throws std::logic_error after a return to a state that was saved without derivatives.
    std::vector<double> differentiate(std::size_t number, std::size_t history, std::size_t quantity) const;

    // Returns a record to return to, nullptr if the derivatives are not known.
    std::shared_ptr<const Sensitivities::Record> save() const;
    // Follows the run to a state to which it has returned; without a record, derivatives are not known there.
    void restore(const Sensitivities::Record* record);

  private:
    // The derivatives of one stage; after the first stage the models have the actions of theirs.
    struct OfStage {
        std::size_t stage = 0;
        std::vector<std::unique_ptr<Model>> models;
        std::unique_ptr<Sensitivities> carried;
    };
    // Makes derivatives of the stage at hand, not started yet.
    OfStage build() const;
    // Makes derivatives of a stage those at hand.
    void take_over(OfStage stage);

    const SteppedRun& run_;
    std::vector<VariedNumber> variations_;
    OfStage now_;
    std::unique_ptr<SignalDerivatives> signals_;  // nullptr without signals
    std::exception_ptr failure_;                  // of the start of a stage
    bool is_known_ = true;                        // whether derivatives of the accepted state are known
};

// A quantity of a history, and what each of its numbers counts in a sum.
struct WeightedQuantity {
    std::size_t history, quantity;
    std::vector<double> weights;
};

// Lists the nodes on whose motions a sum depends, in order. Throws std::invalid_argument if one of its
// quantities has no gradient.
std::vector<int> list_nodes(const Problem& problem, const std::vector<WeightedQuantity>& sum);

// Finds derivatives of a weighted sum at the accepted equilibrium of a static run, by multipliers. Throws
// std::invalid_argument if there are none.
std::vector<double> find_gradient(const SteppedRun& run,
                                  const std::vector<WeightedQuantity>& sum,
                                  const std::vector<VariedNumber>& variations);

}  // namespace gxrod
