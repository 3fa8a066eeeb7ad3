#include "model/sections/stiffness_ratio.hpp"

#include "rotation/rotation_map.hpp"
#include "tools/catch.hpp"

using namespace gxrod;

namespace {

Mat6 diagonal(const std::array<double, 6>& values) {
    return Eigen::Map<const Vec6>(values.data()).asDiagonal();
}

Model make_model(const std::vector<Mat6>& stiffnesses) {
    Model model;
    for (const Mat6& stiffness : stiffnesses) {
        Section section;
        section.stiffness = stiffness;
        model.sections.push_back(section);
        Rod rod;
        rod.name = "r" + std::to_string(model.rods.size());
        rod.section = static_cast<int>(model.rods.size());
        model.rods.push_back(rod);
    }
    return model;
}

// The same section with its axes turned, and then moved off the line.
Mat6 turned(const Mat6& stiffness, const Vec3& rotation_vector) {
    Mat6 turn = Mat6::Zero();
    turn.topLeftCorner<3, 3>() = turn.bottomRightCorner<3, 3>() =
        exp_quaternion(rotation_vector).toRotationMatrix();
    return turn * stiffness * turn.transpose();
}
Mat6 moved(const Mat6& stiffness, const Vec3& offset) {
    Mat6 move = Mat6::Identity();  // Γ there = Γ + K × offset
    move.topRightCorner<3, 3>() << 0.0, offset.z(), -offset.y(), -offset.z(), 0.0, offset.x(), offset.y(),
        -offset.x(), 0.0;
    return move.transpose() * stiffness * move;
}

const Mat6 strip = diagonal({300.0, 100.0, 100.0, 8e-3, 4e-3, 40.0});

}  // namespace

TEST_CASE("A ratio of stiffnesses is that of twist and bending", "[model]") {
    const auto ratio = find_stiffness_ratio(make_model({strip}));
    REQUIRE(ratio);
    CHECK(ratio->ratio == Approx(1e4));
    CHECK(describe(*ratio, make_model({strip})) ==
          "rod r0 is 1e+04 times as stiff in bending about z as in bending about y");
    const Model shaft = make_model({diagonal({1e4, 1e4, 1e4, 500.0, 2.0, 4.0})});
    CHECK(describe(*find_stiffness_ratio(shaft), shaft) ==
          "rod r0 is 2.5e+02 times as stiff in twist as in bending about y");
}

TEST_CASE("The rod with the largest ratio counts", "[model]") {
    const Mat6 plain = diagonal({1.0, 1.0, 1.0, 2.0, 2.0, 2.0});
    const Model model = make_model({plain, strip, plain});
    CHECK(find_stiffness_ratio(model)->rod == 1);
    CHECK(find_stiffness_ratio(make_model({plain}))->ratio == Approx(1.0));
    CHECK_FALSE(find_stiffness_ratio(Model{}));
}

TEST_CASE("A ratio is found in a full matrix, and not from an offset of the axes", "[model]") {
    const auto of = [](const Mat6& stiffness) {
        return find_stiffness_ratio(make_model({stiffness}))->ratio;
    };
    CHECK(of(turned(strip, {0.3, -0.2, 0.9})) == Approx(1e4));
    CHECK(of(moved(turned(strip, {0.3, -0.2, 0.9}), {0.0, 0.7, -0.4})) == Approx(1e4));
    // EI = 1, but EA e² = 1e6 more about axes that are off.
    const Mat6 bar = diagonal({1e6, 1e6, 1e6, 1.0, 1.0, 1.0});
    CHECK(moved(bar, {0.0, 1.0, 0.0})(5, 5) == Approx(1e6));
    CHECK(of(moved(bar, {0.0, 1.0, 0.0})) == Approx(1.0));
}

TEST_CASE("What resists nothing has no ratio", "[model]") {
    CHECK_FALSE(find_stiffness_ratio(make_model({diagonal({1.0, 1.0, 1.0, 1.0, 0.0, 1.0})})));
    CHECK_FALSE(find_stiffness_ratio(make_model({diagonal({1.0, 0.0, 1.0, 1.0, 1.0, 1.0})})));
}
