#include "assembly/state_matrices.hpp"
#include "assembly/system_values.hpp"

#include "assembly/sample_model.hpp"
#include "assembly/scatter.hpp"
#include "state/increment.hpp"
#include "tools/catch.hpp"
#include "tools/dense_algebra.hpp"
#include "tools/difference.hpp"

using namespace gxrod;
using namespace gxrod::tools;

namespace {

constexpr double now = 0.7;

// The derivative of the residual by what `move` does to each unknown's node: (node, its increment, state).
template <class Move>
Eigen::MatrixXd differentiate_residual(const System& system, const State& state, Move&& move) {
    const std::int64_t size = system.equations().count();
    Eigen::MatrixXd derivative(size, size);
    for (std::int64_t j = 0; j < size; ++j) {
        const int node = system.equations().unknown(j).node;
        const Vec6 direction = system.equations().increment_of(node, Eigen::VectorXd::Unit(size, j));
        derivative.col(j) = differentiate(
            [&](double amount) {
                State moved = state;
                move(Vec6(amount * direction), state.previous[node], moved.trial[node]);
                Residual residual;
                system.compute_residual(moved, now, residual);
                return gather(residual.nodal, system.equations());
            },
            1e-2);
    }
    return derivative;
}

void check_matrices(const Model& model, const State& still, const System& system, unsigned seed) {
    INFO("seed " << seed);
    RandomValues random(seed);
    State state = still;
    for (NodeMotion& motion : state.trial) {
        motion.v = random.vector();
        motion.omega = random.vector();
        motion.a = random.vector();
        motion.alpha = random.vector();
    }
    const StateMatrices matrices = compute_state_matrices(system, state, now);
    const auto place_node = [](const Vec6& by, const NodeMotion& previous, NodeMotion& trial) {
        apply_spin(previous, by.head<3>(), by.tail<3>(), trial);
    };
    const auto add_rate = [](const Vec6& by, const NodeMotion&, NodeMotion& trial) {
        trial.v += by.head<3>();
        trial.omega += by.tail<3>();
    };
    const auto accelerate = [](const Vec6& by, const NodeMotion&, NodeMotion& trial) {
        trial.a += by.head<3>();
        trial.alpha += by.tail<3>();
    };
    const auto compare = [&](const std::vector<double>& values, const Eigen::MatrixXd& differences) {
        CHECK(relative_difference(make_dense(system.pattern(), values), differences) < 1e-8);
    };
    compare(matrices.stiffness, differentiate_residual(system, state, place_node));
    compare(matrices.damping, differentiate_residual(system, state, add_rate));
    compare(matrices.mass, differentiate_residual(system, state, accelerate));
    CHECK(model.nodes.size() == state.trial.size());
}

}  // namespace

TEST_CASE("matrices about moving states are derivatives of the residual", "[assembly]") {
    for (const ElementKind kind : {ElementKind::objective, ElementKind::simo}) {
        for (int order = 1; order <= 4; ++order) {
            INFO((kind == ElementKind::simo ? "simo" : "objective") << ", order " << order);
            const Model model = make_turned_model(kind, order);
            const System system(model);
            check_matrices(model, make_turned_state(system, 11), system, 12);
        }
    }
    const Model model = make_sample_model();
    const System system(model);
    check_matrices(model, make_sample_state(system, 13), system, 14);
}

TEST_CASE("matrices about a state leave its resultants aside", "[assembly]") {
    const Model model = make_turned_model(ElementKind::objective, 2);
    const System system(model);
    State state = make_turned_state(system, 15);
    const StateMatrices expected = compute_state_matrices(system, state, now);
    state.previous = state.trial;
    system.start_resultants(state);
    for (Vec6& resultants : state.resultants) resultants *= 3.0;
    CHECK(compute_state_matrices(system, state, now).stiffness == expected.stiffness);
    CHECK(state.resultants.size() > 0);
}

TEST_CASE("strain work of rods is the second derivative of their energy without geometric part",
          "[assembly]") {
    // About the stress-free shape, where nothing is geometric: φᵀ K φ.
    for (const ElementKind kind : {ElementKind::objective, ElementKind::simo}) {
        for (int order = 1; order <= 4; ++order) {
            Model model = make_turned_model(kind, order);
            model.gravity = TimeVector(Vec3::Zero());
            model.loads.clear();
            model.distributed_loads.clear();
            model.bodies.clear();
            model.supports.clear();
            const System system(model);
            const State state = system.initial_state();
            RandomValues random(16);
            std::vector<Vec6> increments(state.trial.size());
            for (Vec6& increment : increments) increment << random.vector(), random.vector();
            const Eigen::VectorXd x = gather(increments, system.equations());
            const std::vector<Vec6> work = SystemValues(system).compute_strain_work(state, increments);
            REQUIRE(work.size() == 1);
            std::vector<double> stiffness;
            system.compute_tangent(state,
                                   0.0,
                                   std::vector<NodeLinearization>(state.trial.size(), {.placement = 1.0}),
                                   stiffness);
            CHECK(work[0].sum() == Approx(x.dot(make_dense(system.pattern(), stiffness) * x)).epsilon(1e-11));
        }
    }
}
