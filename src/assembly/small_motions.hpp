#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "assembly/system.hpp"
#include "linear/eigen/quadratic_problem.hpp"
#include "model/settings/settings.hpp"

namespace gxrod {

// The system of small motions about an accepted state: the same unknowns, but sections have their elastic
// tangents instead of the tangents of the last step, and friction sticks. With Linearization::loading, the
// tangents are those of continued loading (docs/theory/laws.md, (L27) to (L29)). Without laws and friction it
// is the given system, which must outlive this.
class SmallMotions {
  public:
    explicit SmallMotions(const System& system, Linearization linearization = Linearization::elastic);

    // Returns the system in which relaxing stiffness has relaxed.
    const System& system() const { return own_ ? *own_ : *given_; }
    // Computes the relaxing stiffness for each relaxation time of the sections.
    std::vector<RelaxingMatrix> compute_relaxing(const State& state, double time) const;
    bool relaxes() const { return !times_.empty(); }
    // Measures the length of rods whose sections are about to slip or to yield.
    double measure_length_at_limit(const State& state, double time) const;
    // Lists friction at its limit: "joint knee", "the seabed".
    std::vector<std::string> list_friction_at_limit(const State& state, double time) const;

  private:
    const System* given_;
    std::vector<double> times_;
    std::shared_ptr<double> quick_;  // the relaxation time whose stiffness has not relaxed; 0: all has
    std::unique_ptr<const Model> model_;
    std::optional<System> own_;
};

}  // namespace gxrod
