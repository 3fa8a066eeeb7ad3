// Vibrations in steady rotation: spectral elements and shooting, by two programs.
#include <algorithm>
#include <cmath>

#include "analyses/shapes/eigenvalues.hpp"
#include "tools/catch.hpp"
#include "tools/rod_models.hpp"
#include "tools/steady_run.hpp"

using namespace gxrod;
using namespace gxrod::tools;

namespace {

EigenvaluesRecord find_of(const SteadyRun& run, int count) {
    const SteadyAnalysis& analysis = run.analysis();
    return find_eigenvalues(
        analysis.system(), analysis.state(), 1.0, {.count = count}, &analysis.frame_columns());
}

// The lowest ones, and no others.
void check_lowest(const EigenvaluesRecord& record, const std::vector<double>& expected, double tolerance) {
    CHECK(record.is_complete);
    CHECK(record.unstable == 0);
    REQUIRE(record.modes.size() >= expected.size());
    for (std::size_t i = 0; i < expected.size(); ++i)
        CHECK(record.modes[i].omega == Approx(expected[i]).epsilon(tolerance));
}

void check_contains(const EigenvaluesRecord& record, double omega, double tolerance) {
    double nearest = 0.0;
    for (const Eigenmode& mode : record.modes) {
        if (std::abs(mode.omega - omega) < std::abs(nearest - omega)) nearest = mode.omega;
    }
    CHECK(std::abs(nearest - omega) < tolerance);
}

Section make_blade_section() {
    return make_section({1e4, 4e3, 4e3, 0.8, 1.0, 4.0}, {1.0, 1.0, 1.0, 5e-4, 1e-4, 4e-4});
}

Model make_blade(double cone) {
    const Mat3 axes = Eigen::AngleAxisd(-cone, Vec3::UnitY()).toRotationMatrix();
    const Line line = [&](double s) { return Placement{Vec3(0.2, 0.0, 0.0) + s * axes.col(0), Quat(axes)}; };
    Model model = make_rod_model(line, 1.0, {16, 4}, make_blade_section());
    clamp(model, 0);
    return model;
}

// A shaft in a clamp that turns about its axis, with a disc at its end.
Model make_shaft(const Section& section) {
    Model model = make_rod_model(along_x, 1.0, {12, 4}, section);
    clamp(model, 0);
    model.bodies.push_back({.name = "disc",
                            .node = last_node(model),
                            .mass = 1.0,
                            .inertia = Vec3(0.05, 0.03, 0.03).asDiagonal()});
    return model;
}

SteadyRun turn_shaft(const Model& model, double speed) {
    return SteadyRun(model, ramped_frame(Vec3::UnitX(), speed), make_static_settings(1));
}

const std::array<double, 6> shaft_stiffness{1e4, 4e3, 4e3, 0.8, 1.0, 1.0};

}  // namespace

TEST_CASE("P10a: a blade on a hub", "[analyses]") {
    struct Row {
        double speed, tip;
        std::vector<double> omega;
    };
    const std::vector<Row> rows{
        {0.0, 1.2, {3.5131597338, 7.0092876523, 21.9106231789, 43.1040931350, 60.8818637247, 62.8318530718}},
        {2.0,
         1.2001733613,
         {4.2820433272, 7.1477238107, 22.6400163158, 43.4212131467, 61.6094515940, 62.8513132012}},
        {5.0,
         1.2010844282,
         {7.0126496082, 7.8185879085, 26.1335199639, 45.0483129690, 62.9502959085, 65.2827364216}},
        {10.0,
         1.2043509045,
         {9.7069294310, 12.4532489861, 35.8726186568, 50.4144878005, 63.3082244628, 76.8081776936}}};
    const Model model = make_blade(0.0);
    for (const Row& row : rows) {
        INFO("speed " << row.speed);
        const SteadyRun run(model, ramped_frame(Vec3::UnitZ(), row.speed), make_static_settings(2));
        CHECK(run.tip().r[0] == Approx(row.tip).epsilon(1e-10));
        check_lowest(find_of(run, 6), row.omega, 1e-9);
    }
}

TEST_CASE("P10b: a shaft with a disc", "[analyses]") {
    const Model shaft = make_shaft(make_section(shaft_stiffness, {0.1, 0.1, 0.1, 2e-4, 1e-4, 1e-4}));
    struct Row {
        double speed;
        int count;
        std::vector<double> whirl;  // as seen at rest
    };
    for (const Row& row :
         {Row{0.0, 8, {1.656641539, 11.649355862, 71.419992335}},
          Row{10.0, 8, {2.140668543, -1.152727708, -6.854348626, 21.986864299, -71.120703626, 71.826798183}},
          Row{40.0, 6, {2.816154055, -0.467652964, -4.250927690, 61.822148033}}}) {
        INFO("speed " << row.speed);
        const SteadyRun run = turn_shaft(shaft, row.speed);
        const EigenvaluesRecord record = find_of(run, row.count);
        CHECK(record.is_complete);
        CHECK(record.unstable == 0);
        for (const double whirl : row.whirl) check_contains(record, std::abs(whirl - row.speed), 2e-8);
    }
    // At the critical speed the whirl stands still in the frame.
    constexpr double critical = 1.7495210546, part = 1e-4;
    double standing[2];
    for (const int side : {0, 1}) {
        const SteadyRun run = turn_shaft(shaft, critical * (side == 0 ? 1.0 - part : 1.0 + part));
        standing[side] = find_of(run, 2).modes[0].omega;
    }
    const double found = critical * (1.0 + part * (standing[0] - standing[1]) / (standing[0] + standing[1]));
    CHECK(found == Approx(critical).epsilon(1e-8));
}

TEST_CASE("P10b: a disc on a shaft without mass", "[analyses]") {
    const Model shaft = make_shaft(make_section(shaft_stiffness));
    const SteadyRun run = turn_shaft(shaft, 10.0);
    const EigenvaluesRecord record = find_of(run, 6);
    CHECK(record.is_complete);
    for (const double whirl : {-6.990086714708, -1.160461412852, 2.170946620029, 22.646268174197})
        check_contains(record, std::abs(whirl - 10.0), 1e-8);
    CHECK(record.is_all);
}

TEST_CASE("P10c: a coned blade", "[analyses]") {
    const Model model = make_blade(0.2);
    const SteadyRun slow(model, ramped_frame(Vec3::UnitZ(), 3.0), make_static_settings(4));
    CHECK(slow.tip().r[0] == Approx(1.1946633200).epsilon(1e-9));
    CHECK(slow.tip().r[2] == Approx(0.1007223575).epsilon(1e-8));
    CHECK(-slow.reactions()[0][0] == Approx(6.2667832542).epsilon(1e-9));
    CHECK(std::abs(slow.reactions()[0][4]) == Approx(0.4439184082).epsilon(1e-9));
    check_lowest(
        find_of(slow, 5), {5.027665620, 7.327429233, 23.467501294, 43.705252080, 62.308291453}, 1e-9);
    const SteadyRun fast(model, ramped_frame(Vec3::UnitZ(), 6.0), make_static_settings(4));
    CHECK(fast.tip().r[0] == Approx(1.1994125624).epsilon(1e-9));
    CHECK(fast.tip().r[2] == Approx(0.0462057897).epsilon(1e-8));
    check_lowest(find_of(fast, 4), {7.838182579, 8.311638909, 27.723435816, 45.766744368}, 1e-9);
}

// The flap of a blade whose extension, shear and rotary inertia are 1/S, nearest to a reference.
double find_flap(double S, double speed, double reference) {
    Model model =
        make_rod_model(along_x,
                       1.0,
                       {12, 4},
                       make_section({S, S, S, 100.0, 1.0, 1e4}, {1.0, 1.0, 1.0, 2.0 / S, 1.0 / S, 1.0 / S}));
    clamp(model, 0);
    const SteadyRun run(model, ramped_frame(Vec3::UnitZ(), speed), make_static_settings(2));
    double nearest = 0.0;
    for (const Eigenmode& mode : find_of(run, 6).modes) {
        if (std::abs(mode.omega - reference) < std::abs(nearest - reference)) nearest = mode.omega;
    }
    return nearest;
}

TEST_CASE("M2: the flap of a slender blade that turns", "[analyses]") {
    struct Row {
        double speed;
        std::vector<double> omega;
    };
    // Wright (1982), without extension, shear and rotary inertia: what is linear in 1/S is extrapolated.
    for (const Row& row : {Row{1.0, {3.6816468140, 22.1810111506, 61.8417625872}},
                           Row{3.0, {4.7972785324, 23.3202636743}},
                           Row{6.0, {7.3603730193, 26.8090816785}},
                           Row{12.0, {13.1701504875, 37.6031123312}}}) {
        for (const double omega : row.omega) {
            INFO("speed " << row.speed << ", ω " << omega);
            const double coarse = find_flap(1e5, row.speed, omega), fine = find_flap(1e6, row.speed, omega);
            CHECK((10.0 * fine - coarse) / 9.0 == Approx(omega).epsilon(2e-7));
        }
    }
}
