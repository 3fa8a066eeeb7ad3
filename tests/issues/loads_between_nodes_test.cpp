// Loads and motions that change between nodes and between steps: once sampled there, lost, or taken as blows.

#include "assembly/system.hpp"
#include "check/model_examination.hpp"
#include "deck/decks.hpp"
#include "tools/catch.hpp"
#include "tools/static_run.hpp"

namespace gxrod::test {
namespace {

// A cantilever along x, 10 long.
std::string cantilever(const std::string& load, int elements, int order, const std::string& more = "") {
    return R"([section.s]
stiffness = { EA = 1e6, GAy = 1e6, GAz = 1e6, GJ = 1e4, EIy = 1e4, EIz = 1e4 }
inertia = { rhoA = 1.0, rhoIy = 1e-3, rhoIz = 1e-3 }
[rod.b]
section = "s"
line = { from = [0, 0, 0], to = [10, 0, 0] }
elements = )" +
           std::to_string(elements) + "\norder = " + std::to_string(order) + R"(
[[support]]
at = "b.start"
fix = "all"
[[load]]
on = "b"
force_per_length = [0, 0, ")" +
           load + "\"]\n" + more;
}

const std::string static_analysis = "[analysis]\nkind = \"static\"\nsteps = 1\n";

// The clamp's force and moment of a static deck, against f and m of the straight rod.
void check_reactions(const std::string& deck, double force, double moment) {
    const Problem problem = read(deck);
    const tools::StaticRun run =
        tools::run_static(problem.model, std::get<StaticSettings>(problem.analysis()));
    CHECK(std::abs(run.reactions[0][2] + force) < 1e-7 * std::abs(force));
    // The rod bends a little.
    CHECK(std::abs(run.reactions[0][4] - moment) < 1e-5 * std::abs(moment));
}

void check_on_all_meshes(const std::string& load, double force, double moment, const std::string& more = "") {
    for (const int elements : {3, 10, 17}) {
        for (int order = 1; order <= 4; ++order) {
            INFO(load << ", " << elements << " elements of order " << order);
            check_reactions(cantilever(load, elements, order, more + static_analysis), force, moment);
        }
    }
}

std::string dynamic_body(const std::string& more, const std::string& step = "0.01") {
    return R"([body.b]
mass = 2.0
inertia = [1, 1, 1]
[analysis]
kind = "dynamic"
end_time = 2.0
time_step = )" +
           step + "\n" + more;
}

// What is said of a deck, of the kind that names `word`.
std::string findings_of(const std::string& deck, const std::string& word) {
    const Problem problem = read(deck);
    std::string text;
    for (const Finding& finding : examine_model(problem.model, problem.analysis())) {
        if (finding.message.find(word) != std::string::npos) text += finding.message + "\n";
    }
    return text;
}

std::string push(const std::string& force) {
    return "[[load]]\nat = \"b\"\nforce = [0, \"" + force + "\", 0]\n";
}

std::string impulse_of(const std::string& more, const std::string& step = "0.01") {
    return findings_of(dynamic_body(more, step), "over time instead");
}

std::string moved(const std::string& motion, const std::string& more = "") {
    return dynamic_body("[[support]]\nat = \"b\"\nfix = [\"x\", \"y\", \"rotation\"]\nmove = { z = \"" +
                        motion + "\" }\n" + more);
}

}  // namespace

TEST_CASE("A load on half a metre acts whole, whatever the mesh", "[issues]") {
    check_on_all_meshes("s > 2 && s < 2.5 ? -1 : 0", -0.5, -1.125);
    // From node to node of ten elements; as numbers; far narrower than an element.
    check_on_all_meshes("s >= 2 && s <= 3 ? -1 : 0", -1.0, -2.5);
    check_on_all_meshes("-(s > 2)*(s < 2.5)", -0.5, -1.125);
    check_on_all_meshes("abs(s - 4.2) < 0.0005 ? -1000 : 0", -1.0, -4.2);
}

TEST_CASE("Tables, functions of functions, min and max are integrated along the rod", "[issues]") {
    // A triangle of height 2 from 3.3 to 3.4, that of the table of another function's value, and a hat.
    const std::string functions = R"deck([function.profile]
table = [[0, 0], [3.3, 0], [3.35, 2], [3.4, 0]]
[function.twice]
expression = "2*profile(t/2)"
)deck";
    check_on_all_meshes("-profile(s)", -0.1, -0.335, functions);
    check_on_all_meshes("-twice(s)", -0.4, -2.68, functions);
    check_on_all_meshes("-max(0, 1 - abs(s - 5.05)/0.01)", -0.01, -0.0505);
    check_on_all_meshes("-0.01*min(1, max(0, (s - 6)*1e4))", -0.04 + 0.5e-6, -0.32 + 6.0 * 0.5e-6);
}

TEST_CASE("A load that travels along a beam acts whole at all times", "[issues]") {
    for (const int elements : {3, 10}) {
        for (int order = 1; order <= 4; ++order) {
            const Problem problem =
                read(cantilever("s > 7*t && s < 7*t + 0.02 ? -50 : 0",
                                elements,
                                order,
                                "[analysis]\nkind = \"dynamic\"\nend_time = 1.0\ntime_step = 0.01\n"));
            const System system(problem.model);
            const State state = system.initial_state();
            for (int i = 0; i <= 100; ++i) {
                Residual residual;
                system.compute_residual(state, 0.01 * i, residual);
                double force = 0.0;
                for (const Vec6& nodal : residual.nodal) force += nodal[2];
                CHECK(std::abs(force - 1.0) < 1e-12);
            }
            CHECK(
                findings_of(cantilever("s > 7*t && s < 7*t + 0.02 ? -50 : 0",
                                       elements,
                                       order,
                                       "[analysis]\nkind = \"dynamic\"\nend_time = 1.0\ntime_step = 0.01\n"),
                            "over time instead")
                    .empty());
        }
    }
}

TEST_CASE("A pulse shorter than a step is reported with its time and the step needed", "[issues]") {
    const std::string found = impulse_of(push("t > 0.503 && t < 0.507 ? 100 : 0"));
    CHECK(
        found.starts_with("load[0].force[1]: between t = 0.45 and 0.56 steps of 0.01 give it the integral 0 "
                          "over time instead of 0.4; expected steps of 0.0"));
    // A table, gravity, a function that calls another one, a peak on a step.
    CHECK_FALSE(impulse_of("[function.tap]\ntable = [[0, 0], [1.001, 0], [1.003, 50], [1.005, 0]]\n" +
                           push("3*tap(t)"))
                    .empty());
    CHECK_FALSE(
        impulse_of("[function.tap]\ntable = [[0, 0], [0.999, 0], [1, 50], [1.001, 0]]\n" + push("tap(t)"))
            .empty());
    CHECK_FALSE(
        findings_of("gravity = [0, 0, \"abs(t - 1.0055) < 0.001 ? -500 : -9.81\"]\n" + dynamic_body(""),
                    "over time instead")
            .empty());
    CHECK_FALSE(impulse_of(push("5*sin(2*pi*t/0.015)")).empty());
    // With the step that is asked for nothing is lost.
    CHECK(impulse_of(push("t > 0.503 && t < 0.507 ? 100 : 0"), "0.00125").empty());
}

TEST_CASE("Loads that steps resolve, and loads that are switched on or off, are not reported", "[issues]") {
    for (const char* force : {"t < 0.5 ? 0 : 7",
                              "t < 0.503 ? 0 : 7",
                              "t < 0.507 ? 7 : -3",
                              "t > 0 ? 5 : 0",
                              "5*sin(2*pi*t/0.2)",
                              "t < 0.1 ? 200*sin(pi*t/0.1)^2 : 0",
                              "t < 0.1 ? 200*sin(pi*t/0.1) : 0",
                              "t*t",
                              "t",
                              "(7 - 3*t)/9",
                              "t < 0.123 ? t : 0.123",
                              "exp(-((t - 1)/0.05)^2)",
                              "sign(sin(2*pi*t/0.3))",
                              "min(t, 0.3)"}) {
        INFO(force);
        CHECK(impulse_of(push(force)).empty());
    }
    CHECK(impulse_of("[function.record]\ntable = [[0, 0], [0.1, 3], [0.2, -4], [0.3, 2], [1.0, 0]]\n" +
                     push("record(t)"))
              .empty());
}

TEST_CASE("A support that is said to jump is refused, with its time", "[issues]") {
    const auto check_jump = [](const std::string& motion, const std::string& sentence) {
        const std::string faults = faults_of(moved(motion));
        INFO(faults);
        CHECK(faults.starts_with("x.toml:11:14: support[0].move.z: jumps from "));
        CHECK(faults.find(sentence) != std::string::npos);
    };
    check_jump("t < 0.5 ? 0 : 0.1", "jumps from 0 to 0.1 at t = 0.5; expected a motion without jumps");
    check_jump("0.05 + 0.05*sign(t - 0.25)", "at t = 0.25");
    check_jump("t > 0 ? 0.1 : 0", "jumps from 0 to 0.1 at t = 0;");
    check_jump("(t > 1.5)*0.2", "at t = 1.5;");
    // Continuous ones.
    for (const char* motion : {"t < 0.5 ? 0 : 0.1*(1 - cos(t - 0.5))", "0.1*sin(t)", "min(t, 0.5)"}) {
        CHECK(faults_of(moved(motion)).empty());
    }
}

TEST_CASE("A move whose velocity jumps is reported, and one by a cubic table is not", "[issues]") {
    const auto table = [](const std::string& interpolation) {
        return "[function.sway]\ntable = [[0, 0], [0.5, 0.1], [1, 0.3], [1.5, 0.2], [2, 0]]\ninterpolation = "
               "\"" +
               interpolation + "\"\n";
    };
    const auto findings = [](const std::string& motion, const std::string& more = "") {
        return findings_of(moved(motion, more), "velocity that jumps");
    };
    const std::string found = findings("sway(t)", table("linear"));
    CHECK(found.starts_with(
        "the [[support]] at b moves z with a velocity that jumps from 0.2 to 0.4 at t = 0.5 (and "
        "at 2 more times): "));
    CHECK(found.find("interpolation = \"cubic\"") != std::string::npos);
    CHECK(findings("sway(t)", table("cubic")).empty());
    CHECK(findings("sway(t)", table("monotone")).empty());
    CHECK_FALSE(findings("min(t, 0.5)").empty());
    CHECK_FALSE(findings("abs(t - 0.3) - 0.3").empty());
    CHECK(findings("0.1*sin(t)").empty());
    CHECK(findings("t < 0.5 ? 0 : (t - 0.5)^2").empty());
}

TEST_CASE("A move that sets a rod at rest in motion at once is noted", "[issues]") {
    const auto findings = [](const std::string& motion, const std::string& more) {
        return findings_of(
            rod_deck + "[[support]]\nat = \"r.start\"\nfix = [\"x\", \"y\", \"rotation\"]\nmove = { z = \"" +
                motion + "\" }\n" + more,
            "the start is a blow");
    };
    CHECK(findings("0.1*sin(3*t)", "")
              .starts_with("the [[support]] at r.start moves z at a velocity of 0.3 from t = 0 on, while the "
                           "model is at "
                           "rest: "));
    CHECK(findings("0.1*(1 - cos(3*t))", "").empty());
    CHECK(findings("0.1*t", "[[initial]]\non = \"r\"\nvelocity = [0, 0, 0.1]\n").empty());
}

}  // namespace gxrod::test
