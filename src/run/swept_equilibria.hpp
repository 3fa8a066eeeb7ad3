#pragma once

#include <cstdint>
#include <memory>
#include <string>

#include "analyses/shapes/sweep.hpp"
#include "analyses/stepped_analysis.hpp"
#include "model/settings/stage.hpp"

namespace gxrod {

// The equilibria in which the stages of a deck leave its model, for one value of the deck after another.
class SweptEquilibria {
  public:
    // `plan` is of the stage that sweeps, number `index`; the stages before it are static or steady.
    SweptEquilibria(const StagePlan& plan, std::size_t index, int threads)
        : plan_(plan), index_(index), threads_(threads) {}

    // From the last equilibrium by Newton's method if that is near and of the same reference shape, otherwise
    // through all stages. Valid until the next one.
    SweepState find(double value);

  private:
    struct Equilibrium {
        std::unique_ptr<Model> model;  // with what acts in the last stage
        std::unique_ptr<SteppedAnalysis> analysis;
    };

    // The last stage before that takes steps; the first one if there is none.
    std::size_t find_last(const StagedModel& deck) const;
    Equilibrium prepare(const StagedModel& deck, std::size_t stage) const;
    bool settle(const StagedModel& deck, Equilibrium& found) const;
    // Why a stage failed, "" if none did.
    std::string run_stages(const StagedModel& deck, Equilibrium& found) const;

    const StagePlan& plan_;
    std::size_t index_;
    int threads_;
    std::int64_t unknowns_ = 0;  // of all models
    Equilibrium last_;
};

}  // namespace gxrod
