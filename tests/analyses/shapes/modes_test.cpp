// Modes as such; compared with references in modes_benchmarks_test.cpp.
#include "analyses/shapes/modes.hpp"
#include "assembly/system_measures.hpp"
#include "assembly/system_values.hpp"

#include <numbers>

#include "assembly/sample_model.hpp"
#include "assembly/state_matrices.hpp"
#include "tools/catch.hpp"
#include "tools/dense_algebra.hpp"
#include "tools/rod_models.hpp"
#include "tools/static_run.hpp"

using namespace gxrod;
using namespace gxrod::tools;
using Catch::Contains;

namespace {

constexpr double cycle = 2.0 * std::numbers::pi;

Section make_round_section() {
    return make_section({1e4, 4e3, 4e3, 0.8, 1.0, 1.0}, {1.0, 1.0, 1.0, 2e-2, 1e-2, 1e-2});
}

ModesRecord find_modes_at_rest(const Model& model, const ModesSettings& settings) {
    const System system(model);
    return find_modes(system, system.initial_state(), 0.0, settings);
}

}  // namespace

TEST_CASE("a free rod moves in six ways as one piece", "[analyses]") {
    const Model model = make_rod_model(along_x, 1.0, {8, 3}, make_round_section());
    const ModesRecord record = find_modes_at_rest(model, {.count = 8});
    REQUIRE(record.modes.size() == 8);
    CHECK(record.is_complete);
    CHECK(record.unstable == 0);
    const double first = record.modes[6].omega;
    for (int i = 0; i < 6; ++i) {
        INFO(record.modes[i].shape.words);
        CHECK(std::abs(record.modes[i].omega_squared) < 1e-9 * first * first);
        CHECK(record.modes[i].effective_mass[i] > 0.0);
        if (i < 3) CHECK(record.modes[i].effective_mass[i] == Approx(1.0));
    }
    CHECK(record.modes[0].shape.words == "the whole model moves along x");
    CHECK(record.modes[1].shape.words == "the whole model moves along y");
    CHECK(record.modes[2].shape.words == "the whole model moves along z");
    CHECK_THAT(record.modes[3].shape.words, Contains("turns about"));
    // Nothing else takes part in motions of the whole.
    CHECK((record.effective_share - Vec6::Ones()).norm() < 1e-9);
    CHECK(record.total_mass[0] == Approx(1.0));
    CHECK(record.total_mass[4] == Approx(1.0 / 3.0 + 1e-2));
    CHECK(record.modes[7].omega == Approx(first).epsilon(1e-10));
}

TEST_CASE("copies of a round rod's frequencies are turned along the axes", "[analyses]") {
    const Quat turn(Eigen::AngleAxisd(0.4, Vec3::UnitX()));
    const Line line = [&](double s) { return Placement{Vec3(s, 0.0, 0.0), turn}; };
    Model model = make_rod_model(line, 1.0, {8, 3}, make_round_section());
    model.rods[0].name = "shaft";
    clamp(model, 0);
    const ModesRecord record = find_modes_at_rest(model, {.count = 5});
    REQUIRE(record.modes.size() == 5);
    CHECK(record.is_complete);
    CHECK(record.counted == 5);
    CHECK(record.modes[1].omega == Approx(record.modes[0].omega).epsilon(1e-10));
    const auto tip = [&](int mode) { return record.modes[mode].shape.nodes.back(); };
    CHECK(tip(0)[1] > 1.0);
    CHECK(std::abs(tip(0)[2]) < 1e-6 * tip(0)[1]);
    CHECK(tip(1)[2] > 1.0);
    CHECK(std::abs(tip(1)[1]) < 1e-6 * tip(1)[2]);
    CHECK(record.modes[0].effective_mass[1] == Approx(record.modes[1].effective_mass[2]));
    CHECK(record.modes[2].shape.words == "1st torsion of shaft");
    CHECK(record.modes[2].shape.energy_shares[0][3] == Approx(1.0).epsilon(1e-9));
    CHECK(record.modes[2].omega == Approx(0.5 * std::numbers::pi * std::sqrt(0.8 / 2e-2)).epsilon(1e-9));
    CHECK_THAT(record.modes[0].shape.words, Contains("bending about z"));
}

TEST_CASE("shapes have unit modal mass, and words by their strain energy", "[analyses]") {
    Section section = make_section({1e4, 4e3, 4e3, 8.0, 1.0, 9.0}, {1.0, 1.0, 1.0, 2e-2, 1e-2, 1e-2});
    Model model = make_rod_model(along_x, 1.0, {6, 3}, section);
    model.rods[0].name = "wing";
    clamp(model, 0);
    const System system(model);
    State state = system.initial_state();
    const ModesRecord record = find_modes(system, state, 0.0, {.count = 6});
    REQUIRE(record.modes.size() == 6);
    CHECK(record.modes[0].shape.words == "1st bending about y of wing");
    CHECK(record.modes[1].shape.words == "1st bending about z of wing");
    for (const Mode& mode : record.modes) {
        INFO(mode.shape.words);
        for (std::size_t i = 0; i < state.trial.size(); ++i) {
            state.trial[i].v = mode.shape.nodes[i].head<3>();
            state.trial[i].omega = mode.shape.nodes[i].tail<3>();
        }
        CHECK(2.0 * SystemMeasures(system).compute_kinetic_energy(state.trial) == Approx(1.0));
        CHECK(mode.shape.energy_shares[0].sum() == Approx(1.0));
        CHECK(mode.residual < 1e-8);
        double largest = 0.0;
        for (const Vec6& motion : mode.shape.nodes) {
            for (const double component : motion.head<3>())
                if (std::abs(component) > std::abs(largest)) largest = component;
        }
        CHECK(largest > -1e-9);
        CHECK(mode.frequency == Approx(mode.omega / cycle));
        double work =
            SystemValues(system).compute_strain_work(system.initial_state(), mode.shape.nodes)[0].sum();
        CHECK(work == Approx(mode.omega_squared));
    }
}

TEST_CASE("effective masses are those of a slender cantilever", "[analyses]") {
    // (∫φ)²/∫φ² of cosh λx − cos λx − σ (sinh λx − sin λx), λ = 1.875104, 4.694091, 7.854757.
    Model model =
        make_rod_model(along_x,
                       1.0,
                       {20, 3},
                       make_section({1e8, 1e8, 1e8, 50.0, 1.0, 1e4}, {2.0, 2.0, 2.0, 1e-8, 1e-8, 1e-8}));
    clamp(model, 0);
    const ModesRecord record = find_modes_at_rest(model, {.count = 3});
    REQUIRE(record.modes.size() == 3);
    CHECK(record.modes[0].effective_mass[2] == Approx(2.0 * 0.613075).epsilon(1e-4));
    CHECK(record.modes[1].effective_mass[2] == Approx(2.0 * 0.188300).epsilon(1e-4));
    CHECK(record.modes[2].effective_mass[2] == Approx(2.0 * 0.064736).epsilon(1e-4));
    CHECK(record.effective_share[2] == Approx(0.866111).epsilon(1e-4));
    CHECK(record.total_mass[2] == Approx(2.0));
    CHECK(record.total_mass[4] == Approx(2.0 / 3.0));
}

TEST_CASE("modes below a frequency, and all of a small model", "[analyses]") {
    Model model = make_rod_model(along_x, 1.0, {6, 3}, make_round_section());
    clamp(model, 0);
    const ModesRecord all = find_modes_at_rest(model, {.count = 12});
    REQUIRE(all.modes[5].frequency > 1.01 * all.modes[4].frequency);
    const double between = 0.5 * (all.modes[4].frequency + all.modes[5].frequency);
    const ModesRecord lower = find_modes_at_rest(model, {.count = 1, .below = between});
    CHECK(lower.modes.size() == 5);
    CHECK(lower.is_complete);
    CHECK(lower.limit == Approx(std::pow(cycle * between, 2)));
    // One element of order 1, its mass at the nodes: three displacements of the end and its rotations.
    Section section = make_round_section();
    section.mass.bottomRightCorner<3, 3>().setZero();
    Model small = make_rod_model(along_x, 1.0, {1, 1}, section);
    clamp(small, 0);
    const ModesRecord few = find_modes_at_rest(small, {.count = 10});
    CHECK(few.is_all);
    CHECK(few.is_complete);
    CHECK(few.modes.size() >= 3);
    CHECK(few.modes.size() <= 6);
}

TEST_CASE("without inertia there are no modes", "[analyses]") {
    Model model = make_rod_model(along_x, 1.0, {2, 1}, make_section({1e4, 4e3, 4e3, 0.8, 1.0, 1.0}));
    clamp(model, 0);
    CHECK(find_modes_at_rest(model, {}).failure == "nothing that moves has inertia");
}

TEST_CASE("modes of a column beyond its buckling load grow", "[analyses]") {
    Model model = make_rod_model(
        along_x, 1.0, {8, 3}, make_section({1e4, 4e3, 4e3, 80.0, 100.0, 1.0}, {1, 1, 1, 2e-2, 1e-2, 1e-2}));
    clamp(model, 0);
    add_ramp(model, last_node(model), {-3.0, 0.0, 0.0}, Vec3::Zero());
    const StaticRun run = run_static(model, make_static_settings(1));
    const System system(model);
    const ModesRecord record = find_modes(system, run.state, 1.0, {.count = 2});
    REQUIRE(record.modes.size() == 2);
    CHECK(record.is_complete);
    CHECK(record.unstable == 1);
    CHECK(record.modes[0].omega == 0.0);
    CHECK(record.modes[0].growth > 1.0);
    CHECK(record.modes[1].omega > 1.0);
    CHECK(record.is_symmetric);
}

TEST_CASE("modes say that a following load needs eigenvalues", "[analyses]") {
    Model model = make_rod_model(along_x, 1.0, {6, 3}, make_round_section());
    clamp(model, 0);
    add_ramp(model, last_node(model), {0.0, 0.0, -2.0}, Vec3::Zero(), Frame::follower);
    model.loads[0].key = "load[0]";
    const StaticRun run = run_static(model, make_static_settings(5));
    const System system(model);
    const ModesRecord record = find_modes(system, run.state, 1.0, {.count = 4});
    CHECK_FALSE(record.is_symmetric);
    CHECK(record.unsymmetry > 1e-3);
    CHECK_THAT(record.cause, Contains("load[0] follows its point"));
    // They are those of the symmetric part.
    const StateMatrices matrices = compute_state_matrices(system, run.state, 1.0);
    const Eigen::MatrixXd K = make_dense(system.pattern(), matrices.stiffness);
    const Eigen::VectorXd expected =
        find_symmetric_eigenvalues(0.5 * (K + K.transpose()), make_dense(system.pattern(), matrices.mass));
    for (int i = 0; i < 4; ++i) CHECK(record.modes[i].omega_squared == Approx(expected[i]).epsilon(1e-8));
    // Without its load the same state is out of balance, but symmetric.
    model.loads.clear();
    const System bare(model);
    CHECK(find_modes(bare, run.state, 1.0, {.count = 4}).is_symmetric);
}
