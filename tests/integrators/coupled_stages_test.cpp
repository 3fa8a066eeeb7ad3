#include "integrators/coupled_stages.hpp"

#include <Eigen/LU>

#include "assembly/system.hpp"
#include "integrators/scheme_samples.hpp"
#include "rotation/tangent_map.hpp"
#include "solvers/coupled/coupled_step.hpp"
#include "state/increment.hpp"
#include "tools/catch.hpp"
#include "tools/difference.hpp"
#include "tools/random_values.hpp"
#include "tools/run.hpp"
#include "tools/tops.hpp"

using namespace gxrod;
using namespace gxrod::tools;

namespace {

struct Tableau {
    std::string name;
    CoupledStages scheme;
    Eigen::MatrixXd A;
    Eigen::VectorXd b, c;
    int order, stage_order;
};

// A by the definition of collocation: a_ij = ∫₀^cᵢ l_j, of the fractions alone.
Tableau make_tableau(const std::string& name, const CoupledStages& scheme, int order) {
    const int count = scheme.stage_count();
    Tableau tableau{name, scheme, {}, {}, Eigen::VectorXd(count), order, count};
    for (int i = 0; i < count; ++i) tableau.c[i] = scheme.stage_fraction(i);
    // Powers of c: A c^k = c^(k+1)/(k+1), and b alike with c = 1.
    Eigen::MatrixXd powers(count, count), integrals(count, count);
    Eigen::RowVectorXd ends(count);
    for (int k = 0; k < count; ++k) {
        powers.col(k) = tableau.c.array().pow(k);
        integrals.col(k) = tableau.c.array().pow(k + 1) / (k + 1);
        ends[k] = 1.0 / (k + 1);
    }
    const Eigen::MatrixXd inverse = powers.inverse();
    tableau.A = integrals * inverse;
    tableau.b = (ends * inverse).transpose();
    return tableau;
}

std::vector<Tableau> all_tableaus() {
    return {make_tableau("radau-5", CoupledStages::make_radau_5(), 5),
            make_tableau("gauss-4", CoupledStages::make_gauss_4(), 4)};
}

// Two nodes at random stages of a step from random motions.
State make_random_stages(const CoupledStages& scheme, unsigned seed) {
    RandomValues random(seed);
    State state = make_random_state(scheme, seed);
    const Stage step = make_stage(0);
    scheme.predict(state, step, CoupledStages::Prediction::from_start, ThreadTeam::alone());
    for (std::vector<NodeMotion>& motions : state.stage_motions) {
        for (std::size_t i = 0; i < motions.size(); ++i)
            place(state.previous[i],
                  state.previous[i].r + random.vector(0.3),
                  random.number(0.3, 2.5) * random.direction(),
                  motions[i]);
    }
    scheme.update_stages(state, step, ThreadTeam::alone());
    return state;
}

}  // namespace

TEST_CASE("coupled schemes meet the conditions of their orders, and not of the next", "[integrators]") {
    for (const Tableau& it : all_tableaus()) {
        INFO(it.name);
        for (int k = 1; k <= it.order; ++k)
            CHECK(it.b.dot(Eigen::VectorXd(it.c.array().pow(k - 1))) == Approx(1.0 / k).epsilon(1e-13));
        const double next = it.b.dot(Eigen::VectorXd(it.c.array().pow(it.order)));
        CHECK(std::abs(next - 1.0 / (it.order + 1)) > 1e-4);
        const std::vector<double> weights = it.scheme.power_weights();
        REQUIRE(weights.size() == static_cast<std::size_t>(it.b.size()) + 1);
        CHECK(weights[0] == 0.0);
        for (Eigen::Index j = 0; j < it.b.size(); ++j)
            CHECK(weights[static_cast<std::size_t>(j) + 1] == Approx(it.b[j]).epsilon(1e-14));
    }
}

TEST_CASE("the equations of coupled stages part by the eigenvalues of their matrix", "[integrators]") {
    for (const Tableau& it : all_tableaus()) {
        INFO(it.name);
        const Eigen::MatrixXd inverse = it.A.inverse();
        const CoupledStages& scheme = it.scheme;
        const std::complex<double> factor = scheme.complex_factor();
        const Eigen::MatrixXd parts =
            scheme.real_factor() * scheme.from_real() * scheme.to_real().transpose() +
            2.0 * (factor * scheme.from_complex() * scheme.to_complex().transpose()).real();
        CHECK(relative_difference(parts, inverse) < 1e-13);
        CHECK(factor.imag() > 0.0);
        // The square of the largest angle is less than a half turn from K: what elimination relies on.
        CHECK(std::abs(std::arg(factor * factor)) < 0.75 * 3.14159);
    }
    CHECK(CoupledStages::make_radau_5().real_factor() == Approx(3.637834252744496).epsilon(1e-14));
    CHECK(CoupledStages::make_gauss_4().real_factor() == 0.0);
}

namespace {

// Sets the stages of the step from 0 to `time_step` to `motion`, a function of time, and commits its end.
template <class Motion>
void take_step(const CoupledStages& scheme, const Motion& motion, double time_step, State& state) {
    state.previous = state.trial = {motion(0.0)};
    scheme.start(state);
    state.stage_motions.clear();
    for (int j = 0; j < scheme.stage_count(); ++j) {
        state.stage_motions.push_back({motion(time_step * scheme.stage_fraction(j))});
        NodeMotion& stage = state.stage_motions.back()[0];
        stage.theta = log((stage.Lambda * state.previous[0].Lambda.conjugate()).normalized());
    }
    scheme.end_step(state, {0, 0.0, time_step, time_step}, ThreadTeam::alone());
    state.previous = state.trial = {motion(time_step)};
    state.carried_previous = state.carried_trial;
}

// Errors of the stages that are predicted for the next step, as long as the ratio says.
template <class Motion>
double find_prediction_error(const CoupledStages& scheme,
                             const Motion& motion,
                             double time_step,
                             double ratio,
                             CoupledStages::Prediction prediction) {
    State state;
    take_step(scheme, motion, time_step, state);
    const double next = ratio * time_step;
    scheme.predict(state, {0, time_step, next, time_step + next}, prediction, ThreadTeam::alone());
    double error = 0.0;
    for (int j = 0; j < scheme.stage_count(); ++j) {
        const NodeMotion& stage = state.stage_motions[static_cast<std::size_t>(j)][0];
        const NodeMotion exact = motion(time_step + next * scheme.stage_fraction(j));
        error = std::max({error,
                          (stage.r - exact.r).norm(),
                          log((stage.Lambda * exact.Lambda.conjugate()).normalized()).norm()});
    }
    return error;
}

}  // namespace

TEST_CASE("coupled stages are predicted as the accelerations of the last step go on", "[integrators]") {
    using Prediction = CoupledStages::Prediction;
    for (const Tableau& it : all_tableaus()) {
        INFO(it.name);
        RandomValues random(5);
        const int count = it.scheme.stage_count();
        std::vector<Vec3> coefficients;
        for (int m = 0; m < count + 2; ++m) coefficients.push_back(random.vector());
        const Vec3 axis = random.direction();
        // Accelerations are a polynomial through as many values as there are stages; the axis stays.
        const auto polynomial = [&](double t) {
            NodeMotion motion;
            Vec3 r = Vec3::Zero();
            for (int m = count + 1; m >= 0; --m) {
                motion.a = motion.a * t + 2.0 * motion.v;
                motion.v = motion.v * t + r;
                r = r * t + coefficients[static_cast<std::size_t>(m)];
            }
            motion.r = r;
            motion.Lambda = exp_quaternion(r.x() * axis);
            motion.omega = motion.v.x() * axis;
            motion.alpha = motion.a.x() * axis;
            return motion;
        };
        for (const double ratio : {1.0, 1.7, 0.4}) {
            CHECK(find_prediction_error(it.scheme, polynomial, 0.3, ratio, Prediction::from_last_step) <
                  1e-14);
            CHECK(find_prediction_error(it.scheme, polynomial, 0.3, ratio, Prediction::from_start) > 1e-4);
        }
        // About two axes at once.
        const Vec3 p = random.vector(), q = random.vector();
        const auto turning = [&](double t) {
            NodeMotion motion;
            const Quat outer = exp_quaternion(t * p);
            motion.Lambda = outer * exp_quaternion(t * q);
            motion.omega = p + outer * q;
            motion.alpha = p.cross(outer * q);
            return motion;
        };
        const double coarse = find_prediction_error(it.scheme, turning, 0.1, 1.0, Prediction::from_last_step);
        const double fine = find_prediction_error(it.scheme, turning, 0.05, 1.0, Prediction::from_last_step);
        CHECK(std::log2(coarse / fine) == Approx(count + 2).margin(0.2));
    }
}

TEST_CASE("each coupled stage is a sum over the rates of all", "[integrators]") {
    for (const Tableau& it : all_tableaus()) {
        INFO(it.name);
        const State state = make_random_stages(it.scheme, 7);
        const double time_step = make_stage(0).time_step;
        const auto check_sums = [&](const NodeMotion& end, const auto& weights) {
            const NodeMotion& previous = state.previous[0];
            Vec3 r = previous.r, v = previous.v, theta = Vec3::Zero(), omega = previous.omega;
            for (Eigen::Index k = 0; k < it.c.size(); ++k) {
                const NodeMotion& motion = state.stage_motions[static_cast<std::size_t>(k)][0];
                r += time_step * weights[k] * motion.v;
                v += time_step * weights[k] * motion.a;
                theta += time_step * weights[k] * (tangent_map(motion.theta).inverse() * motion.omega);
                omega += time_step * weights[k] * motion.alpha;
            }
            CHECK(relative_difference(end.r, r) < 1e-12);
            CHECK(relative_difference(end.v, v) < 1e-12);
            CHECK(relative_difference(end.theta, theta) < 1e-12);
            CHECK(relative_difference(end.omega, omega) < 1e-12);
        };
        for (Eigen::Index j = 0; j < it.c.size(); ++j)
            check_sums(state.stage_motions[static_cast<std::size_t>(j)][0], it.A.row(j));
        State ended = state;
        it.scheme.end_step(ended, make_stage(0), ThreadTeam::alone());
        check_sums(ended.trial[0], it.b);
        CHECK(ended.trial_time == 0.5);
    }
}

TEST_CASE("linearizations of coupled stages are derivatives by the placements of each", "[integrators]") {
    const Stage step = make_stage(0);
    for (const Tableau& it : all_tableaus()) {
        INFO(it.name);
        const State state = make_random_stages(it.scheme, 11);
        std::vector<NodeLinearization> linearizations;
        for (int j = 0; j < it.scheme.stage_count(); ++j) {
            for (int k = 0; k < it.scheme.stage_count(); ++k) {
                INFO("stage " << j << " by stage " << k);
                it.scheme.linearize(state, step.time_step, j, k, linearizations, ThreadTeam::alone());
                const NodeLinearization& one = linearizations[0];
                Eigen::Matrix<double, 12, 6> expected = Eigen::Matrix<double, 12, 6>::Zero();
                expected.block<3, 3>(0, 0) = one.rate * Mat3::Identity();
                expected.block<3, 3>(3, 0) = one.acceleration * Mat3::Identity();
                expected.block<3, 3>(6, 3) = one.d_omega;
                expected.block<3, 3>(9, 3) = one.d_alpha;
                Eigen::Matrix<double, 12, 6> derivative;
                for (int unknown = 0; unknown < 6; ++unknown) {
                    derivative.col(unknown) = differentiate([&](double amount) {
                        State moved = state;
                        const Vec6 change = amount * Vec6::Unit(unknown);
                        apply_spin(state.previous[0],
                                   change.head<3>(),
                                   change.tail<3>(),
                                   moved.stage_motions[static_cast<std::size_t>(k)][0]);
                        it.scheme.update_stages(moved, step, ThreadTeam::alone());
                        return stack_rates(moved.stage_motions[static_cast<std::size_t>(j)][0]);
                    });
                }
                CHECK(one.placement == (j == k ? 1.0 : 0.0));
                CHECK(relative_difference(expected, derivative) < 1e-9);
            }
        }
    }
}

TEST_CASE("the error estimate of radau-5 falls with the fourth power of the step", "[integrators]") {
    const Model model = heavy_top::make_model();
    const System system(model);
    SolverWorkspace workspace(system, LinearSolverKind::klu);
    const CoupledStages scheme = CoupledStages::make_radau_5();
    CHECK(scheme.error_order() == 4);
    NewtonSettings newton;
    newton.tolerance = 1e-12;
    std::vector<double> errors;
    for (const double step : {2e-3, 1e-3, 5e-4}) {
        State state = system.initial_state();
        REQUIRE(solve_accelerations(system, 0.0, {0.0, step}, workspace, state).converged());
        scheme.start(state);
        system.commit(state, 0.0);
        REQUIRE(solve_step({system, scheme, newton}, {0, 0.0, step, step}, workspace, state).converged());
        const StepError error = measure_step_error(workspace.coupled->placement_errors,
                                                   workspace.coupled->rate_errors,
                                                   [&](int) { return system.length_scale(); });
        CHECK(error.node == 0);
        errors.push_back(error.size);
    }
    INFO("errors " << errors[0] << " " << errors[1] << " " << errors[2]);
    CHECK(compute_orders(errors)[1] == Approx(4.0).margin(0.1));
}
