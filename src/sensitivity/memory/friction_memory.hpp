#pragma once

#include <functional>
#include <vector>

#include "assembly/system.hpp"
#include "sensitivity/memory/rod_memory.hpp"

namespace gxrod {

// Transposes by differences what friction of joints, tendons and the ground remembers from one step to the
// next: the numbers of State::memory that are not of rods (docs/theory/sensitivities.md, (G20), (G21)). Their
// steps are so small that what sticks or slips goes on to do so.
class FrictionMemory {
  public:
    // The system must outlive it.
    explicit FrictionMemory(const System& system);

    bool is_empty() const { return places_.empty(); }
    // Returns the step of differences by placements, of the length of a node's part, or in rad.
    double part() const { return part_; }
    // Adds how a scalar changes with the placements at the end of the step, which are the trial motions, if
    // it changes by `after` with what friction remembers after the step.
    void add_by_placements(const State& state,
                           double time,
                           const MemoryGradient& after,
                           MotionGradient& by_end) const;
    // Adds the derivatives of a function of the start of the step by what friction remembers there, and by
    // the accepted placements from which tendons stretch where they stick.
    void add_by_start(const State& state,
                      double time,
                      const std::function<double(const State& start)>& function,
                      MemoryGradient& before,
                      MotionGradient& motions_before) const;

  private:
    struct Place {
        std::size_t number;
        double step;
    };
    void add_joints();
    void add_tendons();
    void add_loads();
    // Adds the derivatives of function() by these nodes of `motions`, which it reads.
    template <class Function>
    void add_by_nodes(const std::vector<int>& nodes,
                      std::vector<NodeMotion>& motions,
                      const Function& function,
                      MotionGradient& gradient) const;

    const System* system_;
    std::vector<Place> places_;
    std::vector<int> nodes_;         // whose placements count, sorted
    std::vector<int> tendon_nodes_;  // of them those of tendons
    double part_;
};

}  // namespace gxrod
