#include "study/findings/deck_advice.hpp"

#include <limits>

#include "tools/catch.hpp"
#include "verification/made_studies.hpp"

using namespace gxrod;
using namespace gxrod::test;

TEST_CASE("what is not is named, with its error, until when it is, and what to refine", "[study]") {
    const DeckStudy study = make_study({make_report("root", 1e-4, 1e-4), make_report("tip", 0.002, 0.08)});
    CHECK_FALSE(study.is_accurate());
    CHECK(says(study, "Right to 1 % of their largest change: root position."));
    CHECK(says(study, "Not right to 1 %: tip position (8.2 %, right up to t = 0.25)."));
    // 0.08 / 4² = 0.005, half of the tolerance.
    CHECK(says(study,
               "The mesh adds 8 % to tip position. 4 times as many elements would bring that to 0.5 %."));
    CHECK_FALSE(says(study, "The step adds"));
    DeckStudy other = make_study({make_report("tip", 0.03, 0.0)});
    CHECK(says(other,
               "The step adds 3 % to tip position. A step 3 times as short would bring that to 0.33 %."));
    other.is_adaptive = true;
    CHECK(says(other,
               "Steps 3 times as short, with 1/81 of the tolerance and 1/3 of min_step, max_step and the "
               "first step, would bring that to 0.33 %."));
    other.series[0].order_difference = 0.06;
    CHECK_FALSE(says(other, "next order"));
    other = make_study({make_report("tip", 0.0, 0.05)});
    other.series[0].order_difference = 0.06;
    CHECK(says(other, "Elements of the next order change tip position by 3 %."));
}

TEST_CASE("for errors out of reach no refinement is named", "[study]") {
    CHECK(
        says(make_study({make_report("tip", 43.4, 0.0)}),
             "The step adds 4300 % to tip position. It falls too slowly to say what would mend that: refine "
             "the step and ask again."));
    for (const double share : {0.9951, 1.0})
        CHECK(says(make_study({make_report("tip", share, 0.0)}), "The step adds 100 % to tip position."));
    CHECK(says(make_study({make_report("tip", 0.9949, 0.0)}), "The step adds 99 % to tip position."));
    CHECK(says(make_study({make_report("tip", 1234.5, 0.0)}),
               "The step adds more than 100000 % to tip position."));
}

TEST_CASE("errors that do not fall, or too slowly, are reported", "[study]") {
    DeckStudy study = make_study({make_report("tip", 0.3, 0.0)});
    study.series[0].steps = estimate_error({{0.1}, {0.1}}, 2.0, 1e-12);
    CHECK(says(study, "Errors do not fall with the step (tip position: 0.1, 0.1)"));
    study.series[0].steps = make_estimate(0.1, 1.0);
    CHECK(says(study, "Errors fall with the step with order 1.0, less than the scheme's 2 (tip position)"));
    study = make_study({make_report("tip", 0.0, 0.3)});
    study.series[0].mesh = estimate_error({{0.1}, {0.1}}, 2.0, 1e-12);
    CHECK(says(study, "Errors do not fall with the mesh (tip position: 0.1, 0.1)"));
}

TEST_CASE("small errors ask for nothing, however they fall", "[study]") {
    DeckStudy study = make_study({make_report("tip", 0.0, 0.3)});
    study.series[0].steps = estimate_error({{2e-4}, {2e-4}}, 2.0, 1e-12);
    CHECK_FALSE(says(study, "Errors do not fall"));
    study.series[0].steps = estimate_error({{2e-2}, {2e-2}}, 2.0, 1e-12);
    CHECK(says(study, "Errors do not fall with the step"));
}

TEST_CASE("statics: the load steps must not matter", "[study]") {
    DeckStudy study = make_study({make_report("tip", 0.05, 0.0)});
    study.is_static = true;
    CHECK(says(study, "The state depends on the load steps by 5 % (tip position)."));
    CHECK(says(study, "(5 %, right up to load factor 0.25)"));
    CHECK_FALSE(says(study, "The step adds"));
    study.series[0].steps = estimate_error({{0.0}, {0.0}}, 1.0, 1e-12);
    CHECK_FALSE(says(study, "The state depends"));
}
