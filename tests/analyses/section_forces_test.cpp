
#include "deck/decks.hpp"
#include "study/deck_run.hpp"
#include "tools/catch.hpp"
#include "tools/run.hpp"
#include "tools/static_run.hpp"

// Section forces and strains of histories, at nodes and between, against equilibrium.

namespace gxrod::test {
namespace {

Vec3 vector_of(DeckRun& run, const std::string& history, const std::string& quantity) {
    const HistoryRow row = run.value(history, quantity);
    return {row[0], row[1], row[2]};
}

std::string history(const std::string& name, const std::string& at, const std::string& more = "") {
    return "[[history]]\nname = \"" + name + "\"\nat = \"" + at +
           "\"\nquantities = [\"position\", \"force_spatial\", \"moment_spatial\", \"force\", \"moment\", "
           "\"strain\", \"curvature\", \"orientation\"" +
           more + "]\n";
}

// A clamped curved rod with a force and a moment at its end, a load along it and its weight.
std::string clamped(const std::string& element, const std::string& kind, const std::string& damping = "") {
    return R"deck(gravity = [0, 0, -2]
[section.s]
stiffness = { EA = 1e3, GAy = 1e3, GAz = 1e3, GJ = 5, EIy = 6, EIz = 7 }
inertia = { rhoA = 1.0, rhoJ = 0.2, rhoIy = 0.1, rhoIz = 0.1 }
)deck" + damping +
           R"deck([rod.r]
section = "s"
arc = { from = [0, 0, 0], through = [1, 0.3, 0], to = [2, 0, 0] }
elements = 4
)deck" + element +
           R"deck(
[[support]]
at = "r.start"
fix = "all"
[[load]]
at = "r.end"
force = [1, -2, 3]
moment = ["0.5", 1, 0]
[[load]]
on = "r"
force_per_length = [0, 1, "s"]
moment_per_length = ["0.3*s", 0, 0]
[analysis]
)deck" + kind +
           history("root", "r.start", R"(, "reaction_force", "reaction_moment")") + history("tip", "r.end") +
           history("inside", "r@0.5") + history("between", "r@0.4");
}

}  // namespace

TEST_CASE("Section forces at the ends of a rod are those of supports and loads", "[analyses]") {
    const std::string element = GENERATE(as<std::string>{},
                                         "order = 1",
                                         "order = 2",
                                         "order = 3",
                                         "order = 4",
                                         "element = \"simo\"",
                                         "order = 3\nelement = \"simo\"");
    const std::string kind =
        GENERATE(as<std::string>{},
                 "kind = \"static\"\nsteps = 2\nnewton = { tolerance = 1e-12 }\n",
                 "kind = \"dynamic\"\nend_time = 0.5\nsteps = 10\nnewton = { tolerance = 1e-12 }\n",
                 "kind = \"dynamic\"\nend_time = 0.5\nsteps = 10\nintegrator = \"generalized-alpha\"\nnewton "
                 "= { tolerance = 1e-12 }\n",
                 "kind = \"dynamic\"\nend_time = 0.5\nsteps = 10\nintegrator = \"sdirk-4\"\nnewton = { "
                 "tolerance = 1e-12 }\n");
    const std::string damping =
        GENERATE(as<std::string>{}, "", "damping = { kelvin_voigt = 0.01, mass_proportional = 0.5 }\n");
    INFO(element << " " << kind << damping);
    DeckRun run("clamped", clamped(element, kind, damping), {});
    run.run([] {});
    CHECK((vector_of(run, "root", "force_spatial") + vector_of(run, "root", "reaction_force")).norm() < 1e-7);
    CHECK((vector_of(run, "root", "moment_spatial") + vector_of(run, "root", "reaction_moment")).norm() <
          1e-7);
    CHECK((vector_of(run, "tip", "force_spatial") - Vec3(1, -2, 3)).norm() < 1e-7);
    CHECK((vector_of(run, "tip", "moment_spatial") - Vec3(0.5, 1, 0)).norm() < 1e-7);
    // Material components are those in the axes there.
    for (const char* point : {"root", "tip", "inside", "between"}) {
        const HistoryRow q = run.value(point, "orientation");
        const Quat axes(q[0], q[1], q[2], q[3]);
        CHECK((axes * vector_of(run, point, "force") - vector_of(run, point, "force_spatial")).norm() <
              1e-12);
        CHECK((axes * vector_of(run, point, "moment") - vector_of(run, point, "moment_spatial")).norm() <
              1e-12);
    }
}

TEST_CASE("Section forces follow loads that turn and supports that move", "[analyses]") {
    const std::string integrator = GENERATE(as<std::string>{}, "newmark-simplified", "runge-kutta-4");
    const std::string frame = GENERATE(as<std::string>{}, "follower", "body");
    const std::string steps = integrator == "runge-kutta-4"
                                  ? "end_time = 2e-3\nsteps = 40"
                                  : "end_time = 0.5\nsteps = 20\nnewton = { tolerance = 1e-12 }";
    std::string deck =
        clamped("order = 2", "kind = \"dynamic\"\n" + steps + "\nintegrator = \"" + integrator + "\"\n");
    deck = replaced(deck,
                    "moment_per_length = [\"0.3*s\", 0, 0]",
                    "moment_per_length = [\"0.3*s\", 0, 0]\nframe = \"" + frame + "\"");
    deck = replaced(deck,
                    "fix = \"all\"",
                    "fix = [\"x\", \"y\", \"rx\", \"ry\"]\nmove = { z = \"0.01*t^2\", rz = \"t^2\" }");
    INFO(integrator << " " << frame);
    DeckRun run("moved", deck, {});
    run.run([] {});
    CHECK((vector_of(run, "root", "force_spatial") + vector_of(run, "root", "reaction_force")).norm() < 1e-7);
    CHECK((vector_of(run, "root", "moment_spatial") + vector_of(run, "root", "reaction_moment")).norm() <
          1e-7);
    CHECK((vector_of(run, "tip", "force_spatial") - Vec3(1, -2, 3)).norm() < 1e-7);
}

TEST_CASE("Strains of a point belong to its section forces", "[analyses]") {
    DeckRun run("clamped", clamped("order = 2", "kind = \"static\"\nsteps = 2\n"), {});
    run.run([] {});
    for (const char* point : {"root", "tip", "inside", "between"}) {
        const Vec3 strain = vector_of(run, point, "strain");
        const Vec3 curvature = vector_of(run, point, "curvature");
        CHECK((1e3 * strain - vector_of(run, point, "force")).norm() < 1e-9);
        CHECK((Vec3(5, 6, 7).cwiseProduct(curvature) - vector_of(run, point, "moment")).norm() < 1e-9);
    }
}

TEST_CASE("Damping does not change a point's strain", "[analyses]") {
    // So strongly damped that the resultants are those of damping mostly; strains start from zero. Between
    // force points damping is interpolated.
    DeckRun run("clamped",
                clamped("order = 4",
                        "kind = \"dynamic\"\nend_time = 1e-4\nsteps = 10\nnewton = { tolerance = 1e-12 }\n",
                        "damping = { kelvin_voigt = 10.0 }\n"),
                {});
    run.run([] {});
    const Vec3 moment = vector_of(run, "inside", "moment");
    const Vec3 elastic = Vec3(5, 6, 7).cwiseProduct(vector_of(run, "inside", "curvature"));
    CHECK(moment.norm() > 1e-4);
    CHECK(elastic.norm() < 2e-2 * moment.norm());
}

TEST_CASE("Section forces between nodes converge to those of equilibrium", "[analyses]") {
    // A clamped rod bent far by a force at its tip: at any point the force is that one, and the moment its
    // moment about the point.
    const auto error = [](int order, int elements) {
        const std::string deck = R"deck([section.s]
stiffness = { EA = 1e5, GAy = 1e5, GAz = 1e5, GJ = 5, EIy = 6, EIz = 7 }
[rod.r]
section = "s"
line = { from = [0, 0, 0], to = [2, 0, 0] }
elements = 4
[[support]]
at = "r.start"
fix = "all"
[[load]]
at = "r.end"
force = [0, 3, 4]
[analysis]
kind = "static"
steps = 2
newton = { tolerance = 1e-11 }
)deck" + history("tip", "r.end") +
                                 history("between", "r@0.333333333333");
        DeckRun run("bent",
                    deck,
                    {"rod.r.elements=" + std::to_string(elements), "rod.r.order=" + std::to_string(order)});
        run.run([] {});
        const Vec3 arm = vector_of(run, "tip", "position") - vector_of(run, "between", "position");
        const Vec3 expected = arm.cross(Vec3(0, 3, 4));
        return (vector_of(run, "between", "moment_spatial") - expected).norm();
    };
    for (const int order : {1, 2, 3}) {
        INFO("order " << order);
        const double coarse = error(order, 8);
        const double fine = error(order, 16);
        CHECK(fine < 0.02);
        CHECK(coarse / fine > std::pow(2.0, order + 0.6));
    }
}

TEST_CASE("A history places no node", "[analyses]") {
    const std::string deck = clamped("order = 2", "kind = \"static\"\n");
    const Problem problem = read(deck);
    CHECK(problem.model.nodes.size() == 9);
    const std::vector<HistoryRequest>& histories = problem.output.histories;
    CHECK(node_of(histories[2].target) == 4);
    CHECK(node_of(histories[3].target) == -1);
    const RodPlace& place = std::get<WatchedPoint>(histories[3].target).place;
    CHECK(place.element == 1);
    CHECK(place.xi == Approx(0.2).epsilon(1e-12));
    // What the history is relative to has axes, and so a node.
    const std::string relative =
        "[[history]]\nname = \"seen\"\nat = \"r@0.4\"\nrelative_to = \"r@0.6\"\nquantities = \"position\"\n";
    const Problem placed = read(deck + relative);
    CHECK(node_of(placed.output.histories[4].target) == -1);
    CHECK(placed.model.nodes[static_cast<std::size_t>(placed.output.histories[4].relative_node)].name ==
          "r@0.6");
}

TEST_CASE("A point between nodes starts on the rod's line", "[analyses]") {
    DeckRun run("still", clamped("order = 4", "kind = \"dynamic\"\nend_time = 1e-9\nsteps = 1\n"), {});
    run.run([] {});
    const Vec3 at = vector_of(run, "between", "position");
    // The circle through the arc's three points.
    const double radius = (1.0 + 0.09) / 0.6;
    CHECK((at - Vec3(1.0, 0.3 - radius, 0.0)).norm() == Approx(radius).epsilon(1e-7));
    CHECK(at.x() < 1.0);
}

}  // namespace gxrod::test
