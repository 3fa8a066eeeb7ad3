#include "cross_section/section_stress.hpp"

#include <algorithm>
#include <cmath>

#include "cross_section/failure_criteria.hpp"
#include "cross_section/stress_measures.hpp"

namespace gxrod {
namespace {

std::vector<int> list_judged(const StressField& field) {
    std::vector<int> judged;
    for (std::size_t i = 0; i < field.points.size(); ++i) {
        if (!field.points[i].is_singular) judged.push_back(static_cast<int>(i));
    }
    return judged;
}

const StressPoint& point_of(const CrossSection& section, int index) {
    return section.stresses.points[static_cast<std::size_t>(index)];
}

// A with |A R| the von Mises stress of the resultants R.
Mat6 find_mises_form(const StressPoint& point) {
    const Mat6& H = point.stress_operator;
    Mat6 form;
    form << (H.row(0) - H.row(1)) * M_SQRT1_2, (H.row(1) - H.row(2)) * M_SQRT1_2,
        (H.row(2) - H.row(0)) * M_SQRT1_2, std::sqrt(3.0) * H.bottomRows<3>();
    return form;
}

LongestImage sort_mises(const CrossSection& section, const std::vector<int>& judged) {
    std::vector<Mat6> forms;
    for (const int index : judged) forms.push_back(find_mises_form(point_of(section, index)));
    return LongestImage(std::move(forms));
}

}  // namespace

SectionStresses::SectionStresses(std::shared_ptr<const CrossSection> section, const std::string& criterion)
    : section_(std::move(section)),
      judged_(list_judged(section_->stresses)),
      von_mises_(sort_mises(*section_, judged_)) {
    const FailureCriterion* yields = find_failure_criterion("von-mises");
    const FailureCriterion* wanted = criterion.empty() ? yields : find_failure_criterion(criterion);
    for (const ElasticMaterial& material : section_->materials)
        criteria_.push_back(choose_failure_criterion(wanted, material));
    const auto is_yield = [&](const FailureCriterion* one) { return one == nullptr || one == yields; };
    if (!has_strength() || !std::ranges::all_of(criteria_, is_yield)) return;
    std::vector<Mat6> forms;
    for (const int index : judged_) {
        const StressPoint& point = point_of(*section_, index);
        const SectionLayer& layer = section_->mesh.layers[static_cast<std::size_t>(point.layer)];
        const auto& limit = section_->materials[static_cast<std::size_t>(layer.material)].yield_stress;
        forms.push_back(limit ? Mat6(find_mises_form(point) / *limit) : Mat6(Mat6::Zero()));
    }
    by_yield_.emplace(std::move(forms));
}

bool SectionStresses::has_strength() const {
    return std::ranges::any_of(criteria_, [](const FailureCriterion* one) { return one != nullptr; });
}

int SectionStresses::find_nearest_point(const PlanePoint& at) const {
    const std::vector<StressPoint>& points = section_->stresses.points;
    const auto distance = [&](const StressPoint& one) { return (one.at - at).squaredNorm(); };
    return static_cast<int>(std::ranges::min_element(points, {}, distance) - points.begin());
}

std::optional<LargestStress> SectionStresses::find_von_mises(const Vec6& resultants, double floor) const {
    const std::optional<LongestImage::Image> found = von_mises_.find(resultants, floor);
    if (!found) return std::nullopt;
    return LargestStress{judged_[static_cast<std::size_t>(found->index)], found->length};
}

std::optional<LargestStress> SectionStresses::find_exposure(const Vec6& resultants, double floor) const {
    if (by_yield_) {
        const std::optional<LongestImage::Image> found = by_yield_->find(resultants, floor);
        if (!found) return std::nullopt;
        return LargestStress{judged_[static_cast<std::size_t>(found->index)], found->length};
    }
    if (!has_strength()) return std::nullopt;
    LargestStress largest{-1, floor};
    for (const int index : judged_) {
        const double value = compute_exposure(point_of(*section_, index), resultants);
        if (value > largest.value) largest = {index, value};
    }
    if (largest.point < 0) return std::nullopt;
    return largest;
}

const FailureCriterion* SectionStresses::criterion_of(const StressPoint& point) const {
    const SectionLayer& layer = section_->mesh.layers[static_cast<std::size_t>(point.layer)];
    return criteria_[static_cast<std::size_t>(layer.material)];
}

double SectionStresses::compute_exposure(const StressPoint& point, const Vec6& resultants) const {
    const FailureCriterion* criterion = criterion_of(point);
    if (criterion == nullptr) return 0.0;
    const SectionLayer& layer = section_->mesh.layers[static_cast<std::size_t>(point.layer)];
    const Vec6 in_ply = turn_stress_to_ply(point.stress_operator * resultants, layer.fibre_angle, point.wall);
    const ElasticMaterial& material = section_->materials[static_cast<std::size_t>(layer.material)];
    return criterion->find_modes(in_ply, material).governing().exposure();
}

SectionStress SectionStresses::describe(int index, const Vec6& resultants) const {
    const StressPoint& point = point_of(*section_, index);
    SectionStress found{.at = point.at, .layer = point.layer, .stress = point.stress_operator * resultants};
    found.von_mises = compute_von_mises(found.stress);
    found.principal = compute_principal_stresses(found.stress);
    const FailureCriterion* criterion = criterion_of(point);
    if (criterion == nullptr) return found;
    const SectionLayer& layer = section_->mesh.layers[static_cast<std::size_t>(point.layer)];
    const Vec6 in_ply = turn_stress_to_ply(found.stress, layer.fibre_angle, point.wall);
    const FailureModes modes =
        criterion->find_modes(in_ply, section_->materials[static_cast<std::size_t>(layer.material)]);
    found.exposure = modes.governing().exposure();
    found.mode = modes.governing().word;
    return found;
}

}  // namespace gxrod
