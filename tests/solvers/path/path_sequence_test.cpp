#include "solvers/path/path_sequence.hpp"

#include "tools/catch.hpp"

using namespace gxrod;

namespace {

PathSettings make_settings() {
    PathSettings settings;
    settings.first_step = 0.01;
    settings.arc = 0.1;
    return settings;
}

void accept(PathSequence& steps, int iterations) {
    steps.adapt(iterations);
    steps.accept();
}

}  // namespace

TEST_CASE("steps of a path grow after few iterations and shrink after many", "[solvers]") {
    PathSequence steps(make_settings());
    CHECK(steps.time_step() == 0.01);
    accept(steps, 1);
    CHECK(steps.time_step() == Approx(0.02));  // 4^0.7, but at most twice as long
    accept(steps, 4);
    CHECK(steps.time_step() == Approx(0.02));
    accept(steps, 8);
    CHECK(steps.time_step() == Approx(0.02 * std::pow(0.5, 0.7)));
    REQUIRE(steps.reject());
    CHECK(steps.time_step() == Approx(0.01 * std::pow(0.5, 0.7)));
}

TEST_CASE("a path ends at its arc length to the last bit, or after its steps", "[solvers]") {
    PathSequence steps(make_settings());
    while (!steps.finished()) accept(steps, 2);
    CHECK(steps.time() == 0.1);
    PathSettings settings = make_settings();
    settings.steps = 3;
    PathSequence few(settings);
    while (!few.finished()) accept(few, 9);
    CHECK(few.steps_done() == 3);
    CHECK(few.time() < 0.1);
}

TEST_CASE("a step that ends on what was asked for has a frame and does not shorten the next one",
          "[solvers]") {
    PathSequence steps(make_settings());
    accept(steps, 4);
    CHECK_FALSE(steps.is_frame_due(1000));
    steps.end_at(0.003);
    accept(steps, 4);
    CHECK(steps.time() == Approx(0.013));
    CHECK(steps.is_frame_due(1000));
    CHECK(steps.time_step() == Approx(0.01));
}

TEST_CASE("a path resumes with the step that it was about to take", "[solvers]") {
    PathSequence steps(make_settings());
    accept(steps, 3);
    PathSequence resumed(make_settings());
    REQUIRE(resumed.resume(steps.memory()));
    CHECK(resumed.time() == steps.time());
    CHECK(resumed.time_step() == steps.time_step());
    CHECK(resumed.steps_done() == 1);
}
