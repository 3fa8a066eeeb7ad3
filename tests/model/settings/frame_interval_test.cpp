#include "model/settings/frame_interval.hpp"

#include <algorithm>

#include "tools/catch.hpp"

namespace gxrod {
namespace {

long interval_of(long steps) {
    DynamicSettings settings;
    settings.steps = steps;
    return choose_frame_interval(settings);
}

}  // namespace

TEST_CASE("A file has a few hundred frames unless the deck says otherwise", "[model]") {
    CHECK(interval_of(1) == 1);
    CHECK(interval_of(500) == 1);
    CHECK(interval_of(1000) == 2);
    CHECK(interval_of(1002) == 5);
    CHECK(interval_of(5000) == 10);
    CHECK(interval_of(5020) == 20);
    CHECK(interval_of(10'000'000) == 20'000);
    for (long steps = 1; steps < 1'000'000; steps = 3 * steps / 2 + 1) {
        CHECK(steps / interval_of(steps) <= default_frames);
        CHECK((steps <= default_frames || steps / interval_of(steps) >= default_frames / 3));
    }
    StaticSettings load_steps;
    load_steps.steps = 2000;
    CHECK(choose_frame_interval(load_steps) == 5);
    DynamicSettings adaptive;
    adaptive.adaptive = AdaptiveSettings{};
    CHECK(choose_frame_interval(adaptive) == 0);
}

TEST_CASE("Steps of unequal length get a frame in each part of the time", "[model]") {
    CHECK_FALSE(is_frame_time(0.0, 0.0199, 10.0));
    CHECK(is_frame_time(0.0199, 0.0201, 10.0));
    CHECK_FALSE(is_frame_time(0.0201, 0.0399, 10.0));
    // A long step has one frame, and the end has one.
    CHECK(is_frame_time(0.0201, 5.0, 10.0));
    CHECK(is_frame_time(9.99, 10.0, 10.0));
    long frames = 0;
    double time = 0.0;
    for (double step = 1e-3; time < 10.0; step *= 1.0003) {
        const double next = std::min(time + step, 10.0);
        if (is_frame_time(time, next, 10.0)) ++frames;
        time = next;
    }
    CHECK(frames == default_frames);
}

}  // namespace gxrod
