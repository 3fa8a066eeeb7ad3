#include "watch/stress_watch.hpp"

#include <algorithm>
#include <limits>

namespace gxrod {
namespace {

Vec6 join(const Vec3& force, const Vec3& moment) {
    Vec6 resultants;
    resultants << force, moment;
    return resultants;
}

void keep_larger(const SectionStresses& stresses,
                 const std::optional<LargestStress>& found,
                 const Vec6& resultants,
                 double time,
                 WorstStress& worst) {
    if (!found) return;
    const StressPoint& point = stresses.section()->stresses.points[static_cast<std::size_t>(found->point)];
    worst = {found->value, time, point.at, point.layer, resultants};
}

}  // namespace

std::vector<RodPlace> list_stress_places(const Model& model) {
    std::vector<RodPlace> places;
    for (std::size_t r = 0; r < model.rods.size(); ++r) {
        for (int element = 0; element < model.rods[r].element_count(); ++element) {
            for (const double xi : {-1.0, 0.0, 1.0}) {
                const RodPlace place{.rod = static_cast<int>(r), .element = element, .xi = xi};
                if (find_shape(model, place)) places.push_back(place);
            }
        }
    }
    return places;
}

StressWatch::StressWatch(const Model& model, const std::string& criterion)
    : model_(&model), listed_(list_shapes(model)) {
    for (const ListedShape& one : listed_) stresses_.emplace_back(one.shape, criterion);
}

int StressWatch::shape_at(const RodPlace& place) const {
    const std::shared_ptr<const CrossSection> shape = find_shape(*model_, place);
    const auto found = std::ranges::find(listed_, shape, &ListedShape::shape);
    return !shape || found == listed_.end() ? -1 : static_cast<int>(found - listed_.begin());
}

StressWatch::Largest StressWatch::find_largest(int shape, const SectionValues& middle) const {
    constexpr double nan = std::numeric_limits<double>::quiet_NaN();
    if (shape < 0) return {nan, nan};
    const Vec6 resultants = join(middle.force, middle.moment);
    const auto value = [](const std::optional<LargestStress>& found) { return found ? found->value : nan; };
    const SectionStresses& stresses = stresses_of(shape);
    return {value(stresses.find_von_mises(resultants)), value(stresses.find_exposure(resultants))};
}

StressEnvelope::StressEnvelope(const Model& model, const StressWatch& watch, std::size_t first_point)
    : watch_(&watch), first_point_(first_point) {
    for (const RodPlace& place : list_stress_places(model)) places_.push_back({place, watch.shape_at(place)});
    von_mises_.resize(places_.size());
    exposure_.resize(places_.size());
}

void StressEnvelope::add(const Snapshot& snapshot) {
    for (std::size_t i = 0; i < places_.size(); ++i) {
        const PointValues& point = snapshot.points[first_point_ + i];
        const Vec6 resultants = join(point.force, point.moment);
        const SectionStresses& stresses = watch_->stresses_of(places_[i].shape);
        keep_larger(stresses,
                    stresses.find_von_mises(resultants, von_mises_[i].value),
                    resultants,
                    snapshot.time,
                    von_mises_[i]);
        keep_larger(stresses,
                    stresses.find_exposure(resultants, exposure_[i].value),
                    resultants,
                    snapshot.time,
                    exposure_[i]);
    }
}

}  // namespace gxrod
