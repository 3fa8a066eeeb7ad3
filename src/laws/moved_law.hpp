#pragma once

#include <memory>
#include <string>
#include <vector>

#include "model/sections/kinked_law.hpp"
#include "model/sections/section_frame.hpp"
#include "model/sections/small_motion_law.hpp"

namespace gxrod {

// A law given about another point of the section and in other axes: S = Tᵀ S′(T E), with T of the frame;
// docs/theory/laws.md, (L31).
class MovedLaw final : public SmallMotionLaw, public KinkedLaw {
  public:
    MovedLaw(const SectionFrame& frame, std::shared_ptr<const SectionLaw> law);

    int memory_size() const override { return law_->memory_size(); }
    bool has_derivatives() const override { return law_->has_derivatives(); }
    std::string describe() const override { return law_->describe(); }
    SectionResponse respond(const Vec6& strain,
                            std::span<const double> memory,
                            double elapsed,
                            std::span<double> after) const override;
    Mat6 elastic_tangent(const Vec6& strain, std::span<const double> memory) const override;
    std::vector<RelaxingStiffness> relaxing_stiffness() const override;
    bool is_at_limit(const Vec6& strain, std::span<const double> memory) const override;
    int piece_count() const override { return kinked_ != nullptr ? kinked_->piece_count() : 0; }
    void find_pieces(const Vec6& strain,
                     std::span<const double> memory,
                     std::span<int> pieces) const override;
    SectionResponse respond_on(std::span<const int> pieces,
                               const Vec6& strain,
                               std::span<const double> memory,
                               double elapsed,
                               std::span<double> after) const override;

    const SectionLaw& inner() const { return *law_; }

  private:
    SectionResponse move_back(SectionResponse response) const;

    Mat6 to_frame_;  // T
    std::shared_ptr<const SectionLaw> law_;
    const KinkedLaw* kinked_;  // law_, if it has kinks
};

}  // namespace gxrod
