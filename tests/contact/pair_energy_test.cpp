#include "contact/pair_impulse.hpp"

#include <cmath>
#include <numbers>
#include <random>

#include "rotation/rotation_map.hpp"
#include "tools/catch.hpp"

namespace gxrod::test {
namespace {

const PairLaw wires{2.0, {0.02, 30.0}};

struct FourEnds {
    Vec3 ends[4];

    Segment a() const { return {ends[0], ends[1]}; }
    Segment b() const { return {ends[2], ends[3]}; }
    FourEnds moved(const Vec12& by) const {
        FourEnds result = *this;
        for (int k = 0; k < 4; ++k) result.ends[k] += by.segment<3>(3 * k);
        return result;
    }
};

PairEnergy compute_pair(const FourEnds& ends, double length_a = 1.0, double length_b = 1.0) {
    return compute_pair_energy(wires, ends.a(), ends.b(), length_a, length_b);
}

class RandomPairs {
  public:
    explicit RandomPairs(std::uint64_t seed) : random_(seed) {}

    double number() { return uniform_(random_); }
    Vec3 vector() {
        const double x = number(), y = number(), z = number();
        return {x, y, z};
    }
    Vec12 direction() {
        Vec12 by;
        for (double& x : by) x = number();
        return by.normalized();
    }
    // Segments of any position, as far apart as leaves x of the skin: crossings, ends, nearly parallel ones.
    FourEnds make(double x, double size = 1.0) {
        while (true) {
            FourEnds pair{{size * vector(), size * vector(), size * vector(), size * vector()}};
            if (number() > 0.5)
                pair.ends[3] = pair.ends[2] + (pair.ends[1] - pair.ends[0]) + 0.1 * size * vector();
            const ClosestPoints closest = find_closest_points(pair.a(), pair.b());
            if (closest.distance < 0.01) continue;
            const double wanted = wires.radii + x * wires.law.skin;
            const Vec3 shift = (wanted / closest.distance - 1.0) * closest.offset;
            pair.ends[0] += shift;
            pair.ends[1] += shift;
            if (std::abs(find_closest_points(pair.a(), pair.b()).distance - wanted) < 1e-9) return pair;
        }
    }

  private:
    std::mt19937_64 random_;
    std::uniform_real_distribution<double> uniform_{-1.0, 1.0};
};

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

// Long lines at the distance d, at an angle.
FourEnds cross_lines(double angle, double d, double length) {
    const Vec3 along(std::cos(angle), std::sin(angle), 0.0), up(0.0, 0.0, d);
    return {{Vec3(-0.45 * length, 0, 0),
             Vec3(0.55 * length, 0, 0),
             up - 0.52 * length * along,
             up + 0.48 * length * along}};
}

// Of contact, with forces of the end of a motion.
double work_of(const PairEnergy& pair, const FourEnds& from, const FourEnds& to) {
    double work = 0.0;
    for (int end = 0; end < 4; ++end)
        work -= pair.gradient.segment<3>(3 * end).dot(to.ends[end] - from.ends[end]);
    return work;
}

PairStart start_of(const FourEnds& before, const FourEnds& after, const OpenEnds& open = {}) {
    const OpenContact contact = find_open_contact(before.a(), before.b(), open);
    PairStart start{contact.s, contact.t, contact.offset, contact.offset.norm(), {}};
    for (int end = 0; end < 4; ++end) start.way.segment<3>(3 * end) = after.ends[end] - before.ends[end];
    return start;
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

TEST_CASE("Damped forces of a pair have their derivative, and never do more work", "[contact]") {
    RandomPairs random(11);
    for (int sample = 0; sample < 200; ++sample) {
        const FourEnds before = random.make(0.3);
        const Vec12 way = 2e-3 * random.direction();
        const FourEnds now = before.moved(way);
        if (find_closest_points(now.a(), now.b()).distance <= wires.radii) continue;
        for (const double damping : {10.0, 200.0, 2000.0}) {
            INFO(sample << " " << damping);
            const auto damped = [&](const Vec12& by) {
                PairEnergy pair = compute_pair(now.moved(by));
                damp(pair, way + by, damping);
                return pair;
            };
            const PairEnergy pair = damped(Vec12::Zero()), plain = compute_pair(now);
            CHECK(-pair.gradient.dot(way) <= -plain.gradient.dot(way) + 1e-15);
            CHECK(pair.energy == plain.energy);
            const double factor = pair.gradient.norm() / plain.gradient.norm();
            CHECK((pair.gradient - factor * plain.gradient).norm() <= 1e-12 * plain.gradient.norm());
            const Vec12 along = random.direction();
            const double step = 1e-7;
            const Vec12 difference =
                (damped(step * along).gradient - damped(-step * along).gradient) / (2.0 * step);
            if (factor == 0.0) {
                CHECK(pair.hessian.isZero(0.0));
                continue;
            }
            CHECK((pair.hessian * along - difference).norm() <
                  1e-5 * (pair.hessian.norm() + plain.hessian.norm()));
        }
    }
}

TEST_CASE("An impulse turned to the mean normal does no work where a pair slides", "[contact]") {
    RandomPairs random(47);
    const double h = 0.05;
    int turned = 0, passed = 0, slid = 0;
    for (int k = 0; k < 200; ++k) {
        INFO(k);
        const FourEnds pair = random.make(0.1 + 0.4 * (1.0 + random.number()));
        const ClosestPoints at = find_closest_points(pair.a(), pair.b());
        const Vec3 A = pair.ends[1] - pair.ends[0], B = pair.ends[3] - pair.ends[2];
        // Crossings far from ends.
        if (std::abs(at.s - 0.5) > 0.2 || std::abs(at.t - 0.5) > 0.2) continue;
        if (A.cross(B).norm() < 0.5 * A.norm() * B.norm()) continue;
        const PairEnergy at_end = compute_pair(pair);
        const double force = at_end.force().norm();
        // a turns about the line of b: along the normal at the end it would gain F h²/2R.
        FourEnds before = pair;
        const Quat turn = exp_quaternion(h / wires.radii * B.normalized());
        for (int end = 0; end < 2; ++end)
            before.ends[end] = turn * Vec3(pair.ends[end] - pair.ends[2]) + pair.ends[2];
        PairEnergy impulse = at_end;
        turn_impulse(pair.a(), pair.b(), {}, start_of(before, pair), wires.radii, impulse);
        CHECK(std::abs(work_of(impulse, before, pair)) < 0.01 * force * h * h);
        turned += work_of(at_end, before, pair) > 0.2 * force * h * h ? 1 : 0;
        CHECK((impulse.gradient.segment<3>(0) + impulse.gradient.segment<3>(3) +
               impulse.gradient.segment<3>(6) + impulse.gradient.segment<3>(9))
                  .norm() < 1e-12 * force);
        // By more than a right angle in the step: to the other side of b. Pushed on there, it would gain.
        const Quat far = exp_quaternion(2.4 * B.normalized());
        for (int end = 0; end < 2; ++end)
            before.ends[end] = far * Vec3(pair.ends[end] - pair.ends[2]) + pair.ends[2];
        impulse = at_end;
        turn_impulse(pair.a(), pair.b(), {}, start_of(before, pair), wires.radii, impulse);
        CHECK(std::abs(work_of(impulse, before, pair)) < 0.01 * force * wires.radii);
        passed += work_of(at_end, before, pair) > 1.5 * force * wires.radii ? 1 : 0;
        // Along both lines.
        before = pair;
        for (int end = 0; end < 2; ++end) before.ends[end] += h * (A + B).normalized();
        impulse = at_end;
        turn_impulse(pair.a(), pair.b(), {}, start_of(before, pair), wires.radii, impulse);
        CHECK(std::abs(work_of(impulse, before, pair)) < 0.01 * force * h * h);
        ++slid;
    }
    CHECK(turned > 10);
    CHECK(passed > 10);
    CHECK(slid > 10);
    // Forces do not turn without a motion.
    const FourEnds pair = random.make(0.5);
    PairEnergy impulse = compute_pair(pair);
    turn_impulse(pair.a(), pair.b(), {}, start_of(pair, pair), wires.radii, impulse);
    CHECK(impulse.gradient.isApprox(compute_pair(pair).gradient, 1e-12));
}

TEST_CASE("An impulse keeps energy and angular momentum up to the third power of a motion", "[contact]") {
    RandomPairs random(49);
    for (int k = 0; k < 20; ++k) {
        INFO(k);
        const FourEnds pair = cross_lines(1.15 + 0.4 * random.number(), 2.01, 20.0);
        const ClosestPoints at = find_closest_points(pair.a(), pair.b());
        const PairEnergy at_end = compute_pair(pair, 20.0, 20.0);
        const double force = at_end.force().norm();
        // A turn about the normal changes the angle of the lines, and with it their energy.
        const Vec3 flat(1.0, 1.0, 0.0);
        const Vec3 turns[2] = {random.vector().cwiseProduct(flat), random.vector().cwiseProduct(flat)},
                   moves[2] = {Vec3(1, 1, 0.1).cwiseProduct(random.vector()),
                               Vec3(1, 1, 0.1).cwiseProduct(random.vector())};
        // What the work differs by from that of the change of the gap, and the change of angular momentum.
        const auto errors_of = [&](double h, bool turned) {
            FourEnds before = pair;
            for (int end = 0; end < 4; ++end) {
                const int line = end / 2;
                const Vec3 about = line == 0 ? pair.a().at(at.s) : pair.b().at(at.t);
                before.ends[end] =
                    about + h * moves[line] + exp_quaternion(h * turns[line]) * Vec3(pair.ends[end] - about);
            }
            PairEnergy impulse = at_end;
            if (turned) turn_impulse(pair.a(), pair.b(), {}, start_of(before, pair), wires.radii, impulse);
            Vec3 moment = Vec3::Zero();
            for (int end = 0; end < 4; ++end)
                moment -=
                    0.5 * (before.ends[end] + pair.ends[end]).cross(impulse.gradient.segment<3>(3 * end));
            const double change = at.distance - find_closest_points(before.a(), before.b()).distance;
            return std::pair(std::abs(work_of(impulse, before, pair) - force * change) / force,
                             moment.norm() / force);
        };
        const auto [work, moment] = errors_of(0.02, true);
        const auto [plain_work, plain_moment] = errors_of(0.02, false);
        CHECK(work < 2e-5);
        CHECK(moment < 1e-3);
        CHECK(moment < 0.1 * plain_moment);
        if (plain_work > 1e-4) CHECK(work < 0.1 * plain_work);
    }
}

TEST_CASE("What slides along a line of several pieces is not braked", "[contact]") {
    const double length = 1.2;
    double braked = 0.0;
    for (const double place : {-0.5, -0.2, 0.0, 0.1, 0.45}) {
        INFO(place);
        double work = 0.0, clamped_work = 0.0, force = 0.0;
        const double slide = 0.7;
        for (int piece = -2; piece < 2; ++piece) {
            const Vec3 along(std::cos(1.1), std::sin(1.1), 0.0), up(0.0, 0.0, 2.01);
            const double start = (piece + place) * length;
            const FourEnds pair{
                {Vec3(-8, 0, 0), Vec3(8, 0, 0), up + start * along, up + (start + length) * along}};
            FourEnds before = pair;
            for (int end = 2; end < 4; ++end) before.ends[end] -= slide * along;
            const PairEnergy at_end = compute_pair(pair, 16.0, length);
            if (at_end.energy == 0.0) continue;
            force += at_end.force().norm();
            const OpenEnds open{false, false, true, true};
            PairEnergy impulse = at_end, clamped = at_end;
            turn_impulse(pair.a(), pair.b(), open, start_of(before, pair, open), wires.radii, impulse);
            turn_impulse(pair.a(), pair.b(), {}, start_of(before, pair), wires.radii, clamped);
            work += work_of(impulse, before, pair);
            clamped_work += work_of(clamped, before, pair);
        }
        CHECK(std::abs(work) < 1e-4 * force * slide);
        braked = std::max(braked, std::abs(clamped_work) / (force * slide));
    }
    CHECK(braked > 0.05);
}

TEST_CASE("A turned impulse has its derivative", "[contact]") {
    RandomPairs random(48);
    for (int k = 0; k < 60; ++k) {
        INFO(k);
        const FourEnds pair = random.make(0.1 + 0.4 * (1.0 + random.number()));
        if (compute_pair(pair).energy < 1e-9) continue;
        const ClosestPoints at = find_closest_points(pair.a(), pair.b());
        const auto is_clear = [](double place) {
            return place == 0.0 || place == 1.0 || std::abs(place - 0.5) < 0.49;
        };
        const Vec3 A = pair.ends[1] - pair.ends[0], B = pair.ends[3] - pair.ends[2];
        if (!is_clear(at.s) || !is_clear(at.t) || A.cross(B).norm() < 0.1 * A.norm() * B.norm()) continue;
        const double side = k % 3 == 0 ? -1.0 : 1.0;
        const Vec3 offset = side * at.offset.normalized() + 0.8 * random.vector();
        const PairStart start{at.s + 0.3 * random.number(),
                              random.number(),
                              offset,
                              offset.norm(),
                              (k % 7 == 0 ? 0.1 : 2.0) * random.direction()};
        const OpenEnds open{k % 2 == 0, k % 4 < 2, k % 5 < 3, k % 5 > 1};
        const auto impulse_of = [&](const Vec12& by) {
            const FourEnds moved = pair.moved(by);
            PairEnergy impulse = compute_pair(moved);
            turn_impulse(moved.a(),
                         moved.b(),
                         open,
                         {start.s, start.t, start.offset, start.distance, start.way + by},
                         wires.radii,
                         impulse);
            return impulse;
        };
        const Vec12 by = random.direction();
        const double h = 2e-4 * wires.law.skin;
        Vec12 change = Vec12::Zero();
        const double weights[3] = {45.0, -9.0, 1.0};
        for (int i = 1; i <= 3; ++i)
            change += weights[i - 1] * (impulse_of(i * h * by).gradient - impulse_of(-i * h * by).gradient) /
                      (60.0 * h);
        const PairEnergy here = impulse_of(Vec12::Zero());
        CHECK((change - here.hessian * by).norm() < 1e-6 * here.hessian.norm());
    }
}

TEST_CASE("The energy of the least distance has its derivatives", "[contact]") {
    RandomPairs random(45);
    const auto energy_of = [](const FourEnds& ends) {
        return compute_closest_energy(wires, ends.a(), ends.b());
    };
    for (int k = 0; k < 120; ++k) {
        INFO(k);
        FourEnds pair = random.make(0.1 + 0.4 * (1.0 + random.number()));
        const ClosestPoints at = find_closest_points(pair.a(), pair.b());
        // Away from where the closest points change their kind, and from parallel lines.
        const auto is_clear = [](double place) {
            return place == 0.0 || place == 1.0 || std::abs(place - 0.5) < 0.49;
        };
        const Vec3 A = pair.ends[1] - pair.ends[0], B = pair.ends[3] - pair.ends[2];
        if (!is_clear(at.s) || !is_clear(at.t) || A.cross(B).norm() < 0.1 * A.norm() * B.norm()) continue;
        check_pair_derivatives(energy_of, pair, random.direction(), 2e-4 * wires.law.skin);
        CHECK(energy_of(pair).energy == Approx(compute_contact_energy(wires.law, at.distance - 2.0)));
    }
    // Two points, and a point and a segment.
    const FourEnds points{{Vec3(0, 0, 0), Vec3(0, 0, 0), Vec3(0, 1.2, 1.61), Vec3(0, 1.2, 1.61)}};
    CHECK(energy_of(points).force().norm() ==
          Approx(compute_contact_force(wires.law, std::hypot(1.2, 1.61) - 2.0)).epsilon(1e-9));
    const FourEnds over{{Vec3(0.2, 0, 2.01), Vec3(0.2, 0, 2.01), Vec3(-1, 0, 0), Vec3(1, 0, 0)}};
    CHECK(energy_of(over).gradient[11] / energy_of(over).force()[2] == Approx(0.6));
    CHECK(energy_of(over).force()[2] == Approx(15.0));
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
