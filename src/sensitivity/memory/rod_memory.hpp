#pragma once

#include <vector>

#include "assembly/system.hpp"
#include "sensitivity/state_direction.hpp"
#include "state/motion_gradient.hpp"

namespace gxrod {

// How a scalar changes with what a state remembers: a factor of each number. Axes of sections change by
// spins: Λ ← exp(δφ) Λ.
struct MemoryGradient {
    std::vector<StateDirection::OfSection> sections;  // as State::sections
    std::vector<double> numbers;                      // as State::memory

    MemoryGradient() = default;
    explicit MemoryGradient(const State& state)
        : sections(state.sections.size()), numbers(state.memory.size(), 0.0) {}
};

// Computes the change of the scalar where what is remembered changes from one state to another, or along a
// direction.
double dot(const MemoryGradient& by, const State& to, const State& from);
double dot(const MemoryGradient& by, const StateDirection& along);

// Transposes what rods remember from one step to the next: the memory of their laws and, of `simo` elements,
// the axes from which they measure rotations (docs/theory/sensitivities.md, (G20) to (G22)). All is at the
// trial motions of a state that has the memory before the step.
class RodMemory {
  public:
    // The system must outlive it; its laws are smooth, or held on pieces.
    explicit RodMemory(const System& system) : system_(&system) {}

    // Adds how a scalar changes with the placements at the end of the step, if it changes by `after`, μ, with
    // what rods remember after it: (∂M/∂x)ᵀ μ.
    void add_by_placements(const State& state,
                           double time,
                           const MemoryGradient& after,
                           MotionGradient& by_end) const;
    // Adds how this scalar less ξ · R, R the residual forces on nodes, changes with what was remembered
    // before the step, (∂M/∂m)ᵀ μ − (∂R/∂m)ᵀ ξ, and, through `simo` elements, with the axes of nodes before
    // it. An empty `after` counts for nothing.
    void add_by_memory(const State& state,
                       double time,
                       const std::vector<Vec6>& xi,
                       const MemoryGradient& after,
                       MemoryGradient& before,
                       MotionGradient& motions_before) const;

    // Lists the numbers of State::memory, and of State::sections, of the elements at any of these nodes.
    struct Places {
        std::vector<std::size_t> numbers, sections;
    };
    Places list_places(const State& state, const std::vector<int>& nodes) const;
    // Returns steps for differences by each number of State::memory; 0 where it is not of a rod.
    std::vector<double> list_steps(const State& state, double time) const;

  private:
    template <class Visit>
    void visit(const State& state, double time, const Visit& visit) const;

    const System* system_;
};

}  // namespace gxrod
