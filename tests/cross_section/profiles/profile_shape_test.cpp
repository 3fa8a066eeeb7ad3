#include "cross_section/profiles/profile_shape.hpp"

#include "cross_section/outlines/outline_moments.hpp"
#include "tools/catch.hpp"

namespace gxrod::test {
namespace {

std::string fault_of(const ProfileShape& shape) {
    const auto fault = find_fault(shape);
    return fault ? fault->part + ": " + fault->message : "";
}

struct Expected {
    double area, Iy, Iz, y, z, Iyz = 0.0;
};

// Checks area, moments and the centroid to the digits of reference values, and that the shape is one.
void check(const ProfileShape& shape, const Expected& expected) {
    CHECK(fault_of(shape).empty());
    const OutlineMoments found = compute_moments(draw_outline(shape));
    CHECK(found.area == Approx(expected.area).epsilon(3e-8));
    CHECK(found.Iy == Approx(expected.Iy).epsilon(4e-8));
    CHECK(found.Iz == Approx(expected.Iz).epsilon(4e-8));
    CHECK(found.Iyz == Approx(expected.Iyz).epsilon(1e-5).margin(1e-9 * found.Iy));
    CHECK(found.centroid.x() == Approx(expected.y).epsilon(2e-7).margin(1e-9));
    CHECK(found.centroid.y() == Approx(expected.z).epsilon(2e-7).margin(1e-9));
}

}  // namespace

// Reference values X11 to X19c, by finite elements of high order.
TEST_CASE("Profiles have the area and the moments of the references", "[cross_section]") {
    check(IShape{200, 100, 5.6, 8.5, 12}, {2848.4107, 19431683, 1423683.3, 0, 0});
    check(IShape{200, 100, 5.6, 8.5}, {2724.8, 18455902, 1419344.8, 0, 0});
    check(
        ChannelShape{
            .height = 140, .width = 60, .web = 7, .flange = 10, .fillet = 10, .toe = 5, .slope = 0.08},
        {2036.9768, 6048135.6, 624852.7, 17.55426, 0});
    check(AngleShape{100, 100, 10, 12, 6}, {1915.4513, 1766763.7, 1766763.7, 28.22455, 28.22455, -1.03671e6});
    check(BoxShape{100, 100, 5, 5, 10, 5}, {1835.6194, 2711020.9, 2711020.9, 0, 0});
    check(TeeShape{100, 100, 10, 10, 8}, {1927.4690, 1807836.8, 842160.44, 0, 71.55660});
    check(HatShape{60, 50, 20, 3, 3}, {588.82300, 292613.67, 358575.43, 0, 30.58082});
    check(HollowCircle{114.3, 5}, {1716.880385, 2569202.045, 2569202.045, 0, 0});
}

TEST_CASE("A zed has the area of its walls and bends", "[cross_section]") {
    const double h = 100, b = 40, t = 2, r = 3;
    const OutlineMoments sharp = compute_moments(draw_outline(ZedShape{h, b, t}));
    CHECK(sharp.area == Approx(h * t + 2 * (b - t) * t));
    CHECK(sharp.centroid.norm() < 1e-12);
    CHECK(sharp.Iyz > 0.0);  // the upper flange goes to +y
    const OutlineMoments bent = compute_moments(draw_outline(ZedShape{h, b, t, r}));
    const double bends = 2 * M_PI / 4 * ((r + t) * (r + t) - r * r);
    CHECK(bent.area == Approx((h - 2 * (r + t)) * t + 2 * (b - t - r) * t + bends));
}

TEST_CASE("Numbers that do not go together are named", "[cross_section]") {
    CHECK(fault_of(IShape{0.2, 0.1, 0.007, 0.12}) == "flange: 0.12 is more than half the height 0.2");
    CHECK(fault_of(IShape{0.2, 0.1, 0.007, 0.1}) == "flange: 0.1 is half the height 0.2");
    CHECK(fault_of(IShape{0.2, 0.1, 0.11, 0.01}) == "web: 0.11 is more than the width 0.1");
    CHECK(fault_of(IShape{0.2, 0.1, 0.02, 0.01, 0.05}) == "fillet: 0.05 does not fit; expected at most 0.04");
    ChannelShape channel{.height = 140, .width = 60, .web = 7, .flange = 10};
    channel.slope = 0.4;
    CHECK(fault_of(channel) == "slope: 0.4 leaves no flange at its end; expected less");
    channel = {.height = 140, .width = 60, .web = 7, .flange = 60, .slope = 0.5};
    CHECK(fault_of(channel) == "slope: 0.5 makes the flanges meet at the web; expected less");
    channel = {.height = 140, .width = 60, .web = 7, .flange = 10, .toe = 11};
    CHECK(fault_of(channel) == "toe: 11 does not fit; expected at most 10");
    channel = {.height = 140, .width = 60, .web = 7, .flange = 10, .fillet = 50, .toe = 5};
    CHECK(fault_of(channel) == "fillet: 50 does not fit; expected at most 48");
    CHECK(fault_of(AngleShape{100, 80, 90}) == "wall: 90 is more than the leg 80");
    CHECK(fault_of(AngleShape{100, 80, 10, 12, 11}) == "toe: 11 does not fit; expected at most 10");
    CHECK(fault_of(AngleShape{100, 80, 10, 66, 5}) == "fillet: 66 does not fit; expected at most 65");
    CHECK(fault_of(TeeShape{100, 100, 10, 110}) == "flange: 110 is more than the height 100");
    CHECK(fault_of(TeeShape{100, 100, 10, 10, 46}) == "fillet: 46 does not fit; expected at most 45");
    CHECK(fault_of(BoxShape{100, 80, 40, 5}) == "wall: 40 is half the width 80");
    CHECK(fault_of(BoxShape{100, 80, 5, 60}) == "flange: 60 is more than half the height 100");
    CHECK(fault_of(BoxShape{100, 80, 5, 5, 41}) == "outer_radius: 41 does not fit; expected at most 40");
    CHECK(fault_of(BoxShape{100, 80, 5, 5, 10, 36}) == "inner_radius: 36 does not fit; expected at most 35");
    CHECK(fault_of(BoxShape{100, 80, 5, 5, 30, 0}) ==
          "outer_radius: 30 leaves no wall at the corners where inner_radius is 0");
    CHECK(fault_of(ZedShape{100, 40, 50}) == "wall: 50 is more than the width 40");
    CHECK(fault_of(ZedShape{100, 60, 55}) == "wall: 55 is more than half the height 100");
    CHECK(fault_of(ZedShape{100, 40, 2, 39}) == "radius: 39 does not fit; expected at most 38");
    CHECK(fault_of(HatShape{60, 50, 20, 26}) == "wall: 26 is more than half the width 50");
    CHECK(fault_of(HatShape{60, 50, 20, 3, 21}) == "radius: 21 does not fit; expected at most 20");
    CHECK(fault_of(HollowCircle{10, 5}) == "wall: 5 is half the diameter 10");
}

TEST_CASE("Radii as large as they may be give outlines", "[cross_section]") {
    const auto area = [](const ProfileShape& shape) {
        CHECK(fault_of(shape).empty());
        return compute_moments(draw_outline(shape)).area;
    };
    CHECK(area(IShape{0.2, 0.1, 0.02, 0.01, 0.04}) > 0.0);
    CHECK(area(ChannelShape{.height = 140, .width = 60, .web = 7, .flange = 10, .fillet = 48, .toe = 5}) >
          0.0);
    CHECK(area(AngleShape{100, 80, 10, 65, 5}) > 0.0);
    CHECK(area(BoxShape{80, 80, 5, 5, 40, 35}) == Approx(M_PI * (40 * 40 - 35 * 35)));
    CHECK(area(ZedShape{100, 40, 2, 38}) > 0.0);
}

}  // namespace gxrod::test
