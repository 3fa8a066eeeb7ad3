#pragma once

#include <array>
#include <memory>
#include <string>
#include <vector>

#include "model/sections/kinked_law.hpp"
#include "model/sections/small_motion_law.hpp"

namespace gxrod {

// A part of a section with a law of its own.
struct LawShare {
    double share = 1.0;  // of the section, from 0 to 1
    std::shared_ptr<const SectionLaw> law;
};

// Two laws side by side, at the same strains: S = (1 − t) S_a + t S_b; docs/theory/laws.md, (L40). It
// remembers what each of them remembers.
class MixedLaw final : public SmallMotionLaw, public KinkedLaw {
  public:
    // The second law has the share `t`, the first one the rest.
    MixedLaw(std::shared_ptr<const SectionLaw> a, std::shared_ptr<const SectionLaw> b, double t);

    int memory_size() const override;
    bool has_derivatives() const override {
        return shares_[0].law->has_derivatives() && shares_[1].law->has_derivatives();
    }
    std::string describe() const override;
    SectionResponse respond(const Vec6& strain,
                            std::span<const double> memory,
                            double elapsed,
                            std::span<double> after) const override;
    Mat6 elastic_tangent(const Vec6& strain, std::span<const double> memory) const override;
    std::vector<RelaxingStiffness> relaxing_stiffness() const override;
    bool is_at_limit(const Vec6& strain, std::span<const double> memory) const override;
    int piece_count() const override;
    void find_pieces(const Vec6& strain,
                     std::span<const double> memory,
                     std::span<int> pieces) const override;
    SectionResponse respond_on(std::span<const int> pieces,
                               const Vec6& strain,
                               std::span<const double> memory,
                               double elapsed,
                               std::span<double> after) const override;

    const std::array<LawShare, 2>& shares() const { return shares_; }

  private:
    std::array<LawShare, 2> shares_;
};

// Mixes two laws as two shares of one section. With t = 0 or 1, or twice the same law, it is that law alone.
std::shared_ptr<const SectionLaw> mix_laws(const std::shared_ptr<const SectionLaw>& a,
                                           const std::shared_ptr<const SectionLaw>& b,
                                           double t);

}  // namespace gxrod
