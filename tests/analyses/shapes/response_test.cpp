#include "analyses/shapes/response.hpp"

#include <complex>

#include "tools/catch.hpp"
#include "tools/rod_models.hpp"
#include "tools/static_run.hpp"

using namespace gxrod;
using namespace gxrod::tools;

namespace {

using Complex = std::complex<double>;

Complex component(const ComplexVectors& vectors, int node, int index) {
    return {vectors.real[static_cast<std::size_t>(node)][index],
            vectors.imaginary[static_cast<std::size_t>(node)][index]};
}

ComplexVectors make_excitation(const Model& model, int node, int index, Complex force) {
    ComplexVectors excitation;
    excitation.real.assign(model.nodes.size(), Vec6::Zero());
    excitation.imaginary = excitation.real;
    excitation.real[static_cast<std::size_t>(node)][index] = force.real();
    excitation.imaginary[static_cast<std::size_t>(node)][index] = force.imag();
    return excitation;
}

Section make_damped_section() {
    Section section = make_section({1e4, 4e3, 4e3, 1.0, 1.0, 1.0}, {1.0, 1.0, 1.0, 2e-4, 1e-4, 1e-4});
    section.kelvin_voigt = 2e-3;
    section.mass_proportional = 0.2;
    return section;
}

}  // namespace

TEST_CASE("P14: the response of a damped cantilever", "[analyses]") {
    struct Row {
        double omega;
        Complex tip;
        int elements = 24;
    };
    // At the resonance, where round-off counts ten times, more elements only add to that.
    for (const Row& row : {Row{1.0, {0.362007553023, -0.00699954965397}},
                           Row{3.5, {0.598289070683, -5.01245392834}, 6},
                           Row{10.0, {-0.033541491529, -0.00151909162518}},
                           Row{21.9, {-0.00397379657242, -0.156320615066}},
                           Row{60.0, {0.00010679361073, -0.00826718031826}}}) {
        INFO("omega = " << row.omega);
        Model model = make_rod_model(along_x, 1.0, {row.elements, 4}, make_damped_section());
        clamp(model, 0);
        const System system(model);
        const ComplexVectors excitation = make_excitation(model, last_node(model), 1, 1.0);
        const Response response =
            find_response(system, system.initial_state(), 0.0, {row.omega}, excitation).responses.at(0);
        REQUIRE(response.failure.empty());
        const Complex tip = component(response.motion, last_node(model), 1);
        CHECK(std::abs(tip - row.tip) < 1e-9 * std::abs(row.tip));
        CHECK(response.error < 1e-7);
        if (row.omega != 3.5) continue;
        // What the support exerts: against the rod's own.
        const Complex moment(2.047754625, -17.59198733);
        CHECK(std::abs(component(response.reactions, 0, 5) + moment) < 1e-9 * std::abs(moment));
    }
}

TEST_CASE("the answer at no frequency is the static one, about a bent state too", "[analyses]") {
    Model model = make_rod_model(along_x, 1.0, {4, 3}, make_damped_section());
    clamp(model, 0);
    Model pushed = model;
    add_ramp(model, last_node(model), {-1.0, 0.0, -2.0}, Vec3::Zero());
    add_ramp(pushed, last_node(model), {-1.0, 1e-5, -2.0}, Vec3::Zero());
    const StaticRun run = run_static(model, make_static_settings(2));
    const StaticRun more = run_static(pushed, make_static_settings(2));
    const System system(model);
    const ComplexVectors excitation = make_excitation(model, last_node(model), 1, 1.0);
    const Response response = find_response(system, run.state, 1.0, {0.0}, excitation).responses.at(0);
    CHECK(component(response.motion, last_node(model), 1).real() ==
          Approx((more.tip().r[1] - run.tip().r[1]) / 1e-5).epsilon(1e-6));
    CHECK(component(response.reactions, 0, 1).real() == Approx(-1.0).epsilon(1e-9));
}

TEST_CASE("an undamped model has no answer at its own frequency", "[analyses]") {
    // A body on a rod without mass, which is a spring of 3.
    Model model = make_rod_model(along_x, 1.0, {1, 4}, make_section({1e8, 1e8, 1e8, 1.0, 1.0, 1.0}));
    clamp(model, 0);
    model.supports.push_back({.node = last_node(model), .fixed = {false, true, true, true, true, true}});
    model.bodies.push_back({.name = "block", .node = last_node(model), .mass = 1e8});
    const System system(model);
    const ComplexVectors excitation = make_excitation(model, last_node(model), 0, 1.0);
    const ResponseRecord record = find_response(system, system.initial_state(), 0.0, {1.0, 2.0}, excitation);
    CHECK(record.responses[0].failure == "the model resonates without damping");
    CHECK(record.responses[1].failure.empty());
    CHECK(component(record.responses[1].motion, last_node(model), 0).real() ==
          Approx(1.0 / (1e8 - 4e8)).epsilon(1e-9));
}
