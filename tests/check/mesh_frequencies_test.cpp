#include "check/mesh_frequencies.hpp"

#include <fmt/format.h>
#include <numbers>

#include "assembly/system.hpp"
#include "integrators/load_stepping.hpp"
#include "tools/catch.hpp"
#include "tools/dense_algebra.hpp"
#include "tools/rod_models.hpp"

using namespace gxrod;
using namespace gxrod::tools;

namespace {

constexpr double cycle = 2.0 * std::numbers::pi;

// M1 of the field's cantilevers: length 1, 0.05 × 0.1, steel.
Section make_steel() {
    constexpr double E = 2.1e11, G = E / 2.6, rho = 7850.0, b = 0.05, h = 0.1;
    constexpr double A = b * h, Iy = b * h * h * h / 12.0, Iz = h * b * b * b / 12.0;
    return make_section({E * A, 5.0 / 6.0 * G * A, 5.0 / 6.0 * G * A, G * 2.8612e-6, E * Iy, E * Iz},
                        {rho * A, rho * A, rho * A, rho * (Iy + Iz), rho * Iy, rho * Iz});
}

Eigen::MatrixXd compute_dense_tangent(const System& system,
                                      const std::vector<NodeLinearization>& linearizations) {
    std::vector<double> values;
    system.compute_tangent(system.initial_state(), 0.0, linearizations, values);
    return make_dense(system.pattern(), values);
}

Eigen::VectorXd compute_all(const Model& model) {
    const System system(model);
    std::vector<NodeLinearization> linearizations(model.nodes.size());
    LoadStepping().linearize(system.initial_state(), {}, linearizations);
    const Eigen::MatrixXd K = compute_dense_tangent(system, linearizations);
    const Eigen::MatrixXd M = compute_dense_tangent(system, mass_linearizations(model.nodes.size()));
    return find_symmetric_eigenvalues(K, M);
}

}  // namespace

TEST_CASE("the lowest frequency of a Timoshenko cantilever", "[check]") {
    // By transfer matrices, 12 digits.
    Model model = make_rod_model(along_x, 1.0, {10, 3}, make_steel());
    clamp(model, 0);
    const auto found = find_mesh_frequencies(model);
    REQUIRE(found);
    CHECK(found->lowest / cycle == Approx(41.6927962022).epsilon(1e-6));
}

TEST_CASE("the frequencies of a mesh are its lowest and highest eigenvalues", "[check]") {
    for (const bool clamped : {true, false}) {
        INFO((clamped ? "clamped" : "free"));
        Model model = make_rod_model(along_x, 1.0, {6, 2}, make_steel());
        if (clamped) clamp(model, 0);
        const Eigen::VectorXd all = compute_all(model);
        const auto found = find_mesh_frequencies(model);
        REQUIRE(found);
        CHECK(found->lowest == Approx(std::sqrt(all[clamped ? 0 : 6])).epsilon(1e-5));
        CHECK(found->highest == Approx(std::sqrt(all[all.size() - 1])).epsilon(1e-5));
        CHECK(found->rigid_motions == (clamped ? 0 : 6));
        const std::string text = describe_frequencies(model, {});
        CHECK((text.find("(in addition to 6 of rigid motions)") != std::string::npos) == !clamped);
    }
}

TEST_CASE("loads and initial velocities do not change a mesh's frequencies", "[check]") {
    Model model = make_rod_model(along_x, 1.0, {4, 1}, make_steel());
    clamp(model, 0);
    const auto bare = find_mesh_frequencies(model);
    NodalLoad load;
    load.node = last_node(model);
    load.frame = Frame::body;
    load.force = {1e9, 1e8, 0.0};
    load.moment = {0.0, 1e9, 0.0};
    model.loads.push_back(load);
    DistributedLoad distributed;
    distributed.frame = Frame::follower;
    distributed.force[1] = LineFunction(1e9);
    model.distributed_loads.push_back(distributed);
    model.gravity = TimeVector(Vec3(0.0, 0.0, -1e6));
    model.nodes[2].angular_velocity = Vec3(1e5, 0.0, 0.0);
    const auto loaded = find_mesh_frequencies(model);
    REQUIRE((bare && loaded));
    CHECK(loaded->lowest == bare->lowest);
    CHECK(loaded->highest == bare->highest);
}

TEST_CASE("a motion without inertia has no frequency", "[check]") {
    Section section = make_steel();
    section.mass(3, 3) = 0.0;
    Model model = make_rod_model(along_x, 1.0, {4, 1}, section);
    clamp(model, 0);
    CHECK_FALSE(find_mesh_frequencies(model));
}

TEST_CASE("damping ratios and the longest explicit step are printed", "[check]") {
    Model model = make_rod_model(along_x, 1.0, {4, 1}, make_steel());
    clamp(model, 0);
    model.sections[0].name = "bar";
    DynamicSettings settings;
    settings.end_time = 1.0;
    settings.steps = 100;
    const auto found = find_mesh_frequencies(model);
    REQUIRE(found);
    CHECK_THAT(describe_frequencies(model, settings), !Catch::Contains("damping"));
    settings.scheme = Scheme::sdirk_4;
    CHECK_THAT(describe_frequencies(model, settings),
               Catch::Contains("sdirk-4 with these steps does not resolve"));
    settings.steps = 1'000'000;
    CHECK_THAT(describe_frequencies(model, settings), !Catch::Contains("sdirk-4"));
    settings.steps = 100;
    // Half of critical at the lowest.
    model.sections[0].kelvin_voigt = 1.0 / found->lowest;
    settings.scheme = Scheme::runge_kutta_4;
    const std::string text = describe_frequencies(model, settings);
    INFO(text);
    CHECK_THAT(text, Catch::Contains("damping of section bar: 0.5 of critical at the lowest"));
    CHECK_THAT(text, Catch::Contains("stable up to time steps of "));
    CHECK_THAT(text, Catch::Contains("this deck's, 0.01, will fail"));
    // Of real rates, 2.785 over the largest: with ζ = ½ω/ω₁ at the highest, ω(ζ + √(ζ² − 1)).
    const double zeta = 0.5 * found->highest / found->lowest;
    const double rate = found->highest * (zeta + std::sqrt(zeta * zeta - 1.0));
    CHECK_THAT(text, Catch::Contains(fmt::format("up to time steps of {:.3g}:", 2.785293563 / rate)));
    model.sections[0].kelvin_voigt = 0.0;
    CHECK_THAT(describe_frequencies(model, settings),
               Catch::Contains(
                   fmt::format("up to time steps of {:.3g}:", 2.0 * std::numbers::sqrt2 / found->highest)));
    settings.steps = 100'000'000;
    CHECK_THAT(describe_frequencies(model, settings), !Catch::Contains("will fail"));
}
