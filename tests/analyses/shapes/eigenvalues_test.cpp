// Eigenvalues as such; compared with references in eigenvalue_benchmarks_test.cpp.
#include "analyses/shapes/eigenvalues.hpp"

#include <algorithm>
#include <complex>

#include "analyses/shapes/modes.hpp"
#include "tools/catch.hpp"
#include "tools/dense_algebra.hpp"
#include "tools/rod_models.hpp"
#include "tools/static_run.hpp"

using namespace gxrod;
using namespace gxrod::tools;

namespace {

using Complex = std::complex<double>;

Section make_flexible_section() {
    Section section = make_section({1e3, 4e2, 4e2, 0.8, 1.0, 2.0}, {1.0, 1.0, 1.0, 2e-2, 1e-2, 1e-2});
    section.kelvin_voigt = 2e-3;
    section.mass_proportional = 0.1;
    return section;
}

// With Im λ ≥ 0, by |λ|.
std::vector<Complex> find_all(const SparsePattern& pattern, const StateMatrices& matrices) {
    std::vector<Complex> all = find_quadratic_eigenvalues(make_dense(pattern, matrices.stiffness),
                                                          make_dense(pattern, matrices.damping),
                                                          make_dense(pattern, matrices.mass));
    std::sort(all.begin(), all.end(), [](Complex a, Complex b) { return std::abs(a) < std::abs(b); });
    return all;
}

void check_against_dense(const EigenvaluesRecord& record, std::vector<Complex> all) {
    CHECK(record.is_complete);
    all.resize(record.modes.size());
    for (const Eigenmode& mode : record.modes) {
        const auto nearest = std::min_element(all.begin(), all.end(), [&](Complex a, Complex b) {
            return std::abs(a - mode.lambda()) < std::abs(b - mode.lambda());
        });
        CHECK(std::abs(*nearest - mode.lambda()) < 1e-9 * std::abs(mode.lambda()));
        all.erase(nearest);
        CHECK(mode.residual < 1e-8);
    }
}

}  // namespace

TEST_CASE("eigenvalues of damped rods under loads that follow are those of a dense solver", "[analyses]") {
    Model model = make_rod_model(along_x, 1.0, {3, 2}, make_flexible_section());
    clamp(model, 0);
    add_ramp(model, last_node(model), {-1.0, 4.0, -2.0}, {0.2, 0.0, 0.1}, Frame::follower);
    const StaticRun run = run_static(model, make_static_settings(4));
    const System system(model);
    const EigenvaluesRecord record = find_eigenvalues(system, run.state, 1.0, {.count = 8});
    REQUIRE(record.failure.empty());
    CHECK(record.modes.size() >= 8);
    check_against_dense(record, find_all(system.pattern(), compute_state_matrices(system, run.state, 1.0)));
}

TEST_CASE("undamped and symmetric, eigenvalues are the modes", "[analyses]") {
    Model model =
        make_rod_model(along_x,
                       1.0,
                       {6, 3},
                       make_section({1e4, 4e3, 4e3, 0.8, 1.0, 1.0}, {1.0, 1.0, 1.0, 2e-2, 1e-2, 1e-2}));
    model.rods[0].name = "shaft";
    clamp(model, 0);
    const System system(model);
    const State state = system.initial_state();
    const ModesRecord modes = find_modes(system, state, 0.0, {.count = 5});
    const EigenvaluesRecord record = find_eigenvalues(system, state, 0.0, {.count = 5});
    REQUIRE(record.modes.size() >= 5);
    CHECK(record.is_complete);
    CHECK(record.unstable == 0);
    for (std::size_t i = 0; i < 5; ++i) {
        const Eigenmode& mode = record.modes[i];
        CHECK(mode.omega == Approx(modes.modes[i].omega).epsilon(1e-9));
        CHECK(std::abs(mode.growth) < 1e-8 * mode.omega);
        CHECK(mode.damping_ratio == Approx(0.0).margin(1e-8));
        double energy = 0.0;
        for (const Vec6& shares : mode.shape.energy_shares) energy += shares.sum();
        CHECK(energy == Approx(1.0));
    }
    CHECK(record.modes[2].shape.words == "1st torsion of shaft");
    CHECK(record.modes[2].shape.words == modes.modes[2].shape.words);
}

TEST_CASE("shapes satisfy the equations of motion", "[analyses]") {
    Model model = make_rod_model(along_x, 1.0, {4, 2}, make_flexible_section());
    clamp(model, 0);
    add_ramp(model, last_node(model), {-1.0, 4.0, -2.0}, Vec3::Zero(), Frame::follower);
    const StaticRun run = run_static(model, make_static_settings(4));
    const System system(model);
    const EigenvaluesRecord record = find_eigenvalues(system, run.state, 1.0, {.count = 4, .left = true});
    const StateMatrices matrices = compute_state_matrices(system, run.state, 1.0);
    const Eigen::MatrixXd K = make_dense(system.pattern(), matrices.stiffness);
    const Eigen::MatrixXd D = make_dense(system.pattern(), matrices.damping);
    const Eigen::MatrixXd M = make_dense(system.pattern(), matrices.mass);
    const auto join = [&](const std::vector<Vec6>& real, const std::vector<Vec6>& imaginary) {
        Eigen::VectorXcd joined(system.pattern().size());
        joined.real() = gather(real, system.equations());
        joined.imag() = gather(imaginary, system.equations());
        return joined;
    };
    for (const Eigenmode& mode : record.modes) {
        const Complex lambda = mode.lambda();
        const Eigen::MatrixXcd Q = K + lambda * D + lambda * lambda * M;
        const Eigen::VectorXcd x = join(mode.shape.nodes, mode.imaginary);
        CHECK((Q * x).norm() < 1e-9 * K.norm() * x.norm());
        CHECK(x.dot(M * x).real() == Approx(1.0));
        REQUIRE(mode.left.size() == run.state.trial.size());
        const Eigen::VectorXcd y = join(mode.left, mode.left_imaginary);
        CHECK((y.transpose() * Q).norm() < 1e-9 * K.norm() * y.norm());
        CHECK(std::abs((y.transpose() * (2.0 * lambda * M + D) * x)(0) - 1.0) < 1e-9);
        Complex largest = 0.0;
        for (std::size_t i = 0; i < mode.imaginary.size(); ++i) {
            for (int k = 0; k < 3; ++k) {
                const Complex component(mode.shape.nodes[i][k], mode.imaginary[i][k]);
                if (std::abs(component) > std::abs(largest)) largest = component;
            }
        }
        CHECK(largest.real() > 0.0);
        CHECK(std::abs(largest.imag()) < 1e-5 * largest.real());
    }
}

TEST_CASE("a free rod has rigid motions next to its vibrations", "[analyses]") {
    const Model model =
        make_rod_model(along_x,
                       1.0,
                       {8, 3},
                       make_section({1e4, 4e3, 4e3, 0.8, 1.0, 1.0}, {1.0, 1.0, 1.0, 2e-2, 1e-2, 1e-2}));
    const System system(model);
    const ModesRecord modes = find_modes(system, system.initial_state(), 0.0, {.count = 9});
    const EigenvaluesRecord record = find_eigenvalues(system, system.initial_state(), 0.0, {.count = 14});
    CHECK(record.shift > 0.0);
    std::vector<double> vibrations;
    for (const Eigenmode& mode : record.modes) {
        if (std::abs(mode.lambda()) > 1e-3 * modes.modes[6].omega) vibrations.push_back(mode.omega);
    }
    REQUIRE(vibrations.size() >= 2);
    CHECK(vibrations[0] == Approx(modes.modes[6].omega).epsilon(1e-9));
    CHECK(vibrations[1] == Approx(modes.modes[7].omega).epsilon(1e-9));
    CHECK(record.unstable == 0);
}

TEST_CASE("a rod without rotary inertia, and one without any", "[analyses]") {
    Model model =
        make_rod_model(along_x, 1.0, {6, 3}, make_section({1e4, 4e3, 4e3, 0.8, 1.0, 2.0}, {1.0, 1.0, 1.0}));
    clamp(model, 0);
    const System system(model);
    const ModesRecord modes = find_modes(system, system.initial_state(), 0.0, {.count = 4});
    const EigenvaluesRecord record = find_eigenvalues(system, system.initial_state(), 0.0, {.count = 4});
    REQUIRE(record.modes.size() >= 4);
    CHECK(record.is_complete);
    for (std::size_t i = 0; i < 4; ++i)
        CHECK(record.modes[i].omega == Approx(modes.modes[i].omega).epsilon(1e-9));
    model.sections[0].mass.setZero();
    const System weightless(model);
    CHECK(find_eigenvalues(weightless, weightless.initial_state(), 0.0, {}).failure ==
          "nothing that moves has inertia");
}
