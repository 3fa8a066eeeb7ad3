#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "assembly/system.hpp"
#include "linear/eigen/quadratic_problem.hpp"
#include "model/settings/settings.hpp"

namespace gxrod {

// A system as small motions about an accepted state meet it: of the same unknowns, with the elastic tangents
// of its sections in place of those of the last step, and friction that sticks; or, by
// Linearization::loading, as if the load went on (docs/theory/laws.md, (L27) to
// (L29)). One without laws and friction is the system itself, which must outlive this.
class SmallMotions {
  public:
    explicit SmallMotions(const System& system, Linearization linearization = Linearization::elastic);

    // What relaxes has relaxed.
    const System& system() const { return own_ ? *own_ : *given_; }
    // The stiffness of what relaxes, for each relaxation time of its sections.
    std::vector<RelaxingMatrix> compute_relaxing(const State& state, double time) const;
    bool relaxes() const { return !times_.empty(); }
    // Of rods, where sections are about to slip or to yield.
    double measure_length_at_limit(const State& state, double time) const;
    // Friction at its limit: "joint knee", "the seabed".
    std::vector<std::string> list_friction_at_limit(const State& state, double time) const;

  private:
    const System* given_;
    std::vector<double> times_;
    std::shared_ptr<double> quick_;  // of these, what has not relaxed; 0: all has
    std::unique_ptr<const Model> model_;
    std::optional<System> own_;
};

}  // namespace gxrod
