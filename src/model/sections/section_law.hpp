#pragma once

#include <span>
#include <string>

#include "rotation/types.hpp"

namespace gxrod {

// How a section answers to its strains E = (Γ, K), material, per length of the rod.
struct SectionResponse {
    Vec6 resultants = Vec6::Zero();  // S = (N, M)
    Mat6 tangent = Mat6::Zero();     // D = ∂S/∂E, what the section remembers and the time elapsed fixed
    double stored = 0.0;             // energy
    double dissipated = 0.0;         // energy, since the last accepted step; not negative
};

// The law of a section that is not linear, or that remembers. Laws hold no state: what a section remembers at
// a force point is memory_size() numbers that State keeps for it, all zero at the start of a run and changed
// by accepted steps alone. So a step that is cut, and a stage that is repeated, start from the same memory.
class SectionLaw {
  public:
    virtual ~SectionLaw() = default;

    virtual int memory_size() const = 0;
    // In words: "relaxes, 2 branches".
    virtual std::string describe() const = 0;
    // The response to strains `strain` at the time `elapsed` since the last accepted step, where the memory
    // was `memory`; infinite where no time passes (statics), and all that relaxes has relaxed. What it would
    // remember there is written to `after`, unless that is empty; `after` is not `memory`. Strain is taken as
    // linear in time in between. Called by several threads at once.
    virtual SectionResponse respond(const Vec6& strain,
                                    std::span<const double> memory,
                                    double elapsed,
                                    std::span<double> after) const = 0;
};

}  // namespace gxrod
