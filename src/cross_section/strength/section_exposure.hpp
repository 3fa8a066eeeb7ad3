#pragma once

#include <vector>

#include "cross_section/cross_section.hpp"
#include "cross_section/failure_criteria.hpp"

namespace gxrod {

// Describes where a section is nearest to failure by a criterion.
struct SectionExposure {
    const FailureCriterion* criterion = nullptr;
    const StressPoint* point = nullptr;
    double exposure = 0.0;  // 1/(factor on all resultants at which it fails)
    std::string_view mode = {};
};

// Returns the material at a point.
const ElasticMaterial& material_at(const CrossSection& section, const StressPoint& point);

// Finds how a stress of a point uses its material; nothing if the material has not what the criterion needs.
std::optional<FailureMode> find_governing_mode(const CrossSection& section,
                                               const StressPoint& point,
                                               const Vec6& stress,
                                               const FailureCriterion& criterion);

// Finds the exposures by all criteria that a material of the section can be judged by, at resultants (N, Vy,
// Vz, T, My, Mz).
std::vector<SectionExposure> find_exposures(const CrossSection& section, const Vec6& resultants);

}  // namespace gxrod
