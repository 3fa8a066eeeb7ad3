// Water, air and the ground around whole models.

#include <span>

#include "assembly/lanes/rod_element_weights.hpp"
#include "assembly/sample_model.hpp"
#include "assembly/surroundings_assembly.hpp"
#include "assembly/system_measures.hpp"
#include "integrators/generalized_alpha.hpp"
#include "integrators/load_stepping.hpp"
#include "integrators/newmark_simplified.hpp"
#include "solvers/difference_tangent.hpp"
#include "solvers/trial_rates.hpp"
#include "state/bed_contact.hpp"
#include "tools/catch.hpp"
#include "tools/dense_algebra.hpp"
#include "tools/difference.hpp"

using namespace gxrod;
using namespace gxrod::tools;

namespace {

constexpr double now = 0.7;
const Stage stage{0, 0.6, 0.1, now};

std::span<double> numbers_at(std::size_t contact, State& state) {
    return std::span(state.memory).subspan(numbers_of_bed_contact * contact, numbers_of_bed_contact);
}

SectionInFluid make_section_in_fluid() {
    SectionInFluid fluid;
    fluid.area = 0.03;
    fluid.diameter = 0.2;
    fluid.drag = {0.1, 1.2, 0.7};
    fluid.added_mass = {0.2, 1.0, 0.6};
    return fluid;
}

// Water that flows with a wave on it, its surface across the rod; wind above.
void surround_with_fluids(Model& model, double surface) {
    Water water;
    water.density = 20.0;
    water.surface = surface;
    water.depth = 8.0;
    water.current.profile = SpeedProfile{{-4.0, 0.0, 3.0}, {0.3, 0.6, 1.1}, Vec3(0.6, 0.8, 0.0), {}};
    // Steady: gradients of rates of functions are left out of tangents.
    water.current.field = [](double, const Vec3& r) {
        return Vec3(0.1 * r.y(), 0.2 * std::sin(r.x()), 0.1 * r.z());
    };
    water.waves = {{.amplitude = 0.3, .frequency = 1.7, .number = 0.34, .direction = 0.4, .phase = 0.2}};
    water.ramp = 2.0;
    Air air;
    air.density = 1.2;
    air.wind.field = [](double, const Vec3& r) { return Vec3(3.0 + 0.3 * r.z(), 0.4, 0.0); };
    model.surroundings.water = water;
    model.surroundings.air = air;
    for (Section& section : model.sections) section.fluid = make_section_in_fluid();
    for (Body& body : model.bodies) {
        BodyInFluid fluid;
        fluid.volume = 0.05;
        fluid.centre = {0.1, -0.2, 0.05};
        fluid.height = 0.8;
        fluid.drag_area = {0.2, 0.3, 0.1};
        fluid.added_mass = RandomValues(5).positive_definite<6>();
        body.fluid = fluid;
    }
}

// A slope in which part of the model lies, and rubs.
void put_on_ground(Model& model, double z) {
    Seabed seabed;
    seabed.point = {0.0, 0.0, z};
    seabed.normal = Vec3(0.2, -0.1, 1.0).normalized();
    seabed.stiffness = 50.0;
    seabed.damping = 3.0;
    seabed.axial_friction = 0.4;
    seabed.lateral_friction = 0.7;
    seabed.friction_stiffness = 40.0;
    model.surroundings.seabed = seabed;
    for (Section& section : model.sections) section.fluid = make_section_in_fluid();
}

double middle_height(const Model& model) {
    double sum = 0.0;
    for (const Node& node : model.nodes) sum += node.position.z();
    return sum / static_cast<double>(model.nodes.size());
}

void check_tangent(const System& system, const Integrator& integrator, State state) {
    integrator.start(state);
    update_trial_rates(system, integrator, stage, state);
    std::vector<NodeLinearization> linearizations(state.trial.size());
    integrator.linearize(state, stage, linearizations);
    std::vector<double> values, differences;
    system.compute_tangent(state, now, linearizations, values);
    DifferenceTangent(system).compute(integrator, stage, state, differences);
    CHECK(relative_difference(make_dense(system.pattern(), values),
                              make_dense(system.pattern(), differences)) < 1e-7);
}

void check_tangents(const Model& model) {
    const System system(model);
    REQUIRE(system.traits().has_surroundings);
    for (const unsigned seed : {1U, 2U}) {
        State state = make_turned_state(system, seed);
        for (std::size_t i = 0; numbers_of_bed_contact * i < state.memory.size(); i += 2)
            write({1.0, state.trial[i].r + RandomValues(seed).vector(0.05)}, numbers_at(i, state));
        check_tangent(system, LoadStepping(), state);
        check_tangent(system, NewmarkSimplified({0.25, 0.5}), state);
        check_tangent(system, GeneralizedAlpha(0.5), state);
    }
}

}  // namespace

TEST_CASE("Tangents of models in water, in wind and on the ground are derivatives of the residual",
          "[assembly][surroundings]") {
    for (const ElementKind kind : {ElementKind::objective, ElementKind::simo}) {
        for (int order = 1; order <= 4; ++order) {
            INFO((kind == ElementKind::simo ? "simo" : "objective") << ", order " << order);
            Model model = make_turned_model(kind, order);
            const double middle = middle_height(model);
            surround_with_fluids(model, middle);
            check_tangents(model);
            put_on_ground(model, middle);
            check_tangents(model);
            model.surroundings.water->factor = TimeFunction([](double t) { return 0.3 + t; });
            model.surroundings.seabed->factor = TimeFunction([](double t) { return 1.7 * t; });
            check_tangents(model);
        }
    }
}

TEST_CASE("A rod under water weighs less by what it displaces", "[assembly][surroundings]") {
    for (int order = 1; order <= 4; ++order) {
        Model model = make_turned_model(ElementKind::objective, order);
        Water water;
        water.density = 1025.0;
        model.surroundings.water = water;
        model.sections[0].fluid = make_section_in_fluid();
        model.gravity = Vec3(0.3, -0.4, -9.81);
        const System system(model);
        const State state = system.initial_state();
        Vec3 force = Vec3::Zero();
        for (const Vec6& of_node : SystemMeasures(system).compute_surrounding_forces(state, 0.0))
            force += of_node.head<3>();
        double length = 0.0;
        for (int e = 0; e < model.rods[0].element_count(); ++e) {
            for (const double of_node : compute_element_weights(model, model.rods[0], e).lengths)
                length += of_node;
        }
        CHECK(length == Approx(model.rods[0].length).epsilon(0.03));
        const Vec3 expected = -1025.0 * 0.03 * length * model.gravity(0.0);
        CHECK(relative_difference(force, expected) < 1e-12);
    }
}

TEST_CASE("A factor of water is one of its density, a factor of the ground one of its forces",
          "[assembly][surroundings]") {
    Model model = make_turned_model(ElementKind::objective, 2);
    surround_with_fluids(model, middle_height(model));
    const auto forces_of = [](const Model& around) {
        const System system(around);
        State state = make_turned_state(system, 3);
        update_trial_rates(system, NewmarkSimplified({0.25, 0.5}), stage, state);
        return SystemMeasures(system).compute_surrounding_forces(state, now);
    };
    const auto difference = [](const std::vector<Vec6>& a, const std::vector<Vec6>& b, double factor) {
        double largest = 0.0, size = 0.0;
        for (std::size_t i = 0; i < a.size(); ++i) {
            largest = std::max(largest, (a[i] - factor * b[i]).norm());
            size = std::max(size, a[i].norm());
        }
        return largest / size;
    };
    Model denser = model;
    denser.surroundings.water->density *= 0.35;
    model.surroundings.water->factor = TimeFunction([](double t) { return 0.5 * t; });  // 0.35 now
    CHECK(difference(forces_of(model), forces_of(denser), 1.0) < 1e-14);
    // Where there is no water, there is air.
    Model dry = model;
    dry.surroundings.water.reset();
    model.surroundings.water->factor = TimeFunction(0.0);
    CHECK(difference(forces_of(model), forces_of(dry), 1.0) < 1e-14);

    Model lying = make_turned_model(ElementKind::objective, 2);
    put_on_ground(lying, middle_height(lying));
    const std::vector<Vec6> whole = forces_of(lying);
    lying.surroundings.seabed->factor = TimeFunction([](double t) { return t; });
    CHECK(difference(forces_of(lying), whole, now) < 1e-14);
    lying.surroundings.seabed->factor = TimeFunction(0.0);
    for (const Vec6& force : forces_of(lying)) CHECK(force.isZero(0.0));
}

TEST_CASE("Ground that is not there forgets what lay on it", "[assembly][surroundings]") {
    Model model = make_turned_model(ElementKind::objective, 2);
    put_on_ground(model, middle_height(model));
    const auto commit_in = [&](double factor) {
        model.surroundings.seabed->factor = TimeFunction(factor);
        const System system(model);
        State state = make_turned_state(system, 3);
        for (std::size_t i = 0; numbers_of_bed_contact * i < state.memory.size(); ++i)
            write({1.0, state.trial[i].r}, numbers_at(i, state));
        system.commit(state, now);
        bool touches = false;
        for (std::size_t i = 0; numbers_of_bed_contact * i < state.memory.size(); ++i)
            touches = touches || read_bed_contact(numbers_at(i, state)).touches;
        return touches;
    };
    CHECK(commit_in(1.0));
    CHECK_FALSE(commit_in(0.0));
}

TEST_CASE("Water and the ground act from outside", "[assembly][surroundings]") {
    Model model = make_turned_model(ElementKind::objective, 2);
    const System dry(model);
    surround_with_fluids(model, middle_height(model));
    put_on_ground(model, middle_height(model));
    const System system(model);
    const State state = make_turned_state(system, 3);
    const std::vector<Vec6> none(model.nodes.size(), Vec6::Zero());
    const Resultant without = SystemMeasures(dry).compute_outer_resultant(state, now, none);
    const Resultant with = SystemMeasures(system).compute_outer_resultant(state, now, none);
    Vec3 force = Vec3::Zero(), moment = Vec3::Zero();
    const std::vector<Vec6> forces = SystemMeasures(system).compute_surrounding_forces(state, now);
    for (std::size_t i = 0; i < forces.size(); ++i) {
        force += forces[i].head<3>();
        moment += forces[i].tail<3>() + state.trial[i].r.cross(forces[i].head<3>());
    }
    CHECK(force.norm() > 1.0);
    CHECK((with.force - without.force - force).norm() < 1e-12 * force.norm());
    CHECK((with.moment - without.moment - moment).norm() < 1e-12 * moment.norm());
}

TEST_CASE("The number of threads changes no force of water and no tangent", "[assembly][surroundings]") {
    Model model = make_turned_model(ElementKind::objective, 3);
    surround_with_fluids(model, middle_height(model));
    const ThreadTeam team(3);
    const System one(model);
    const System several(model, team);
    State state = make_turned_state(one, 4);
    update_trial_rates(one, NewmarkSimplified({0.25, 0.5}), stage, state);
    CHECK(SystemMeasures(one).compute_surrounding_forces(state, now) ==
          SystemMeasures(several).compute_surrounding_forces(state, now));
    std::vector<NodeLinearization> linearizations(state.trial.size());
    NewmarkSimplified({0.25, 0.5}).linearize(state, stage, linearizations);
    std::vector<double> a, b;
    one.compute_tangent(state, now, linearizations, a);
    several.compute_tangent(state, now, linearizations, b);
    CHECK(a == b);
}

TEST_CASE("What has been asked for before changes no force of water", "[assembly][surroundings]") {
    Model model = make_turned_model(ElementKind::objective, 2);
    surround_with_fluids(model, middle_height(model));
    const System used(model);
    const State state = make_turned_state(used, 4);
    const State other = make_turned_state(used, 5);
    SystemMeasures(used).compute_surrounding_forces(other, now);
    SystemMeasures(used).compute_surrounding_forces(state, 0.3);
    CHECK(SystemMeasures(used).compute_surrounding_forces(state, now) ==
          SystemMeasures(System(model)).compute_surrounding_forces(state, now));
}

TEST_CASE("A commit alone moves where friction pulls to", "[assembly][surroundings]") {
    Model model = make_turned_model(ElementKind::objective, 1);
    put_on_ground(model, middle_height(model) + 5.0);  // all of it is in the ground
    const System system(model);
    State state = make_turned_state(system, 6);
    REQUIRE(state.memory.size() == numbers_of_bed_contact * model.nodes.size());
    std::vector<NodeLinearization> linearizations(state.trial.size());
    LoadStepping().linearize(state, stage, linearizations);
    Residual residual;
    std::vector<double> values;
    system.compute_residual(state, now, residual);
    system.compute_tangent(state, now, linearizations, values);
    for (const double number : state.memory) CHECK(number == 0.0);
    system.commit(state, now);
    for (std::size_t i = 0; i < model.nodes.size(); ++i) {
        const BedContact contact = read_bed_contact(numbers_at(i, state));
        CHECK(contact.touches == 1.0);
        CHECK((contact.target - state.trial[i].r).norm() < 1e-12);
    }
}

TEST_CASE("Without inertia a current pushes by its speed alone", "[assembly][surroundings]") {
    Model model = make_turned_model(ElementKind::objective, 1);
    Water water;
    water.density = 1000.0;
    water.current.field = [](double time, const Vec3&) { return Vec3(0.2 * time, 0.0, 0.0); };
    model.surroundings.water = water;
    model.sections[0].fluid = make_section_in_fluid();
    model.gravity = Vec3(0.0, 0.0, 0.0);
    const auto force_of = [&](bool has_inertia, double area, bool has_time = true) {
        model.has_inertia = has_inertia;
        model.has_time = has_time;
        model.sections[0].fluid->area = area;
        const System system(model);
        Vec3 force = Vec3::Zero();
        for (const Vec6& one : SystemMeasures(system).compute_surrounding_forces(system.initial_state(), 0.5))
            force += one.head<3>();
        return force;
    };
    const Vec3 still = force_of(false, 0.03);
    CHECK(still.norm() > 1e-3);
    CHECK((still - force_of(true, 0.0)).norm() < 1e-12 * still.norm());
    CHECK((still - force_of(true, 0.03, false)).norm() < 1e-12 * still.norm());
    CHECK((still - force_of(true, 0.03)).norm() > 1.0);
}
