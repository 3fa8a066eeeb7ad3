#include "deck/problem.hpp"

#include <unistd.h>

#include <cmath>
#include <filesystem>
#include <fstream>
#include <random>
#include <sstream>

#include "deck/decks.hpp"
#include "deck/text/fault.hpp"
#include "machine/file_error.hpp"
#include "tools/catch.hpp"

namespace gxrod::test {
namespace {

const std::string flyer = R"deck(title = "Flexible rod in free flight"
units = "m kg s"
gravity = [0, 0, -9.81]               # top-level keys stand before the first [table]

[parameters]
EI = 500.0

[section.tube]
stiffness = { EA = 1e4, GAy = 1e4, GAz = 1e4, GJ = "EI", EIy = "EI", EIz = "EI" }
inertia   = { rhoA = 1.0, rhoJ = 20.0, rhoIy = 10.0, rhoIz = 10.0 }

[rod.flyer]
section  = "tube"
line     = { from = [6, 0, 0], to = [0, 8, 0] }
elements = 10
order    = 1
element  = "simo"
y_axis   = [0, 0, 1]

[body.gyroscope]
mass     = 1.0
inertia  = [1.0, 1.0, 0.75]
at       = "flyer.end"
rotation_vector  = [0, "pi/3", 0]
velocity = [0, 0, 1]
angular_velocity_material = [0, 0, 2]

[function.pulse]
table = [[0, 0], [2.5, 200], [5, 0]]

[[load]]
at     = "flyer.start"
force  = ["pulse(t)/10", 0, 0]
moment = [0, "-pulse(t)/2", "-pulse(t)"]
frame  = "body"

[[load]]
at     = "gyroscope"
force  = [0, 0, 1]
frame  = "body"

[analysis]
kind       = "dynamic"
end_time   = 15.0
time_step  = 0.01
integrator = "newmark-simplified"
beta = 0.25
newton     = { tolerance = 1e-8, max_iterations = 20, tangent = "consistent" }
linear_solver = "auto"

[output]
every  = 10
[[history]]
name = "tip"
at   = "flyer.end"
quantities = ["position", "velocity", "strain"]
[[history]]
name = "gyroscope"
at   = "gyroscope"
quantities = ["centre_of_mass"]
)deck";

const std::string heavy_top = R"(title = "Heavy top"
gravity = [0, 0, -9.81]
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
time_step = 1e-4
[[history]]
name = "top"
at = "top"
quantities = ["centre_of_mass", "quaternion", "reaction_force"]
)";

bool are_same(const TimeFunction& a, const TimeFunction& b) {
    for (int i = 0; i <= 150; ++i) {
        if (a(0.1 * i) != b(0.1 * i)) return false;
    }
    return a.is_constant() == b.is_constant();
}

bool are_same(const Quat& a, const Quat& b) { return a.coeffs() == b.coeffs(); }

void check_same_nodes(const Model& a, const Model& b) {
    REQUIRE(a.nodes.size() == b.nodes.size());
    for (std::size_t i = 0; i < a.nodes.size(); ++i) {
        CHECK(a.nodes[i].name == b.nodes[i].name);
        CHECK(a.nodes[i].position == b.nodes[i].position);
        CHECK(a.nodes[i].velocity == b.nodes[i].velocity);
        CHECK(a.nodes[i].angular_velocity == b.nodes[i].angular_velocity);
    }
}

void check_same_parts(const Model& a, const Model& b) {
    REQUIRE(a.rods.size() == b.rods.size());
    for (std::size_t i = 0; i < a.rods.size(); ++i) {
        CHECK(a.rods[i].name == b.rods[i].name);
        CHECK(a.rods[i].nodes == b.rods[i].nodes);
        CHECK(a.rods[i].arc_length == b.rods[i].arc_length);
        CHECK(are_same(a.rods[i].triads.front(), b.rods[i].triads.front()));
        CHECK(a.sections[a.rods[i].section].stiffness == b.sections[b.rods[i].section].stiffness);
        CHECK(a.sections[a.rods[i].section].mass == b.sections[b.rods[i].section].mass);
    }
    REQUIRE(a.bodies.size() == b.bodies.size());
    for (std::size_t i = 0; i < a.bodies.size(); ++i) {
        CHECK(a.bodies[i].name == b.bodies[i].name);
        CHECK(a.bodies[i].node == b.bodies[i].node);
        CHECK(a.bodies[i].mass == b.bodies[i].mass);
        CHECK(a.bodies[i].inertia == b.bodies[i].inertia);
        CHECK(a.bodies[i].centre_of_mass == b.bodies[i].centre_of_mass);
        CHECK(are_same(a.bodies[i].attitude, b.bodies[i].attitude));
    }
}

void check_same_loads(const Model& a, const Model& b) {
    CHECK(a.gravity(0.5) == b.gravity(0.5));
    REQUIRE(a.loads.size() == b.loads.size());
    for (std::size_t i = 0; i < a.loads.size(); ++i) {
        CHECK(a.loads[i].key == b.loads[i].key);
        CHECK(a.loads[i].node == b.loads[i].node);
        CHECK(a.loads[i].frame == b.loads[i].frame);
        for (int j = 0; j < 3; ++j) {
            CHECK(are_same(a.loads[i].force[j], b.loads[i].force[j]));
            CHECK(are_same(a.loads[i].moment[j], b.loads[i].moment[j]));
        }
    }
}

void check_same(const Problem& a, const Problem& b) {
    check_same_nodes(a.model, b.model);
    check_same_parts(a.model, b.model);
    check_same_loads(a.model, b.model);
    CHECK(dynamic_of(a).end_time == dynamic_of(b).end_time);
    CHECK(dynamic_of(a).steps == dynamic_of(b).steps);
    CHECK(dynamic_of(a).scheme == dynamic_of(b).scheme);
    CHECK(dynamic_of(a).newton.tolerance == dynamic_of(b).newton.tolerance);
    CHECK(a.output.every == b.output.every);
    CHECK(a.output.histories.size() == b.output.histories.size());
    CHECK(a.record.title == b.record.title);
    CHECK(a.record.units == b.record.units);
}

}  // namespace

TEST_CASE("The free-flight deck becomes its model", "[deck]") {
    const Problem problem = read_problem_text(flyer, "decks/flyer.toml");
    const Model& model = problem.model;
    CHECK(problem.record.name == "flyer.toml");
    CHECK(problem.record.text == flyer);
    CHECK(problem.notes.empty());
    REQUIRE(model.nodes.size() == 11);
    CHECK(model.nodes[0].name == "flyer.start");
    CHECK(model.nodes[4].name == "flyer node 4");
    CHECK(model.nodes[10].name == "flyer.end");
    CHECK(model.nodes[10].position == Vec3(0, 8, 0));
    CHECK((model.nodes[4].position - Vec3(3.6, 3.2, 0)).norm() < 1e-15);

    const Rod& rod = model.rods[0];
    CHECK(rod.arc_length.back() == 10.0);
    CHECK(rod.length == 10.0);
    CHECK(rod.arc_length[8] == Approx(4.0));
    for (const Quat& triad : rod.triads) {
        CHECK((triad * Vec3::UnitX()).isApprox(Vec3(-0.6, 0.8, 0), 1e-15));
        CHECK((triad * Vec3::UnitY()).isApprox(Vec3::UnitZ(), 1e-15));
        CHECK((triad * Vec3::UnitZ()).isApprox(Vec3(0.8, 0.6, 0), 1e-15));
    }
    const Body& body = model.bodies[0];
    CHECK(body.node == 10);
    CHECK(model.nodes[10].velocity == Vec3(0, 0, 1));
    CHECK(model.nodes[10].angular_velocity.isApprox(2.0 * Vec3(std::sin(std::acos(0.5)), 0, 0.5), 1e-15));

    CHECK(model.loads[0].key == "load[0]");
    CHECK(model.loads[0].node == 0);
    CHECK(model.loads[0].force[0](2.5) == 20.0);
    CHECK(model.loads[0].moment[1](1.25) == -50.0);
    CHECK(model.loads[0].force[1].is_zero());
    CHECK(model.loads[0].axes.coeffs() == rod.triads[0].coeffs());
    CHECK(model.loads[1].node == 10);
    CHECK(model.loads[1].axes.coeffs() == body.attitude.coeffs());
}

TEST_CASE("The free-flight deck becomes its analysis and output", "[deck]") {
    const Problem problem = read_problem_text(flyer, "flyer.toml");
    CHECK(dynamic_of(problem).steps == 1500);
    CHECK(dynamic_of(problem).scheme == Scheme::newmark_simplified);
    CHECK(problem.output.every == 10);
    const HistoryRequest& tip = problem.output.histories[0];
    CHECK(tip.at == "flyer.end");
    const auto& end = std::get<WatchedPoint>(tip.target);
    CHECK((end.node == 10 && end.place.rod == 0 && end.place.element == 9));
    const HistoryRequest& gyroscope = problem.output.histories[1];
    const auto& body = std::get<WatchedBody>(gyroscope.target);
    CHECK((body.node == 10 && body.index == 0));
}

TEST_CASE("The heavy top becomes a body with a pivot", "[deck]") {
    const Problem problem = read(heavy_top);
    REQUIRE(problem.model.nodes.size() == 1);
    CHECK(problem.model.nodes[0].name == "top");
    CHECK(problem.model.nodes[0].angular_velocity == Vec3(0, 150, -4.61538));
    CHECK(problem.model.bodies[0].centre_of_mass == Vec3(0, 1, 0));
    REQUIRE(problem.model.supports.size() == 1);
    CHECK(problem.model.supports[0].fixed == std::array{true, true, true, false, false, false});
    CHECK(dynamic_of(problem).steps == 20000);
    CHECK(dynamic_of(problem).newton.tolerance == NewtonSettings{}.tolerance);
    CHECK(dynamic_of(problem).newton.max_iterations == NewtonSettings{}.max_iterations);
    CHECK(problem.output.every == 50);  // of so many steps
}

TEST_CASE("The order of a model is the order of its deck", "[deck]") {
    const std::string rod =
        "section = \"s\"\nline = { from = [0, 0, 0], to = [1, 0, 0] }\nelements = 1\nelement = \"simo\"\n";
    const Problem problem = read(rod_deck + "[rod.b]\n" + rod + "[rod.a]\n" + rod);
    REQUIRE(problem.model.rods.size() == 3);
    CHECK(problem.model.rods[0].name == "r");
    CHECK(problem.model.rods[1].name == "b");
    CHECK(problem.model.rods[2].name == "a");
    CHECK(problem.model.nodes[11].name == "b.start");
}

TEST_CASE("The deck as run reads as the same problem", "[deck]") {
    const std::vector<std::vector<std::string>> sets{
        {"analysis.integrator=sdirk-4", "load[0].force[2]=0.1*pulse(t)", "rod.flyer.elements=7"},
        {"title=Say \"a\\b\"", "analysis.steps=777", "parameters.EI=123.456789012345678"},
        {"body.gyroscope.angular_velocity=[0.1, 1e-17, 3]", "function.pulse.table=[[0, 1], [3.3, 4.4]]"}};
    for (std::vector<std::string> overrides : sets) {
        // Beside sdirk-4, a deck cannot have beta.
        const std::string deck = replaced(flyer, "beta = 0.25\n", "");
        const Problem first = read_problem_text(deck, "flyer.toml", overrides);
        const Problem second = read_problem_text(first.record.text, "flyer.toml");
        CHECK(first.record.text != deck);
        CHECK(second.record.text == first.record.text);
        check_same(first, second);
    }
}

TEST_CASE("A deck is read from a file", "[deck]") {
    const std::filesystem::path folder =
        std::filesystem::temp_directory_path() / ("gxrod_problem_test_" + std::to_string(getpid()));
    std::filesystem::create_directories(folder);
    const std::filesystem::path path = folder / "heavy_top.toml";
    std::ofstream(path) << heavy_top;
    const Problem problem = read_problem(path, {"analysis.end_time=1.0"});
    CHECK(problem.record.name == "heavy_top.toml");
    CHECK(dynamic_of(problem).steps == 10000);

    std::ofstream(path) << replaced(heavy_top, "mass = 15.0", "mass = -15.0");
    CHECK_THROWS_WITH(read_problem(path),
                      path.string() + ":4:8: body.top.mass: expected a number greater than 0, found -15.0");
    CHECK_THROWS_AS(read_problem(path), DeckError);
    CHECK_THROWS_AS(read_problem(folder), FileError);
    CHECK_THROWS_WITH(read_problem(folder), folder.string() + ": is a folder, expected a deck");
    std::filesystem::remove_all(folder);
    CHECK_THROWS_AS(read_problem(path), FileError);
    CHECK_THROWS_WITH(read_problem(path), path.string() + ": cannot be read (No such file or directory)");
}

TEST_CASE("A fault has its parts", "[deck]") {
    try {
        read(replaced(body_deck, "mass", "mas"), {"analysis.beta=2"});
        FAIL("no fault");
    } catch (const DeckError& error) {
        REQUIRE(error.faults.size() == 2);
        CHECK(error.faults[0].file == "x.toml");
        CHECK(error.faults[0].line == 2);
        CHECK(error.faults[0].column == 1);
        CHECK(error.faults[0].key == "body.top.mas");
        CHECK(error.faults[0].message == R"(unknown key; did you mean "mass"?)");
        CHECK(error.faults[1].file == "--set analysis.beta=2");
        CHECK(error.faults[1].line == 0);
        CHECK(error.faults[1].message == "expected a number greater than 0, at most 0.5, found 2");
    }
}

TEST_CASE("An empty deck and one of comments are faults, not crashes", "[deck]") {
    const std::string missing =
        "x.toml:1:1: missing; expected [rod.NAME] or [body.NAME]\n"
        "x.toml:1:1: missing; expected [analysis] or [[stage]]";
    CHECK(faults_of("") == missing);
    CHECK(faults_of("# nothing\n") == missing);
}

TEST_CASE("A damaged deck is read or refused", "[deck]") {
    const std::string pieces[] = {
        "", "\"", "]", "[", "=", "0", "-", "t", ".", "\n", "nan", "at = \"flyer@0.5\"\n", "{}", "[]"};
    std::mt19937 random(5);
    int refused = 0;
    for (int i = 0; i < 400; ++i) {
        std::string deck = flyer;
        for (auto damages = 1 + random() % 3; damages > 0; --damages) {
            const std::size_t at = random() % deck.size();
            deck.replace(at, random() % 8, pieces[random() % std::size(pieces)]);
        }
        try {
            read(deck);
        } catch (const DeckError& error) {
            ++refused;
            REQUIRE_FALSE(error.faults.empty());
        }
    }
    CHECK(refused > 100);
    CHECK(refused < 400);
}

TEST_CASE("Any line of a deck can be left out or come twice", "[deck]") {
    std::vector<std::string> lines;
    std::istringstream text(flyer);
    for (std::string line; std::getline(text, line);) lines.push_back(line);
    int refused = 0;
    for (std::size_t changed = 0; changed < lines.size(); ++changed) {
        for (const int times : {0, 2}) {
            std::string deck;
            for (std::size_t i = 0; i < lines.size(); ++i) {
                for (int copy = i == changed ? times : 1; copy > 0; --copy) deck += lines[i] + "\n";
            }
            if (!faults_of(deck).empty()) ++refused;
        }
    }
    CHECK(refused > 50);
}

}  // namespace gxrod::test
