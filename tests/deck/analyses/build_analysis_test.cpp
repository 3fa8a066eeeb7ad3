
#include "deck/decks.hpp"

#include "model/settings/analysis_traits.hpp"
#include "tools/catch.hpp"

namespace gxrod::test {

TEST_CASE("A time step that makes too many steps is an error", "[deck]") {
    CHECK(faults_of(replaced(body_deck, "steps = 10", "time_step = 1e-300")) ==
          "x.toml:7:13: analysis.time_step: 1e+300 steps are too many; expected at most 1000000000000");
}

TEST_CASE("The paper's tangent is for bodies under newmark-simplified", "[deck]") {
    CHECK(
        faults_of(body_deck + R"(integrator = "newmark-ibrahimbegovic"
newton = { tangent = "paper" })") ==
        R"(x.toml:9:22: analysis.newton.tangent: "paper" belongs to integrator "newmark-simplified", not to "newmark-ibrahimbegovic")");
    CHECK(
        faults_of(rod_deck + R"(newton = { tangent = "paper" })") ==
        R"(x.toml:13:22: analysis.newton.tangent: "paper" is for decks of bodies alone; this one has rods)");
    CHECK(
        faults_of(rod_deck + R"(integrator = "sdirk-4"
newton = { tangent = "paper" })") ==
        R"(x.toml:14:22: analysis.newton.tangent: "paper" belongs to integrator "newmark-simplified", not to "sdirk-4"
x.toml:14:22: analysis.newton.tangent: "paper" is for decks of bodies alone; this one has rods)");
}

TEST_CASE("The paper's tangent is not for static analyses", "[deck]") {
    CHECK(
        faults_of(replaced(static_rod_deck, "kind", "newton = { tangent = \"paper\" }\nkind")) ==
        R"(x.toml:10:22: analysis.newton.tangent: "paper" belongs to integrator "newmark-simplified", not to static analyses
x.toml:10:22: analysis.newton.tangent: "paper" is for decks of bodies alone; this one has rods)");
}

TEST_CASE("A kept tangent is for motions", "[deck]") {
    const auto tangent = [](const std::string& deck) {
        return std::get<DynamicSettings>(read(deck).analysis()).newton.tangent;
    };
    CHECK(tangent(body_deck + "newton = { tangent = \"kept\" }") == TangentKind::kept);
    CHECK(tangent(replaced(rod_deck, "kind = \"dynamic\"", "kind = \"quasi-static\"") +
                  "newton.tangent = \"kept\"\n") == TangentKind::kept);
    CHECK(
        faults_of(replaced(static_rod_deck, "kind", "newton = { tangent = \"kept\" }\nkind")) ==
        R"(x.toml:10:22: analysis.newton.tangent: "kept" is for motions in time, not for static analyses; expected "automatic")");
    CHECK(
        faults_of(replaced(static_rod_deck,
                           "kind = \"static\"",
                           "newton = { tangent = \"kept\" }\nkind = \"path\"\nuntil = { t = 1 }")) ==
        R"(x.toml:10:22: analysis.newton.tangent: "kept" is for motions in time, not for paths; expected "automatic")");
    CHECK(
        faults_of(body_deck + "integrator = \"gauss-4\"\nnewton = { tangent = \"kept\" }") ==
        R"(x.toml:9:22: analysis.newton.tangent: "gauss-4" finds the stages of a step together and has a tangent of its own; expected "automatic")");
}

TEST_CASE("A static analysis has steps of the load factor", "[deck]") {
    const auto settings = [](const std::string& lines) {
        return std::get<StaticSettings>(read(static_rod_deck + lines).analysis());
    };
    CHECK(settings("").steps == 10);
    CHECK_FALSE(settings("").newton.tolerance);
    CHECK(settings("").newton.tangent == TangentKind::automatic);
    CHECK(settings("newton = { tolerance = 1e-5 }\n").newton.tangent == TangentKind::automatic);
    CHECK_FALSE(settings("newton = { max_iterations = 5 }\n").newton.tolerance);
    CHECK(settings("newton = { tangent = \"consistent\" }\n").newton.tangent == TangentKind::consistent);
    const StaticSettings given = settings(
        "steps = 7\nnewton = { tolerance = 1e-5, max_iterations = 8, tangent = \"difference\" }\n"
        "linear_solver = \"klu\"\n");
    CHECK(given.steps == 7);
    CHECK(given.newton.tolerance == 1e-5);
    CHECK(given.newton.max_iterations == 8);
    CHECK(given.newton.tangent == TangentKind::difference);
    CHECK(given.linear_solver == LinearSolverKind::klu);
}

TEST_CASE("A time step that divides the time makes that many steps, another one shorter steps", "[deck]") {
    const auto problem = [](const std::string& end_time, const std::string& time_step) {
        return read(replaced(replaced(body_deck, "end_time = 1.0", "end_time = " + end_time),
                             "steps = 10",
                             "time_step = " + time_step));
    };
    CHECK(dynamic_of(problem("1.0", "0.1")).steps == 10);
    CHECK(dynamic_of(problem("0.3", "0.1")).steps == 3);
    CHECK(dynamic_of(problem("2.0", "1e-4")).steps == 20000);
    CHECK(dynamic_of(problem("\"2*pi\"", "\"2*pi/400\"")).steps == 400);
    CHECK(problem("1.0", "0.1").notes.empty());
    CHECK(dynamic_of(problem("1.0", "0.3")).steps == 4);
    CHECK(problem("1.0", "0.3").notes ==
          std::vector<std::string>{"analysis.time_step: 0.3 does not divide 1; 4 steps of 0.25 are taken"});
    CHECK(dynamic_of(problem("1.0", "3.0")).steps == 1);
    CHECK(dynamic_of(problem("1.0", "0.100001")).steps == 10);
    CHECK(dynamic_of(problem("1.0", "0.099999")).steps == 11);
}

TEST_CASE("Every integrator, tangent and solver has its word", "[deck]") {
    const auto analysis = [](const std::string& line) { return dynamic_of(read(body_deck + line)); };
    CHECK(analysis("").scheme == Scheme::newmark_simplified);
    CHECK(analysis("integrator = \"newmark-simplified\"").scheme == Scheme::newmark_simplified);
    CHECK(analysis("integrator = \"newmark-ibrahimbegovic\"").scheme == Scheme::newmark_ibrahimbegovic);
    CHECK(analysis("integrator = \"generalized-alpha\"").scheme == Scheme::generalized_alpha);
    CHECK(analysis("integrator = \"sdirk-4\"").scheme == Scheme::sdirk_4);
    CHECK(analysis("integrator = \"runge-kutta-4\"").scheme == Scheme::runge_kutta_4);
    CHECK(dynamic_of(read(rod_deck + "integrator = \"energy-momentum\"")).scheme == Scheme::energy_momentum);
    CHECK(analysis("").newton.tangent == TangentKind::automatic);
    CHECK(analysis("newton.tangent = \"automatic\"").newton.tangent == TangentKind::automatic);
    CHECK(analysis("newton.tangent = \"mixed\"").newton.tangent == TangentKind::mixed);
    CHECK(analysis("newton.tangent = \"consistent\"").newton.tangent == TangentKind::consistent);
    CHECK(analysis("newton.tangent = \"difference\"").newton.tangent == TangentKind::difference);
    CHECK(analysis("linear_solver = \"auto\"").linear_solver == LinearSolverKind::automatic);
    CHECK(analysis("linear_solver = \"klu\"").linear_solver == LinearSolverKind::klu);
    CHECK(analysis("linear_solver = \"umfpack\"").linear_solver == LinearSolverKind::umfpack);
}

TEST_CASE("Steps by their error are for schemes that estimate it", "[deck]") {
    CHECK(
        faults_of(body_deck + "integrator = \"gauss-4\"\nadaptive = {}") ==
        R"(x.toml:9:1: analysis.adaptive: integrator "gauss-4" does not use this key; it is for newmark-simplified, newmark-ibrahimbegovic, generalized-alpha, sdirk-4, radau-5, energy-momentum, auto)");
    CHECK_FALSE(dynamic_of(read(body_deck + "integrator = \"sdirk-4\"")).adaptive);
    const auto adaptive = dynamic_of(read(body_deck + "integrator = \"sdirk-4\"\nadaptive = {}")).adaptive;
    REQUIRE(adaptive);
    CHECK(adaptive->tolerance == 1e-4);
    CHECK(adaptive->min_step == 0.0);
    CHECK(std::isinf(adaptive->max_step));
}

TEST_CASE("An accuracy chooses radau-5 and its steps", "[deck]") {
    const std::string deck = replaced(body_deck, "steps = 10", "accuracy = 1e-3");
    const DynamicSettings settings = dynamic_of(read(deck));
    CHECK(settings.scheme == Scheme::radau_5);
    REQUIRE(settings.adaptive);
    CHECK(settings.adaptive->tolerance == Approx(1e-5).epsilon(1e-14));
    CHECK(settings.time_step() == Approx(1e-4 * settings.end_time).epsilon(1e-14));
    CHECK(dynamic_of(read(deck + "integrator = \"sdirk-4\"")).scheme == Scheme::sdirk_4);
    CHECK(
        faults_of(deck + "beta = 0.3") ==
        R"(x.toml:8:8: analysis.beta: accuracy without an integrator takes "radau-5", which does not use this key; give the integrator)");
    CHECK(faults_of(deck + "adaptive = { tolerance = 1e-4 }") ==
          "x.toml:7:1: analysis.accuracy: adaptive is given too; only one of them can be");
    CHECK(faults_of(body_deck + "accuracy = 1e-3") ==
          "x.toml:8:1: analysis.accuracy: steps is given too; only one of them can be");
}

TEST_CASE("An integrator that is left open is chosen once the model is known", "[deck]") {
    const Problem problem = read(body_deck + "integrator = \"auto\"");
    CHECK(dynamic_of(problem).scheme == Scheme::radau_5);
    CHECK(dynamic_of(problem).chosen_for == "for bodies");
    CHECK(problem.record.integrators == "radau-5");
    CHECK(dynamic_of(read(body_deck)).chosen_for.empty());
    CHECK(read(body_deck).record.integrators == "newmark-simplified");
    CHECK(
        read(static_rod_deck + "[[support]]\nat = \"r.start\"\nfix = \"all\"\n").record.integrators.empty());
    const std::string accurate = replaced(body_deck, "steps = 10", "accuracy = 0.05\nintegrator = \"auto\"");
    CHECK(dynamic_of(read(accurate)).scheme == Scheme::radau_5);
    CHECK(dynamic_of(read(accurate)).adaptive->tolerance == Approx(5e-4).epsilon(1e-14));
    const std::string seabed = "[seabed]\nz = -1\nstiffness = 1e3\n";
    const std::string lying = replaced(rod_deck, "[rod.r]", "fluid = { outer_diameter = 0.1 }\n[rod.r]") +
                              "integrator = \"auto\"\n" + seabed;
    CHECK(dynamic_of(read(lying)).scheme == Scheme::generalized_alpha);
    CHECK(dynamic_of(read(replaced(lying, "steps = 10", "accuracy = 1e-4"))).scheme == Scheme::radau_5);
    CHECK_NOTHROW(read(body_deck + "integrator = \"auto\"\nadaptive = {}\nnewton = { tolerance = 1e-9 }"));
    CHECK(faults_of(body_deck + "integrator = \"auto\"\nnewton = { tangent = \"mixed\" }") ==
          R"(x.toml:9:22: analysis.newton.tangent: "auto" chooses the tangent, too; expected "automatic")");
    CHECK(
        faults_of(body_deck + "integrator = \"auto\"\nspectral_radius = 0.5") ==
        R"(x.toml:9:1: analysis.spectral_radius: integrator "auto" does not use this key; it is for generalized-alpha)");
}

TEST_CASE("Each stage has the integrator that suits it", "[deck]") {
    const std::string stages = R"([[stage]]
name = "rest"
kind = "static"
[[stage]]
name = "move"
kind = "dynamic"
end_time = 1.0
steps = 10
integrator = "auto"
[[stage]]
name = "ring"
kind = "dynamic"
end_time = 1.0
steps = 10
integrator = "sdirk-4"
[[support]]
at = "r.start"
fix = "all"
)";
    const Problem problem = read(rod_deck.substr(0, rod_deck.find("[analysis]")) + stages);
    CHECK(problem.record.integrators == "move: radau-5, ring: sdirk-4");
    CHECK(!std::get<DynamicSettings>(problem.stages[1].analysis).chosen_for.empty());
}

TEST_CASE("Schemes whose stages are found together have a tangent of their own", "[deck]") {
    CHECK(
        faults_of(body_deck + "integrator = \"radau-5\"\nnewton = { tangent = \"mixed\" }") ==
        R"(x.toml:9:22: analysis.newton.tangent: "radau-5" finds the stages of a step together and has a tangent of its own; expected "automatic")");
}

TEST_CASE("A shortest step is not above the longest", "[deck]") {
    CHECK(faults_of(body_deck + R"(integrator = "sdirk-4"
adaptive = { min_step = 0.1, max_step = 0.01 })") ==
          "x.toml:9:41: analysis.adaptive.max_step: expected a number not below min_step, 0.1; found 0.01");
}

TEST_CASE("A first step outside the limits is noted", "[deck]") {
    const auto notes = [](const std::string& step, const std::string& adaptive) {
        return read(replaced(body_deck, "steps = 10", step) +
                    "integrator = \"sdirk-4\"\nadaptive = " + adaptive)
            .notes;
    };
    CHECK(notes("steps = 10", "{ min_step = 0.1, max_step = 0.1 }").empty());
    CHECK(notes("time_step = 0.3", "{}").empty());
    CHECK(notes("steps = 10", "{ min_step = 0.2 }") ==
          std::vector<std::string>{
              "analysis.steps: the first step, 0.1, is below adaptive.min_step; it will be 0.2"});
    CHECK(notes("time_step = 0.25", "{ max_step = 0.02 }") ==
          std::vector<std::string>{
              "analysis.time_step: the first step, 0.25, is above adaptive.max_step; it will be 0.02"});
}

TEST_CASE("A quasi-static analysis has time and no inertia", "[deck]") {
    const std::string deck = replaced(static_rod_deck, "\"static\"", "\"quasi-static\"") +
                             "end_time = 2.0\nsteps = 4\nadaptive = { tolerance = 1e-6 }\n"
                             "[[load]]\nat = \"r.end\"\nforce = [0, 3, 0]\n";
    const Problem problem =
        read(replaced(deck, "inertia = { rhoA = 1.0, rhoJ = 20, rhoIy = 10, rhoIz = 11 }\n", ""));
    const DynamicSettings settings = dynamic_of(problem);
    CHECK_FALSE(settings.has_inertia);
    CHECK_FALSE(problem.model.has_inertia);
    CHECK(settings.scheme == Scheme::sdirk_4);
    CHECK(settings.time_step() == 0.5);
    CHECK(settings.adaptive->tolerance == 1e-6);
    // A load is as it is written.
    CHECK(problem.model.loads[0].force[1](0.1) == 3.0);
    CHECK(std::string(kind_of(problem.analysis())) == "quasi-static");
    CHECK(read(deck + "[[initial]]\non = \"r\"\nvelocity = [1, 0, 0]\n")
              .notes.back()
              .find("initial[0]: without effect") == 0);
}

TEST_CASE("A response needs a history to be recorded in", "[deck]") {
    const std::string deck = replaced(static_rod_deck, "\"static\"", "\"response\"") +
                             "omega = { values = [1] }\nexcite = [{ at = \"r.end\", force = [1, 0, 0] }]\n";
    CHECK(faults_of(deck) ==
          "x.toml:10:8: analysis.kind: a response is recorded where [[history]] names a node; the deck has "
          "no such "
          "history");
}

}  // namespace gxrod::test
