#include "contact/segment_pairs.hpp"
#include "rotation/rotation_map.hpp"
#include "tools/catch.hpp"

namespace gxrod::test {
namespace {

template <class Energy>
void check_pair_derivatives(const Energy& energy_of, const FourEnds& pair, const Vec12& by, double h) {
    const PairEnergy here = energy_of(pair);
    double slope = 0.0;
    Vec12 change = Vec12::Zero();
    // Sixth order.
    const double weights[3] = {45.0, -9.0, 1.0};
    for (int k = 1; k <= 3; ++k) {
        const PairEnergy plus = energy_of(pair.moved(k * h * by)), minus = energy_of(pair.moved(-k * h * by));
        slope += weights[k - 1] * (plus.energy - minus.energy) / (60.0 * h);
        change += weights[k - 1] * (plus.gradient - minus.gradient) / (60.0 * h);
    }
    CHECK(std::abs(slope - here.gradient.dot(by)) < 1e-7 * here.gradient.norm());
    CHECK((change - here.hessian * by).norm() < 1e-6 * here.hessian.norm());
    CHECK((here.hessian - here.hessian.transpose()).norm() < 1e-12 * here.hessian.norm());
}

}  // namespace

TEST_CASE("Gradient and Hessian of a pair are those of its energy", "[contact]") {
    RandomPairs random(21);
    for (int k = 0; k < 120; ++k) {
        const double x = 0.1 + 0.35 * (1.0 + random.number());
        const FourEnds pair = random.make(x);
        if (compute_pair(pair).energy < 1e-9) continue;
        INFO(k << " at " << x);
        check_pair_derivatives([](const FourEnds& ends) { return compute_pair(ends, 0.9, 1.3); },
                               pair,
                               random.direction(),
                               2e-4 * wires.law.skin);
    }
}

TEST_CASE("Lines that cross, or lie along each other, repel as the closed forms say", "[contact]") {
    const double w = 0.02 * 4.02, c = 30.0 * 0.02 / (std::numbers::pi * w);
    const auto kernel = [w](double u) { return std::pow(1.0 - u / w, 3) * (w / u) * (w / u); };
    for (const double gap : {0.9, 0.5, 0.2, 0.05}) {
        const double d = 2.0 + gap * 0.02;
        for (const double degrees : {90.0, 30.0, 5.0}) {
            INFO(gap << " at " << degrees);
            const double angle = degrees * std::numbers::pi / 180.0, length = 30.0;
            const PairEnergy pair = compute_pair(cross_lines(angle, d, length), length, length);
            const double force = c * 2.0 * std::numbers::pi * d * kernel(d * d - 4.0) / std::sin(angle);
            // Of eight points on the line that is integrated numerically.
            CHECK(-pair.force()[2] == Approx(force).epsilon(gap > 0.1 ? 1e-4 : 2e-3));
            CHECK(pair.force().head<2>().norm() < 1e-3 * force);
            // Where it acts.
            CHECK(pair.gradient[5] / -pair.force()[2] == Approx(0.45).margin(1e-5));
            CHECK(pair.gradient[11] / pair.force()[2] == Approx(0.52).margin(1e-5));
        }
        // Parallel: a short piece over the middle of a long line, by a sum over the closed kernel.
        const double reach = std::sqrt(w - (d * d - 4.0));
        double force = 0.0;
        for (int k = 0; k < 4000; ++k) {
            const double z = reach * (k + 0.5) / 4000.0, u = d * d - 4.0 + z * z;
            const double slope = -std::pow(1.0 - u / w, 2) * (2.0 + u / w) * std::pow(w / u, 3) / w;
            force += -2.0 * c * 2.0 * d * slope * reach / 4000.0;
        }
        const FourEnds along{{Vec3(-0.5, 0, 0), Vec3(0.5, 0, 0), Vec3(-20, 0, d), Vec3(20, 0, d)}};
        CHECK(-compute_pair(along, 1.0, 40.0).force()[2] == Approx(force).epsilon(1e-5));
    }
}

TEST_CASE("The energy of a pair moves with it, and is the same for both orders", "[contact]") {
    RandomPairs random(33);
    for (int k = 0; k < 30; ++k) {
        INFO(k);
        const FourEnds pair = random.make(0.5, 0.4);
        const PairEnergy here = compute_pair(pair);
        const Mat3 R = exp_matrix(3.0 * random.vector());
        const Vec3 shift = 10.0 * random.vector();
        FourEnds turned = pair;
        for (Vec3& end : turned.ends) end = R * end + shift;
        const PairEnergy there = compute_pair(turned);
        CHECK(there.energy == Approx(here.energy).epsilon(1e-9).margin(1e-14));
        CHECK((there.force() - R * here.force()).norm() < 1e-8 * here.gradient.norm());
        // No resultant force or moment.
        Vec3 force = Vec3::Zero(), moment = Vec3::Zero();
        for (int end = 0; end < 4; ++end) {
            force += here.gradient.segment<3>(3 * end);
            moment += pair.ends[end].cross(here.gradient.segment<3>(3 * end));
        }
        CHECK(force.norm() <= 1e-12 * here.gradient.norm());
        CHECK(moment.norm() <= 1e-12 * here.gradient.norm());
        // The other order integrates the other line numerically.
        const PairEnergy swapped = compute_pair({{pair.ends[2], pair.ends[3], pair.ends[0], pair.ends[1]}});
        CHECK(swapped.energy == Approx(here.energy).epsilon(0.01).margin(1e-6));
    }
}

TEST_CASE("A segment that is cut in two keeps its energy", "[contact]") {
    const double length = 0.6;
    for (const double gap : {0.8, 0.3})
        for (const double degrees : {90.0, 30.0, 5.0, 0.0})
            for (const double cut : {0.2, 0.44, 0.45, 0.5}) {
                INFO(gap << " at " << degrees << " cut at " << cut);
                const FourEnds whole =
                    cross_lines(degrees * std::numbers::pi / 180.0, 2.0 + gap * 0.02, length);
                const double energy = compute_pair(whole, length, length).energy;
                const Vec3 on_a = whole.a().at(cut), on_b = whole.b().at(cut);
                const auto sum = [&](const Segment& first, const Segment& second, bool is_a) {
                    const double l1 = length * cut, l2 = length * (1.0 - cut);
                    if (is_a)
                        return compute_pair_energy(wires, first, whole.b(), l1, length).energy +
                               compute_pair_energy(wires, second, whole.b(), l2, length).energy;
                    return compute_pair_energy(wires, whole.a(), first, length, l1).energy +
                           compute_pair_energy(wires, whole.a(), second, length, l2).energy;
                };
                const double tolerance = 1e-2;
                CHECK(sum({whole.ends[0], on_a}, {on_a, whole.ends[1]}, true) ==
                      Approx(energy).epsilon(tolerance));
                CHECK(sum({whole.ends[2], on_b}, {on_b, whole.ends[3]}, false) ==
                      Approx(energy).epsilon(tolerance));
            }
}

TEST_CASE("The force of lines that are nearly parallel is that of many short pieces", "[contact]") {
    RandomPairs random(41);
    const PairLaw rods{0.01, {1e-4, 1.5}};
    const double length = 0.025;
    double largest = 0.0;
    for (const double spread : {3e-3, 0.03, 0.1}) {
        for (int k = 0; k < 200;) {
            // The end of b lies somewhere along a.
            const Vec3 along = random.vector().normalized();
            const Vec3 beside = (along + spread * random.vector()).normalized();
            const Vec3 middle = 0.8 * length * random.number() * along + 0.002 * random.vector();
            Segment a{-0.5 * length * along, 0.5 * length * along};
            const Segment b{middle - 0.5 * length * beside, middle + 0.5 * length * beside};
            const ClosestPoints closest = find_closest_points(a, b);
            const double distance = rods.radii + (0.55 + 0.35 * random.number()) * rods.law.skin;
            const Vec3 shift = (distance / closest.distance - 1.0) * closest.offset;
            a = {a.start + shift, a.end + shift};
            if (std::abs(find_closest_points(a, b).distance - distance) > 1e-9) continue;
            ++k;
            constexpr int pieces = 64;
            Vec3 sum = Vec3::Zero();
            for (int i = 0; i < pieces; ++i) {
                const Segment piece{a.at(double(i) / pieces), a.at(double(i + 1) / pieces)};
                sum += compute_pair_energy(rods, piece, b, length / pieces, length).force();
            }
            const Vec3 force = compute_pair_energy(rods, a, b, length, length).force();
            largest = std::max(largest, (force - sum).norm() / sum.norm());
        }
    }
    INFO(largest);
    CHECK(largest < 0.01);
}

TEST_CASE("The energy of two points has its derivatives", "[contact]") {
    RandomPairs random(45);
    const auto energy_of = [](const FourEnds& pair) {
        return compute_points_energy(wires, pair.ends[0], pair.ends[2]);
    };
    for (int k = 0; k < 20; ++k) {
        INFO(k);
        FourEnds pair{{random.vector(), random.vector(), Vec3::Zero(), random.vector()}};
        const double gap = (0.1 + 0.4 * (1.0 + random.number())) * wires.law.skin;
        pair.ends[2] = pair.ends[0] + (wires.radii + gap) * random.vector().normalized();
        check_pair_derivatives(energy_of, pair, random.direction(), 2e-4 * wires.law.skin);
        CHECK(energy_of(pair).energy == Approx(compute_contact_energy(wires.law, gap)));
        const Vec3 away = (pair.ends[0] - pair.ends[2]).normalized();
        CHECK(energy_of(pair).force().dot(away) ==
              Approx(compute_contact_force(wires.law, gap)).epsilon(1e-9));
    }
    const FourEnds apart{{Vec3(0, 0, 0), Vec3(), Vec3(0, 0, 2.021), Vec3()}};
    CHECK(energy_of(apart).energy == 0.0);
}

TEST_CASE("The energy of a point and a line has its derivatives, and is that of its parts", "[contact]") {
    RandomPairs random(46);
    const auto energy_of = [](const FourEnds& ends) {
        return compute_point_energy(wires, ends.ends[0], ends.b(), 1.3);
    };
    int near_ends = 0;
    for (int k = 0; k < 120; ++k) {
        INFO(k);
        FourEnds pair = random.make(0.1 + 0.4 * (1.0 + random.number()));
        // The start of a as far from b as a was.
        const ClosestPoints at = find_closest_points(pair.a(), pair.b());
        pair.ends[0] = pair.a().at(at.s);
        near_ends += at.t == 0.0 || at.t == 1.0 ? 1 : 0;
        if (energy_of(pair).energy < 1e-6) continue;
        check_pair_derivatives(energy_of, pair, random.direction(), 2e-4 * wires.law.skin);
        const double cut = 0.3;
        const Vec3 between = pair.b().at(cut);
        CHECK(compute_point_energy(wires, pair.ends[0], {pair.ends[2], between}, 1.3 * cut).energy +
                  compute_point_energy(wires, pair.ends[0], {between, pair.ends[3]}, 1.3 * (1.0 - cut))
                      .energy ==
              Approx(energy_of(pair).energy).epsilon(1e-9));
    }
    CHECK(near_ends > 10);
}

TEST_CASE("A point abreast of the end of a line has a finite energy, however near to abreast", "[contact]") {
    const auto energy_at = [](double beyond) {
        return compute_point_energy(wires, Vec3(-beyond, 0, 2.01), {Vec3(0, 0, 0), Vec3(1, 0, 0)}, 1.0);
    };
    const PairEnergy there = energy_at(0.0);
    CHECK(there.energy ==
          Approx(0.5 *
                 compute_point_energy(wires, Vec3(0, 0, 2.01), {Vec3(-1, 0, 0), Vec3(1, 0, 0)}, 2.0).energy));
    for (const double size : {1e-300, 1e-170, 1e-20, 1e-9}) {
        for (const double beyond : {-size, size}) {
            INFO(beyond);
            const PairEnergy near = energy_at(beyond);
            CHECK(near.energy == Approx(there.energy).epsilon(1e-6));
            CHECK((near.gradient - there.gradient).norm() < 1e-6 * there.gradient.norm());
            CHECK((near.hessian - there.hessian).norm() < 1e-6 * there.hessian.norm());
        }
    }
}

TEST_CASE("A point over a long line has the force of the law at half the skin", "[contact]") {
    const Segment line{Vec3(-1, 0, 0), Vec3(1.5, 0, 0)};
    const PairEnergy half = compute_point_energy(wires, Vec3(0.2, 0, 2.01), line, 2.5);
    // 15, but that u is not linear in the gap: by the integral over the line in numpy.
    CHECK(half.force().isApprox(Vec3(0, 0, 15.182298132), 1e-8));
    // An integral by the trapezoidal rule.
    const double w = 0.02 * 4.02, G = 2.01 * 2.01 - 4.0;
    double sum = 0.0;
    constexpr int pieces = 200000;
    for (int i = 0; i < pieces; ++i) {
        const double z = -1.0 + (i + 0.5) * (2.0 / pieces), x = (G + z * z) / w;
        if (x < 1.0) sum += 2.0 / pieces * std::pow(1.0 - x, 3) / (x * x);
    }
    CHECK(half.energy == Approx(30.0 * 0.02 / (4.0 * std::sqrt(2.0 * w)) * sum).epsilon(1e-6));
    // Beyond its ends it grows without bound, too.
    double before = 0.0;
    for (const double gap : {0.019, 0.01, 1e-3, 1e-4}) {
        const double energy = compute_point_energy(wires, Vec3(3.5 + gap, 0, 0), line, 2.5).energy;
        CHECK(energy > 4.0 * before);
        before = energy;
    }
    CHECK(compute_point_energy(wires, Vec3(3.521, 0, 0), line, 2.5).energy == 0.0);
}

}  // namespace gxrod::test
