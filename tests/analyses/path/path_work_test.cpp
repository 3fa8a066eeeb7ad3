#include "analyses/path_work.hpp"

#include <cmath>

#include "tools/catch.hpp"

using namespace gxrod;

namespace {

// One force, as large as the load factor, and where it has moved its node; the energy is the work along the
// path.
struct TestSpring {
    std::function<double(double)> position;
    std::function<double(double)> energy;

    PathPoint at(double load_factor) const {
        PathPoint point;
        point.load_factor = load_factor;
        point.strain_energy = energy(load_factor);
        point.forces.assign(1, Vec6::Zero());
        point.forces[0][0] = load_factor;
        point.turned.assign(1, Vec3::Zero());
        point.state.trial.resize(1);
        point.state.trial[0].r.x() = position(load_factor);
        return point;
    }
    PathSearch search(int halvings, int& found) const {
        const auto find = [this, &found](const PathPoint&, double load_factor) {
            ++found;
            return std::optional(at(load_factor));
        };
        return {find, 1e-3, halvings};
    }
};

// Slack: nearly all of the way is made at once. W = ∫ λ dr.
const TestSpring slack{[](double t) { return std::pow(t, 0.05); },
                       [](double t) { return 0.05 / 1.05 * std::pow(t, 1.05); }};

// At λ = 0.3 it jumps by 1, and loses all of the work that its load does there.
const TestSpring jumping{[](double t) { return t + (t > 0.3 ? 1.0 : 0.0); },
                         [](double t) { return 0.5 * t * t; }};

}  // namespace

TEST_CASE("equilibria in between show that a slack structure goes along one path", "[analyses]") {
    int found = 0;
    const double exact = slack.energy(1.0);
    const StepWork coarse = integrate_path(slack.at(0.0), slack.at(1.0), slack.search(0, found));
    CHECK(found == 0);
    CHECK(coarse.work == Approx(0.5));
    CHECK(exact - coarse.work + coarse.uncertainty == Approx(0.0).margin(1e-12));
    const StepWork fine = integrate_path(slack.at(0.0), slack.at(1.0), slack.search(12, found));
    CHECK(fine.work == Approx(exact).epsilon(0.1));
    CHECK(found > 8);
    CHECK(std::abs(exact - fine.work) <= fine.uncertainty + 1e-12);
}

TEST_CASE("equilibria in between leave what a jump loses", "[analyses]") {
    int found = 0;
    const StepWork work = integrate_path(jumping.at(0.0), jumping.at(1.0), jumping.search(8, found));
    // The load moves its node by 1 at 0.3.
    CHECK(work.work == Approx(0.5 + 0.3).epsilon(0.01));
    CHECK(work.work - 0.5 - work.uncertainty > 0.29);
    CHECK(found <= 16);
}

TEST_CASE("a piece whose middle cannot be found is left as it is", "[analyses]") {
    const auto find = [](const PathPoint&, double) { return std::optional<PathPoint>(); };
    const StepWork work = integrate_path(slack.at(0.0), slack.at(1.0), {find, 1e-3, 8});
    CHECK(work.work == Approx(0.5));
    CHECK(work.uncertainty == Approx(0.5 - slack.energy(1.0)));
}

TEST_CASE("nothing is looked for where work and energy agree", "[analyses]") {
    const TestSpring linear{[](double t) { return t; }, [](double t) { return 0.5 * t * t; }};
    int found = 0;
    const StepWork work = integrate_path(linear.at(0.0), linear.at(1.0), linear.search(8, found));
    CHECK(found == 0);
    CHECK(work.work == Approx(0.5));
    CHECK(work.uncertainty < 1e-15);
}

TEST_CASE("moments work along turns of more than a half", "[analyses]") {
    const auto turned_by = [](double angle, double moment) {
        PathPoint point;
        point.load_factor = moment;
        point.strain_energy = 0.5 * moment * angle;
        point.forces.assign(1, Vec6::Zero());
        point.forces[0][5] = moment;
        point.turned.assign(1, Vec3(0.0, 0.0, angle));
        point.state.trial.resize(1);
        point.state.trial[0].Lambda = Quat(Eigen::AngleAxisd(angle, Vec3::UnitZ()));
        return point;
    };
    const auto find = [](const PathPoint&, double) { return std::optional<PathPoint>(); };
    CHECK(integrate_path(turned_by(0.0, 0.0), turned_by(7.0, 2.0), {find, 1e-3, 8}).work == Approx(7.0));
    CHECK(integrate_path(turned_by(1.0, 2.0), turned_by(5.0, 2.0), {find, 1e-3, 8}).work == Approx(8.0));
}

TEST_CASE("a jump whose energies agree by accident is found where a step takes many iterations",
          "[analyses]") {
    // At λ = 0.7 it jumps by 1, which takes the work 0.7; 0.5 of it is kept, which is the mean force times
    // the way.
    const TestSpring accident{[](double t) { return t > 0.7 ? 1.0 : 0.0; },
                              [](double t) { return t > 0.7 ? 0.5 : 0.0; }};
    const auto find = [&](const PathPoint& from, double load_factor) {
        PathPoint point = accident.at(load_factor);
        point.iterations = from.load_factor <= 0.7 && load_factor > 0.7 ? many_iterations : 2;
        return std::optional(point);
    };
    PathPoint end = accident.at(1.0);
    CHECK(integrate_path(accident.at(0.0), end, {find, 1e-3, 8}).work == 0.5);
    end.iterations = many_iterations;
    const StepWork work = integrate_path(accident.at(0.0), end, {find, 1e-3, 8});
    CHECK(work.work == Approx(0.7).margin(1.0 / 256.0));
    CHECK(work.uncertainty < 0.01);
}
