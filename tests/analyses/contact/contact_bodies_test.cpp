// Bodies that touch obstacles, against exact solutions.
#include <fmt/format.h>

#include <cmath>

#include "analyses/static.hpp"
#include "deck/decks.hpp"
#include "rotation/rotation_map.hpp"
#include "tools/catch.hpp"

namespace gxrod::test {
namespace {

// A deck, run step by step.
class BodyRun {
  public:
    explicit BodyRun(const std::string& deck)
        : problem_(read(deck)), analysis_(make_analysis(problem_.model, problem_.analysis(), 1)) {
        REQUIRE(analysis_->start().converged());
    }
    void step() {
        REQUIRE(analysis_->advance().converged());
        least_gap_ = std::min(least_gap_, analysis_->solver_row().least_gap);
    }
    void finish() {
        while (!is_finished()) step();
    }
    bool is_finished() const { return analysis_->finished(); }
    const NodeMotion& body() const { return analysis_->state().trial[0]; }
    ObstacleValues obstacle() const { return analysis_->snapshot(false).obstacles[0]; }
    LedgerRow ledger() const { return analysis_->ledger_row(); }
    double time() const { return analysis_->state().time; }
    double least_gap() const { return least_gap_; }

  private:
    Problem problem_;
    std::unique_ptr<SteppedAnalysis> analysis_;
    double least_gap_ = 1.0;
};

std::string analysis(double end_time, double time_step) {
    return fmt::format(
        "[analysis]\nkind = \"dynamic\"\nend_time = {}\ntime_step = {}\n", end_time, time_step);
}

std::string ball(double height, const std::string& more) {
    return fmt::format(
        "gravity = [0, 0, -9.81]\n[body.ball]\nmass = 0.5\ninertia = [5e-4, 5e-4, 5e-4]\n"
        "at = [0, 0, {}]\nsphere = {{ radius = 0.05 }}\n{}",
        height,
        more);
}

std::string floor(double friction, const std::string& normal = "0, 0, 1") {
    return fmt::format("[obstacle.floor]\nplane = {{ point = [0, 0, 0], normal = [{}] }}\nfriction = {}\n",
                       normal,
                       friction);
}

}  // namespace

TEST_CASE("C5a: a ball that loses nothing rebounds to its height", "[analyses][touch][bodies]") {
    for (const double step : {1e-3, 7e-3}) {
        INFO("time step " << step);
        BodyRun run(ball(0.55, "") + floor(0.0) + "[contact]\ndissipation = 0\n" + analysis(6.5, step));
        const LedgerRow start = run.ledger();
        int rebounds = 0;
        double first_touch = 0.0, highest = 0.0, top_error = 0.0, energy_error = 0.0;
        bool rises = false;
        while (!run.is_finished()) {
            run.step();
            const double height = run.body().r.z() - 0.05;
            if (first_touch == 0.0 && run.body().v.z() > -9.81 * run.time() + 1e-6) first_touch = run.time();
            if (rises && run.body().v.z() < 0.0) {
                ++rebounds;
                top_error = std::max(top_error, std::abs(std::max(highest, height) - 0.5));
                highest = 0.0;
            }
            rises = run.body().v.z() > 0.0;
            highest = std::max(highest, height);
            const LedgerRow row = run.ledger();
            const double energy = row.kinetic_energy + row.contact_energy - row.external_work;
            energy_error = std::max(energy_error, std::abs(energy - start.kinetic_energy));
        }
        CHECK(rebounds == 10);
        // It acts from the skin on.
        CHECK(std::abs(first_touch - 0.3192754284) < 1.01 * step + 1e-3 / 3.13);
        CHECK(top_error < 9.81 / 8.0 * step * step + 1e-6);  // between two steps
        CHECK(energy_error < 1e-7);
        CHECK(run.least_gap() > 0.0);
    }
}

TEST_CASE("A ball circles in a hollow cylinder and on a sphere's inside without loss",
          "[analyses][touch][bodies]") {
    for (const char* hollow :
         {"cylinder = { from = [0, 0, -1], to = [0, 0, 1], radius = 0.11, side = \"inside\" }",
          "sphere = { centre = [0, 0, 0], radius = 0.11, side = \"inside\" }"}) {
        for (const double step : {1e-2, 1e-3}) {
            INFO(hollow << ", time step " << step);
            BodyRun run(
                fmt::format("[body.ball]\nmass = 0.1\ninertia = [4e-6, 4e-6, 4e-6]\nat = [0.0998, 0, 0]\n"
                            "sphere = {{ radius = 0.01 }}\n[[initial]]\non = \"ball\"\nvelocity = [0, 1, 0]\n"
                            "[obstacle.hollow]\n{}\n[contact]\ndissipation = 0\n{}",
                            hollow,
                            analysis(1.0, step)));
            run.finish();
            // 1.6 turns, in 100 or in 1000 steps.
            CHECK(std::abs(run.ledger().kinetic_energy / 0.05 - 1.0) < 2e-4);
            CHECK(std::abs(run.ledger().contact_loss) < 1e-9);
        }
    }
}

TEST_CASE("C5b': a ball slides until it rolls", "[analyses][touch][bodies]") {
    BodyRun run(ball(0.050983, "velocity = [2, 0, 0]\n") + floor(0.3) + analysis(0.4, 5e-4));
    double start = 0.0, place = 0.0;  // where nothing slips
    while (!run.is_finished()) {
        run.step();
        if (start == 0.0 && run.body().v.x() - 0.05 * run.body().omega.y() < 1e-3)
            start = run.time(), place = run.body().r.x();
    }
    CHECK(start == Approx(0.1941653318).margin(1e-3));
    CHECK(place == Approx(0.3328548545).margin(2e-3));
    CHECK(run.body().r.x() == Approx(0.3328548545 + (0.4 - 0.1941653318) * 1.4285714286).epsilon(1e-5));
    CHECK(run.body().v.x() == Approx(1.4285714286).epsilon(1e-6));
    CHECK(run.body().omega.y() == Approx(1.4285714286 / 0.05).epsilon(1e-6));
    CHECK(run.ledger().contact_loss == Approx(0.5 * 0.5714285714).epsilon(1e-3));
}

TEST_CASE("A ball on a slope rolls, and holds where it cannot turn", "[analyses][touch][bodies]") {
    const std::string slope = "0.24740395925, 0, 0.96891242171";  // 0.25 rad
    const std::string start = "at = [0.0126, 0, 0.0494]\n";
    const auto deck = [&](const std::string& more) {
        return "gravity = [0, 0, -9.81]\n[body.ball]\nmass = 0.5\ninertia = [5e-4, 5e-4, 5e-4]\n" + start +
               "sphere = { radius = 0.05 }\n" + floor(0.3, slope) + more + analysis(0.5, 1e-3);
    };
    SECTION("free") {
        BodyRun run(deck(""));
        run.finish();
        // 5/7 of g sin; it falls from a part of the skin first.
        CHECK(std::hypot(run.body().v.x(), run.body().v.z()) ==
              Approx(0.5 * 9.81 * std::sin(0.25) / 1.4).epsilon(2e-3));
    }
    SECTION("held") {
        BodyRun run(deck("[[support]]\nat = \"ball\"\nfix = \"rotation\"\n"));
        const Vec3 from = run.body().r;
        run.finish();
        CHECK((run.body().r - from).norm() < 1e-3);
        CHECK(run.body().v.norm() < 1e-6);
    }
}

TEST_CASE("A capsule falls on a plane and comes to rest", "[analyses][touch][bodies]") {
    BodyRun run(R"(
gravity = [0, 0, -9.81]
[body.stick]
mass = 1
inertia = [1e-3, 4e-3, 4e-3]
at = [0, 0, 0.25]
rotation_vector = [0, 0.4, 0]
angular_velocity = [0, 2, 0]
capsule = { from = [-0.12, 0, 0], to = [0.08, 0, 0], radius = 0.03 }
)" + floor(0.4) +
                analysis(3.0, 1e-3));
    double energy = run.ledger().kinetic_energy, rise = 0.0;
    while (!run.is_finished()) {
        run.step();
        const LedgerRow row = run.ledger();
        const double now = row.kinetic_energy + row.contact_energy - row.external_work;
        rise = std::max(rise, now - energy);
        energy = now;
    }
    CHECK(rise < 1e-4 * 9.81 * 0.25);
    CHECK(run.least_gap() > 0.0);
    CHECK(run.ledger().kinetic_energy < 1e-9);
    // It lies: both ends are up to a skin above the floor.
    const Vec3 axis = run.body().Lambda * exp_matrix(Vec3(0, 0.4, 0)) * Vec3::UnitX();
    CHECK(std::abs(axis.z()) < 2e-3);
    CHECK(run.body().r.z() > 0.03);
    CHECK(run.body().r.z() < 0.03 * 1.03);
    CHECK(run.obstacle().force.isApprox(Vec3(0, 0, -9.81), 1e-6));
}

TEST_CASE("In statics a body is pressed against an obstacle", "[analyses][touch][bodies]") {
    BodyRun run(R"(
[body.ball]
at = [0, 0, 0.0505]
sphere = { radius = 0.05, force = 10 }
[[load]]
at = "ball"
force = [0, 0, -10]
[[support]]
at = "ball"
fix = ["x", "y", "rotation"]
)" + floor(0.0) +
                "[analysis]\nkind = \"static\"\nsteps = 3\n");
    run.finish();
    CHECK(run.obstacle().force.isApprox(Vec3(0, 0, -10), 1e-8));
    CHECK(run.obstacle().least_gap == Approx(0.5e-3).epsilon(1e-6));
}

TEST_CASE("A body passes through what a pair leaves out, and rubs as a pair says", "[analyses][touch]") {
    const auto pair = [](const char* more) {
        return std::string("[contact]\n[[contact.pair]]\nbetween = [\"b*\", \"floor\"]\n") + more + "\n";
    };
    BodyRun fallen(ball(0.06, floor(0.3) + pair("off = true") + analysis(0.3, 1e-3)));
    fallen.finish();
    CHECK(fallen.body().r.z() == Approx(0.06 - 0.5 * 9.81 * 0.09).epsilon(1e-9));
    // Without friction it slides on as it was thrown, without spin.
    BodyRun slid(
        ball(0.050983, "velocity = [2, 0, 0]\n" + floor(0.3) + pair("friction = 0") + analysis(0.3, 1e-3)));
    slid.finish();
    CHECK(slid.body().v.x() == Approx(2.0).epsilon(1e-12));
    CHECK(slid.body().omega.norm() < 1e-12);
    CHECK(slid.body().r.z() > 0.05);
}

}  // namespace gxrod::test
