#include "watch/stress_watch.hpp"

#include <Eigen/Cholesky>
#include <algorithm>
#include <limits>

namespace gxrod {
namespace {

Vec6 join(const Vec3& force, const Vec3& moment) {
    Vec6 resultants;
    resultants << force, moment;
    return resultants;
}

using Search = std::optional<LargestStress> (SectionStresses::*)(const Vec6&, double) const;

void keep_larger(const StressWatch& watch,
                 Search search,
                 const ShapeShares& shapes,
                 const Vec6& resultants,
                 double time,
                 WorstStress& worst) {
    const SectionStresses& first = watch.stresses_of(shapes.front().shape);
    const std::optional<LargestStress> found =
        (first.*search)(shapes.front().resultants(resultants), shapes.size() == 1 ? worst.value : 0.0);
    if (!found) return;
    double value = shapes.front().part * found->value;
    for (std::size_t i = 1; i < shapes.size(); ++i) {
        const auto other =
            (watch.stresses_of(shapes[i].shape).*search)(shapes[i].resultants(resultants), 0.0);
        value += other ? shapes[i].part * other->value : 0.0;
    }
    if (value <= worst.value) return;
    const StressPoint& point = first.section()->stresses.points[static_cast<std::size_t>(found->point)];
    worst = {value, time, point.at, point.layer, resultants};
}

}  // namespace

std::vector<RodPlace> list_stress_places(const Model& model) {
    std::vector<RodPlace> places;
    for (std::size_t r = 0; r < model.rods.size(); ++r) {
        for (int element = 0; element < model.rods[r].element_count(); ++element) {
            for (const RodPlace& place : list_stress_places(model, static_cast<int>(r), element)) {
                if (!find_shapes(model, place).empty()) places.push_back(place);
            }
        }
    }
    return places;
}

StressWatch::StressWatch(const Model& model, const std::string& criterion)
    : model_(&model), listed_(list_shapes(model)) {
    for (const ListedShape& one : listed_) stresses_.emplace_back(one.shape, criterion);
}

ShapeShares StressWatch::shapes_at(const RodPlace& place) const {
    ShapeShares shares;
    for (const ShapePart& one : find_shapes(*model_, place)) {
        const auto found = std::ranges::find(listed_, one.shape, &ListedShape::shape);
        shares.push_back({static_cast<int>(found - listed_.begin()), one.part});
        if (one.between == nullptr) continue;
        const Mat6& own = one.shape->properties.stiffness;
        shares.back().transfer = one.between->stiffness.ldlt().solve(own).transpose();
    }
    return shares;
}

StressWatch::Largest StressWatch::find_largest(const ShapeShares& shapes, const SectionValues& middle) const {
    constexpr double nan = std::numeric_limits<double>::quiet_NaN();
    if (shapes.empty()) return {nan, nan};
    const Vec6 resultants = join(middle.force, middle.moment);
    Largest largest;
    for (const ShapeShare& share : shapes) {
        const auto value = [&](const std::optional<LargestStress>& found) {
            return found ? share.part * found->value : nan;
        };
        const SectionStresses& stresses = stresses_of(share.shape);
        const Vec6 own = share.resultants(resultants);
        largest.von_mises += value(stresses.find_von_mises(own));
        largest.exposure += value(stresses.find_exposure(own));
    }
    return largest;
}

StressEnvelope::StressEnvelope(const Model& model, const StressWatch& watch, std::size_t first_point)
    : watch_(&watch), first_point_(first_point) {
    for (const RodPlace& place : list_stress_places(model))
        places_.push_back({place, watch.shapes_at(place)});
    von_mises_.resize(places_.size());
    exposure_.resize(places_.size());
}

void StressEnvelope::add(const Snapshot& snapshot) {
    for (std::size_t i = 0; i < places_.size(); ++i) {
        const PointValues& point = snapshot.points[first_point_ + i];
        const Vec6 resultants = join(point.force, point.moment);
        const ShapeShares& shapes = places_[i].shapes;
        keep_larger(
            *watch_, &SectionStresses::find_von_mises, shapes, resultants, snapshot.time, von_mises_[i]);
        keep_larger(
            *watch_, &SectionStresses::find_exposure, shapes, resultants, snapshot.time, exposure_[i]);
    }
}

}  // namespace gxrod
