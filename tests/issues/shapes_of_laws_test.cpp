#include <fmt/format.h>

#include <cmath>
#include <complex>

#include "deck/decks.hpp"
#include "tools/catch.hpp"
#include "tools/problem_run.hpp"

// Eigenvalues, modes, responses, buckling factors and sweeps of sections that remember took the tangent of
// the last step: relaxed or not, and elastic or not, by what the stage before had done.

namespace gxrod::test {
namespace {

using Catch::Contains;
using tools::run_problem;
using Complex = std::complex<double>;

const std::string viscoelastic = "law = { viscoelastic = { prony = [[0.5, 0.1], [0.3, 0.5]] } }";
const std::string plastic = "law = { plastic = { yield = { My = 0.5, Mz = 0.5 }, kinematic = 0.5 } }";
constexpr double relaxed_omega = 3.4223802519;  // of the cantilever with its relaxed stiffness

std::string make_cantilever(const std::string& law, const std::string& rest, const std::string& more = "") {
    return fmt::format(R"([section.bar]
stiffness = {{ EA = 1e3, GAy = 500, GAz = 500, GJ = 1, EIy = 1, EIz = 1.5 }}
inertia = {{ rhoA = 1, rhoJ = 0.02, rhoIy = 0.01, rhoIz = 0.01 }}
{}
{}
[rod.beam]
section = "bar"
line = {{ from = [0, 0, 0], to = [1, 0, 0] }}
elements = 6
order = 2
y_axis = [0, 1, 0]
[[support]]
at = "beam.start"
fix = "all"
{})",
                       law,
                       more,
                       rest);
}

std::string make_stage(const std::string& kind, const std::string& rest) {
    static int number = 0;
    return fmt::format("[[stage]]\nname = \"s{}\"\nkind = \"{}\"\n{}\n", ++number, kind, rest);
}

RunSummary run(const std::string& deck) {
    RunSummary summary = run_problem(read(deck));
    INFO(summary.reason);
    REQUIRE(summary.status == RunStatus::complete);
    return summary;
}

template <class Record>
Record find(const RunSummary& summary, std::size_t index = 0) {
    return std::get<Record>(summary.shapes.at(index).record);
}

bool has_note(const RunSummary& summary, const std::string& words) {
    return std::ranges::any_of(
        summary.notes, [&](const std::string& note) { return note.find(words) != std::string::npos; });
}

// 1 + Σ r λτ/(1 + λτ)
Complex find_modulus(Complex lambda) {
    return 1.0 + 0.5 * 0.1 * lambda / (1.0 + 0.1 * lambda) + 0.3 * 0.5 * lambda / (1.0 + 0.5 * lambda);
}

// By Newton's method: λ² + ω² (modulus + damping λ) = 0 of a structure all of whose strains relax alike.
Complex solve_for_lambda(double omega, double damping = 0.0) {
    const auto f = [&](Complex z) { return z * z + omega * omega * (find_modulus(z) + damping * z); };
    Complex lambda(-0.1 * omega, 1.2 * omega);
    for (int i = 0; i < 30; ++i) {
        const double h = 1e-5 * omega;
        lambda -= f(lambda) * 2.0 * h / (f(lambda + h) - f(lambda - h));
    }
    return lambda;
}

}  // namespace

TEST_CASE("Eigenvalues of a viscoelastic rod have its complex modulus", "[issues]") {
    const auto modes =
        find<ModesRecord>(run(make_cantilever("", "[analysis]\nkind = \"modes\"\ncount = 8\n")));
    CHECK(modes.modes[0].omega == Approx(relaxed_omega).epsilon(1e-8));
    const std::string ask = "count = 8\n";
    const auto check = [&](const RunSummary& summary, double damping) {
        const auto record = find<EigenvaluesRecord>(summary);
        CHECK(record.missing == 0);
        CHECK(record.unstable == 0);
        REQUIRE(record.modes.size() == 8);
        for (std::size_t i = 0; i < 8; ++i) {
            const Complex lambda = record.modes[i].lambda();
            CHECK(std::abs(lambda - solve_for_lambda(modes.modes[i].omega, damping)) <
                  1e-7 * std::abs(lambda));
        }
    };
    const std::string analysis = "[analysis]\nkind = \"eigenvalues\"\n" + ask;
    const RunSummary summary = run(make_cantilever(viscoelastic, analysis));
    check(summary, 0.0);
    CHECK(has_note(summary, "sections of beam relax"));
    // A dynamic run after a small blow rings with it.
    CHECK(std::abs(find<EigenvaluesRecord>(summary).modes[0].lambda() - Complex(-0.47331, 3.93070)) < 1e-5);
    SECTION("with Kelvin-Voigt damping in addition") {
        check(run(make_cantilever(viscoelastic, analysis, "damping = { kelvin_voigt = 0.01 }")), 0.01);
    }
    SECTION("whatever the steps before") {
        for (const char* steps : {"end_time = 1\ntime_step = 0.1", "end_time = 3\ntime_step = 1"})
            check(run(make_cantilever(viscoelastic,
                                      make_stage("quasi-static", steps) + make_stage("eigenvalues", ask))),
                  0.0);
        check(run(make_cantilever(viscoelastic,
                                  make_stage("static", "steps = 2") + make_stage("eigenvalues", ask))),
              0.0);
    }
    SECTION("of a free rod, whose rigid motions do not relax") {
        std::string deck = make_cantilever(viscoelastic, analysis);
        const std::size_t support = deck.find("[[support]]");
        deck.erase(support, deck.find("[analysis]") - support);
        const auto record = find<EigenvaluesRecord>(run(deck));
        CHECK(record.missing == 0);
        CHECK(record.modes.back().damping_ratio > 0.02);
    }
    SECTION("of branches on some strains alone, fast and slow") {
        const auto record = find<EigenvaluesRecord>(run(
            make_cantilever("law = { viscoelastic = { prony = [[5.0, 1e-3], [0.3, 0.5], [2, 100.0]], on = "
                            "[\"bending y\"] } }",
                            analysis)));
        CHECK(record.missing == 0);
        int undamped = 0;
        for (const Eigenmode& mode : record.modes) {
            if (mode.shape.words.find("bending about z") == std::string::npos) continue;
            ++undamped;
            CHECK(std::abs(mode.growth) < 1e-8 * mode.omega);
        }
        CHECK(undamped >= 2);
    }
}

TEST_CASE("Modes and buckling factors of a viscoelastic rod are relaxed, and the run says so", "[issues]") {
    const std::string load = "[[load]]\nat = \"beam.end\"\nforce = [-1, 0, 0]\n";
    const auto factor = [&](const std::string& law, const std::string& before) {
        const RunSummary summary =
            run(make_cantilever(law, load + before + make_stage("buckling", "count = 1")));
        CHECK(has_note(summary, "factors are those of loads that stay") == !law.empty());
        return find<BucklingRecord>(summary).factors.at(0).factor;
    };
    const double elastic = factor("", make_stage("static", ""));
    CHECK(factor(viscoelastic, make_stage("static", "")) == Approx(elastic).epsilon(1e-9));
    CHECK(factor(viscoelastic, make_stage("quasi-static", "end_time = 100\ntime_step = 10")) ==
          Approx(elastic).epsilon(1e-5));
    const RunSummary summary = run(make_cantilever(
        viscoelastic,
        make_stage("quasi-static", "end_time = 0.3\ntime_step = 0.1") + make_stage("modes", "count = 1")));
    CHECK(find<ModesRecord>(summary).modes[0].omega == Approx(relaxed_omega).epsilon(1e-8));
    CHECK(has_note(summary, "modes are those of the stiffness after a long time"));
}

TEST_CASE("The response of a viscoelastic rod is that of Kelvin and Voigt's at each frequency", "[issues]") {
    const auto respond = [](const std::string& section, double omega) {
        const auto record = find<ResponseRecord>(run(fmt::format(R"([section.bar]
{}
inertia = {{ rhoA = 1, rhoJ = 0.02, rhoIy = 0.01, rhoIz = 0.01 }}
[rod.beam]
section = "bar"
line = {{ from = [0, 0, 0], to = [1, 0, 0] }}
elements = 6
order = 2
[[support]]
at = "beam.start"
fix = "all"
[analysis]
kind = "response"
omega = {{ values = [{}] }}
excite = [{{ at = "beam.end", force = [0.3, 1, 0.5] }}]
[[history]]
name = "tip"
at = "beam.end"
quantities = ["displacement"]
)",
                                                                 section,
                                                                 omega)));
        const Response& response = record.responses.at(0);
        REQUIRE(response.failure.empty());
        Eigen::Matrix<Complex, 6, 1> tip;
        tip.real() = response.motion.real.back();
        tip.imag() = response.motion.imaginary.back();
        return tip;
    };
    const auto stiffness_of = [](double times) {
        return fmt::format("stiffness = {{ EA = {}, GAy = {}, GAz = {}, GJ = {}, EIy = {}, EIz = {} }}\n",
                           1e3 * times,
                           500 * times,
                           500 * times,
                           times,
                           times,
                           1.5 * times);
    };
    for (const double omega : {0.5, 3.42, 30.0}) {
        const Complex modulus = find_modulus(Complex(0.0, omega));
        const std::string damping =
            fmt::format("damping = {{ kelvin_voigt = {} }}", modulus.imag() / modulus.real() / omega);
        const auto expected = respond(stiffness_of(modulus.real()) + damping, omega);
        CHECK((respond(stiffness_of(1.0) + viscoelastic, omega) - expected).norm() < 1e-9 * expected.norm());
    }
}

TEST_CASE("Frequencies of what has yielded are elastic, whatever the load steps", "[issues]") {
    const std::string loads = "[[load]]\nat = \"beam.end\"\nforce = [0, 0.2, -0.4]\n";
    const auto omega_after = [&](const std::string& law, const std::string& stages) {
        const RunSummary summary =
            run("gravity = [0, 0, -1]\n" +
                make_cantilever(law, loads + stages + make_stage("modes", "count = 1")));
        CHECK(has_note(summary, "about to yield or to slip over a length of"));
        return find<ModesRecord>(summary).modes.at(0).omega;
    };
    // Besseling's layers and a table say the same of one direction as the surface does.
    for (const std::string& law :
         {plastic,
          std::string("law = { layers = [{ on = \"bending\", stiffness = 0.6, limit = 0.2 }] }"),
          std::string("law = { moment_curvature = { table = [[0, 0], [0.4, 0.4], [2, 1]], hysteresis = "
                      "\"kinematic\" } }")}) {
        INFO(law);
        const double omega = omega_after(law, make_stage("static", "steps = 40"));
        // Let go by a fiftieth of its load, it rings in a dynamic run with 3.606.
        if (law == plastic) CHECK(omega == Approx(3.609).epsilon(1e-3));
        for (const char* steps : {"steps = 5", "steps = 10", "steps = 20"})
            CHECK(omega_after(law, make_stage("static", steps)) == Approx(omega).epsilon(3e-4));
        const std::string twice = make_stage("static", "steps = 10") + make_stage("static", "steps = 1");
        CHECK(omega_after(law, twice) == Approx(omega).epsilon(3e-4));
    }
}

TEST_CASE("A sweep over sections that yield finds at each value what a run finds", "[issues]") {
    const auto find_omegas = [](double P, const std::string& sweep) {
        const RunSummary summary = run(fmt::format(R"(gravity = [0, 0, -1]
[section.bar]
shape = {{ rectangle = {{ width_y = 0.11, height_z = 0.1 }} }}
material = {{ E = 1e5, nu = 0.3, density = 100, yield_stress = 3000 }}
[rod.beam]
section = "bar"
line = {{ from = [0, 0, 0], to = [1, 0, 0] }}
elements = 6
order = 2
y_axis = [0, 1, 0]
[[support]]
at = "beam.start"
fix = "all"
[parameters]
P = {}
[[load]]
at = "beam.end"
force = [0, 0.2, "P"]
[[stage]]
name = "hang"
kind = "static"
steps = 10
[[stage]]
name = "tones"
kind = "eigenvalues"
count = 3
{})",
                                                   P,
                                                   sweep));
        std::vector<double> omegas;
        if (sweep.empty()) {
            omegas.push_back(find<EigenvaluesRecord>(summary).modes.at(0).omega);
        } else {
            for (const auto& point : find<SweepRecord>(summary).points)
                omegas.push_back(point.lambda.at(0).imag());
        }
        return omegas;
    };
    const std::vector<double> swept =
        find_omegas(0.0, "sweep = { key = \"parameters.P\", values = [-0.2, -0.4, -0.2] }\n");
    CHECK(swept[0] == Approx(find_omegas(-0.2, "")[0]).epsilon(1e-6));
    CHECK(swept[1] == Approx(find_omegas(-0.4, "")[0]).epsilon(1e-6));
    CHECK(swept[2] == Approx(swept[0]).epsilon(1e-9));
}

TEST_CASE("What yields has the stiffness of more load where the deck asks for it", "[issues]") {
    // A moment that is the same all along yields every section; from there on the slope is a quarter in the
    // plane of the moment.
    const std::string column = R"([section.bar]
stiffness = { EA = 1e6, GAy = 1e6, GAz = 1e6, GJ = 10, EIy = 1, EIz = 5 }
inertia = { rhoA = 1, rhoJ = 1e-6, rhoIy = 1e-6, rhoIz = 1e-6 }
law = { plastic = { yield = { My = 1e-3, Mz = 1e-3 }, kinematic = 0.3333333333333333 } }
[rod.beam]
section = "bar"
line = { from = [0, 0, 0], to = [1, 0, 0] }
elements = 8
order = 2
y_axis = [0, 1, 0]
[[support]]
at = "beam.start"
fix = "all"
[[load]]
at = "beam.end"
moment = [0, 2e-3, 0]
)";
    const auto first_omega = [&](const std::string& words) {
        return find<ModesRecord>(run(column + make_stage("static", "steps = 4") +
                                     make_stage("modes", "count = 1\n" + words)))
            .modes.at(0)
            .omega;
    };
    const double elastic = first_omega("");
    CHECK(elastic == Approx(3.5160153).epsilon(1e-4));
    CHECK(first_omega("linearization = \"elastic\"") == elastic);
    CHECK(first_omega("linearization = \"loading\"") == Approx(0.5 * elastic).epsilon(1e-4));

    // Of a force that presses, too: the load is (1 + factor) times what acts.
    const std::string pressed = column + "[[load]]\nat = \"beam.end\"\nforce = [-0.1, 0, 0]\n";
    const auto first_factor = [&](const std::string& words, const std::string& note) {
        const RunSummary summary =
            run(pressed + make_stage("static", "steps = 4") + make_stage("buckling", "count = 1\n" + words));
        CHECK(has_note(summary, note));
        return find<BucklingRecord>(summary).factors.at(0).factor;
    };
    const double euler = 2.4674011;
    CHECK(0.1 * (1.0 + first_factor("", "linearization = \"loading\" takes the other")) ==
          Approx(euler).epsilon(1e-3));
    CHECK(0.1 * (1.0 + first_factor("linearization = \"loading\"", "is taken as under more load")) ==
          Approx(0.25 * euler).epsilon(1e-3));
}

TEST_CASE("Friction at its limit sticks in small motions, or slips where the deck asks for it", "[issues]") {
    const auto first_omega =
        [&](const std::string& joint, const std::string& words, const std::string& note) {
            const RunSummary summary = run(R"(gravity = [0, 0, -1]
[section.bar]
stiffness = { EA = 1e6, GAy = 1e6, GAz = 1e6, GJ = 10, EIy = 10, EIz = 50 }
inertia = { rhoA = 1, rhoJ = 1e-6, rhoIy = 1e-6, rhoIz = 1e-6 }
[rod.beam]
section = "bar"
line = { from = [0, 0, 0], to = [1, 0, 0] }
elements = 6
order = 2
y_axis = [0, 1, 0]
[joint.root]
between = ["ground", "beam.start"]
type = "hinge"
axis = [0, 1, 0]
)" + joint + "\n" + make_stage("static", "steps = 4") +
                                           make_stage("modes", "count = 1\n" + words));
            CHECK(has_note(summary, "friction of joint root") == !note.empty());
            CHECK(has_note(summary, note) == !note.empty());
            return find<ModesRecord>(summary).modes.at(0).omega;
        };
    // The moment 0.5 of the weight slips by much more than `stick`.
    const std::string rough = "spring = { stiffness = 30 }\nfriction = { moment = 0.02, stick = 1e-3 }";
    const double stuck = first_omega("spring = { stiffness = 50 }", "", "");
    const double slipping = first_omega("spring = { stiffness = 30 }", "", "");
    CHECK(slipping < 0.95 * stuck);
    CHECK(first_omega(rough, "", "is at its limit: it is taken to stick") == Approx(stuck).epsilon(1e-4));
    CHECK(first_omega(rough, "linearization = \"loading\"", "it is taken to slip") ==
          Approx(slipping).epsilon(1e-4));
}

TEST_CASE("Friction between a rod and a floor sticks in modes as in eigenvalues", "[issues]") {
    const auto run_kind = [&](const std::string& kind) {
        return run("gravity = [0, 0, -1]\n" +
                   make_cantilever("radius = 0.02",
                                   "[[load]]\nat = \"beam.end\"\nforce = [0, 0.3, -0.5]\n"
                                   "[obstacle.floor]\nplane = { point = [0, 0, -0.07], normal = [0, 0, 1] }\n"
                                   "friction = 0.2\n" +
                                       make_stage("static", "steps = 10") + make_stage(kind, "count = 4")));
    };
    const RunSummary modes = run_kind("modes"), values = run_kind("eigenvalues");
    CHECK(has_note(modes, "friction of contact is at its limit: it is taken to stick"));
    for (std::size_t i = 0; i < 3; ++i) {
        const double omega = find<ModesRecord>(modes).modes.at(i).omega;
        CHECK(omega > 1.0);
        CHECK(find<EigenvaluesRecord>(values).modes.at(i).omega == Approx(omega).epsilon(1e-6));
    }
}

TEST_CASE("Buckling factors do not multiply the move of an obstacle", "[issues]") {
    const RunSummary summary = run_problem(read(make_cantilever(
        "radius = 0.02",
        "[[load]]\nat = \"beam.end\"\nforce = [-0.3, 0, 0]\n"
        "[obstacle.ball]\nsphere = { centre = [0.7, 0, -0.2], radius = 0.1 }\nmove = { z = \"0.15*t\" }\n" +
            make_stage("buckling", "count = 1"))));
    CHECK(summary.status != RunStatus::complete);
    CHECK_THAT(summary.reason, Contains("buckling factors would leave out the move of obstacle ball"));
}

}  // namespace gxrod::test
