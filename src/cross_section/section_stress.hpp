#pragma once

#include <memory>
#include <optional>
#include <string>

#include "cross_section/cross_section.hpp"
#include "cross_section/longest_image.hpp"

namespace gxrod {

struct FailureCriterion;

// The stress at a point of a section.
struct SectionStress {
    PlanePoint at = PlanePoint::Zero();
    int layer = 0;
    Vec6 stress = Vec6::Zero();  // xx yy zz yz xz xy, in section axes
    double von_mises = 0.0;
    Vec3 principal = Vec3::Zero();
    double exposure = 0.0;       // 0 where the material has no strength
    std::string_view mode = {};  // how it would fail
};

// A point of a section with the measure by which its stress is the largest one.
struct LargestStress {
    int point = 0;  // an index in StressField::points
    double value = 0.0;
};

// Finds stresses of a section by its resultants, (N, Vy, Vz, T, My, Mz), at one of its points or where they
// are worst. Points near sharp corners are not among the worst.
class SectionStresses {
  public:
    // Exposure is by the criterion of this word in each material that has what it needs, else by
    // yield_stress; "" is the criterion of von Mises.
    SectionStresses(std::shared_ptr<const CrossSection> section, const std::string& criterion);

    const std::shared_ptr<const CrossSection>& section() const { return section_; }
    // Whether some material of the section has a strength.
    bool has_strength() const;
    int find_nearest_point(const PlanePoint& at) const;
    // Find the largest von Mises stress, or exposure, if there is one and it is more than `floor`.
    std::optional<LargestStress> find_von_mises(const Vec6& resultants, double floor = -1.0) const;
    std::optional<LargestStress> find_exposure(const Vec6& resultants, double floor = -1.0) const;
    SectionStress describe(int point, const Vec6& resultants) const;

  private:
    const FailureCriterion* criterion_of(const StressPoint& point) const;
    double compute_exposure(const StressPoint& point, const Vec6& resultants) const;

    std::shared_ptr<const CrossSection> section_;
    std::vector<const FailureCriterion*> criteria_;  // of each material; nullptr: it has no strength
    std::vector<int> judged_;                        // points that can be the worst
    LongestImage von_mises_;                         // of these points
    std::optional<LongestImage> by_yield_;           // if yield stresses alone are compared
};

}  // namespace gxrod
