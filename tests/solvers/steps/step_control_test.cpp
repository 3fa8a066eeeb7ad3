#include "solvers/steps/step_control.hpp"

#include "tools/catch.hpp"

using namespace gxrod;

TEST_CASE("steps that succeed are the nominal ones and end at the end time", "[solvers]") {
    StepControl control(0.7, 7);
    CHECK(control.steps_in_all() == 7);
    for (long step = 0; step < 7; ++step) {
        CHECK_FALSE(control.finished());
        CHECK(control.steps_done() == step);
        CHECK(control.time_step() == 0.1);
        CHECK(control.next_time() == Approx(0.1 * static_cast<double>(step + 1)).epsilon(1e-15));
        const double next = control.next_time();
        control.accept();
        CHECK(control.time() == next);
        CHECK(control.at_nominal_step());
    }
    CHECK(control.finished());
    CHECK(control.time() == 0.7);
}

TEST_CASE("the end is exact whatever the number of steps", "[solvers]") {
    for (const long steps : {1L, 3L, 49L, 1000L, 123457L}) {
        StepControl control(0.1, steps);
        while (!control.finished()) control.accept();
        CHECK(control.time() == 0.1);
        CHECK(control.steps_done() == steps);
    }
}

TEST_CASE("a step that fails is halved and doubled again on the grid", "[solvers]") {
    StepControl control(8.0, 8);
    REQUIRE(control.reject());
    REQUIRE(control.reject());
    CHECK(control.time_step() == 0.25);
    CHECK(control.next_time() == 0.25);
    control.accept();
    CHECK(control.time() == 0.25);
    CHECK_FALSE(control.at_nominal_step());
    CHECK(control.time_step() == 0.25);  // a step of 0.5 from 0.25 would leave the grid of halves
    control.accept();
    CHECK(control.time() == 0.5);
    CHECK(control.time_step() == 0.5);
    control.accept();
    CHECK(control.time() == 1.0);
    CHECK(control.at_nominal_step());
    CHECK(control.steps_done() == 1);
    CHECK(control.time_step() == 1.0);
    while (!control.finished()) control.accept();
    CHECK(control.time() == 8.0);
}

TEST_CASE("after a failure within a cut step, steps continue from there", "[solvers]") {
    StepControl control(2.0, 2);
    REQUIRE(control.reject());
    control.accept();
    REQUIRE(control.reject());
    CHECK(control.time() == 0.5);
    CHECK(control.next_time() == 0.75);
    control.accept();
    CHECK(control.time_step() == 0.25);
    control.accept();
    CHECK(control.time() == 1.0);
    CHECK(control.time_step() == 1.0);
}

TEST_CASE("after ten halvings a step is given up", "[solvers]") {
    StepControl control(3.0, 3);
    for (int halving = 0; halving < 10; ++halving) REQUIRE(control.reject());
    CHECK(control.time_step() == 1.0 / 1024.0);
    CHECK_FALSE(control.reject());
    CHECK(control.time_step() == 1.0 / 1024.0);
    CHECK(control.time() == 0.0);
}

TEST_CASE("the shortest steps all the way reach the end exactly", "[solvers]") {
    StepControl control(0.3, 3);
    long count = 0;
    while (!control.finished()) {
        while (control.time_step() > 0.1 / 1000.0) REQUIRE(control.reject());
        control.accept();
        ++count;
    }
    CHECK(count == 3 * 1024);
    CHECK(control.time() == 0.3);
}

TEST_CASE("parts of a step are not steps, and frames stand on the grid", "[solvers]") {
    StepControl control(4.0, 4);
    REQUIRE(control.reject());
    control.accept();
    CHECK(control.steps_done() == 0);
    CHECK(control.part_done() == 0.0);
    CHECK_FALSE(control.is_frame_due(1));
    control.accept();
    CHECK(control.steps_done() == 1);
    CHECK(control.part_done() == 0.25);
    CHECK(control.is_frame_due(1));
    CHECK_FALSE(control.is_frame_due(2));
    control.accept();
    CHECK(control.is_frame_due(2));
}

TEST_CASE("steps resume at a time that they meet", "[solvers]") {
    StepControl first(1.0, 10);
    first.accept();
    REQUIRE(first.reject());
    first.accept();
    StepControl same(1.0, 10);
    REQUIRE(same.resume(first.memory()));
    CHECK(same.time() == first.time());
    CHECK(same.next_time() == first.next_time());
    CHECK(same.time_step() == first.time_step());
    StepControl longer(1.5, 15);
    REQUIRE(longer.resume(first.memory()));
    CHECK(longer.next_time() == first.next_time());
    StepControl finer(1.0, 100);
    REQUIRE(finer.resume(first.memory()));
    CHECK(finer.time() == 0.15);
    CHECK(finer.next_time() == 0.16);
    StepControl coarser(1.0, 5);
    REQUIRE(coarser.resume(first.memory()));
    CHECK(coarser.time() == 0.15);
    CHECK(coarser.next_time() == 0.2);
    CHECK_FALSE(StepControl(1.0, 7).resume(first.memory()));
    CHECK_FALSE(StepControl(0.1, 1).resume(first.memory()));
}

TEST_CASE("steps land on a time and go on to the next nominal one", "[solvers]") {
    StepControl control(1.0, 10);
    CHECK_FALSE(control.land_on(-0.1));
    CHECK_FALSE(control.land_on(1.1));
    SECTION("between nominal times") {
        REQUIRE(control.land_on(0.15));
        control.accept();
        CHECK(control.time() == 0.1);
        CHECK(control.next_time() == 0.15);
        CHECK(control.time_step() == Approx(0.05));
        control.accept();
        CHECK(control.time() == 0.15);
        CHECK_FALSE(control.at_nominal_step());
        CHECK(control.next_time() == 0.2);
        control.accept();
        CHECK(control.time() == 0.2);
        CHECK(control.at_nominal_step());
        CHECK(control.time_step() == 0.1);
    }
    SECTION("off the finest grid, and a step that fails there") {
        const double time = 0.1234567;
        REQUIRE(control.land_on(time));
        control.accept();
        REQUIRE(control.reject());
        CHECK(control.next_time() < time);
        control.accept();
        CHECK(control.next_time() == time);
        control.accept();
        CHECK(control.time() == time);
        REQUIRE(control.reject());
        CHECK(control.next_time() > time);
        CHECK(control.next_time() < 0.2);
        while (!control.finished()) control.accept();
        CHECK(control.time() == 1.0);
    }
    SECTION("without slivers next to nominal times") {
        REQUIRE(control.land_on(0.100001));
        CHECK(control.next_time() == 0.100001);
        control.accept();
        CHECK(control.next_time() == 0.2);
        REQUIRE(control.land_on(0.199999));
        control.accept();
        CHECK(control.next_time() == Approx(0.3));
    }
    SECTION("a nominal time but for rounding is that time") {
        CHECK(control.land_on(0.1 + 0.2) == 0.3);
        for (int i = 0; i < 3; ++i) control.accept();
        CHECK(control.time() == 0.3);
        CHECK(control.at_nominal_step());
        CHECK(control.land_on(0.1 + 0.2) == 0.3);
        CHECK(control.next_time() == Approx(0.4));
    }
    SECTION("a time of the finest grid but for rounding is that time") {
        CHECK(control.land_on(0.15000000000000002) == 0.15);
        control.accept();
        control.accept();
        CHECK(control.time() == 0.15);
        CHECK(control.land_on(0.15000000000000002) == 0.15);
        CHECK(control.next_time() == 0.2);
    }
    SECTION("the end") {
        REQUIRE(control.land_on(1.0));
        while (!control.finished()) control.accept();
        CHECK(control.time() == 1.0);
    }
    SECTION("and are resumed there") {
        REQUIRE(control.land_on(0.1234567));
        control.accept();
        control.accept();
        StepControl other(1.0, 10);
        REQUIRE(other.resume(control.memory()));
        CHECK(other.time() == 0.1234567);
        CHECK(other.next_time() == control.next_time());
    }
}
