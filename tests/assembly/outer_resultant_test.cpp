// What acts on a model from outside is the rate of its momenta, in equilibrium or with what is missing from
// it.

#include "assembly/sample_model.hpp"
#include "assembly/system.hpp"
#include "assembly/system_measures.hpp"
#include "rotation/rotation_map.hpp"
#include "tools/catch.hpp"
#include "tools/difference.hpp"
#include "tools/random_values.hpp"

using namespace gxrod;
using namespace gxrod::tools;

namespace {

// The momenta a time later, of nodes that continue with their velocities and accelerations.
Momentum move_on(const System& system, const State& state, double time, double later) {
    State moved = state;
    for (NodeMotion& node : moved.trial) {
        node.r += later * node.v + 0.5 * later * later * node.a;
        node.Lambda = exp_quaternion(later * node.omega + 0.5 * later * later * node.alpha) * node.Lambda;
        node.v += later * node.a;
        node.omega += later * node.alpha;
    }
    return SystemMeasures(system).compute_balance(moved, time).momentum;
}

void check_rates(const Model& model, State state, const System& system) {
    RandomValues random(7);
    for (NodeMotion& node : state.trial) {
        node.v = random.vector(1.0);
        node.a = random.vector(2.0);
        node.omega = random.vector(1.0);
        node.alpha = random.vector(2.0);
    }
    const double time = 0.4;
    Residual residual;
    system.compute_residual(state, time, residual);
    Resultant missing;
    for (std::size_t i = 0; i < model.nodes.size(); ++i) {
        missing.force += residual.nodal[i].head<3>();
        missing.moment += residual.nodal[i].tail<3>() + state.trial[i].r.cross(residual.nodal[i].head<3>());
    }
    const std::vector<Vec6> none(model.nodes.size(), Vec6::Zero());
    const Resultant outer = SystemMeasures(system).compute_outer_resultant(state, time, none);
    for (int i = 0; i < 3; ++i) {
        const double linear =
            differentiate([&](double t) { return move_on(system, state, time, t).linear[i]; });
        const double angular =
            differentiate([&](double t) { return move_on(system, state, time, t).angular[i]; });
        CHECK(outer.force[i] == Approx(linear - missing.force[i]).epsilon(1e-8).margin(1e-7));
        CHECK(outer.moment[i] == Approx(angular - missing.moment[i]).epsilon(1e-8).margin(1e-7));
    }
}

}  // namespace

TEST_CASE("what acts from outside is the rate of the momenta", "[assembly]") {
    SECTION("rods, bodies, loads of every frame, gravity") {
        Model model = make_sample_model();
        // The test functions of elements simo do not contain a rigid rotation, so their internal forces have
        // a moment.
        for (Rod& rod : model.rods) rod.kind = ElementKind::objective;
        const System system(model);
        check_rates(model, make_sample_state(system, 3), system);
    }
    SECTION("damping, distributed loads, offset mass") {
        const Model model = make_turned_model(ElementKind::objective, 2);
        const System system(model);
        check_rates(model, make_turned_state(system, 3), system);
    }
}

TEST_CASE("reactions act from outside", "[assembly]") {
    const Model model = make_sample_model();
    const System system(model);
    const State state = make_sample_state(system, 3);
    std::vector<Vec6> reactions(model.nodes.size(), Vec6::Zero());
    const Resultant without = SystemMeasures(system).compute_outer_resultant(state, 0.0, reactions);
    reactions[1] << 1.0, 2.0, 3.0, 4.0, 5.0, 6.0;
    const Resultant with = SystemMeasures(system).compute_outer_resultant(state, 0.0, reactions);
    CHECK((with.force - without.force - Vec3(1.0, 2.0, 3.0)).norm() < 1e-12);
    const Vec3 moment = Vec3(4.0, 5.0, 6.0) + state.trial[1].r.cross(Vec3(1.0, 2.0, 3.0));
    CHECK((with.moment - without.moment - moment).norm() < 1e-12);
}
