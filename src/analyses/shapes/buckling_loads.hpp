#pragma once

#include <optional>
#include <vector>

#include "assembly/system.hpp"
#include "model/model.hpp"
#include "state/state.hpp"

// The actions that a buckling factor multiplies, as changes of a model (docs/theory/vibrations.md).
namespace gxrod {

// Returns the model without what a factor multiplies: loads, gravity, tensions and actuations vanish, and
// what moves joints and draws in tendons is where it is at t = 0. Supports keep their moves, and the model
// its unknowns.
Model make_unloaded(Model model);

// The system of small motions in which the tendons of winches neither go slack nor become taut. About the
// reference shape all are taut, about a loaded state those with a tension. Without such tendons it is the
// given system, which must outlive this.
class TautSystem {
  public:
    TautSystem(const System& system, const State& state, bool at_reference);

    const System& system() const { return own_ ? *own_ : *given_; }

  private:
    const System* given_;
    std::optional<Model> model_;
    std::optional<System> own_;
};

// Computes the tensions of all tendons after these increments, to first order; the state has the multipliers
// after them, and its motions before.
std::vector<double> compute_tensions(const System& system,
                                     const State& state,
                                     double time,
                                     const std::vector<Vec6>& increments);

// Returns whether a winch pulls a tendon that stretches.
bool has_elastic_winch(const Model& model);
// Returns the model in which such tendons have these tensions at the trial motions.
Model set_elastic_tensions(const System& system, const State& state, const std::vector<double>& tensions);

}  // namespace gxrod
