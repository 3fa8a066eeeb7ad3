// Tangents of whole models, own axes of supports, distributed loads and damping included, for every kind and
// order of rod.

#include "assembly/sample_model.hpp"
#include "assembly/system_measures.hpp"
#include "integrators/generalized_alpha.hpp"
#include "integrators/load_stepping.hpp"
#include "integrators/newmark_simplified.hpp"
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
const Stage stage{0, 0.6, 0.1, now};

template <class Visit>
void for_each_turned_model(Visit&& visit) {
    for (const ElementKind kind : {ElementKind::objective, ElementKind::simo}) {
        for (int order = 1; order <= 4; ++order) {
            INFO((kind == ElementKind::simo ? "simo" : "objective") << ", order " << order);
            visit(make_turned_model(kind, order));
        }
    }
}

void check_tangent(const System& system, const Integrator& integrator, unsigned seed) {
    State state = make_turned_state(system, seed);
    integrator.start(state);
    update_trial_rates(system, integrator, stage, state);
    std::vector<NodeLinearization> linearizations(state.trial.size());
    integrator.linearize(state, stage, linearizations);
    std::vector<double> values, differences;
    system.compute_tangent(state, now, linearizations, values);
    DifferenceTangent(system).compute(integrator, stage, state, differences);
    CHECK(relative_difference(make_dense(system.pattern(), values),
                              make_dense(system.pattern(), differences)) < 1e-8);
}

}  // namespace

TEST_CASE("tangents of turned models are derivatives of the residual", "[assembly]") {
    for_each_turned_model([](const Model& model) {
        const System system(model);
        // Those of statics show stiffness and loads, those of dynamics inertia and damping too.
        for (const unsigned seed : {1U, 2U}) {
            check_tangent(system, LoadStepping(), seed);
            check_tangent(system, NewmarkSimplified({0.25, 0.5}), seed);
        }
        check_tangent(system, GeneralizedAlpha(0.5), 3);
    });
}

TEST_CASE("with the resultants of the strains, tangents of turned models stay what they are",
          "[assembly][mixed]") {
    for_each_turned_model([](const Model& model) {
        const System system(model);
        State state = make_turned_state(system, 5);
        std::vector<NodeLinearization> linearizations(state.trial.size());
        LoadStepping().linearize(state, stage, linearizations);
        std::vector<double> consistent, mixed;
        system.compute_tangent(state, now, linearizations, consistent);
        state.previous = state.trial;  // resultants start from the last accepted motion
        system.start_resultants(state);
        system.compute_tangent(state, now, linearizations, mixed);
        CHECK(relative_difference(make_dense(system.pattern(), mixed),
                                  make_dense(system.pattern(), consistent)) < 1e-15);
        for (Vec6& resultants : state.resultants) resultants *= 1.5;
        system.compute_tangent(state, now, linearizations, mixed);
        CHECK(relative_difference(make_dense(system.pattern(), mixed),
                                  make_dense(system.pattern(), consistent)) > 1e-3);
    });
}

TEST_CASE("resultants of a model advance with its nodes", "[assembly][mixed]") {
    for_each_turned_model([](const Model& model) {
        const System system(model);
        State state = make_turned_state(system, 6);
        RandomValues random(61);
        std::vector<Vec6> increments(state.trial.size());
        for (Vec6& increment : increments) increment << random.vector(), random.vector();
        const auto resultants_after = [&](double amount) {
            State moved = state;
            for (std::size_t i = 0; i < increments.size(); ++i) {
                const Vec6 delta = amount * increments[i];
                apply_spin(state.previous[i], delta.head<3>(), delta.tail<3>(), moved.trial[i]);
            }
            moved.previous = moved.trial;
            system.start_resultants(moved);
            Eigen::VectorXd stacked(6 * moved.resultants.size());
            for (std::size_t p = 0; p < moved.resultants.size(); ++p)
                stacked.segment<6>(6 * static_cast<Eigen::Index>(p)) = moved.resultants[p];
            return stacked;
        };
        const Eigen::VectorXd expected = resultants_after(0.0) + differentiate(resultants_after, 2e-3);
        state.previous = state.trial;  // resultants start from the last accepted motion
        system.start_resultants(state);
        system.advance_resultants(increments, state);
        REQUIRE(expected.size() == static_cast<Eigen::Index>(6 * state.resultants.size()));
        for (std::size_t p = 0; p < state.resultants.size(); ++p) {
            const Vec6 of_point = expected.segment<6>(6 * static_cast<Eigen::Index>(p));
            CHECK(relative_difference(state.resultants[p], of_point) < 1e-8);
        }
    });
}

TEST_CASE("the static tangent without loads is symmetric but for moments out of balance", "[assembly]") {
    // K − Kᵀ = −[m_I]× of each node, in the axes of its support; see objective_map_test.cpp.
    for_each_turned_model([](Model model) {
        model.loads.clear();
        model.distributed_loads.clear();
        const System system(model);
        const State state = make_turned_state(system, 4);
        Residual residual;
        system.compute_residual(state, now, residual);
        std::vector<NodeLinearization> linearizations(state.trial.size());
        LoadStepping().linearize(state, stage, linearizations);
        std::vector<double> values;
        system.compute_tangent(state, now, linearizations, values);
        const Eigen::MatrixXd tangent = make_dense(system.pattern(), values);
        Eigen::MatrixXd skew = tangent - tangent.transpose();
        CHECK(skew.norm() > 1e-3 * tangent.norm());
        for (std::size_t node = 0; node < model.nodes.size(); ++node) {
            const int number = static_cast<int>(node);
            const Vec6 own = system.equations().to_own_axes(number, residual.nodal[node]);
            const Mat3 expected = -spin(own.tail<3>());
            const auto& equations = system.equations().of_node(number);
            for (int i = 0; i < 3; ++i) {
                for (int j = 0; j < 3; ++j) {
                    const std::int64_t row = equations[3 + i];
                    const std::int64_t column = equations[3 + j];
                    if (row >= 0 && column >= 0) skew(row, column) -= expected(i, j);
                }
            }
        }
        CHECK(skew.norm() < 1e-13 * tangent.norm());
    });
}

TEST_CASE("reactions are those of held components, in global axes", "[assembly]") {
    for_each_turned_model([](const Model& model) {
        const System system(model);
        const State state = make_turned_state(system, 5);
        Residual residual;
        system.compute_residual(state, now, residual);
        const std::vector<Vec6> reactions = SystemMeasures(system).compute_reactions(residual);
        for (std::size_t node = 0; node < model.nodes.size(); ++node) {
            Vec6 expected = Vec6::Zero();
            for (const Support& support : model.supports) {
                if (support.node != static_cast<int>(node)) continue;
                for (int i = 0; i < 6; ++i) {
                    if (!support.holds(i)) continue;
                    const Vec3 axis = support.axes * Vec3::Unit(i % 3);
                    expected.segment<3>(3 * (i / 3)) +=
                        axis * axis.dot(residual.nodal[node].segment<3>(3 * (i / 3)));
                }
            }
            CHECK((reactions[node] - expected).norm() < 1e-13);
        }
    });
}
