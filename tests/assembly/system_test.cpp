#include "assembly/system.hpp"
#include "assembly/system_measures.hpp"
#include "assembly/system_values.hpp"

#include <numbers>

#include "assembly/sample_model.hpp"
#include "integrators/newmark_simplified.hpp"
#include "loads/nodal_load.hpp"
#include "rotation/rotation_map.hpp"
#include "solvers/difference_tangent.hpp"
#include "solvers/trial_rates.hpp"
#include "state/increment.hpp"
#include "tools/catch.hpp"
#include "tools/dense_algebra.hpp"
#include "tools/difference.hpp"

using namespace gxrod;
using namespace gxrod::tools;

namespace {

constexpr double now = 0.7;

// Adds what one element asks of its nodes; histories follow each other in the order of rod elements.
template <class E>
void add_element(
    const E& element, const Model& model, const State& state, int history, std::vector<Vec6>& nodal) {
    constexpr int nodes = E::node_count;
    Motions<nodes> motions;
    for (int i = 0; i < nodes; ++i) motions[i] = &state.trial[element.nodes[i]];
    NodalVector<nodes> force = NodalVector<nodes>::Zero();
    element.add_internal_force(motions, {.axes = {state.sections.data() + history, E::history_count}}, force);
    element.add_inertial_force(motions, model.gravity(0.0), force);
    for (int i = 0; i < nodes; ++i) nodal[element.nodes[i]] += force.template segment<6>(6 * i);
}

std::vector<SimoElement<2>> make_elements(const Model& model) {
    std::vector<SimoElement<2>> elements;
    const Rod& rod = model.rods[0];
    for (int e = 0; e < rod.element_count(); ++e) {
        elements.emplace_back(RodElementGeometry<2>{{rod.nodes[e], rod.nodes[e + 1]},
                                                    {model.nodes[rod.nodes[e]].position,
                                                     model.nodes[rod.nodes[e + 1]].position},
                                                    {rod.triads[2 * e], rod.triads[2 * e + 1]}},
                              model.sections[0]);
    }
    return elements;
}

// A straight rod along x of four elements with a diagonal stiffness, alone.
Model make_straight_rod() {
    Model model;
    model.sections.push_back({"tube", Mat6::Zero(), Mat6::Identity()});
    model.sections[0].stiffness.diagonal() << 10.0, 20.0, 30.0, 1.0, 2.0, 3.0;
    Rod rod;
    rod.kind = ElementKind::simo;
    for (int i = 0; i <= 4; ++i) {
        model.nodes.push_back({"node", Vec3(0.5 * i, 0.0, 0.0)});
        rod.nodes.push_back(i);
    }
    set_line_elements(rod, {0.0, 0.5, 1.0, 1.5, 2.0}, std::vector<Quat>(5, Quat::Identity()));
    model.rods.push_back(rod);
    return model;
}

}  // namespace

TEST_CASE("the initial state is the model's reference shape and velocities", "[assembly]") {
    const Model model = make_sample_model();
    const System system(model);
    const State state = system.initial_state();
    REQUIRE(state.trial.size() == model.nodes.size());
    CHECK(state.sections.size() == 3);
    for (std::size_t i = 0; i < model.nodes.size(); ++i) {
        CHECK(state.trial[i].r == model.nodes[i].position);
        CHECK(state.trial[i].Lambda.isApprox(Quat::Identity(), 0.0));
        CHECK(state.trial[i].theta.isZero(0.0));
        CHECK(state.trial[i].a.isZero(0.0));
        CHECK(state.trial[i].alpha.isZero(0.0));
        CHECK(state.previous[i].v == state.trial[i].v);
        CHECK(state.previous[i].omega == state.trial[i].omega);
    }
    CHECK(state.trial[1].v == model.nodes[1].velocity);
    CHECK(state.trial[1].omega == model.nodes[1].angular_velocity);
    CHECK(SystemMeasures(system).compute_balance(state, state.time).strain_energy < 1e-28);
    for (const SectionHistory& history : state.sections) CHECK(history.K.isZero(0.0));
}

TEST_CASE("supported components start at rest whatever velocity the model names", "[assembly]") {
    const Model model = make_sample_model();
    const State state = System(model).initial_state();
    CHECK(state.trial[0].v.isZero(0.0));  // the ball joint
    CHECK(state.trial[0].omega == model.nodes[0].angular_velocity);
    CHECK(state.trial[lone_node].v == model.nodes[lone_node].velocity);
    CHECK(state.trial[lone_node].omega == Vec3(0.0, 0.0, model.nodes[lone_node].angular_velocity.z()));
}

TEST_CASE("the residual is the sum over elements less loads", "[assembly]") {
    const Model model = make_sample_model();
    const System system(model);
    State state = make_sample_state(system, 1);
    NewmarkSimplified({0.25, 0.5}).update_rates(state, {0, 0.6, 0.1, 0.7});
    std::vector<Vec6> expected(model.nodes.size(), Vec6::Zero());
    for (const Body& body : model.bodies) add_element(RigidBody(body), model, state, 0, expected);
    int history = 0;
    for (const auto& element : make_elements(model)) add_element(element, model, state, history++, expected);
    double largest_force = 0.0;
    for (const NodalLoad& load : model.loads) {
        const Vec6 value = compute_load(load, state.trial[load.node], now);
        expected[load.node] -= value;
        largest_force = std::max(largest_force, value.head<3>().lpNorm<Eigen::Infinity>());
    }
    Residual residual;
    system.compute_residual(state, now, residual);
    for (std::size_t i = 0; i < expected.size(); ++i) {
        CHECK(relative_difference(residual.nodal[i], expected[i]) < 1e-14);
    }
    CHECK(residual.force_scale >= largest_force);
    CHECK(residual.moment_scale > 0.0);
}

TEST_CASE("the assembled tangent is the derivative of the residual", "[assembly]") {
    const Model model = make_sample_model();
    const System system(model);
    const NewmarkSimplified scheme({0.25, 0.5});
    const Stage stage{0, 0.6, 0.1, now};
    for (unsigned seed = 1; seed <= 3; ++seed) {
        State state = make_sample_state(system, seed);
        update_trial_rates(system, scheme, stage, state);
        std::vector<NodeLinearization> linearizations(state.trial.size());
        scheme.linearize(state, stage, linearizations);
        std::vector<double> values, differences;
        system.compute_tangent(state, now, linearizations, values);
        DifferenceTangent(system).compute(scheme, stage, state, differences);
        const auto tangent = make_dense(system.pattern(), values);
        CHECK(relative_difference(tangent, make_dense(system.pattern(), differences)) < 1e-8);
        // Without inertia, so that stiffness and loads are not small in the sum.
        for (NodeLinearization& linearization : linearizations)
            linearization = {1.0, 0.0, 0.0, Mat3::Zero(), Mat3::Zero()};
        system.compute_tangent(state, now, linearizations, values);
        const auto stiffness = make_dense(system.pattern(), values);
        for (std::int64_t column = 0; column < stiffness.cols(); ++column) {
            const EquationNumbers::Unknown unknown = system.equations().unknown(column);
            const Eigen::VectorXd expected = differentiate([&](double amount) {
                State moved = state;
                const Vec6 step = amount * Vec6::Unit(unknown.component);
                apply_spin(
                    state.previous[unknown.node], step.head<3>(), step.tail<3>(), moved.trial[unknown.node]);
                Residual residual;
                system.compute_residual(moved, now, residual);
                return gather(residual.nodal, system.equations());
            });
            CHECK((stiffness.col(column) - expected).norm() < 1e-9 * stiffness.norm());
        }
    }
}

TEST_CASE("energies and momenta are sums over elements", "[assembly]") {
    const Model model = make_sample_model();
    const System system(model);
    const State state = make_sample_state(system, 4);
    Balance expected;
    const auto add = [&](const auto& element, int history) {
        constexpr int nodes = std::remove_cvref_t<decltype(element)>::node_count;
        Motions<nodes> motions;
        for (int i = 0; i < nodes; ++i) motions[i] = &state.trial[element.nodes[i]];
        expected.kinetic_energy += element.kinetic_energy(motions);
        expected.gravity_potential += element.gravity_potential(motions, model.gravity(0.0));
        expected.strain_energy +=
            element.strain_energy(motions, {.axes = {state.sections.data() + history, 1}});
        expected.momentum.linear += element.momentum(motions).linear;
        expected.momentum.angular += element.momentum(motions).angular;
    };
    for (const Body& body : model.bodies) add(RigidBody(body), 0);
    int history = 0;
    for (const auto& element : make_elements(model)) add(element, history++);
    const Balance balance = SystemMeasures(system).compute_balance(state, state.time);
    CHECK(relative_difference(balance.kinetic_energy, expected.kinetic_energy) < 1e-14);
    CHECK(relative_difference(balance.strain_energy, expected.strain_energy) < 1e-14);
    CHECK(relative_difference(balance.gravity_potential, expected.gravity_potential) < 1e-14);
    CHECK(relative_difference(balance.momentum.linear, expected.momentum.linear) < 1e-14);
    CHECK(relative_difference(balance.momentum.angular, expected.momentum.angular) < 1e-14);
}

TEST_CASE("a committed step is where the next one starts", "[assembly]") {
    const Model model = make_sample_model();
    const System system(model);
    State state = make_sample_state(system, 5);
    const auto trial = state.trial;
    const double strain_energy = SystemMeasures(system).compute_balance(state, state.time).strain_energy;
    system.commit(state, 0.3);
    CHECK(state.time == 0.3);
    for (std::size_t i = 0; i < trial.size(); ++i) {
        CHECK(state.previous[i].r == trial[i].r);
        CHECK(state.previous[i].Lambda.angularDistance(trial[i].Lambda) < 1e-15);
        CHECK(state.previous[i].omega == trial[i].omega);
        CHECK(state.trial[i].theta.isZero(0.0));
        CHECK(state.previous[i].theta.isZero(0.0));
    }
    CHECK(relative_difference(SystemMeasures(system).compute_balance(state, state.time).strain_energy,
                              strain_energy) < 1e-13);
}

TEST_CASE("section values are those of a stretched and bent rod, element by element", "[assembly]") {
    const Model model = make_straight_rod();
    const System system(model);
    State state = system.initial_state();
    // Element e stretched by 0.1 e; the nodes turned about z by the square of their number.
    double x = 0.0;
    for (int i = 0; i <= 4; ++i) {
        place(state.previous[i], Vec3(x, 0.0, 0.0), Vec3(0.02 * i * i, 0.0, 0.0), state.trial[i]);
        x += 0.5 * (1.0 + 0.1 * i);
    }
    const auto values = SystemValues(system).compute_section_values(state);
    REQUIRE(values.size() == 4);
    for (int e = 0; e < 4; ++e) {
        const double twist = 0.02 * (2 * e + 1) / 0.5;
        CHECK((values[e].strain - Vec3(0.1 * e, 0.0, 0.0)).norm() < 1e-14);
        CHECK((values[e].curvature - Vec3(twist, 0.0, 0.0)).norm() < 1e-14);
        CHECK((values[e].force - Vec3(e, 0.0, 0.0)).norm() < 1e-13);
        CHECK((values[e].moment - Vec3(twist, 0.0, 0.0)).norm() < 1e-13);
        const Quat middle = exp_quaternion(Vec3(0.01 * (e * e + (e + 1) * (e + 1)), 0.0, 0.0));
        CHECK(values[e].axes.angularDistance(middle) < 1e-15);
    }
    // A quarter of a circle of the same length, about z: K = π/2 / L.
    const double angle = std::numbers::pi / 8.0;
    for (int i = 0; i <= 4; ++i)
        place(state.previous[i], Vec3::Zero(), Vec3(0.0, 0.0, i * angle), state.trial[i]);
    for (const SectionValues& value : SystemValues(system).compute_section_values(state)) {
        CHECK((value.moment - Vec3(0.0, 0.0, 3.0 * angle / 0.5)).norm() < 1e-13);
    }
}

TEST_CASE("the length scale is the model's extent or its bodies' size", "[assembly]") {
    CHECK(System(make_straight_rod()).length_scale() == Approx(2.0).epsilon(1e-15));
    Model point;
    point.nodes.push_back({"top", Vec3(5.0, 0.0, 0.0)});
    CHECK(System(point).length_scale() == 1.0);
    point.bodies.push_back({"top", 0, 4.0, Mat3::Identity() * 3.0});
    CHECK(System(point).length_scale() == Approx(1.5).epsilon(1e-15));  // √(9/4)
    point.bodies[0].centre_of_mass = Vec3(0.0, 0.0, 7.0);
    CHECK(System(point).length_scale() == Approx(7.0).epsilon(1e-15));
}

TEST_CASE("elements and equations of a model are counted", "[assembly]") {
    const Model model = make_sample_model();
    const System system(model);
    CHECK(SystemMeasures(system).count_elements() == 5);
    CHECK(system.equations().count() == 5 * 6 - 3 - 2);
}

TEST_CASE("a residual is measured against terms that do not cancel", "[assembly]") {
    // A free body in torque-free motion: J α and ω × J ω balance each other and are its only moments.
    Model model;
    model.nodes.push_back({"body", Vec3::Zero()});
    model.bodies.push_back({"body", 0, 2.0, Vec3(1.0, 2.0, 4.0).asDiagonal()});
    model.gravity = Vec3(0.0, 0.0, -10.0);
    const System system(model);
    State state = system.initial_state();
    state.trial[0].omega = Vec3(1.0, 1.0, 1.0);
    state.trial[0].alpha = Vec3(-2.0, 1.5, -0.25);
    state.trial[0].a = model.gravity(0.0);
    Residual residual;
    system.compute_residual(state, 0.0, residual);
    CHECK(residual.nodal[0].norm() < 1e-14);
    CHECK(residual.moment_scale == Approx(3.0).epsilon(1e-14));
    CHECK(residual.force_scale == Approx(20.0).epsilon(1e-14));
}
