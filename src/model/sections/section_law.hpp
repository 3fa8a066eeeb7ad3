#pragma once

#include <span>
#include <string>

#include "rotation/types.hpp"

namespace gxrod {

// The response of a section to its strains E = (Γ, K), material, per length of the rod.
struct SectionResponse {
    Vec6 resultants = Vec6::Zero();  // S = (N, M)
    Mat6 tangent = Mat6::Zero();     // D = ∂S/∂E at fixed memory and elapsed time
    double stored = 0.0;             // energy
    double dissipated = 0.0;         // energy since the last accepted step; not negative
};

// The law of a section that is not linear, or that remembers. Laws hold no state: the memory of a section at
// a force point is memory_size() numbers in State, all zero at the start of a run and changed by accepted
// steps only. A step that is cut, and a stage that is repeated, thus start from the same memory.
class SectionLaw {
  public:
    virtual ~SectionLaw() = default;

    virtual int memory_size() const = 0;
    // Whether its memory can be differentiated: it is smooth, or smooth on pieces that it knows (KinkedLaw).
    virtual bool has_derivatives() const { return true; }
    // Describes the law in words: "relaxes, 2 branches".
    virtual std::string describe() const = 0;
    // Computes the response to strains `strain` at the time `elapsed` since the last accepted step, when the
    // memory was `memory`. `elapsed` is infinite if no time passes (statics): then all relaxing parts have
    // relaxed. The new memory is written to `after`, unless that is empty; `after` is not `memory`. Strain is
    // taken as linear in time in between. Several threads may call it at once.
    virtual SectionResponse respond(const Vec6& strain,
                                    std::span<const double> memory,
                                    double elapsed,
                                    std::span<double> after) const = 0;
};

}  // namespace gxrod
