#include "deck/rods/imperfections.hpp"

#include <fmt/format.h>

#include <cmath>
#include <numbers>

#include "deck/decks.hpp"
#include "face/gxrod.hpp"
#include "tools/catch.hpp"

namespace gxrod::test {
namespace {

using Catch::Contains;

constexpr double L = 2.0, EI = 60.0, pi = std::numbers::pi;

// A pinned column along z, pressed by a part of Euler's load; stiff against extension and shear.
std::string make_column(double part, const std::string& imperfection) {
    const double critical = pi * pi * EI / (L * L);
    return fmt::format(R"([section.s]
stiffness = {{ EA = 1e7, GAy = 1e7, GAz = 1e7, GJ = 50, EIy = 60, EIz = 70 }}
[rod.c]
section = "s"
line = {{ from = [0, 0, 0], to = [0, 0, 2] }}
elements = 8
order = 3
z_axis = "up"
[[support]]
at = "c.start"
fix = ["position", "rx", "rz"]
[[support]]
at = "c.end"
fix = ["x", "y"]
[[load]]
at = "c.end"
force = [0, 0, -{}]
[[history]]
name = "middle"
at = "c@0.5"
quantities = ["displacement", "moment", "position"]
[analysis]
kind = "static"
steps = 1
{})",
                       part * critical,
                       imperfection);
}

double deflect(double part, const std::string& imperfection) {
    Simulation run(Deck::from_text(make_column(part, imperfection)).build());
    run.run();
    return run["middle"].displacement.x();
}

}  // namespace

TEST_CASE("A column with a bow deflects by Ayrton and Perry", "[deck]") {
    // The start is w₀ sin(π z/L); the load adds w₀ p/(1 − p), p = P/P_E.
    constexpr double w0 = 1e-4;
    for (const char* imperfection : {"[[imperfection]]\nmode = 1\namplitude = 1e-4\n",
                                     "[[imperfection]]\nbow = 0.5e-4\ndirection = [1, 0, 0.3]\n"}) {
        for (const double part : {0.2, 0.5, 0.8}) {
            CHECK(deflect(part, imperfection) == Approx(w0 * part / (1.0 - part)).epsilon(1e-4));
        }
    }
    CHECK(deflect(0.5, "") == Approx(0.0).margin(1e-12));
}

TEST_CASE("A start with an imperfection is stress-free", "[deck]") {
    Simulation run(
        Deck::from_text(make_column(0.5, "[[imperfection]]\nmode = 1\namplitude = 0.1\n")).build());
    CHECK(run["middle"].moment.vector().norm() < 1e-9);
}

TEST_CASE("A mode displaces the start, and several add up", "[deck]") {
    const Problem one =
        Deck::from_text(make_column(0.5, "[[imperfection]]\nmode = 1\namplitude = -0.02\n")).build();
    const Vec3 middle = one.model.nodes.at(12).position;
    CHECK(middle.x() == Approx(-0.02).epsilon(1e-6));
    CHECK(middle.z() == Approx(1.0));
    CHECK(one.record.meshes.at(0).file == "imperfection[0].csv");
    const Problem two = Deck::from_text(make_column(0.5,
                                                    "[[imperfection]]\nmode = 1\namplitude = 0.02\n"
                                                    "[[imperfection]]\nbow = 0.01\ndirection = [-1, 0, 0]\n"))
                            .build();
    CHECK(two.model.nodes.at(12).position.x() == Approx(0.0).margin(1e-6));
    // The same problem again, from what the record has of it.
    const Problem again = rebuild_problem(one.record);
    for (std::size_t i = 0; i < one.model.nodes.size(); ++i)
        CHECK(again.model.nodes[i].position == one.model.nodes[i].position);
}

TEST_CASE("A structure leans by a sway", "[deck]") {
    const Model model =
        Deck::from_text(make_column(0.5, "[[imperfection]]\nsway = \"1/200\"\ndirection = [0, 2, 1]\n"))
            .build()
            .model;
    CHECK(model.nodes.back().position.y() == Approx(0.01).epsilon(1e-14));
    CHECK(model.nodes.front().position == Vec3(0, 0, 0));
    const Vec3 tangent = model.rods[0].triads[3] * Vec3::UnitX();
    CHECK((tangent - Vec3(0, 0.005, 1).normalized()).norm() < 1e-12);
    // It is as straight as before.
    Simulation run(
        Deck::from_text(replaced(make_column(0.5, "[[imperfection]]\nsway = 0.01\ndirection = [1, 0, 0]\n"),
                                 "steps = 1",
                                 "steps = 1\n"))
            .build());
    CHECK(run["middle"].moment.vector().norm() < 1e-9);
}

TEST_CASE("Faults of imperfections name what to do", "[deck]") {
    const auto faults = [](const std::string& text) {
        try {
            Deck::from_text(make_column(0.5, text), "x.toml").build();
        } catch (const DeckError& error) {
            return std::string(error.what());
        }
        return std::string();
    };
    CHECK_THAT(faults("[[imperfection]]\nmode = 1\n"), Contains("amplitude: missing; expected the largest"));
    CHECK_THAT(faults("[[imperfection]]\nbow = 0.01\n"), Contains("expected a direction that is not zero"));
    CHECK_THAT(faults("[[imperfection]]\nbow = 0.01\ndirection = [0, 0, 1]\n"),
               Contains("is along c; expected a direction across each member"));
    CHECK_THAT(faults("[[imperfection]]\nsway = 0.01\ndirection = [0, 0, 1]\n"), Contains("is vertical"));
    CHECK_THAT(faults("[[imperfection]]\nfile = \"none.csv\"\namplitude = 1\n"), Contains("none.csv"));
    CHECK_THAT(faults("[[imperfection]]\nmode = 1\nsway = 1\n"), Contains("mode"));
    CHECK_THAT(
        faults("[[imperfection]]\nmode = 1\namplitude = 1\n[[support]]\nat = \"c.end\"\nfix = \"z\"\n"),
        Contains("imperfection[0].mode: no buckling mode: "));
}

}  // namespace gxrod::test
