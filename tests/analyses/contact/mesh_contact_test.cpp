// Rods that touch meshes, against exact solutions and obstacles without triangles.
#include <fmt/format.h>

#include <cmath>
#include <fstream>

#include "analyses/static.hpp"
#include "contact/meshes.hpp"
#include "deck/decks.hpp"
#include "machine/temporary_folder.hpp"
#include "tools/catch.hpp"

namespace gxrod::test {
namespace {

// STL files, as long as it lives.
class StlFiles {
  public:
    StlFiles() : folder_(make_temporary_folder("stl")) {}
    ~StlFiles() { std::filesystem::remove_all(folder_); }
    StlFiles(const StlFiles&) = delete;
    StlFiles& operator=(const StlFiles&) = delete;

    // What `mesh = ` of a deck is.
    std::string write(const TriangleMesh& mesh, const std::string& more = "") {
        const std::filesystem::path path = folder_ / fmt::format("{}.stl", ++count_);
        std::ofstream stream(path);
        stream << "solid s\n";
        for (const std::array<int, 3>& corners : mesh.triangles) {
            stream << "facet normal 0 0 0\nouter loop\n";
            for (const int corner : corners) {
                const Vec3& x = mesh.positions[static_cast<std::size_t>(corner)];
                stream << fmt::format("vertex {} {} {}\n", x.x(), x.y(), x.z());
            }
            stream << "endloop\nendfacet\n";
        }
        stream << "endsolid\n";
        return fmt::format("mesh = {{ file = \"{}\"{} }}\n", path.string(), more);
    }

  private:
    std::filesystem::path folder_;
    int count_ = 0;
};

struct MeshRun {
    explicit MeshRun(const std::string& deck)
        : problem(read(deck)), analysis(make_analysis(problem.model, problem.analysis(), 1)) {
        REQUIRE(analysis->start().converged());
        while (!analysis->finished()) {
            REQUIRE(analysis->advance().converged());
            least_gap = std::min(least_gap, analysis->solver_row().least_gap);
        }
    }
    ObstacleValues obstacle(std::size_t index = 0) const {
        return analysis->snapshot(false).obstacles[index];
    }
    const NodeMotion& at(const std::string& node) const {
        const auto found = std::ranges::find(problem.model.nodes, node, &Node::name);
        return analysis->state().trial[static_cast<std::size_t>(found - problem.model.nodes.begin())];
    }

    Problem problem;
    std::unique_ptr<SteppedAnalysis> analysis;
    double least_gap = 1.0;
};

// C1c's, onto what is there.
std::string pressed_cantilever(const std::string& obstacle) {
    return R"(
[section.s]
shape = { circle = { radius = 0.01 } }
material = { E = 1e9, nu = 0.3 }
[rod.a]
section = "s"
line = { from = [0, 0, 0.0005], to = [1, 0, 0.0005] }
elements = 20
order = 2
[[support]]
at = "a.start"
fix = ["x", "y", "rotation"]
move = { z = "-t*0.3005" }
[obstacle.c]
)" + obstacle +
           "[analysis]\nkind = \"static\"\nsteps = 3\n";
}

// A cylinder's triangles about the line through (0.8, ·, −0.06) along y, an edge on top.
TriangleMesh make_lying_cylinder(int facets) {
    TriangleMesh mesh = make_cylinder(0.05, -0.2, 0.2, facets, 1);
    for (Vec3& x : mesh.positions) x = Vec3(0.8 + x.y(), x.z(), -0.06 + x.x());
    return mesh;
}

// A heavy rod along x, drawn along it within a mesh.
std::string drawn_rod(const std::string& mesh, double height, double friction) {
    return fmt::format(R"(
gravity = [0, 0, -10]
[section.s]
shape = {{ circle = {{ radius = 0.05 }} }}
material = {{ E = 1e8, nu = 0.3, density = 1000 }}
[rod.a]
section = "s"
line = {{ from = [-0.5, 0, {0}], to = [0.5, 0, {0}] }}
elements = 4
[[support]]
at = "a.end"
fix = "rotation"
move = {{ x = "0.02*t" }}
[obstacle.o]
{1}friction = {2}
[analysis]
kind = "static"
steps = 8
)",
                       height,
                       mesh,
                       friction);
}

constexpr double weight = 1000.0 * M_PI * 0.05 * 0.05 * 10.0;

}  // namespace

TEST_CASE("C1c on a triangulated cylinder is that on a cylinder but for its sagitta", "[analyses][touch]") {
    StlFiles files;
    constexpr double exact = 12.429723539;
    double before = 1.0;
    for (const int facets : {24, 96, 384}) {
        const MeshRun run(pressed_cantilever(files.write(make_lying_cylinder(facets))));
        const double sagitta = 0.05 * (1.0 - std::cos(M_PI / facets));
        const ObstacleValues found = run.obstacle();
        INFO(facets << " facets, force " << found.force.norm() << ", gap " << found.least_gap);
        CHECK(run.least_gap > 0.0);
        CHECK(std::abs(found.force.norm() - exact) < 45.0 * (sagitta + 2e-4));
        const double error = std::abs(found.force.norm() - exact - 30.0 * found.least_gap);
        CHECK(error < std::max(before, 5e-3));
        before = error;
    }
    CHECK(before < 5e-3);
}

TEST_CASE("In a groove both faces bear and rub", "[analyses][touch]") {
    StlFiles files;
    const double height = std::sqrt(2.0) * (0.05 + 0.9e-3);
    const TriangleMesh groove = make_groove(1.0, 1.0, 6);
    const MeshRun run(drawn_rod(files.write(groove), height, 0.2));
    const ObstacleValues found = run.obstacle();
    CHECK(found.force.z() == Approx(-weight).epsilon(1e-5));
    CHECK(found.force.y() == Approx(0.0).margin(1e-5 * weight));
    CHECK(found.friction.x() == Approx(0.2 * weight * std::sqrt(2.0)).epsilon(1e-3));
    SECTION("one face alone where its edge is taken to be smooth") {
        const MeshRun smooth(drawn_rod(files.write(groove, ", feature_angle = 2"), height, 0.2));
        CHECK(smooth.obstacle().friction.x() == Approx(0.2 * weight).epsilon(1e-3));
    }
}

TEST_CASE("A rod drawn over a flat mesh is drawn over a plane", "[analyses][touch]") {
    StlFiles files;
    const MeshRun run(drawn_rod(files.write(make_floor(1.0, 9)), 0.05095, 0.3));
    // With the same places, because of what is far below.
    TriangleMesh below = make_floor(1.0, 9);
    for (Vec3& position : below.positions) position.z() = -1.0;
    const MeshRun plane(drawn_rod("plane = { point = [0, 0, 0], normal = [0, 0, 1] }\n", 0.05095, 0.3) +
                        "[obstacle.below]\n" + files.write(below));
    CHECK(run.obstacle().force.z() == Approx(-weight).epsilon(1e-6));
    CHECK(run.obstacle().friction.x() == Approx(0.3 * weight).epsilon(1e-6));
    CHECK((run.obstacle().friction - plane.obstacle().friction).norm() < 1e-9 * weight);
    for (const char* node : {"a.start", "a.end"}) CHECK((run.at(node).r - plane.at(node).r).norm() < 1e-9);
}

TEST_CASE("A rod in a tube of triangles is pressed as in a tube", "[analyses][touch]") {
    const auto deck = [](const std::string& obstacle) {
        return R"(
[section.s]
shape = { circle = { radius = 0.01 } }
material = { E = 1e8, nu = 0.3 }
[rod.a]
section = "s"
line = { from = [0, 0, -0.5], to = [0, 0, 0.5] }
elements = 16
order = 2
[[support]]
at = "a.start"
fix = "all"
[[load]]
at = "a.end"
force = ["0.4*t", "0.15*t", 0]
[obstacle.t]
)" + obstacle + "[analysis]\nkind = \"static\"\nsteps = 4\n";
    };
    StlFiles files;
    const MeshRun smooth(
        deck("cylinder = { from = [0, 0, -1], to = [0, 0, 1], radius = 0.05, side = \"inside\" }\n"));
    for (const int facets : {16, 48}) {
        const MeshRun run(deck(files.write(make_cylinder(0.05, -1.0, 1.0, facets, 3))));
        INFO(facets << " facets");
        const double sagitta = 0.05 * (1.0 - std::cos(M_PI / facets));
        CHECK(run.least_gap > 0.0);
        // It goes to the bottom of a groove between two facets.
        const Vec3 difference = run.at("a.end").r - smooth.at("a.end").r;
        CHECK(difference.norm() < 0.04 * M_PI / facets + 2.0 * sagitta);
        CHECK(run.at("a.end").r.head<2>().norm() ==
              Approx(smooth.at("a.end").r.head<2>().norm()).margin(sagitta + 2e-4));
        CHECK((run.obstacle().force - smooth.obstacle().force).norm() <
              1.5 * M_PI / facets * smooth.obstacle().force.norm());
    }
}

TEST_CASE("No rod passes through a mesh, however fast it is", "[analyses][touch]") {
    StlFiles files;
    const std::string mesh = files.write(make_floor(3.0, 7));
    for (const double speed : {3.0, 30.0}) {
        const MeshRun run(fmt::format(R"(
[section.s]
shape = {{ circle = {{ radius = 0.02 }} }}
material = {{ E = 1e9, nu = 0.3, density = 1000 }}
[rod.a]
section = "s"
line = {{ from = [-0.3, 0.1, 0.3], to = [0.4, 0.2, 0.7] }}
elements = 6
order = 2
[[initial]]
on = "a"
velocity = [5, 0, -{}]
[obstacle.o]
{}
[analysis]
kind = "dynamic"
integrator = "newmark-simplified"
end_time = {}
time_step = {}
)",
                                      speed,
                                      mesh,
                                      2.0 / speed,
                                      0.1 / speed));
        INFO("speed " << speed);
        CHECK(run.least_gap > 0.0);
        for (const char* node : {"a.start", "a.end"}) CHECK(run.at(node).r.z() > 0.02);
    }
}

TEST_CASE("A rod that starts in what it touches is refused, of any kind of analysis", "[analyses][touch]") {
    StlFiles files;
    const std::string mesh = files.write(make_floor(1.0, 3));
    for (const std::string& obstacle :
         {mesh, std::string("plane = { point = [0, 0, 0], normal = [0, 0, 1] }\n")}) {
        for (const char* kind :
             {"kind = \"static\"\n", "kind = \"dynamic\"\nend_time = 1\ntime_step = 0.1\n"}) {
            const std::string deck = drawn_rod(obstacle, 0.04, 0.0);
            const Problem problem = read(deck.substr(0, deck.find("[analysis]")) + "[analysis]\n" + kind);
            const auto analysis = make_analysis(problem.model, problem.analysis(), 1);
            CHECK_THROWS_WITH(analysis->start(),
                              Catch::StartsWith("at the start a@") && Catch::Contains(" is 0.01 deep in ") &&
                                  Catch::Contains("obstacle \"o\"; expected a gap"));
        }
    }
}

TEST_CASE("A ball that circles within a mesh keeps its energy", "[analyses][touch][bodies]") {
    StlFiles files;
    TriangleMesh mesh = make_cylinder(0.11, -0.3, 0.3, 48, 2);
    // Seen from within.
    for (std::array<int, 3>& corners : mesh.triangles) std::swap(corners[0], corners[1]);
    const std::string mesh_key = files.write(mesh);
    for (const double step : {5e-3, 1e-3}) {
        INFO("time step " << step);
        const MeshRun run(fmt::format(R"(
[body.ball]
mass = 0.1
inertia = [4e-6, 4e-6, 4e-6]
at = [0.0988, 0, 0]
sphere = {{ radius = 0.01 }}
[[initial]]
on = "ball"
velocity = [0, 1, 0]
[obstacle.hollow]
{}
[contact]
dissipation = 0
[analysis]
kind = "dynamic"
integrator = "newmark-simplified"
end_time = 1
time_step = {}
)",
                                      mesh_key,
                                      step));
        // 1.6 turns, past 77 edges.
        const LedgerRow ledger = run.analysis->ledger_row();
        CHECK(std::abs((ledger.kinetic_energy + ledger.contact_energy) / 0.05 - 1.0) < 2e-4);
        CHECK(std::abs(ledger.contact_loss) < 1e-5);
        CHECK(run.least_gap > 0.0);
    }
}

}  // namespace gxrod::test
