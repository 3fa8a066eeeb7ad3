#include "contact/pairs/open_contact.hpp"

#include <cmath>

#include "tools/catch.hpp"
#include "tools/random_values.hpp"

using namespace gxrod;
using namespace gxrod::tools;

namespace {

constexpr OpenEnds all_open{true, true, true, true};

Segment piece_of(const Vec3& point, const Vec3& along, double from) {
    return {point + from * along, point + (from + 1.0) * along};
}

}  // namespace

TEST_CASE("open contact: places and offsets are those of the lines, whichever pieces of them are taken",
          "[contact]") {
    const Vec3 along(1, 0, 0), across(0.3, 1, 0);
    for (const double from : {-3.0, -1.2, -0.4, 0.3, 2.0}) {
        INFO(from);
        const Segment a = piece_of({0, 0, 1}, along, from), b = piece_of({0, 0, 0}, across, 0.5 * from + 0.1);
        const OpenContact contact = find_open_contact(a, b, all_open);
        CHECK((contact.offset - Vec3(0, 0, 1)).norm() < 2e-3);
        CHECK(contact.s == Approx(-from).margin(2e-3));
        CHECK(contact.t == Approx(-0.5 * from - 0.1).margin(2e-3));
        CHECK(contact.crossing > 0.99);
    }
}

TEST_CASE("open contact: ends of lines are ends", "[contact]") {
    const Segment a = piece_of({0, 0, 1}, {1, 0, 0}, 0.5), b = piece_of({0, 0, 0}, {0, 1, 0}, -0.5);
    const OpenContact closed = find_open_contact(a, b, {});
    CHECK(closed.s == 0.0);
    CHECK(closed.offset.isApprox(Vec3(0.5, 0, 1)));
    // The other end is another matter.
    CHECK(find_open_contact(a, b, {false, true, true, true}).offset.isApprox(Vec3(0.5, 0, 1)));
    const OpenContact open = find_open_contact(a, b, {true, false, false, false});
    CHECK(open.s == Approx(-0.5).margin(1e-3));
    CHECK(open.offset.isApprox(Vec3(0, 0, 1), 1e-3));
    // A point is seen by a line at right angles.
    const Segment point{{0.2, -0.9, 3}, {0.2, -0.9, 3}};
    const OpenContact seen = find_open_contact(point, b, {false, false, true, true});
    CHECK(seen.offset.isApprox(Vec3(0.2, 0, 3)));
    CHECK(seen.t == Approx(-0.4));
}

TEST_CASE("open contact: parallel lines are apart by what is across them", "[contact]") {
    for (const double turn : {0.0, 1e-9, 1e-3, 0.02}) {
        INFO(turn);
        const Segment a = piece_of({0, 0, 1}, {1, 0, 0}, 0.0);
        const Segment b = piece_of({0, 0, 0}, {std::cos(turn), std::sin(turn), 0}, 1.3);
        const OpenContact contact = find_open_contact(a, b, all_open);
        CHECK((contact.offset - Vec3(0, 0, 1)).norm() < 1e-9 + 3.0 * turn);
        CHECK(contact.crossing < 1e-3);
        CHECK(std::abs(contact.s - 1.15) < 0.1);
    }
}

TEST_CASE("open contact: derivatives by the ends", "[contact]") {
    RandomValues random(63);
    int beyond = 0;
    for (int k = 0; k < 200; ++k) {
        INFO(k);
        const Vec3 p = random.vector(), q = random.vector(), A = random.vector();
        // Of every angle.
        const Vec3 B = k % 3 == 0 ? Vec3(A + 0.2 * random.vector()) : random.vector();
        const OpenEnds open{k % 2 == 0, k % 5 < 3, k % 3 == 0, k % 7 < 4};
        const Eigen::Matrix<double, 12, 1> by = random.matrix<12, 1>();
        const auto at = [&](double h) {
            const auto end = [&](const Vec3& x, int i) { return Vec3(x + h * by.segment<3>(3 * i)); };
            return find_open_contact({end(p, 0), end(p + A, 1)}, {end(q, 2), end(q + B, 3)}, open);
        };
        const OpenContact here = at(0.0), plus = at(1e-6), minus = at(-1e-6);
        // Where closest points come to an end, derivatives jump.
        if ((plus.offset + minus.offset - 2.0 * here.offset).norm() > 1e-9) continue;
        beyond += here.s < 0.0 || here.s > 1.0 ? 1 : 0;
        const double scale = 1.0 + here.s_by.norm() + here.t_by.norm();
        CHECK(std::abs((plus.s - minus.s) / 2e-6 - here.s_by.dot(by)) < 1e-6 * scale);
        CHECK(std::abs((plus.t - minus.t) / 2e-6 - here.t_by.dot(by)) < 1e-6 * scale);
        CHECK(std::abs((plus.crossing - minus.crossing) / 2e-6 - here.crossing_by.dot(by)) < 1e-6 * scale);
        CHECK(((plus.offset - minus.offset) / 2e-6 - here.offset_by * by).norm() < 1e-6 * scale);
    }
    CHECK(beyond > 20);
}
