#pragma once

#include <array>
#include <map>
#include <string>

#include "analyses/cut_warning.hpp"
#include "solvers/equilibrium.hpp"

namespace gxrod {

// Counts the failed trials of steps, with their reasons and places.
class CutTally {
  public:
    // Adds a failed trial; `step` steps were accepted before it.
    void add(const EquilibriumReport& report, long step);

    StepCuts count(long steps) const;
    // Describes why trials failed, as in "Newton's method did not converge (880 times, mostly at b.end (ry)),
    // a node turned by half a turn or more within a step (23 times, mostly at b.end)".
    std::string describe_reasons(const Model& model) const;

  private:
    struct Place {
        int node, component;
        auto operator<=>(const Place&) const = default;
    };
    struct Reason {
        long cuts = 0;
        std::map<Place, long> places;
    };
    std::map<Outcome, Reason> reasons_;
    long last_step_ = -1;
    long cut_steps_ = 0;
    long cuts_ = 0;
};

}  // namespace gxrod
