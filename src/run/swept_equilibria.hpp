#pragma once

#include <cstdint>
#include <memory>
#include <string>

#include "analyses/shapes/sweep.hpp"
#include "analyses/stepped_analysis.hpp"
#include "model/problem.hpp"

namespace gxrod {

// The equilibria at the end of the stages of a deck, for one value of a key after another.
class SweptEquilibria {
  public:
    // Takes the plan of the stage that sweeps, number `index`; the stages before it are static or steady.
    SweptEquilibria(const StagePlan& plan, std::size_t index, int threads)
        : plan_(plan), index_(index), threads_(threads) {}

    // Finds the equilibrium by Newton's method from the last one if that is near and has the same reference
    // shape, otherwise through all stages. Valid until the next call.
    SweepState find(double value);

  private:
    struct Equilibrium {
        std::unique_ptr<Model> model;  // with the loads of the last stage
        std::unique_ptr<SteppedAnalysis> analysis;
    };

    // Finds the last stage before it that takes steps; the first stage if there is none.
    std::size_t find_last(const Problem& deck) const;
    Equilibrium prepare(const Problem& deck, std::size_t stage) const;
    bool settle(const Problem& deck, Equilibrium& found) const;
    // Runs the stages and returns why one failed, "" if none did.
    std::string run_stages(const Problem& deck, Equilibrium& found) const;

    const StagePlan& plan_;
    std::size_t index_;
    int threads_;
    std::int64_t unknowns_ = 0;  // number in each model
    Equilibrium last_;
};

}  // namespace gxrod
