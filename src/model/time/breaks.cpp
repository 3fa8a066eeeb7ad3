#include "model/time/breaks.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <limits>

namespace gxrod {

namespace {

// A knot is touched where the argument comes nearer to it than this part of its own change.
constexpr double touching = 1e-9;
constexpr int most_extremum_steps = 60;

// One switch as a function of one number.
class Crossings {
  public:
    Crossings(const std::function<double(double)>& argument,
              const std::vector<double>& knots,
              const Interval& range)
        : argument_(argument),
          knots_(knots),
          resolution_(2.0 * std::numeric_limits<double>::epsilon() *
                      std::max(std::abs(range.from), std::abs(range.to))) {}

    // Between `places`, which are sorted.
    std::vector<double> find(const std::vector<double>& places) {
        std::vector<Point> points;
        points.reserve(places.size());
        for (const double at : places) {
            const Point point = look(at);
            if (!std::isnan(point.value)) points.push_back(point);
        }
        measure(points);
        for (std::size_t i = 0; i + 1 < points.size(); ++i) bisect(points[i], points[i + 1]);
        for (std::size_t i = 0; i + 2 < points.size(); ++i) {
            find_touch(points[i], points[i + 1], points[i + 2]);
        }
        return std::move(found_);
    }

  private:
    struct Point {
        double at;
        double value;
        std::size_t knots_below;  // that the value has reached
    };

    Point look(double at) const {
        const double value = argument_(at);
        const auto above = std::upper_bound(knots_.begin(), knots_.end(), value);
        return {at, value, static_cast<std::size_t>(above - knots_.begin())};
    }

    void measure(const std::vector<Point>& points) {
        const auto [low, high] = std::minmax_element(
            points.begin(), points.end(), [](const Point& a, const Point& b) { return a.value < b.value; });
        change_ = points.empty() ? 0.0 : high->value - low->value;
    }

    // Every crossing between two points, those apart where knots lie between.
    void bisect(const Point& from, const Point& to) {
        if (from.knots_below == to.knots_below) return;
        const double middle = 0.5 * (from.at + to.at);
        if (to.at - from.at <= resolution_ || middle <= from.at || middle >= to.at) {
            found_.push_back(find_plain(to.at));
            return;
        }
        if (const auto [left, right] = cut_by_secant(from, to); right.at > left.at) {
            bisect(from, left);
            bisect(left, right);
            bisect(right, to);
            return;
        }
        Point half = look(middle);
        if (std::isnan(half.value)) half = {middle, from.value, from.knots_below};
        bisect(from, half);
        bisect(half, to);
    }

    // The number of few digits that is meant, such as 2 for 2.0000000000000018, if it is as near as can be
    // told.
    double find_plain(double at) const {
        const double plain = std::strtod(fmt::format("{:.14g}", at).c_str(), nullptr);
        return std::abs(plain - at) <= resolution_ ? plain : at;
    }

    // Two points close to both sides of where a straight line would cross the knot, if it is one knot; equal
    // ones if the argument is not straight there.
    std::pair<Point, Point> cut_by_secant(const Point& from, const Point& to) const {
        const bool is_one =
            std::max(from.knots_below, to.knots_below) == std::min(from.knots_below, to.knots_below) + 1;
        const double width = to.at - from.at;
        if (!is_one || width <= 8.0 * resolution_) return {from, from};
        const double knot = knots_[std::min(from.knots_below, to.knots_below)];
        const double at = from.at + width * ((knot - from.value) / (to.value - from.value));
        const Point left = look(std::max(at - 0.4 * resolution_, from.at));
        const Point right = look(std::min(at + 0.4 * resolution_, to.at));
        const bool is_met = left.knots_below == from.knots_below && right.knots_below == to.knots_below;
        if (!is_met || left.at >= right.at) return {from, from};
        return {left, right};
    }

    double distance(const Point& point) const {
        double nearest = std::numeric_limits<double>::infinity();
        if (point.knots_below > 0) nearest = point.value - knots_[point.knots_below - 1];
        if (point.knots_below < knots_.size())
            nearest = std::min(nearest, knots_[point.knots_below] - point.value);
        return nearest;
    }

    // Where the argument comes near to a knot between two places without having crossed it in either: by
    // golden sections, until it has, or is nearest.
    void find_touch(const Point& from, const Point& middle, const Point& to) {
        const bool is_same = from.knots_below == middle.knots_below && middle.knots_below == to.knots_below;
        const double near = distance(middle);
        const bool turns = near < distance(from) && near <= distance(to);
        if (!is_same || !turns || near >= change_) return;
        Point left = from;
        Point best = middle;
        Point right = to;
        constexpr double golden = 0.381966011250105;
        for (int i = 0; i < most_extremum_steps && right.at - left.at > 4.0 * resolution_; ++i) {
            const bool is_right = right.at - best.at > best.at - left.at;
            const double width = is_right ? right.at - best.at : left.at - best.at;
            const Point next = look(best.at + golden * width);
            if (std::isnan(next.value)) return;
            if (next.knots_below != best.knots_below) {
                bisect(std::min(best, next, earlier), std::max(best, next, earlier));
                (is_right ? bisect(next, right) : bisect(left, next));
                return;
            }
            if (distance(next) < distance(best)) {
                (is_right ? left : right) = best;
                best = next;
            } else {
                (is_right ? right : left) = next;
            }
        }
        if (distance(best) <= touching * change_) found_.push_back(best.at);
    }

    static bool earlier(const Point& a, const Point& b) { return a.at < b.at; }

    const std::function<double(double)>& argument_;
    const std::vector<double>& knots_;
    double resolution_;
    double change_ = 0.0;
    std::vector<double> found_;
};

// Evenly spread ones, and what lies between them already.
std::vector<double> make_places(const Interval& range, int samples, const std::vector<double>& found) {
    std::vector<double> places = found;
    for (int i = 0; i <= samples; ++i) {
        places.push_back(range.from + (range.to - range.from) * (static_cast<double>(i) / samples));
    }
    std::sort(places.begin(), places.end());
    places.erase(std::unique(places.begin(), places.end()), places.end());
    return places;
}

// The breaks where switches become functions of one number by `argument_of`; those that are this number
// itself by `is_own`.
template <class IsOwn, class ArgumentOf>
std::vector<double> find_breaks(const Switches& switches,
                                const Interval& range,
                                int samples,
                                const IsOwn& is_own,
                                const ArgumentOf& argument_of) {
    std::vector<double> found;
    if (!(range.to > range.from)) return found;
    for (const Switch& one : switches) {
        std::vector<double> more = one.knots;
        if (!is_own(one)) {
            const std::function<double(double)> argument = argument_of(one);
            if (!argument) continue;
            more = Crossings(argument, one.knots, range).find(make_places(range, samples, found));
        }
        std::erase_if(more, [&](double at) { return !(at > range.from && at < range.to); });
        found.insert(found.end(), more.begin(), more.end());
        std::sort(found.begin(), found.end());
        found.erase(std::unique(found.begin(), found.end()), found.end());
    }
    return found;
}

}  // namespace

std::vector<double> find_breaks_in_time(const Switches& switches, const Interval& times, int samples) {
    return find_breaks(
        switches,
        times,
        samples,
        [](const Switch& one) { return one.is_variable && one.has_time; },
        [](const Switch& one) -> std::function<double(double)> {
            if (!one.has_time) return nullptr;
            return [&one](double time) { return one.argument(time, 0.0); };
        });
}

std::vector<double> find_breaks_along(const Switches& switches,
                                      double time,
                                      const Interval& rod,
                                      int samples) {
    return find_breaks(
        switches,
        rod,
        samples,
        [](const Switch& one) { return one.is_variable && one.has_arc_length; },
        [time](const Switch& one) -> std::function<double(double)> {
            if (!one.has_arc_length) return nullptr;
            return [&one, time](double s) { return one.argument(time, s); };
        });
}

}  // namespace gxrod
