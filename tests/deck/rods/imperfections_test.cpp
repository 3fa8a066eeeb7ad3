#include "deck/rods/imperfections.hpp"

#include <fmt/format.h>

#include <cmath>
#include <numbers>

#include "deck/decks.hpp"
#include "face/gxrod.hpp"
#include "run/run.hpp"
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

TEST_CASE("A mode of vibration displaces the start as the modes of the perfect structure have it", "[deck]") {
    const std::string column = make_column(0.0, "");
    for (int number = 1; number <= 3; ++number) {
        const std::string inertia = "inertia = { rhoA = 2, rhoJ = 0.1, rhoIy = 0.05, rhoIz = 0.05 }\n[rod.c]";
        const std::string moving = replaced(column, "[rod.c]", inertia);
        // By a stage of modes, from the results in memory.
        const Problem modes =
            Deck::from_text(replaced(moving, "kind = \"static\"\nsteps = 1", "kind = \"modes\"")).build();
        const RunSummary summary = run_analysis(RunRequest{modes});
        const std::vector<Vec6>& shape = std::get<ModesRecord>(summary.shapes.at(0).record)
                                             .modes.at(static_cast<std::size_t>(number) - 1)
                                             .shape.nodes;
        double size = 0.0;
        for (const Vec6& node : shape) size = std::max(size, node.head<3>().norm());
        const Problem bent =
            Deck::from_text(
                moving +
                fmt::format("[[imperfection]]\nmode = {}\nof = \"vibration\"\namplitude = 0.02\n", number))
                .build();
        const auto displacement = [&](std::size_t i) {
            return Vec3(bent.model.nodes.at(i).position - modes.model.nodes.at(i).position);
        };
        double largest = 0.0, product = 0.0;
        for (std::size_t i = 0; i < shape.size(); ++i) {
            largest = std::max(largest, displacement(i).norm());
            product += displacement(i).dot(shape[i].head<3>());
        }
        CHECK(largest == Approx(0.02).epsilon(1e-12));
        const double sign = product < 0.0 ? -1.0 : 1.0;
        for (std::size_t i = 0; i < shape.size(); ++i)
            CHECK((displacement(i) - sign * 0.02 / size * shape[i].head<3>()).norm() < 1e-10 * 0.02);
    }
}

TEST_CASE("A load combination scales an imperfection, or leaves it out", "[deck]") {
    const auto middle = [](const std::string& more, const std::string& apply) {
        Deck deck = Deck::from_text(
            make_column(0.5, more) +
            "[combination.a]\nfactors = { bent = 0.5 }\n[combination.b]\nfactors = { gone = 1 }\n"
            "[[load]]\ncase = \"gone\"\nat = \"c.end\"\nforce = [0, 0, -1]\n");
        return deck.set_all({"apply=" + apply}).build().model.nodes.at(12).position.x();
    };
    const std::string bow = "[[imperfection]]\nbow = 0.01\ndirection = [1, 0, 0]\ncase = \"bent\"\n";
    CHECK(middle(bow, "a") == Approx(0.01).epsilon(1e-6));
    CHECK(middle(bow, "b") == 0.0);
    const std::string mode = "[[imperfection]]\nmode = 1\namplitude = 0.02\ncase = \"bent\"\n";
    CHECK(middle(mode, "a") == Approx(0.01).epsilon(1e-6));
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
