#include "run/pace.hpp"

#include "tools/catch.hpp"

namespace gxrod {

TEST_CASE("What is left of a run follows from its latter half", "[analyses]") {
    Pace pace;
    CHECK(pace.seconds_left() < 0.0);
    // A resumed run: half was done before.
    pace.record(0.0, 0.5);
    CHECK(pace.seconds_left() < 0.0);
    pace.record(1.0, 0.5);
    CHECK(pace.seconds_left() < 0.0);
    pace.record(10.0, 0.6);
    CHECK(pace.seconds_left() == Approx(36.0));

    SECTION("what is slower than its beginning takes as long as it is now slow") {
        Pace slower;
        for (int second = 0; second <= 10; ++second) slower.record(second, 0.04 * second);
        CHECK(slower.seconds_left() == Approx(15.0));
        for (int second = 11; second <= 100; ++second) slower.record(second, 0.4 + 0.002 * (second - 10));
        CHECK(slower.seconds_left() == Approx(0.42 / 0.002));
    }
    SECTION("what does not go on has no end") {
        Pace still;
        for (int second = 0; second <= 100; ++second) still.record(second, 0.3);
        CHECK(still.seconds_left() < 0.0);
    }
}

}  // namespace gxrod
