// Linear buckling of continuous rods: closed forms, and spectral elements and shooting where there are none.
#include "analyses/shapes/buckling.hpp"

#include <numbers>

#include "assembly/sample_model.hpp"
#include "rotation/rotation_map.hpp"
#include "tools/catch.hpp"
#include "tools/dense_algebra.hpp"
#include "tools/rod_models.hpp"
#include "tools/static_run.hpp"

using namespace gxrod;
using namespace gxrod::tools;
using Catch::Contains;

namespace {

using std::numbers::pi;

void push(Model& model, int node, const Vec3& force, Frame frame = Frame::spatial) {
    NodalLoad load;
    load.key = "load[0]";
    load.node = node;
    load.frame = frame;
    for (int i = 0; i < 3; ++i) load.force[i] = force[i] == 0.0 ? TimeFunction() : ramp(force[i]);
    model.loads.push_back(load);
}

BucklingRecord find_factors(const Model& model, int count) {
    const System system(model);
    return find_buckling(system, system.initial_state(), 1.0, {count});
}

std::vector<double> list(const std::vector<BucklingFactor>& factors) {
    std::vector<double> values;
    for (const BucklingFactor& factor : factors) values.push_back(factor.factor);
    return values;
}

void check(const std::vector<double>& found, const std::vector<double>& expected, double tolerance) {
    REQUIRE(found.size() >= expected.size());
    for (std::size_t i = 0; i < expected.size(); ++i)
        CHECK(found[i] == Approx(expected[i]).epsilon(tolerance));
}

Model make_column(double EA, double GA, const Mesh& mesh = {10, 4}) {
    Model model = make_rod_model(along_x, 1.0, mesh, make_section({EA, GA, GA, 1.0, 2.0, 1.0}));
    model.rods[0].name = "column";
    clamp(model, 0);
    push(model, last_node(model), {-1.0, 0.0, 0.0});
    return model;
}

// An arc in the plane xy that rises by its half-angle on both sides of its crown, everything held in the
// plane.
Model make_arch(double half_angle, double EI, double EA, double GA, bool is_clamped, int elements) {
    constexpr double R = 100.0;
    const Line line = [&](double s) {
        const double angle = half_angle - s / R;
        return Placement{R * Vec3(-std::sin(angle), std::cos(angle), 0.0),
                         exp_quaternion(Vec3(0.0, 0.0, angle))};
    };
    Model model =
        make_rod_model(line, 2.0 * half_angle * R, {elements, 4}, make_section({EA, GA, GA, EI, EI, EI}));
    for (int node = 0; node <= last_node(model); ++node) {
        const bool is_end = node == 0 || node == last_node(model);
        model.supports.push_back(
            {.node = node, .fixed = {is_end, is_end, true, true, true, is_end && is_clamped}});
    }
    push(model, last_node(model) / 2, {0.0, -1.0, 0.0});
    return model;
}

}  // namespace

TEST_CASE("P16: linear buckling of a column", "[analyses]") {
    const BucklingRecord record = find_factors(make_column(1e3, 4e2), 2);
    check(list(record.factors), {2.4523658546, 4.8753789019}, 1e-9);
    CHECK(record.is_complete);
    CHECK(record.is_symmetric);
    CHECK(record.reversed.empty());
    const Shape& shape = record.factors[0].shape;
    CHECK(shape.words == "bending about z of column");
    CHECK(record.factors[1].shape.words == "bending about y of column");
    CHECK(shape.nodes.back().head<3>().norm() == Approx(1.0));
    CHECK(shape.nodes.back()[1] == Approx(1.0));
}

TEST_CASE("P16: lateral buckling of a deep cantilever, loaded from either side", "[analyses]") {
    Model model = make_rod_model(along_x, 1.0, {12, 4}, make_section({1e5, 4e4, 4e4, 1.0, 1.0, 50.0}));
    clamp(model, 0);
    push(model, last_node(model), {0.0, -1.0, 0.0});
    const BucklingRecord record = find_factors(model, 2);
    check(list(record.factors), {4.0123200155, 10.2452875854}, 1e-8);
    check(list(record.reversed), {-4.0123200155, -10.2452875854}, 1e-8);
    CHECK(record.is_complete);
    CHECK(record.counted_positive == 2);
    CHECK(record.counted_negative == 2);
}

TEST_CASE("B2: a narrow cantilever, stiff against its load", "[analyses]") {
    Model model = make_rod_model(along_x, 1.0, {12, 4}, make_section({1e7, 1e7, 1e7, 1.0, 1.0, 50.0}));
    clamp(model, 0);
    push(model, last_node(model), {0.0, -1.0, 0.0});
    check(list(find_factors(model, 1).factors), {4.0125993435789}, 1e-6);
}

TEST_CASE("P16: a right-angle frame", "[analyses]") {
    constexpr double E = 71240.0, G = E / 2.62, leg = 240.0;
    const auto make_frame = [&](double force) {
        const Line line = [&](double s) {
            return s <= leg ? Placement{Vec3(s, 0.0, 0.0), Quat::Identity()}
                            : Placement{Vec3(leg, s - leg, 0.0), exp_quaternion(Vec3(0.0, 0.0, 0.5 * pi))};
        };
        const Section section = make_section({18.0 * E, 18.0 * G, 18.0 * G, 2.16 * G, 0.54 * E, 1350.0 * E});
        Model model = make_rod_model(line, 2.0 * leg, {16, 4}, section);
        // The second leg's element at the corner has axes of its own there.
        model.rods[0].triads[8 * 5] = exp_quaternion(Vec3(0.0, 0.0, 0.5 * pi));
        clamp(model, 0);
        push(model, last_node(model), {force, 0.0, 0.0});
        return model;
    };
    const BucklingRecord record = find_factors(make_frame(1.0), 1);
    check(list(record.factors), {1.08675519}, 2e-8);
    check(list(record.reversed), {-0.68023463}, 2e-8);
    const BucklingRecord turned = find_factors(make_frame(-1.0), 1);
    check(list(turned.factors), {0.68023463}, 2e-8);
    CHECK(turned.reversed.empty());
    CHECK(turned.is_complete);
}

TEST_CASE("P16: arches", "[analyses]") {
    check(list(find_factors(make_arch(0.2, 9e5, 1e7, 4e6, true, 24), 1).factors), {12023.95466}, 1e-8);
    check(list(find_factors(make_arch(0.2, 1e5, 1e7, 4e6, true, 24), 1).factors), {1109.0150879}, 1e-8);
    const BucklingRecord deep = find_factors(make_arch(215.0 / 360.0 * pi, 1e6, 1e8, 1e8, false, 40), 1);
    check(list(deep.factors), {357.1689}, 2e-7);
    CHECK(deep.is_complete);
}

TEST_CASE("B5: Greenhill's shaft under an axial couple", "[analyses]") {
    Model model = make_rod_model(along_x, 1.0, {10, 4}, make_section({1e7, 1e7, 1e7, 0.8, 1.0, 1.0}));
    clamp(model, 0);
    model.supports.push_back({.node = last_node(model), .fixed = {false, true, true, false, true, true}});
    NodalLoad couple;
    couple.key = "load[0]";
    couple.node = last_node(model);
    couple.moment[0] = ramp(1.0);
    model.loads.push_back(couple);
    const BucklingRecord record = find_factors(model, 2);
    // A round shaft gives way in any direction, and either way round.
    check(list(record.factors), {8.98681891581813, 8.98681891581813}, 1e-6);
    check(list(record.reversed), {-8.98681891581813, -8.98681891581813}, 1e-6);
    CHECK(record.is_complete);
}

TEST_CASE("B1: the nearer a column is to giving way, the better its factor", "[analyses]") {
    constexpr double exact = 2.458335976611;
    const auto find_load = [](double load) {
        Model model = make_column(1e3, 4e2);
        model.loads.clear();
        push(model, last_node(model), {-load, 0.0, 0.0});
        const StaticRun run = run_static(model, make_static_settings(1));
        const System system(model);
        const BucklingRecord record = find_buckling(system, run.state, 1.0, {1});
        REQUIRE(record.factors.size() == 1);
        return load * (1.0 + record.factors[0].factor);
    };
    CHECK(find_load(2.45) == Approx(exact).epsilon(1e-5));
    CHECK(find_load(2.4583) == Approx(exact).epsilon(5e-8));
}

TEST_CASE("a state that is unstable has no factors", "[analyses]") {
    Model model = make_column(1e3, 4e2, {6, 3});
    model.loads.clear();
    push(model, last_node(model), {-3.0, 0.0, 0.0});
    const StaticRun run = run_static(model, make_static_settings(1));
    const System system(model);
    const BucklingRecord record = find_buckling(system, run.state, 1.0, {1});
    CHECK_THAT(record.failure, Contains("unstable"));
    CHECK(record.factors.empty());
    const BucklingRecord none =
        find_factors(make_rod_model(along_x, 1.0, {4, 2}, make_section({1, 1, 1, 1, 1, 1})), 1);
    CHECK_FALSE(none.failure.empty());
}

TEST_CASE("buckling under gravity counts as that of any load", "[analyses]") {
    // Greenhill (1881): q L³/EI = 7.8373474.
    Model model = make_rod_model(
        along_x, 1.0, {10, 4}, make_section({1e6, 1e6, 1e6, 1.0, 2.0, 1.0}, {1, 1, 1, 0, 0, 0}));
    clamp(model, 0);
    model.gravity = TimeVector(Vec3(-1.0, 0.0, 0.0));
    check(list(find_factors(model, 1).factors), {7.8373474394}, 1e-5);
}

TEST_CASE("following loads make linear buckling a matter of their symmetric part", "[analyses]") {
    Model model = make_column(1e3, 4e2);
    model.loads.clear();
    push(model, last_node(model), {-1.0, 0.0, 0.0}, Frame::follower);
    const BucklingRecord record = find_factors(model, 1);
    CHECK_FALSE(record.is_symmetric);
    CHECK_THAT(record.cause, Contains("load[0] follows its point"));
    REQUIRE(record.factors.size() == 1);
    // The column is straight: its resultants are N = −1 alone, and at t = 1 the load has a stiffness of its
    // own.
    const System system(model);
    State state = system.initial_state();
    const auto compute_stiffness = [&](double time) {
        std::vector<double> values;
        system.compute_tangent(
            state, time, std::vector<NodeLinearization>(state.trial.size(), {.placement = 1.0}), values);
        return make_dense(system.pattern(), values);
    };
    const Eigen::MatrixXd K = compute_stiffness(0.0);
    system.start_resultants(state);
    for (Vec6& resultants : state.resultants) resultants[0] -= 1.0;
    const Eigen::MatrixXd change = compute_stiffness(1.0) - K;
    const Eigen::MatrixXd S = 0.5 * (change + change.transpose());
    // −S φ = φ/λ K.
    const Eigen::VectorXd inverse_factors = find_symmetric_eigenvalues(-S, K);
    CHECK(record.factors[0].factor == Approx(1.0 / inverse_factors.maxCoeff()).epsilon(1e-7));
    CHECK((change - S).norm() > 1e-3 * S.norm());
    // A load that acts at once, not by the load factor, is multiplied with its stiffness, too.
    for (TimeFunction& force : model.loads.front().force) force = TimeFunction(2.0 * force(1.0));
    CHECK(find_factors(model, 1).factors.at(0).factor ==
          Approx(0.5 * record.factors[0].factor).epsilon(1e-9));
}
