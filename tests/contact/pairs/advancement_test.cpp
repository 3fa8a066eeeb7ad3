#include "contact/pairs/advancement.hpp"

#include <cmath>
#include <random>

#include "tools/catch.hpp"

namespace gxrod::test {
namespace {

template <class Gap>
Advancement advance_by_speed(const Gap& gap_at, double speed, const AdvancementLimits& limits = {}) {
    return advance([&](double t) { return GapAndSpeed{gap_at(t), speed}; }, limits);
}

Segment between(const Segment& from, const Segment& to, double t) {
    return {from.start + t * (to.start - from.start), from.end + t * (to.end - from.end)};
}

}  // namespace

TEST_CASE("Capsules that move at random keep a tenth of their gap", "[contact]") {
    std::mt19937_64 random(11);
    std::uniform_real_distribution<double> uniform(-1.0, 1.0);
    const auto segment = [&](double scale) {
        const double a = uniform(random), b = uniform(random), c = uniform(random);
        const double d = uniform(random), e = uniform(random), f = uniform(random);
        return Segment{scale * Vec3(a, b, c), scale * Vec3(d, e, f)};
    };
    int limited = 0, tried = 0, capped = 0, evaluations = 0;
    double least = 1.0, longest = 0.0;
    while (tried < 5000) {
        const Segment a = segment(1.0), b = segment(1.0);
        const double radii = 0.2 * std::abs(uniform(random));
        const double gap = find_closest_points(a, b).distance - radii;
        if (gap <= 0.0) continue;
        ++tried;
        const double scale = std::pow(10.0, uniform(random));
        const Segment da = segment(scale), db = segment(scale);
        const Segment a_end{a.start + da.start, a.end + da.end}, b_end{b.start + db.start, b.end + db.end};
        const Advancement advancement = advance_capsules(a, a_end, b, b_end, radii);
        const double fraction = advancement.fraction;
        CHECK((fraction > 0.0 && fraction <= 1.0));
        capped += advancement.evaluations >= 64;
        evaluations += advancement.evaluations;
        const auto gap_at = [&](double t) {
            return find_closest_points(between(a, a_end, t), between(b, b_end, t)).distance - radii;
        };
        for (int k = 0; k <= 200; ++k) least = std::min(least, gap_at(fraction * k / 200.0) / gap);
        if (fraction < 1.0 && advancement.evaluations < 64) {
            ++limited;
            longest = std::max(longest, gap_at(fraction) / gap);
        }
    }
    CHECK(least > 0.1 - 1e-9);
    CHECK(longest < 0.105 + 1e-9);
    CHECK(limited > 300);
    CHECK(capped < 10);
    CHECK(evaluations < 4 * tried);
}

TEST_CASE("Simple motions advance to where a tenth of the gap is left", "[contact]") {
    const Vec3 o(0, 0, 0), x(1, 0, 0), y(0, 1, 0), z(0, 0, 1);
    AdvancementLimits sharp;
    sharp.tolerance = 1e-9;
    const auto advance = [&](const Segment& a,
                             const Segment& b,
                             const Segment& da,
                             const Segment& db,
                             double radii) {
        return advance_capsules(
            a, {a.start + da.start, a.end + da.end}, b, {b.start + db.start, b.end + db.end}, radii, sharp);
    };
    // A crossing: one falls by 1 from a gap of 0.5 − 0.1.
    const Segment along{-x, x}, across{0.5 * z - y, 0.5 * z + y}, rest{o, o}, fall{-z, -z};
    CHECK(advance(along, across, rest, fall, 0.1).fraction == Approx(0.9 * 0.4).epsilon(1e-8));
    // What both do together does not count, and takes one evaluation.
    const Vec3 far(300, -200, 100);
    CHECK(advance(along, across, {far, far}, {far, far}, 0.1).evaluations == 1);
    CHECK(advance(along, across, {far, far}, {far - z, far - z}, 0.1).fraction == Approx(0.36).epsilon(1e-8));
    // Nor does sliding along the other.
    CHECK(advance(along, across, {50 * x, 50 * x}, {20 * y, 20 * y}, 0.499).evaluations == 1);
    // One end falls: it is 1 − t = 0.14 √(4 + t²), because the other line tilts.
    const double t = (1.0 - std::sqrt(1.0 - 0.9804 * 0.9216)) / 0.9804;
    CHECK(advance(along, across, rest, {-z, o}, 0.1).fraction == Approx(t).epsilon(1e-8));
    // Two balls that pass at an angle: |p + t v| = 0.3 + 0.1 (|p| − 0.3).
    const Vec3 p(2.0, 0.1, 0.0), v(-4.0, 0.2, 0.0);
    const double reach = 0.3 + 0.1 * (p.norm() - 0.3);
    const double half = p.dot(v),
                 root = std::sqrt(half * half - v.squaredNorm() * (p.squaredNorm() - reach * reach));
    CHECK(advance({p, p}, {o, o}, {v, v}, rest, 0.3).fraction ==
          Approx((-half - root) / v.squaredNorm()).epsilon(1e-7));
    // Through each other and out again: no end of the motion hides that.
    CHECK(advance(along, across, rest, {-200 * z, -200 * z}, 0.1).fraction ==
          Approx(0.36 / 200.0).epsilon(1e-8));
    // No gap, no way.
    CHECK(advance(along, across, rest, fall, 0.5).fraction == 0.0);
    CHECK(advance(along, along, rest, fall, 0.0).fraction == 0.0);
}

TEST_CASE("A gap of bounded speed advances safely, however few evaluations it gets", "[contact]") {
    // A ball in a hollow sphere of radius 1, and one over a plane; the motions are straight.
    const Vec3 from(0.2, 0.1, 0.0), motion(3.0, 0.5, -0.2);
    const auto inside = [&](double t) { return 0.9 - (from + t * motion).norm(); };
    AdvancementLimits limits;
    limits.tolerance = 1e-9;
    const double floor = 0.1 * inside(0.0);
    const Advancement full = advance_by_speed(inside, motion.norm(), limits);
    CHECK(inside(full.fraction) == Approx(floor).epsilon(1e-6));
    CHECK(advance_by_speed([](double t) { return 2.0 - 4.0 * t; }, 4.0, limits).fraction ==
          Approx(0.45).epsilon(1e-9));
    CHECK(advance_by_speed([](double) { return 2.0; }, 0.0).fraction == 1.0);
    CHECK(advance_by_speed([](double) { return 0.0; }, 1.0).fraction == 0.0);
    // A graze at high speed takes many evaluations; fewer end sooner.
    const auto graze = [](double t) { return std::hypot(1.0 - 2.0 * t, 0.12) - 0.01; };
    double last = 0.0;
    for (const int most : {1, 2, 4, 8, 1000}) {
        limits.most_evaluations = most;
        const Advancement advancement = advance_by_speed(graze, 2.0, limits);
        CHECK(advancement.evaluations <= most);
        CHECK(advancement.fraction > last);
        last = advancement.fraction;
    }
    CHECK(last == 1.0);
}

}  // namespace gxrod::test
