#include "cross_section/strength/section_exposure.hpp"

namespace gxrod {

const ElasticMaterial& material_at(const CrossSection& section, const StressPoint& point) {
    const SectionLayer& layer = section.mesh.layers[static_cast<std::size_t>(point.layer)];
    return section.materials[static_cast<std::size_t>(layer.material)];
}

std::optional<FailureMode> find_governing_mode(const CrossSection& section,
                                               const StressPoint& point,
                                               const Vec6& stress,
                                               const FailureCriterion& criterion) {
    const ElasticMaterial& material = material_at(section, point);
    if (!criterion.applies_to(material)) return std::nullopt;
    const double angle = section.mesh.layers[static_cast<std::size_t>(point.layer)].fibre_angle;
    return criterion.find_modes(turn_stress_to_ply(stress, angle, point.wall), material).governing();
}

std::vector<SectionExposure> find_exposures(const CrossSection& section, const Vec6& resultants) {
    std::vector<SectionExposure> found;
    for (const FailureCriterion& criterion : failure_criteria()) {
        SectionExposure worst{.criterion = &criterion};
        for (const StressPoint& point : section.stresses.points) {
            if (point.is_singular) continue;
            const auto mode =
                find_governing_mode(section, point, point.stress_operator * resultants, criterion);
            if (!mode || (worst.point != nullptr && mode->exposure() <= worst.exposure)) continue;
            worst = {&criterion, &point, mode->exposure(), mode->word};
        }
        if (worst.point != nullptr) found.push_back(worst);
    }
    return found;
}

}  // namespace gxrod
