#include "loads/wet_fraction.hpp"

#include "tools/catch.hpp"
#include "tools/random_values.hpp"

using namespace gxrod;
using namespace gxrod::tools;

namespace {

WaterAt water_up_to(double surface) {
    WaterAt water;
    water.has_surface = true;
    water.surface = surface;
    return water;
}

// Of a straight rod of ten pieces from z = 0 on.
double wetted_length(const WaterAt& water, const Vec3& axis, double width) {
    const double piece = 0.5;
    double wetted = 0.0;
    for (int i = 0; i < 10; ++i) {
        // Halves of elements, so that nodes are at the ends of pieces
        const bool starts = i % 2 == 0;
        const double node = piece * (starts ? i : i + 1);
        const double offset = piece * (starts ? 0.5 : -0.5);
        wetted += piece * compute_wet_fraction(&water, node * axis.z(), axis, offset, piece, width).value;
    }
    return wetted;
}

}  // namespace

TEST_CASE("an upright rod is wet exactly up to the surface", "[loads]") {
    RandomValues random(1);
    for (int i = 0; i < 50; ++i) {
        const double surface = random.number(-1.0, 6.0);
        const double expected = std::clamp(surface, 0.0, 5.0);
        CHECK(std::abs(wetted_length(water_up_to(surface), Vec3::UnitZ(), 0.3) - expected) < 1e-14);
    }
}

TEST_CASE("a straight rod is wet up to the surface on average", "[loads]") {
    RandomValues random(2);
    const Vec3 axis = Vec3(0.5, 0.2, 0.7).normalized();
    const int surfaces = 1000;  // over a piece's height, in the middle of the rod
    double sum = 0.0;
    for (int i = 0; i < surfaces; ++i)
        sum += wetted_length(water_up_to((4.5 + (i + 0.5) / surfaces) * 0.5 * axis.z()), axis, 0.3);
    CHECK(std::abs(sum / surfaces - 2.5) < 1e-6);
}

TEST_CASE("a level rod sinks in over its width", "[loads]") {
    const auto wet = [](double surface) {
        const WaterAt water = water_up_to(surface);
        return compute_wet_fraction(&water, 0.0, Vec3::UnitY(), 0.3, 2.0, 0.4).value;
    };
    CHECK(wet(-0.2) == 0.0);
    CHECK(std::abs(wet(-0.1) - 0.25) < 1e-15);
    CHECK(std::abs(wet(0.1) - 0.75) < 1e-15);
    CHECK(std::abs(wet(0.2) - 1.0) < 1e-15);
}

TEST_CASE("without a surface all is wet, without water nothing", "[loads]") {
    const WaterAt everywhere;
    CHECK(compute_wet_fraction(&everywhere, 1e9, Vec3::UnitX(), 0.0, 1.0, 1.0).value == 1.0);
    CHECK(compute_wet_fraction(&everywhere, 1e9, 1.0).value == 1.0);
    CHECK(compute_wet_fraction(nullptr, -1e9, Vec3::UnitX(), 0.0, 1.0, 1.0).value == 0.0);
    CHECK(compute_wet_fraction(nullptr, -1e9, 1.0).value == 0.0);
}

TEST_CASE("a body without a height sinks in at once", "[loads]") {
    const WaterAt water = water_up_to(2.0);
    CHECK(compute_wet_fraction(&water, 2.0 - 1e-9, 0.0).value == 1.0);
    CHECK(compute_wet_fraction(&water, 2.0 + 1e-9, 0.0).value == 0.0);
    CHECK(compute_wet_fraction(&water, 2.0, 0.0).by_place.isZero(0.0));
    CHECK(std::abs(compute_wet_fraction(&water, 1.9, 0.5).value - 0.7) < 1e-14);
}
