#pragma once

#include <vector>

#include "model/sections/section_law.hpp"

namespace gxrod {

// A relaxing part of a section's stiffness: strains δE e^(λt) add the resultants λτ/(1 + λτ) stiffness δE.
struct RelaxingStiffness {
    double time = 1.0;  // τ
    Mat6 stiffness = Mat6::Zero();
};

// A law with the response of a section to small motions about an accepted state, independent of the step that
// led there. Strains and memory belong to that state.
class SmallMotionLaw : public SectionLaw {
  public:
    // Returns ∂S/∂E after a long time, while all parts that could slip or yield stick.
    virtual Mat6 elastic_tangent(const Vec6& strain, std::span<const double> memory) const = 0;
    // Returns the additional stiffness against changes of strain; each time once.
    virtual std::vector<RelaxingStiffness> relaxing_stiffness() const { return {}; }
    // Whether more strain in some direction slips or yields at once.
    virtual bool is_at_limit(const Vec6& /*strain*/, std::span<const double> /*memory*/) const {
        return false;
    }
};

// Do the same for any law. A law that is not a SmallMotionLaw has its tangent after a long time.
Mat6 find_elastic_tangent(const SectionLaw& law, const Vec6& strain, std::span<const double> memory);
std::vector<RelaxingStiffness> list_relaxing_stiffness(const SectionLaw& law);
bool is_at_limit(const SectionLaw& law, const Vec6& strain, std::span<const double> memory);

}  // namespace gxrod
