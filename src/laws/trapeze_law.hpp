#pragma once

#include <memory>

#include "model/sections/kinked_law.hpp"
#include "model/sections/small_motion_law.hpp"

namespace gxrod {

// Adds the shortening of a twisted section to another law. Its outer fibres become helices and pull: ½ c κ²
// of axial force and c κ ε of torque, κ the twist, ε the extension, c the sum of both bending stiffnesses:
// BeamDyn's term; docs/theory/laws.md, (L17).
class TrapezeLaw final : public SmallMotionLaw, public KinkedLaw {
  public:
    // Without `inner`, adds to the stiffness `C` alone.
    TrapezeLaw(const Mat6& C, std::shared_ptr<const SectionLaw> inner = nullptr);

    int memory_size() const override { return inner_->memory_size(); }
    bool has_derivatives() const override { return inner_->has_derivatives(); }
    std::string describe() const override { return inner_->describe() + "; shortens as it twists"; }
    SectionResponse respond(const Vec6& strain,
                            std::span<const double> memory,
                            double elapsed,
                            std::span<double> after) const override;
    Mat6 elastic_tangent(const Vec6& strain, std::span<const double> memory) const override;
    std::vector<RelaxingStiffness> relaxing_stiffness() const override;
    bool is_at_limit(const Vec6& strain, std::span<const double> memory) const override;
    int piece_count() const override { return kinked_ ? kinked_->piece_count() : 0; }
    void find_pieces(const Vec6& strain,
                     std::span<const double> memory,
                     std::span<int> pieces) const override {
        if (kinked_ != nullptr) kinked_->find_pieces(strain, memory, pieces);
    }
    SectionResponse respond_on(std::span<const int> pieces,
                               const Vec6& strain,
                               std::span<const double> memory,
                               double elapsed,
                               std::span<double> after) const override;

    double coefficient() const { return c_; }
    const SectionLaw& inner() const { return *inner_; }

  private:
    void add_shortening(const Vec6& strain, SectionResponse& response) const;

    double c_;
    std::shared_ptr<const SectionLaw> inner_;
    const KinkedLaw* kinked_;  // inner_, if it has kinks
};

}  // namespace gxrod
