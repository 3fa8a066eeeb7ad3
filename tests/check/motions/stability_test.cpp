#include "check/motions/stability.hpp"

#include <cmath>
#include <numbers>

#include "analyses/static.hpp"
#include "deck/decks.hpp"
#include "tools/catch.hpp"
#include "tools/rod_models.hpp"
#include "tools/static_run.hpp"

using namespace gxrod;
using namespace gxrod::tools;
using Catch::Contains;

namespace {

constexpr double length = 10.0;
constexpr double soft = 500.0;    // EIz
constexpr double stiff = 4000.0;  // EIy
constexpr double euler = std::numbers::pi * std::numbers::pi * soft / (4.0 * length * length);

// A force that grows from nothing, and no moment.
void push(Model& model, int node, const Vec3& force, Frame frame = Frame::spatial) {
    NodalLoad load;
    load.key = "load[0]";
    load.node = node;
    load.frame = frame;
    for (int i = 0; i < 3; ++i) load.force[i] = force[i] == 0.0 ? TimeFunction() : ramp(force[i]);
    model.loads.push_back(load);
}

// Clamped at its start, with hardly any extension and shear; a dead load pushes its end by `factor` times the
// first Euler load, and one sideways along y by `side` of it.
Model make_column(double factor, double side, const Mesh& mesh = {20, 2}) {
    Model model = make_rod_model(along_x, length, mesh, make_section({1e7, 1e7, 1e7, 2000.0, stiff, soft}));
    clamp(model, 0);
    push(model, last_node(model), {-factor * euler, side * euler, 0.0});
    return model;
}

struct WatchedRun {
    std::vector<std::string> warnings;
    std::vector<std::int64_t> pivots;  // of each step
    std::vector<double> times;
    State state;
    bool is_unstable = false;
    long rejected_steps = 0;

    // The load factor at which the count first came to this.
    double first_with(std::int64_t count) const {
        for (std::size_t i = 0; i < pivots.size(); ++i) {
            if (pivots[i] >= count) return times[i];
        }
        return 0.0;
    }
};

WatchedRun watch(const Model& model, const StaticSettings& settings) {
    StaticAnalysis analysis(model, settings);
    WatchedRun watched;
    REQUIRE(analysis.start().converged());
    while (!analysis.finished()) {
        const EquilibriumReport report = analysis.advance();
        if (!report.converged()) FAIL(describe_failure(analysis.explain(report)));
        watched.pivots.push_back(analysis.solver_row().negative_pivots);
        watched.rejected_steps += analysis.solver_row().rejected_steps;
        watched.times.push_back(analysis.state().time);
    }
    watched.warnings = analysis.list_warnings();
    watched.is_unstable = analysis.is_unstable();
    watched.state = analysis.state();
    return watched;
}

// A clamped column of length 1, whose end moves along itself and across one plane alone, between two short
// clamped rods that cross it on both sides of this plane at 0.98, with a gap of half the skin.
constexpr double flexural = 1e9 * std::numbers::pi * 1e-8 / 4.0;

Model make_held_column(double push, double apart, const std::string& more = "") {
    const auto across = [](const std::string& name, double y) {
        const std::string at = "0.98, " + std::to_string(y) + ", ";
        return "[rod." + name + "]\nsection = \"s\"\nline = { from = [" + at + "-0.1], to = [" + at +
               "0.1] }\nelements = 4\norder = 2\n[[support]]\nat = \"" + name +
               ".start\"\nfix = \"all\"\n[[support]]\nat = \"" + name + ".end\"\nfix = \"all\"\n";
    };
    return test::read(
               "[section.s]\nshape = { circle = { radius = 0.01 } }\n"
               "material = { E = 1e9, nu = 0.3, density = 1000 }\n[rod.column]\nsection = \"s\"\n"
               "line = { from = [0, 0, 0], to = [1, 0, 0] }\nelements = 20\norder = 2\n"
               "[[support]]\nat = \"column.start\"\nfix = \"all\"\n"
               "[[support]]\nat = \"column.end\"\nfix = [\"z\"]\n"
               "[[load]]\nat = \"column.end\"\nforce = [" +
               std::to_string(-push) + ", 0, 0]\n" + across("left", 0.0201 + apart) +
               across("right", -0.0201 - apart) + "[contact]\n" + more +
               "[analysis]\nkind = \"static\"\nsteps = 10\n")
        .model;
}

StaticSettings settings_of(LinearSolverKind solver) {
    StaticSettings settings = make_static_settings(10, 1e-10);
    settings.linear_solver = solver;
    return settings;
}

// Of "between t = 0.3 and 0.4 …" the 0.4.
double end_of_change(const std::string& warning) {
    const std::string word = " and ";
    const std::size_t place = warning.find(word);
    REQUIRE(place != std::string::npos);
    return std::stod(warning.substr(place + word.size()));
}

}  // namespace

TEST_CASE("a straight column loses stability at each Euler load", "[check]") {
    // In units of the first one: 1 and 9 about z, 8 about y, where it is eight times as stiff.
    for (const LinearSolverKind solver : {LinearSolverKind::automatic, LinearSolverKind::klu}) {
        for (const ElementKind kind : {ElementKind::objective, ElementKind::simo}) {
            CAPTURE(static_cast<int>(solver), static_cast<int>(kind));
            const WatchedRun run = watch(make_column(9.5, 0.0, {20, 2, kind}), settings_of(solver));
            CHECK(run.first_with(1) * 9.5 == Approx(1.0).margin(9.5 / 2560.0 + 1e-3));
            CHECK(run.first_with(2) * 9.5 == Approx(8.0).margin(9.5 / 2560.0 + 8e-3));
            CHECK(run.first_with(3) * 9.5 == Approx(9.0).margin(9.5 / 2560.0 + 9e-3));
            CHECK(run.pivots.back() == 3);
            CHECK(run.is_unstable);
            REQUIRE(run.warnings.size() == 4);
            CHECK_THAT(run.warnings[0], Contains("became unstable (the tangent has 1 negative pivot)"));
            CHECK_THAT(run.warnings[0], Contains("bending about z"));
            CHECK_THAT(run.warnings[1], Contains("became more unstable (the tangent has 2 negative pivots)"));
            CHECK_THAT(run.warnings[1], Contains("bending about y"));
            CHECK_THAT(run.warnings[2], Contains("bending about z"));
            CHECK_THAT(run.warnings[3], Contains("the state at t = 1 is unstable (3 negative pivots)"));
        }
    }
}

TEST_CASE("below its Euler load a column is stable", "[check]") {
    const WatchedRun run = watch(make_column(0.99, 0.0), make_static_settings(10, 1e-10));
    CHECK(run.warnings.empty());
    CHECK_FALSE(run.is_unstable);
    CHECK(run.rejected_steps == 0);
    CHECK(run.pivots == std::vector<std::int64_t>(10, 0));
}

TEST_CASE("with a little load sideways a column goes where the elastica is", "[check]") {
    // P = 1.5 P_E: K(k) = √1.5 π/2, the end moves sideways by 2 k L / K (Timoshenko & Gere 1961, 2.7).
    const double K = std::sqrt(1.5) * std::numbers::pi / 2.0;
    double low = 0.0, high = 1.0;
    while (high - low > 1e-14) (std::comp_ellint_1(0.5 * (low + high)) < K ? low : high) = 0.5 * (low + high);
    const double sideways = 2.0 * low * length / K;
    for (const long steps : {5, 10, 50}) {
        for (const double side : {1e-4, -1e-4}) {
            CAPTURE(steps, side);
            const WatchedRun run = watch(make_column(1.5, side), make_static_settings(steps, 1e-10));
            CHECK(run.warnings.empty());
            CHECK_FALSE(run.is_unstable);
            CHECK(run.state.trial.back().r.y() == Approx(side > 0.0 ? sideways : -sideways).epsilon(1e-3));
        }
    }
}

TEST_CASE("with a load that follows only divergence is reported", "[check]") {
    // Hinged at both ends and pushed along its axis there (Pflüger's column): it diverges at π² EI / L², four
    // times the load of the clamped column.
    Model model =
        make_rod_model(along_x, length, {20, 2}, make_section({1e7, 1e7, 1e7, 2000.0, stiff, soft}));
    Support start, end;
    start.fixed = {true, true, true, true, true, false};
    end.node = last_node(model);
    end.fixed = {false, true, true, true, true, false};
    model.supports = {start, end};
    push(model, end.node, {-6.0 * euler, 0.0, 0.0}, Frame::follower);
    CHECK(find_load_without_potential(model) == "load[0] follows its point");
    const WatchedRun run = watch(model, make_static_settings(10, 1e-10));
    CHECK(run.is_unstable);
    REQUIRE(run.warnings.size() == 1);
    CHECK_THAT(run.warnings[0], Contains("the determinant of the tangent became negative"));
    CHECK(end_of_change(run.warnings[0]) * 6.0 == Approx(4.0).margin(6.0 / 2560.0 + 4e-3));
    // They count no unstable shapes.
    CHECK(run.pivots == std::vector<std::int64_t>(run.pivots.size(), -1));
}

TEST_CASE("loads without potential are those that turn, and moments that do not", "[check]") {
    Model model = make_column(1.0, 0.0);
    CHECK(find_load_without_potential(model).empty());
    model.loads.back().moment[2] = 1.0;
    CHECK_THAT(find_load_without_potential(model), Contains("load[0] is a moment"));
    Support hinge;
    hinge.node = last_node(model);
    hinge.fixed = {false, false, true, true, true, false};
    model.supports.push_back(hinge);
    CHECK(find_load_without_potential(model).empty());
    DistributedLoad along;
    along.key = "load[1]";
    along.frame = Frame::body;
    model.distributed_loads.push_back(along);
    CHECK(find_load_without_potential(model).empty());
    model.distributed_loads.back().force[1] = LineFunction(1.0);
    CHECK(find_load_without_potential(model) == "load[1] follows its rod");
}

TEST_CASE("where round-off hides what bends, no pivots are counted", "[check]") {
    // Of a string that hangs, EI is so small that the pivots of bending are below the round-off of EA.
    Model model = make_rod_model(along_x, length, {50, 1}, make_section({1e8, 1e8, 1e8, 1e-4, 1e-4, 1e-4}));
    clamp(model, 0);
    Support end;
    end.node = last_node(model);
    end.fixed = {true, true, true, false, false, false};
    model.supports.push_back(end);
    for (int node = 1; node < end.node; ++node) push(model, node, {0.0, 0.0, -10.0});
    const WatchedRun run = watch(model, make_static_settings(10, 1e-8));
    CHECK(run.warnings == std::vector<std::string>{});
    CHECK(run.pivots == std::vector<std::int64_t>(run.pivots.size(), -1));
}

TEST_CASE("what rods hold by contact is as stable as with a support", "[check][touch]") {
    const double free = std::numbers::pi * std::numbers::pi * flexural / 4.0;
    const double pinned = 20.190729 * flexural;  // tan √(P/EI) = √(P/EI): clamped, and held across at the end
    for (const LinearSolverKind solver : {LinearSolverKind::automatic, LinearSolverKind::klu}) {
        CAPTURE(static_cast<int>(solver));
        StaticSettings settings = make_static_settings(100, 1e-10);
        settings.linear_solver = solver;
        const WatchedRun alone = watch(make_held_column(2.0 * free, 0.1), settings);
        CHECK(alone.first_with(1) * 2.0 == Approx(1.01).margin(0.01 + 3e-3));
        CHECK_THAT(alone.warnings.at(0), Contains("rod column, column.end: bending about z"));

        const WatchedRun stable = watch(make_held_column(0.97 * pinned, 0.0), settings);
        CHECK(stable.warnings.empty());
        CHECK(stable.pivots == std::vector<std::int64_t>(100, 0));

        // By contact about z, a fiftieth from the end, and by the support about y.
        const WatchedRun held = watch(make_held_column(1.2 * pinned, 0.0), settings);
        CHECK(held.first_with(1) * 1.2 == Approx(1.006).margin(0.006 + 0.02));
        CHECK(held.pivots.back() == 2);
        CHECK_THAT(held.warnings.at(0), Contains("became unstable (the tangent has 1 negative pivot)"));
        CHECK_THAT(held.warnings.back(), Contains("leaves it at a touch. A small side load"));
    }
}

TEST_CASE("contact has a potential unless it rubs", "[check][touch]") {
    CHECK(find_load_without_potential(make_held_column(1.0, 0.0)).empty());
    CHECK(find_load_without_potential(make_held_column(1.0, 0.0, "friction = 0.1\n")) == "contact rubs");
    const std::string smooth = "[[contact.pair]]\nbetween = [\"column\", \"left\"]\nfriction = ";
    CHECK(find_load_without_potential(make_held_column(1.0, 0.0, smooth + "0.1\n")) == "contact rubs");
    CHECK(find_load_without_potential(make_held_column(1.0, 0.0, smooth + "0\n")).empty());
}

TEST_CASE("with friction of contact only divergence is reported", "[check][touch]") {
    const double free = std::numbers::pi * std::numbers::pi * flexural / 4.0;
    const WatchedRun run =
        watch(make_held_column(2.0 * free, 0.1, "friction = 0.1\n"), make_static_settings(100, 1e-10));
    REQUIRE(run.warnings.size() == 1);
    CHECK(end_of_change(run.warnings[0]) * 2.0 == Approx(1.01).margin(0.01 + 3e-3));
    CHECK_THAT(run.warnings[0], Contains("the determinant of the tangent became negative"));
    CHECK_THAT(run.warnings[0], !Contains("eigenvalues"));
}
