#include "batch/members/member_stations.hpp"

#include <algorithm>
#include <cmath>

#include "assembly/system_values.hpp"
#include "model/sections/section_at.hpp"

namespace gxrod {
namespace {

class MemberLine {
  public:
    MemberLine(const Member& member, const SteppedRun& run)
        : member_(member),
          run_(run),
          first_(arc_length_of(member.ends[0])),
          last_(arc_length_of(member.ends[1])) {}

    std::vector<StationForces> list_stations() const {
        std::vector<RodPlace> places;
        for (std::size_t i = 0; i < fixed_stations; ++i) {
            const double part = static_cast<double>(i) / static_cast<double>(fixed_stations - 1);
            places.push_back(i == 0                    ? member_.ends[0]
                             : i + 1 == fixed_stations ? member_.ends[1]
                                                       : find_place(first_ + part * (last_ - first_)));
        }
        places.push_back(find_largest_moment());
        std::vector<StationForces> stations;
        for (std::size_t i = 0; i < places.size(); ++i) {
            const PointValues value = run_values({places[i]}).front();
            StationForces& one = stations.emplace_back();
            one.station = station_words[i];
            one.s = arc_length_of(places[i]) - first_;
            one.position = value.start;
            one.forces << value.force, value.moment;
        }
        return stations;
    }

  private:
    std::vector<PointValues> run_values(const std::vector<RodPlace>& places) const {
        const SteppedAnalysis& analysis = run_.analysis();
        const State& state = analysis.state();
        return SystemValues(analysis.system()).compute_point_values(state, state.time, places);
    }

    double arc_length_of(const RodPlace& place) const { return arc_length_at(run_.problem().model, place); }

    RodPlace find_place(double s) const {
        RodPlace place = member_.ends[0];
        place.xi = 1.0;
        while (place.element < member_.ends[1].element && arc_length_of(place) < s) ++place.element;
        double low = -1.0;
        double high = 1.0;
        constexpr int halvings = 60;
        for (int i = 0; i < halvings; ++i) {
            place.xi = 0.5 * (low + high);
            (arc_length_of(place) < s ? low : high) = place.xi;
        }
        return place;
    }

    RodPlace find_largest_moment() const {
        RodPlace best = member_.ends[0];
        double largest = -1.0;
        for (int e = best.element; e <= member_.ends[1].element; ++e) {
            std::vector<RodPlace> places(3, {best.rod, e, -1.0});
            places[1].xi = 0.0;
            places[2].xi = 1.0;
            const std::vector<PointValues> values = run_values(places);
            const auto size_at = [&](double xi) {
                return (0.5 * xi * (xi - 1.0) * values[0].moment.tail<2>() +
                        (1.0 - xi * xi) * values[1].moment.tail<2>() +
                        0.5 * xi * (xi + 1.0) * values[2].moment.tail<2>())
                    .norm();
            };
            const double xi = find_largest(size_at);
            // Round-off chooses no place: the first one is taken of several.
            if (size_at(xi) <= largest * (1.0 + round_off)) continue;
            largest = size_at(xi);
            best = {best.rod, e, xi};
        }
        return best;
    }

    // The place −1 … 1 of the largest value: that of samples, and between its neighbours by golden sections.
    template <class Size>
    static double find_largest(const Size& size_at) {
        constexpr int samples = 32;
        constexpr int sections = 60;
        constexpr double golden = 0.6180339887498949;
        constexpr double spacing = 2.0 / samples;
        double best = -1.0;
        for (int i = 1; i <= samples; ++i) {
            const double xi = -1.0 + i * spacing;
            if (size_at(xi) > size_at(best) * (1.0 + round_off)) best = xi;
        }
        double low = std::max(best - spacing, -1.0);
        double high = std::min(best + spacing, 1.0);
        for (int i = 0; i < sections; ++i) {
            const double left = high - golden * (high - low);
            const double right = low + golden * (high - low);
            if (size_at(left) > size_at(right))
                high = right;
            else
                low = left;
        }
        const double inner = 0.5 * (low + high);
        return size_at(inner) > size_at(best) * (1.0 + round_off) ? inner : best;
    }

    static constexpr double round_off = 1e-9;

    const Member& member_;
    const SteppedRun& run_;
    double first_, last_;  // arc lengths of the ends
};

}  // namespace

std::vector<StationForces> find_station_forces(const Member& member, const SteppedRun& run) {
    return MemberLine(member, run).list_stations();
}

}  // namespace gxrod
