#include "contact/pairs/pair_impulse.hpp"

#include <algorithm>

#include "contact/segment_pairs.hpp"
#include "rotation/rotation_map.hpp"
#include "tools/catch.hpp"

namespace gxrod::test {
namespace {

// Of contact, with forces of the end of a motion.
double work_of(const PairEnergy& pair, const FourEnds& from, const FourEnds& to) {
    double work = 0.0;
    for (int end = 0; end < 4; ++end)
        work -= pair.gradient.segment<3>(3 * end).dot(to.ends[end] - from.ends[end]);
    return work;
}

PairStart start_of(const FourEnds& before, const OpenEnds& open = {}) {
    const OpenContact contact = find_open_contact(before.a(), before.b(), open);
    return {contact.s, contact.t, contact.offset, contact.offset.norm(), find_ends(before.a(), before.b())};
}

}  // namespace

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
        turn_impulse(pair.a(), pair.b(), {}, start_of(before), wires.radii, impulse);
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
        turn_impulse(pair.a(), pair.b(), {}, start_of(before), wires.radii, impulse);
        CHECK(std::abs(work_of(impulse, before, pair)) < 0.01 * force * wires.radii);
        passed += work_of(at_end, before, pair) > 1.5 * force * wires.radii ? 1 : 0;
        // Along both lines.
        before = pair;
        for (int end = 0; end < 2; ++end) before.ends[end] += h * (A + B).normalized();
        impulse = at_end;
        turn_impulse(pair.a(), pair.b(), {}, start_of(before), wires.radii, impulse);
        CHECK(std::abs(work_of(impulse, before, pair)) < 0.01 * force * h * h);
        ++slid;
    }
    CHECK(turned > 10);
    CHECK(passed > 10);
    CHECK(slid > 10);
    // Forces do not turn without a motion.
    const FourEnds pair = random.make(0.5);
    PairEnergy impulse = compute_pair(pair);
    turn_impulse(pair.a(), pair.b(), {}, start_of(pair), wires.radii, impulse);
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
            if (turned) turn_impulse(pair.a(), pair.b(), {}, start_of(before), wires.radii, impulse);
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

TEST_CASE("No impulse does more work than that of the change of the gap, however far its rods turn",
          "[contact]") {
    RandomPairs random(50);
    int lessened = 0;
    for (int k = 0; k < 100; ++k) {
        INFO(k);
        const FourEnds pair = cross_lines(1.15 + 0.4 * random.number(), 2.01, 20.0);
        const PairEnergy at_end = compute_pair(pair, 20.0, 20.0);
        const double force = at_end.force().norm();
        FourEnds before = pair;
        for (int line = 0; line < 2; ++line) {
            const Vec3 move = 1.5 * random.vector() + Vec3(0, 0, line == 0 ? -1.5 : 1.5);
            const Quat turn = exp_quaternion(0.6 * Vec3(random.vector()));
            for (int end = 2 * line; end < 2 * line + 2; ++end)
                before.ends[end] = move + turn * pair.ends[end];
        }
        const PairStart start = start_of(before);
        PairStart unlimited = start;
        unlimited.distance = -1e6;  // nothing would be too much
        PairEnergy impulse = at_end, whole = at_end;
        turn_impulse(pair.a(), pair.b(), {}, start, wires.radii, impulse);
        turn_impulse(pair.a(), pair.b(), {}, unlimited, wires.radii, whole);
        const double allowed = force * (2.01 - start.distance);
        CHECK(work_of(impulse, before, pair) < allowed + 1e-3 * force * wires.radii);
        lessened += work_of(whole, before, pair) > allowed + 1e-2 * force * wires.radii ? 1 : 0;
        // By nine tenths of the force at most.
        PairStart far = start;
        far.distance = 1e6;
        impulse = at_end;
        turn_impulse(pair.a(), pair.b(), {}, far, wires.radii, impulse);
        CHECK((impulse.force() - whole.force()).norm() == Approx(0.9 * force).epsilon(1e-6));
    }
    CHECK(lessened > 10);
}

TEST_CASE("A drag takes what its force is times the way of two places, and keeps the momentum", "[contact]") {
    RandomPairs random(53);
    for (int k = 0; k < 20; ++k) {
        INFO(k);
        const FourEnds before = random.make(0.3), after = before.moved(0.4 * random.direction());
        PairStart start = start_of(before);
        start.s = k % 2 == 0 ? start.s : -3.0;  // beyond an end: at the end
        const Vec12 way = find_ends(after.a(), after.b()) - start.ends;
        const double s = std::clamp(start.s, 0.0, 1.0), t = std::clamp(start.t, 0.0, 1.0);
        const Vec3 moved = (after.a().at(s) - before.a().at(s)) - (after.b().at(t) - before.b().at(t));
        CHECK((find_relative_way(start, way) - moved).norm() < 1e-14);
        PairEnergy drag;
        add_drag(drag, start, way, 7.0);
        CHECK(drag.gradient.dot(way) == Approx(7.0 * moved.squaredNorm()));
        CHECK((drag.force() + 7.0 * moved).norm() < 1e-12);
        CHECK((drag.gradient.segment<3>(6) + drag.gradient.segment<3>(9) - drag.force()).norm() < 1e-12);
        // It is linear in the way.
        CHECK((drag.hessian * way - drag.gradient).norm() < 1e-12);
        CHECK((drag.hessian - drag.hessian.transpose()).norm() < 1e-12);
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
            turn_impulse(pair.a(), pair.b(), open, start_of(before, open), wires.radii, impulse);
            turn_impulse(pair.a(), pair.b(), {}, start_of(before), wires.radii, clamped);
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
                              k % 5 == 0 ? 1e3 : offset.norm(),
                              find_ends(pair.a(), pair.b()) - (k % 7 == 0 ? 0.1 : 2.0) * random.direction()};
        const OpenEnds open{k % 2 == 0, k % 4 < 2, k % 5 < 3, k % 5 > 1};
        const auto impulse_of = [&](const Vec12& by) {
            const FourEnds moved = pair.moved(by);
            PairEnergy impulse = compute_pair(moved);
            turn_impulse(moved.a(), moved.b(), open, start, wires.radii, impulse);
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

}  // namespace gxrod::test
