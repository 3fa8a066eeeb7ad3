// Rods whose stress-free shape is another curve than the one in which they start.
#include <fmt/format.h>

#include <cmath>
#include <numbers>

#include "analyses/static.hpp"
#include "deck/decks.hpp"
#include "tools/catch.hpp"

namespace gxrod::test {
namespace {

struct Outcome {
    std::vector<Vec3> places;
    double strain_energy = 0.0;
    Vec6 reaction = Vec6::Zero();  // of the first support
};

Outcome run(const std::string& deck) {
    const Problem problem = read(deck);
    const auto analysis = make_analysis(problem.model, problem.analysis(), 1);
    REQUIRE(analysis->start().converged());
    while (!analysis->finished()) REQUIRE(analysis->advance().converged());
    Outcome outcome;
    for (const NodeMotion& node : analysis->state().trial) outcome.places.push_back(node.r);
    outcome.strain_energy = analysis->ledger_row().strain_energy;
    const Snapshot snapshot = analysis->snapshot();
    outcome.reaction = snapshot.reactions[static_cast<std::size_t>(problem.model.supports.front().node)];
    return outcome;
}

const std::string sections = R"([section.s]
stiffness = { EA = 1e4, GAy = 4e3, GAz = 3e3, GJ = 5, EIy = 6, EIz = 7 }
inertia = { rhoA = 1.5, rhoJ = 0.2, rhoIy = 0.1, rhoIz = 0.1 }
)";

// A rod with these keys, held at its start.
std::string rod(const std::string& keys, const std::string& others = "") {
    return sections + "[rod.r]\nsection = \"s\"\n" + keys +
           "\n[[support]]\nat = \"r.start\"\nfix = \"all\"\n" + others;
}

std::string statics() { return "[analysis]\nkind = \"static\"\nsteps = 2\nnewton = { tolerance = 1e-12 }\n"; }

double distance_between(const std::vector<Vec3>& a, const std::vector<Vec3>& b) {
    REQUIRE(a.size() == b.size());
    double largest = 0.0;
    for (std::size_t i = 0; i < a.size(); ++i) largest = std::max(largest, (a[i] - b[i]).norm());
    return largest;
}

const std::vector<std::string> all_kinds{"order = 1",
                                         "order = 2",
                                         "order = 3",
                                         "order = 4",
                                         "order = 1\nelement = \"simo\"",
                                         "order = 2\nelement = \"simo\"",
                                         "order = 3\nelement = \"simo\"",
                                         "order = 4\nelement = \"simo\""};

}  // namespace

TEST_CASE("a rest that is the start itself changes nothing", "[analyses]") {
    const std::string load =
        "[[load]]\nat = \"r.end\"\nforce = [0.3, -0.5, 0.4]\n"
        "[[load]]\non = \"r\"\nforce_per_length = [0, 0, 0.2]\n";
    for (const std::string curve :
         {"line = { from = [0, 0, 0], to = [1, 2, 0.5] }",
          "arc = { from = [0, 0, 0], through = [1, 1, 0], to = [2, 0, 0.5] }",
          "helix = { centre = [0, 0, 0], axis = [0, 0, 1], from = [1, 0, 0], turns = 0.5, pitch = 2 }",
          "polyline = [[0, 0, 0], [1, 0, 0], [1, 1, 0.5]]",
          "spline = [[0, 0, 0], [1, 1, 0], [2, 0, 0], [3, 1, 1]]"}) {
        for (const std::string& kind : all_kinds) {
            CAPTURE(curve, kind);
            const std::string keys = curve + "\nelements = 6\ny_axis = [0.1, 0.2, 1]\ntwist = 0.7\n" + kind;
            const Outcome without = run(rod(keys, load) + statics());
            const Outcome with = run(rod(keys + "\nrest = { " + curve + " }", load) + statics());
            CHECK(distance_between(without.places, with.places) == 0.0);
            CHECK(with.strain_energy == without.strain_energy);
        }
    }
}

TEST_CASE("a straight strip that is closed to a ring carries EI/R everywhere", "[analyses]") {
    // Energy ½ EI/R² 2πR of a strip whose axis of bending, section y, is normal to the ring's plane.
    const double R = 1.5;
    const double expected = std::numbers::pi * 6.0 / R;
    for (const std::string element : {"objective", "simo"}) {
        CAPTURE(element);
        const auto energy = [&](const std::string& rest) {
            return run(rod("arc = { centre = [0, 0, 0], axis = [0, 0, 1], from = [1.5, 0, 0], angle = "
                           "\"2*pi\" }\n"
                           "elements = 16\norder = 4\ny_axis = [0, 0, 1]\nelement = \"" +
                               element + "\"\nrest = { " + rest + " }",
                           "[[connect]]\npoints = [\"r.start\", \"r.end\"]\n") +
                       statics())
                .strain_energy;
        };
        const double of_line = energy("line = { from = [5, 0, 0], to = [5, \"3*pi\", 0] }");
        CHECK(of_line == Approx(expected).epsilon(1e-10));
        CHECK(of_line == Approx(energy("curvature = [0, 0, 0]")).epsilon(1e-10));
    }
}

TEST_CASE("a straight rod relaxes to the circle of its rest", "[analyses]") {
    const double R = 6.0;
    const std::string keys =
        "line = { from = [0, 0, 0], to = [\"2*pi\", 0, 0] }\ny_axis = [0, 0, 1]\n"
        "rest = { arc = { centre = [0, 6, 0], axis = [0, 0, 1], from = [0, 0, 0], angle = \"pi/3\" } }\n";
    const Vec3 tip(R * std::sqrt(0.75), 0.5 * R, 0.0);
    const auto miss = [&](const std::string& kind) {
        const Outcome outcome = run(rod(keys + kind) + statics());
        CHECK(std::abs(outcome.strain_energy) < 1e-12);
        return (outcome.places.back() - tip).norm();
    };
    // Nodes are those of the rest, whatever the mesh: in a plane of both elements.
    for (const std::string& kind : all_kinds) {
        CAPTURE(kind);
        CHECK(miss("elements = 4\n" + kind) < 1e-9);
    }
}

TEST_CASE("a straight rod relaxes to the helix of its rest, wherever that is drawn", "[analyses]") {
    // Radius 1, pitch 2π c with c = 0.5: axes that are carried turn against the normal by c/(1 + c²) per
    // length.
    const double length = 0.5 * 2.0 * std::numbers::pi * std::sqrt(1.25);
    const std::string start = fmt::format("line = {{ from = [1, 0, 0], to = [1, {}, {}] }}\n",
                                          length / std::sqrt(1.25),
                                          0.5 * length / std::sqrt(1.25));
    for (const std::string element : {"objective", "simo"}) {
        for (const std::string twist : {"0", "1.2"}) {
            CAPTURE(element, twist);
            const std::string keys = start +
                                     "elements = 16\norder = 4\ny_axis = [1, 0, 0]\ntwist = " + twist +
                                     "\nelement = \"" + element + "\"\n";
            const Outcome here = run(
                rod(keys + "rest = { helix = { centre = [0, 0, 0], axis = [0, 0, 1], from = [1, 0, 0], turns "
                           "= 0.5, pitch = \"pi\" } }") +
                statics());
            CHECK((here.places.back() - Vec3(-1.0, 0.0, 0.5 * std::numbers::pi)).norm() < 1e-8);
            CHECK(std::abs(here.strain_energy) < 1e-12);
            // Turned by 90° about x and moved.
            const Outcome there =
                run(rod(keys +
                        "rest = { helix = { centre = [7, 8, 9], axis = [0, -1, 0], from = [8, 8, 9], turns = "
                        "0.5, pitch = \"pi\" }, y_axis = [1, 0, 0] }") +
                    statics());
            CHECK(distance_between(here.places, there.places) < 1e-9);
        }
    }
}

TEST_CASE("a rod that is shorter than its rest is pressed between its ends", "[analyses]") {
    for (const std::string& kind : all_kinds) {
        CAPTURE(kind);
        // Stiff enough against bending not to buckle.
        const Outcome outcome =
            run(replaced(rod("line = { from = [0, 0, 0], to = [2, 0, 0] }\nelements = 3\n" + kind +
                                 "\nrest = { line = { from = [0, 0, 0], to = [0, 2.2, 0] }, "
                                 "y_axis = [1, 0, 0] }",
                             "[[support]]\nat = \"r.end\"\nfix = \"all\"\n"),
                         "EIy = 6, EIz = 7",
                         "EIy = 600, EIz = 700") +
                statics());
        // N = EA (1/1.1 − 1), over the length of the rest.
        CHECK(outcome.reaction[0] == Approx(1e4 * (1.0 - 1.0 / 1.1)).epsilon(1e-12));
        CHECK(outcome.strain_energy == Approx(0.5 * 1e4 * std::pow(1.0 / 1.1 - 1.0, 2) * 2.2).epsilon(1e-12));
    }
}

TEST_CASE("twist of the rest alone is a torque between held ends", "[analyses]") {
    const std::string line = "line = { from = [0, 0, 0], to = [2, 0, 0] }";
    for (const std::string& kind : all_kinds) {
        CAPTURE(kind);
        const auto torque = [&](const std::string& twist, const std::string& of_rest) {
            return run(rod(line + "\nelements = 4\n" + kind + "\ntwist = " + twist + "\nrest = { " + line +
                               of_rest + " }",
                           "[[support]]\nat = \"r.end\"\nfix = \"all\"\n") +
                       statics())
                .reaction[3];
        };
        // T = GJ (φ − φ_rest)/L, which the support at the start balances.
        CHECK(std::abs(torque("0.3", "")) < 1e-13);
        CHECK(torque("0", ", twist = 0.8") == Approx(5.0 * 0.4).epsilon(1e-11));
        CHECK(torque("0.3", ", twist = [[0, 0], [1, 0.8]]") == Approx(5.0 * 0.25).epsilon(1e-11));
    }
}

TEST_CASE("weights and loads per length go by the length of the rest", "[analyses]") {
    for (const std::string& kind : all_kinds) {
        CAPTURE(kind);
        const Outcome outcome = run("gravity = [0, 0, -9]\n" +
                                    rod("line = { from = [0, 0, 0], to = [2, 0, 0] }\nelements = 3\n" + kind +
                                            "\nrest = { line = { from = [0, 0, 0], to = [2.5, 0, 0] } }",
                                        "[[load]]\non = \"r\"\nforce_per_length = [0, \"s\", 0]\n") +
                                    statics());
        CHECK(outcome.reaction[2] == Approx(9.0 * 1.5 * 2.5).epsilon(1e-11));
        CHECK(outcome.reaction[1] == Approx(-0.5 * 2.5 * 2.5).epsilon(1e-11));
    }
}

TEST_CASE("a free rod that starts bent swings about its rest without losing energy", "[analyses]") {
    // From an arc as long as its straight rest; the energy of the start is ½ EI κ² L.
    const auto swing = [](const std::string& steps) {
        const Problem problem =
            read(sections +
                 "[rod.r]\nsection = \"s\"\narc = { centre = [0, 2, 0], axis = [0, 0, 1], from = [0, 0, 0], "
                 "angle = 0.5 "
                 "}\nelements = 4\norder = 3\ny_axis = [0, 0, 1]\nrest = { line = { from = [0, 0, 0], to = "
                 "[1, 0, 0] } "
                 "}\n[analysis]\nkind = \"dynamic\"\nintegrator = \"sdirk-4\"\nend_time = 0.2\nsteps = " +
                 steps + "\nnewton = { tolerance = 1e-12 }\n");
        const auto analysis = make_analysis(problem.model, problem.analysis(), 1);
        REQUIRE(analysis->start().converged());
        CHECK(analysis->ledger_row().strain_energy == Approx(0.5 * 6.0 * 0.25).epsilon(1e-6));
        double kinetic = 0.0;
        while (!analysis->finished()) {
            REQUIRE(analysis->advance().converged());
            kinetic = std::max(kinetic, analysis->ledger_row().kinetic_energy);
        }
        CHECK(kinetic > 0.3);
        return std::abs(analysis->ledger_row().energy_error);
    };
    CHECK(swing("400") < swing("200") / 10.0);
}

}  // namespace gxrod::test
