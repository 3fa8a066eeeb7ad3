#include "cross_section/section_stress.hpp"

#include <algorithm>

#include "cross_section/failure_criteria.hpp"
#include "cross_section/stress_measures.hpp"

namespace gxrod {

SectionStresses::SectionStresses(std::shared_ptr<const CrossSection> section,
                                 const std::optional<PlanePoint>& point,
                                 const std::string& criterion)
    : section_(std::move(section)) {
    const FailureCriterion* wanted = criterion.empty() ? nullptr : find_failure_criterion(criterion);
    for (const ElasticMaterial& material : section_->materials)
        criteria_.push_back(choose_failure_criterion(wanted, material));
    // Stresses are compared by one measure all over the section.
    if (std::ranges::find(criteria_, nullptr) != criteria_.end()) std::ranges::fill(criteria_, nullptr);
    if (!point) return;
    const auto distance = [&](const StressPoint& one) { return (one.at - *point).squaredNorm(); };
    point_ = &*std::ranges::min_element(section_->stresses.points, {}, distance);
}

double SectionStresses::measure(const StressPoint& point, const Vec6& resultants) const {
    const Vec6 stress = point.stress_operator * resultants;
    const SectionLayer& layer = section_->mesh.layers[static_cast<std::size_t>(point.layer)];
    const FailureCriterion* criterion = criteria_[static_cast<std::size_t>(layer.material)];
    if (criterion == nullptr) return compute_von_mises(stress);
    const ElasticMaterial& material = section_->materials[static_cast<std::size_t>(layer.material)];
    const Vec6 in_ply = turn_stress_to_ply(stress, layer.fibre_angle, point.wall);
    return criterion->find_modes(in_ply, material).governing().exposure();
}

SectionStress SectionStresses::describe(const StressPoint& point, const Vec6& resultants) const {
    SectionStress found{.at = point.at, .layer = point.layer, .stress = point.stress_operator * resultants};
    found.von_mises = compute_von_mises(found.stress);
    found.principal = compute_principal_stresses(found.stress);
    const SectionLayer& layer = section_->mesh.layers[static_cast<std::size_t>(point.layer)];
    const auto index = static_cast<std::size_t>(layer.material);
    if (criteria_[index] == nullptr) return found;
    const Vec6 in_ply = turn_stress_to_ply(found.stress, layer.fibre_angle, point.wall);
    const FailureModes modes = criteria_[index]->find_modes(in_ply, section_->materials[index]);
    found.exposure = modes.governing().exposure();
    found.mode = modes.governing().word;
    return found;
}

SectionStress SectionStresses::find(const Vec6& resultants) const {
    if (point_ != nullptr) return describe(*point_, resultants);
    const StressPoint* worst = &section_->stresses.points.front();
    double largest = -1.0;
    for (const StressPoint& point : section_->stresses.points) {
        if (point.is_singular) continue;
        const double value = measure(point, resultants);
        if (value <= largest) continue;
        largest = value;
        worst = &point;
    }
    return describe(*worst, resultants);
}

}  // namespace gxrod
