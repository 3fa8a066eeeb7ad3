#pragma once

#include <memory>
#include <optional>
#include <string>

#include "cross_section/cross_section.hpp"

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

// Finds stresses of a section by its resultants, (N, Vy, Vz, T, My, Mz), at one of its points or where they
// are worst: where the exposure of the criterion is largest, or the von Mises stress if no material has what
// the criterion needs.
class SectionStresses {
  public:
    // A point is taken to the nearest one of the field. An empty word is the criterion of von Mises.
    SectionStresses(std::shared_ptr<const CrossSection> section,
                    const std::optional<PlanePoint>& point,
                    const std::string& criterion);

    SectionStress find(const Vec6& resultants) const;

  private:
    double measure(const StressPoint& point, const Vec6& resultants) const;
    SectionStress describe(const StressPoint& point, const Vec6& resultants) const;

    std::shared_ptr<const CrossSection> section_;
    std::vector<const FailureCriterion*>
        criteria_;                        // of each material; nullptr: none that it can be judged by
    const StressPoint* point_ = nullptr;  // nullptr: the worst one
};

}  // namespace gxrod
