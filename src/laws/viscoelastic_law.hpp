#pragma once

#include <vector>

#include "laws/strain_part.hpp"
#include "model/sections/small_motion_law.hpp"

namespace gxrod {

// A spring of `ratio` times the relaxed stiffness in series with a dashpot that relaxes it in `time`.
struct PronyBranch {
    double ratio = 0.0;
    double time = 1.0;
};

// The law S = C E + Σ S_i, C the relaxed stiffness and each S_i the force of a branch that follows fast
// strains and relaxes; exact for strains linear in time; docs/theory/laws.md, (L12)–(L16). It remembers the
// strain and, for each branch, the strain of its spring.
class ViscoelasticLaw final : public SmallMotionLaw {
  public:
    // Branches act on the entries of C within `on`; on all of C if that is empty.
    ViscoelasticLaw(const Mat6& C, std::vector<PronyBranch> branches, const std::vector<StrainPart>& on = {});

    int memory_size() const override { return 6 + 6 * static_cast<int>(branches_.size()); }
    std::string describe() const override { return "relaxes, branches: " + std::to_string(branches_.size()); }
    SectionResponse respond(const Vec6& strain,
                            std::span<const double> memory,
                            double elapsed,
                            std::span<double> after) const override;
    Mat6 elastic_tangent(const Vec6& /*strain*/, std::span<const double> /*memory*/) const override {
        return stiffness_;
    }
    std::vector<RelaxingStiffness> relaxing_stiffness() const override;

    // The stiffness of the branches at ratio 1.
    const Mat6& relaxing() const { return relaxing_; }
    const std::vector<PronyBranch>& branches() const { return branches_; }

  private:
    Mat6 stiffness_, relaxing_;
    std::vector<PronyBranch> branches_;
};

}  // namespace gxrod
