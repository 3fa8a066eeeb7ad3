
#include "analyses/dynamic.hpp"
#include "check/model_examination.hpp"
#include "deck/decks.hpp"
#include "run/run.hpp"
#include "study/deck_variants.hpp"
#include "tools/catch.hpp"
#include "tools/tops.hpp"

// Newton's tolerance was 1e-8 however small an error the steps were to have.

namespace gxrod::test {
namespace {

State run_to_end(const Model& model, const DynamicSettings& settings) {
    DynamicAnalysis analysis(model, settings);
    REQUIRE(analysis.start().converged());
    while (!analysis.finished()) REQUIRE(analysis.advance().converged());
    return analysis.state();
}

DynamicSettings by_error(double end_time, double tolerance) {
    DynamicSettings settings;
    settings.scheme = Scheme::sdirk_4;
    settings.end_time = end_time;
    settings.steps = static_cast<long>(end_time * 1000.0);
    settings.adaptive = AdaptiveSettings{.tolerance = tolerance};
    return settings;
}

const std::string top_deck = R"(gravity = [0, 0, -9.81]
[body.top]
mass = 15.0
inertia = [0.234375, 0.46875, 0.234375]
centre_of_mass = [0, 1, 0]
angular_velocity_material = [0, 150, -4.61538]
[[support]]
at = "top"
fix = "position"
[analysis]
kind = "dynamic"
end_time = 2.0
time_step = 1e-3
integrator = "sdirk-4"
)";

// A rod swings from a hinge.
const std::string pendulum_deck = R"(gravity = [0, 0, -9.81]
[section.s]
stiffness = { EA = 1e4, GAy = 4e3, GAz = 4e3, GJ = 0.5, EIy = 0.5, EIz = 0.5 }
inertia = { rhoA = 1.0, rhoIy = 1e-3, rhoIz = 1e-3 }
[rod.b]
section = "s"
line = { from = [0, 0, 0], to = [1, 0, 0] }
elements = 3
order = 2
[[support]]
at = "b.start"
fix = ["x", "y", "z", "rx", "rz"]
[analysis]
kind = "dynamic"
end_time = 0.5
time_step = 1e-3
integrator = "sdirk-4"
)";

}  // namespace

TEST_CASE("A heavy top spins as accurately as its steps are asked to be", "[issues]") {
    constexpr double right = -106.163804143;  // ω_y at t = 2
    for (const auto& [tolerance, error] : {std::pair{"1e-8", 1e-3}, {"1e-9", 1e-4}}) {
        INFO(tolerance);
        const Problem problem = read(top_deck + "adaptive = { tolerance = " + tolerance + " }\n");
        const State end = run_to_end(problem.model, dynamic_of(problem));
        CHECK(std::abs(end.trial[0].omega.y() - right) < error);
    }
}

TEST_CASE("A fast top points where it should, a tenth of the error for a tenth of the tolerance",
          "[issues]") {
    const Model model = tools::fast_top::make_model();
    const auto error = [&](double tolerance) {
        const State end = run_to_end(model, by_error(1.0, tolerance));
        return (tools::fast_top::axis(end.trial[0].Lambda) - tools::fast_top::reference_axis_1()).norm();
    };
    const double coarse = error(1e-8);
    CHECK(error(1e-9) < 0.2 * coarse);
}

TEST_CASE("A rod swings as accurately as its steps are asked to be", "[issues]") {
    // By tolerances of 1e-12 and 1e-15 of Newton's method.
    const Vec3 right(-0.10531729404, 0.0, -0.99447605647);
    const Problem problem = read(pendulum_deck + "adaptive = { tolerance = 1e-9 }\n");
    const State end = run_to_end(problem.model, dynamic_of(problem));
    CHECK((end.trial.back().r - right).norm() < 1e-8);
}

TEST_CASE("A tolerance of Newton's method that the deck gives and that is the limit is warned of",
          "[issues]") {
    const auto warnings = [](const std::string& lines) {
        const Problem problem = read(top_deck + lines);
        std::string text;
        for (const Finding& finding : examine_model(problem.model, problem.analysis())) {
            if (finding.severity == Severity::warning) text += finding.message;
        }
        return text;
    };
    CHECK(
        warnings("adaptive = { tolerance = 1e-9 }\nnewton.tolerance = 1e-8\n") ==
        "newton.tolerance, 1e-08, limits the accuracy that adaptive.tolerance, 1e-09, asks for; expected at "
        "most 1e-11, or none: then it follows");
    CHECK(warnings("adaptive = { tolerance = 1e-9 }\nnewton.tolerance = 1e-10\n").empty());
    CHECK(warnings("adaptive = { tolerance = 1e-9 }\n").empty());
    CHECK(warnings("newton.tolerance = 1e-2\n").empty());
}

TEST_CASE("Newton's tolerance bounds no finer run of a verification", "[issues]") {
    const auto overrides = [](const std::string& lines) {
        const auto variants = list_variants(read(top_deck + lines), 2);
        std::vector<std::string> all;
        for (const DeckVariant& variant : variants) {
            if (variant.kind != VariantKind::finer_steps) continue;
            for (const std::string& text : variant.overrides) {
                if (text.find("tolerance") != std::string::npos) all.push_back(text);
            }
        }
        return all;
    };
    const std::string adaptive = "adaptive = { tolerance = 0.0625 }\n";
    CHECK(overrides(adaptive) == std::vector<std::string>{"analysis.adaptive.tolerance=0.00390625",
                                                          "analysis.adaptive.tolerance=0.000244140625"});
    CHECK(overrides(adaptive + "newton.tolerance = 0.25\n") ==
          std::vector<std::string>{"analysis.adaptive.tolerance=0.00390625",
                                   "analysis.newton.tolerance=0.015625",
                                   "analysis.adaptive.tolerance=0.000244140625",
                                   "analysis.newton.tolerance=0.0009765625"});
}

TEST_CASE("Equal steps too short for Newton's tolerance are reported at the end", "[issues]") {
    const auto limit = [](const std::string& lines) {
        const Problem problem = read(replaced(top_deck, "end_time = 2.0", "end_time = 0.1") + lines);
        return run_analysis({problem}).newton_limit;
    };
    CHECK(limit("").empty());
    const std::string short_steps = limit("newton.tolerance = 1e-6\n");
    CHECK_THAT(short_steps, Catch::StartsWith("the estimated errors of the steps, at most "));
    CHECK_THAT(short_steps, Catch::Contains("are near what newton.tolerance, 1e-06, leaves"));
}

}  // namespace gxrod::test
