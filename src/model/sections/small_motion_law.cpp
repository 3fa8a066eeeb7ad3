#include "model/sections/small_motion_law.hpp"

#include <limits>

namespace gxrod {

Mat6 find_elastic_tangent(const SectionLaw& law, const Vec6& strain, std::span<const double> memory) {
    if (const auto* own = dynamic_cast<const SmallMotionLaw*>(&law))
        return own->elastic_tangent(strain, memory);
    return law.respond(strain, memory, std::numeric_limits<double>::infinity(), {}).tangent;
}

std::vector<RelaxingStiffness> list_relaxing_stiffness(const SectionLaw& law) {
    const auto* own = dynamic_cast<const SmallMotionLaw*>(&law);
    return own != nullptr ? own->relaxing_stiffness() : std::vector<RelaxingStiffness>{};
}

bool is_at_limit(const SectionLaw& law, const Vec6& strain, std::span<const double> memory) {
    const auto* own = dynamic_cast<const SmallMotionLaw*>(&law);
    return own != nullptr && own->is_at_limit(strain, memory);
}

}  // namespace gxrod
