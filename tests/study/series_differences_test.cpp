#include "study/series_differences.hpp"

#include <cmath>

#include "tools/catch.hpp"
#include "watch/quantities.hpp"

using namespace gxrod;

namespace {

using Row = HistoryRow;

const Series place{"tip", "position", 0, find_quantity("position"), Turning::vector};
const Series attitude{"tip", "orientation", 0, find_quantity("orientation"), Turning::attitude};
const Series force{"tip", "force", 0, find_quantity("force"), Turning::none};

// About x by an angle.
Row turned(double angle) { return {std::cos(0.5 * angle), std::sin(0.5 * angle), 0.0, 0.0}; }

}  // namespace

TEST_CASE("vectors differ by a length, rotations by an angle", "[study]") {
    CHECK(distance(place, {1.0, 2.0, 3.0, 0.0}, {1.0, 5.0, 7.0, 0.0}) == Approx(5.0));
    for (const double angle : {1e-9, 0.1, 2.0, 3.0}) {
        CHECK(distance(attitude, turned(0.3), turned(0.3 + angle)) == Approx(angle).epsilon(1e-6));
        Row other = turned(0.3 + angle);
        for (double& component : other) component = -component;
        CHECK(distance(attitude, turned(0.3), other) == Approx(angle).epsilon(1e-6));
    }
    CHECK(compute_differences(force, {{1, 0, 0, 0}, {2, 0, 0, 0}}, {{1, 0, 0, 0}}) == std::vector{0.0});
}

TEST_CASE("rows are the same to the last bit, or not", "[study]") {
    const Row row{0.1, 0.2, 0.3, 0.4};
    CHECK(is_same(place, row, row));
    CHECK_FALSE(is_same(place, row, {0.1, 0.2, std::nextafter(0.3, 1.0), 0.4}));
    CHECK_FALSE(is_same(place, row, {-0.1, -0.2, -0.3, -0.4}));
    CHECK(is_same(attitude, row, {-0.1, -0.2, -0.3, -0.4}));
}

TEST_CASE("scales: the way of places, the angle of rotations, the size of the rest", "[study]") {
    const std::vector<std::vector<Row>> rows{{{100, 0, 0, 0}, {103, 4, 0, 0}, {101, 0, 0, 0}},
                                             {turned(0.0), turned(0.2)},
                                             {{7, 0, 0, 0}, {1, 0, 0, 0}}};
    const auto scales = compute_scales({place, attitude, force}, rows, {}, {0.0, 0.0, 0.0});
    CHECK(scales[0].scale == Approx(5.0));
    CHECK(scales[1].scale == Approx(0.2));
    CHECK(scales[2].scale == Approx(7.0));
    CHECK(compute_scales({attitude}, {{turned(0.0), turned(3.0)}}, {}, {0.0})[0].scale == 1.0);
}

TEST_CASE("what stays where it is is judged by its like", "[study]") {
    const std::vector<std::vector<Row>> rows{{{0, 0, 0, 0}, {1e-15, 0, 0, 0}}, {{0, 0, 0, 0}, {2, 0, 0, 0}}};
    const auto scales = compute_scales({place, place}, rows, {}, {0.0, 0.0});
    CHECK(scales[0].is_still);
    CHECK(scales[0].scale == 2.0);
    CHECK_FALSE(scales[1].is_still);
}

TEST_CASE("what is within round-off is still", "[study]") {
    const std::vector<std::vector<Row>> rows{{{0, 0, 0, 0}, {1e-7, 0, 0, 0}}};
    CHECK_FALSE(compute_scales({force}, rows, {}, {0.9e-8})[0].is_still);
    CHECK(compute_scales({force}, rows, {}, {1.1e-8})[0].is_still);
    // Small places count from a billionth of the model on.
    const NaturalScales natural{4.0, 0.0, 0.0};
    CHECK_FALSE(compute_scales({place}, {{{1, 0, 0, 0}, {1 + 5e-9, 0, 0, 0}}}, natural, {0.0})[0].is_still);
    CHECK(compute_scales({place}, {{{1, 0, 0, 0}, {1 + 3e-9, 0, 0, 0}}}, natural, {0.0})[0].scale == 4.0);
    // What does not turn is judged by a radian, if nothing else turns.
    const std::vector<std::vector<Row>> angles{{turned(0.0), turned(1e-15)}, {turned(0.0), turned(0.2)}};
    CHECK(compute_scales({attitude}, {angles[0]}, {}, {1e-15})[0].scale == 1.0);
    const auto scales = compute_scales({attitude, attitude}, angles, {}, {1e-15, 1e-15});
    CHECK(scales[0].is_still);
    CHECK(scales[0].scale == Approx(0.2));
}

TEST_CASE("what solvers leave is judged by what is large in the model", "[study]") {
    const NaturalScales natural{4.0, 2.0, 8.0};
    // A force at a free end: energy by length is 2.
    const auto scales = compute_scales({force}, {{{0, 0, 0, 0}, {1e-7, 0, 0, 0}}}, natural, {0.0});
    CHECK(scales[0].is_still);
    CHECK(scales[0].scale == 2.0);
    CHECK_FALSE(compute_scales({force}, {{{0, 0, 0, 0}, {1e-5, 0, 0, 0}}}, natural, {0.0})[0].is_still);
    CHECK(natural.of(find_quantity("position")->size) == 4.0);
    CHECK(natural.of(find_quantity("velocity")->size) == 2.0);
    CHECK(natural.of(find_quantity("angular_velocity")->size) == 0.5);
    CHECK(natural.of(find_quantity("acceleration")->size) == 1.0);
    CHECK(natural.of(find_quantity("moment")->size) == 8.0);
    CHECK(natural.of(find_quantity("curvature")->size) == 0.25);
    CHECK(natural.of(find_quantity("strain")->size) == 1.0);
    CHECK(natural.of(find_quantity("orientation")->size) == 0.0);
}
