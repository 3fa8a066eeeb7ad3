// Properties that every scheme has: its linearization is the derivative of its update, motions that a scheme
// must follow exactly, and its order, measured.

#include "integrators/coupled_stages.hpp"
#include "integrators/scheme_samples.hpp"
#include "rotation/rotation_map.hpp"
#include "state/increment.hpp"
#include "tools/catch.hpp"
#include "tools/difference.hpp"
#include "tools/random_values.hpp"
#include "tools/run.hpp"
#include "tools/tops.hpp"
#include "verification/rubin2007_problem.hpp"

using namespace gxrod;
using namespace gxrod::tools;

namespace {

// Calls visit(scheme, integrator, stage) for every stage of every implicit scheme whose stages follow each
// other.
template <class Visit>
void for_each_implicit_stage(Visit&& visit) {
    for (const SchemeSample& scheme : all_schemes()) {
        const auto integrator = make_integrator(scheme.settings);
        if (integrator->is_explicit() || scheme.is_coupled()) continue;
        for (int index = 0; index < integrator->stage_count(); ++index) {
            INFO(scheme.name << ", stage " << index);
            visit(*integrator, make_stage(index));
        }
    }
}

// The change of the first node's rates when it moves by (δr, δφ).
Eigen::Matrix<double, 12, 6> differentiate_rates(const Integrator& integrator,
                                                 const Stage& stage,
                                                 const State& state) {
    Eigen::Matrix<double, 12, 6> derivative;
    for (int unknown = 0; unknown < 6; ++unknown) {
        derivative.col(unknown) = differentiate([&](double amount) {
            State moved = state;
            const Vec6 step = amount * Vec6::Unit(unknown);
            apply_spin(state.previous[0], step.head<3>(), step.tail<3>(), moved.trial[0]);
            integrator.update_rates(moved, stage);
            return stack_rates(moved.trial[0]);
        });
    }
    return derivative;
}

// The same as the treaty states it.
Eigen::Matrix<double, 12, 6> stack_linearization(const NodeLinearization& linearization) {
    Eigen::Matrix<double, 12, 6> derivative = Eigen::Matrix<double, 12, 6>::Zero();
    derivative.block<3, 3>(0, 0) = linearization.rate * Mat3::Identity();
    derivative.block<3, 3>(3, 0) = linearization.acceleration * Mat3::Identity();
    derivative.block<3, 3>(6, 3) = linearization.d_omega;
    derivative.block<3, 3>(9, 3) = linearization.d_alpha;
    return derivative;
}

MotionGradient make_random_gradient(const State& state, unsigned seed) {
    RandomValues random(seed);
    MotionGradient gradient(state);
    for (MotionGradient::OfNode& node : gradient.nodes) {
        for (Vec3* vector : {&node.r, &node.phi, &node.v, &node.omega, &node.a, &node.alpha})
            *vector = random.vector();
    }
    for (CarriedAcceleration& one : gradient.carried) one = {random.vector(), random.vector()};
    return gradient;
}

double dot(const MotionGradient& a, const MotionGradient& b) {
    double sum = 0.0;
    for (std::size_t i = 0; i < a.nodes.size(); ++i) {
        const MotionGradient::OfNode &one = a.nodes[i], &other = b.nodes[i];
        sum += one.r.dot(other.r) + one.phi.dot(other.phi) + one.v.dot(other.v) + one.omega.dot(other.omega) +
               one.a.dot(other.a) + one.alpha.dot(other.alpha);
    }
    for (std::size_t i = 0; i < a.carried.size(); ++i)
        sum += a.carried[i].a.dot(b.carried[i].a) + a.carried[i].alpha.dot(b.carried[i].alpha);
    return sum;
}

void move_along(const MotionGradient& by, double amount, std::vector<NodeMotion>& motions) {
    for (std::size_t i = 0; i < motions.size(); ++i) {
        motions[i].r += amount * by.nodes[i].r;
        motions[i].Lambda = exp_quaternion(amount * by.nodes[i].phi) * motions[i].Lambda;
        motions[i].v += amount * by.nodes[i].v;
        motions[i].omega += amount * by.nodes[i].omega;
        motions[i].a += amount * by.nodes[i].a;
        motions[i].alpha += amount * by.nodes[i].alpha;
    }
}

// A dead force and a spin about a principal axis: r = v t + F t²/2m, ω constant.
Model make_thrown_body() {
    Model model = make_free_body(Vec3(1.0, 2.0, 3.0), Vec3(0.0, 0.0, 4.0));
    model.nodes[0].velocity = Vec3(1.0, -2.0, 0.5);
    NodalLoad load;
    load.force = {3.0, 0.0, -1.0};
    model.loads.push_back(load);
    return model;
}

// Steps of a coarse run; two more runs halve them twice.
struct Steps {
    long one_stage, several_stages;
    long of(const SchemeSample& scheme) const { return scheme.order > 2.0 ? several_stages : one_stage; }
};

double measure_heavy_top(const DynamicSettings& settings) {
    const NodeMotion last = run_to_end(heavy_top::make_model(), settings);
    return (heavy_top::centre_of_mass(last.Lambda) - heavy_top::references()[0].centre_of_mass).norm();
}

// The largest orientation error over the cycle.
double measure_paper_problem(const DynamicSettings& settings) {
    const Model model = rubin2007::make_model();
    double worst = 0.0;
    run(model, settings, [&](const DynamicAnalysis& analysis) {
        const Quat axes = analysis.state().trial[0].Lambda * model.bodies[0].attitude;
        const Mat3 exact = rubin2007::exact_rotation(analysis.state().time);
        worst = std::max(worst, (axes.toRotationMatrix() - exact).norm());
    });
    return worst;
}

template <class Measure>
void check_order(const SchemeSample& scheme, double end_time, long steps, double margin, Measure&& measure) {
    INFO(scheme.name);
    DynamicSettings settings = scheme.settings;
    settings.end_time = end_time;
    settings.newton.tolerance = 1e-12;
    std::vector<double> errors;
    for (const long n : {steps, 2 * steps, 4 * steps}) {
        settings.steps = n;
        errors.push_back(measure(settings));
    }
    INFO("errors " << errors[0] << " " << errors[1] << " " << errors[2]);
    CHECK(compute_orders(errors)[1] == Approx(scheme.order).margin(margin));
}

}  // namespace

TEST_CASE("a stage begins in the same way wherever the trial was", "[integrators]") {
    for (const SchemeSample& scheme : all_schemes()) {
        const auto integrator = make_integrator(scheme.settings);
        if (scheme.is_coupled()) continue;
        State state = make_random_state(*integrator, 1);
        State other = make_random_state(*integrator, 2);
        other.previous = state.previous;
        other.carried_previous = state.carried_previous;
        for (int index = 0; index < integrator->stage_count(); ++index) {
            INFO(scheme.name << ", stage " << index);
            const Stage stage = make_stage(index);
            integrator->begin_stage(state, stage);
            integrator->begin_stage(other, stage);
            for (std::size_t i = 0; i < state.trial.size(); ++i) {
                CHECK(state.trial[i].r == other.trial[i].r);
                CHECK(state.trial[i].Lambda.coeffs() == other.trial[i].Lambda.coeffs());
                CHECK(state.trial[i].theta == other.trial[i].theta);
                CHECK(state.trial[i].v == other.trial[i].v);
                CHECK(state.trial[i].omega == other.trial[i].omega);
                if (integrator->is_explicit()) continue;  // the accelerations are asked then
                CHECK(state.trial[i].a == other.trial[i].a);
                CHECK(state.trial[i].alpha == other.trial[i].alpha);
            }
            // The next stage is to find the same rates.
            other.trial = state.trial;
            integrator->end_stage(state, stage);
            integrator->end_stage(other, stage);
            for (NodeMotion& motion : other.trial) motion = {};
        }
    }
}

TEST_CASE("linearizations are derivatives of the update by (δr, δφ)", "[integrators]") {
    for_each_implicit_stage([](const Integrator& integrator, const Stage& stage) {
        for (unsigned seed = 1; seed <= 3; ++seed) {
            State state = make_random_state(integrator, seed);
            begin_random_stage(integrator, stage, seed, state);
            std::vector<NodeLinearization> linearizations(state.trial.size());
            integrator.linearize(state, stage, linearizations);
            CHECK(linearizations[0].placement == 1.0);
            CHECK(relative_difference(stack_linearization(linearizations[0]),
                                      differentiate_rates(integrator, stage, state)) < 1e-9);
        }
    });
}

TEST_CASE("transposed rates are those of the update's derivatives", "[integrators]") {
    int count = 0;
    for_each_implicit_stage([&](const Integrator& integrator, const Stage& stage) {
        if (!integrator.has_transposed_rates()) return;
        ++count;
        State state = make_random_state(integrator, 1);
        begin_random_stage(integrator, stage, 1, state);
        integrator.update_rates(state, stage);
        MotionGradient rates = make_random_gradient(state, 2);
        for (MotionGradient::OfNode& node : rates.nodes) node.r = node.phi = Vec3::Zero();
        const MotionGradient of_trial = make_random_gradient(state, 3);
        const MotionGradient of_previous = make_random_gradient(state, 4);
        const double expected = differentiate([&](double amount) {
            State moved = state;
            move_along(of_previous, amount, moved.previous);
            for (std::size_t i = 0; i < moved.carried_previous.size(); ++i) {
                moved.carried_previous[i].a += amount * of_previous.carried[i].a;
                moved.carried_previous[i].alpha += amount * of_previous.carried[i].alpha;
            }
            move_along(of_trial, amount, moved.trial);
            for (std::size_t i = 0; i < moved.trial.size(); ++i)
                moved.trial[i].theta = log_nearest(
                    moved.trial[i].Lambda * moved.previous[i].Lambda.conjugate(), state.trial[i].theta);
            integrator.update_rates(moved, stage);
            MotionGradient found(moved);
            for (std::size_t i = 0; i < moved.trial.size(); ++i) {
                const NodeMotion& motion = moved.trial[i];
                found.nodes[i] = {Vec3::Zero(), Vec3::Zero(), motion.v, motion.omega, motion.a, motion.alpha};
            }
            found.carried = moved.carried_trial;
            return dot(rates, found);
        });
        MotionGradient trial(state), previous(state);
        integrator.transpose_rates(state, stage.time_step, rates, trial, previous);
        CHECK(relative_difference(dot(trial, of_trial) + dot(previous, of_previous), expected) < 1e-9);
    });
    CHECK(count > 0);
}

TEST_CASE("a node's rates follow from its own motion alone", "[integrators]") {
    for_each_implicit_stage([](const Integrator& integrator, const Stage& stage) {
        State state = make_random_state(integrator, 1);
        begin_random_stage(integrator, stage, 1, state);
        const Rates before = stack_rates(state.trial[1]);
        apply_spin(state.previous[0], Vec3::Ones(), Vec3(0.1, 0.2, 0.3), state.trial[0]);
        integrator.update_rates(state, stage);
        CHECK(stack_rates(state.trial[1]) == before);
    });
}

TEST_CASE("an explicit scheme is linearized as a mass matrix", "[integrators]") {
    int count = 0;
    for (const SchemeSample& scheme : all_schemes()) {
        const auto integrator = make_integrator(scheme.settings);
        if (!integrator->is_explicit()) continue;
        ++count;
        std::vector<NodeLinearization> linearizations(2);
        integrator->linearize(make_random_state(*integrator, 1), make_stage(0), linearizations);
        REQUIRE(linearizations.size() == 2);
        for (const NodeLinearization& linearization : linearizations) {
            CHECK(linearization.placement == 0.0);
            CHECK(linearization.rate == 0.0);
            CHECK(linearization.acceleration == 1.0);
            CHECK(linearization.d_omega.isZero(0.0));
            CHECK(linearization.d_alpha == Mat3::Identity());
        }
    }
    CHECK(count > 0);
}

TEST_CASE("the last stage of a step lies at its end to the last bit", "[integrators]") {
    for (const SchemeSample& scheme : all_schemes()) {
        INFO(scheme.name);
        const auto integrator = make_integrator(scheme.settings);
        const Stage last{integrator->stage_count() - 1, 0.2, 0.1, 0.3};  // 0.2 + 0.1 > 0.3 in doubles
        const bool ends_with_stage = !integrator->coupled() || integrator->coupled()->ends_with_stage();
        if (ends_with_stage) CHECK(integrator->stage_time(last) == 0.3);
        for (int index = 0; index < integrator->stage_count(); ++index) {
            CHECK(integrator->stage_fraction(index) > 0.0);
            CHECK(integrator->stage_fraction(index) <= 1.0);
        }
        const auto weights = integrator->power_weights();
        if (weights.empty()) continue;
        CHECK(weights.size() == static_cast<std::size_t>(integrator->stage_count()) + 1);
        double sum = 0.0;
        for (const double weight : weights) sum += weight;
        CHECK(sum == Approx(1.0).epsilon(1e-14));
    }
}

TEST_CASE("constant acceleration is followed exactly", "[integrators]") {
    const Model model = make_thrown_body();
    for (const SchemeSample& scheme : all_schemes()) {
        INFO(scheme.name);
        DynamicSettings settings = scheme.settings;
        settings.end_time = 2.0;
        settings.steps = 5;
        const NodeMotion last = run_to_end(model, settings);
        CHECK((last.r - Vec3(2.0 + 6.0, -4.0, 1.0 - 2.0)).norm() < 1e-12);
        CHECK((last.v - Vec3(1.0 + 6.0, -2.0, 0.5 - 2.0)).norm() < 1e-12);
        // radau-5 divides differences of places by Δt² and multiplies them by up to 60.
        const double rounding = settings.scheme == Scheme::radau_5 ? 1e-11 : 1e-12;
        CHECK((last.a - Vec3(3.0, 0.0, -1.0)).norm() < rounding);
    }
}

TEST_CASE("steady spin about a principal axis is followed exactly", "[integrators]") {
    const Model model = make_thrown_body();
    const Quat exact = exp_quaternion(Vec3(0.0, 0.0, 8.0));
    for (const SchemeSample& scheme : all_schemes()) {
        INFO(scheme.name);
        DynamicSettings settings = scheme.settings;
        settings.end_time = 2.0;
        settings.steps = 5;  // 1.6 rad a step
        settings.newton.tolerance = 1e-14;
        const NodeMotion last = run_to_end(model, settings);
        CHECK((last.omega - Vec3(0.0, 0.0, 4.0)).norm() < 1e-12);
        // Quaternions of runge-kutta-4 follow a circle to its order only.
        if (settings.scheme != Scheme::runge_kutta_4) CHECK(last.Lambda.angularDistance(exact) < 1e-13);
    }
}

TEST_CASE("orders measured on the heavy top", "[integrators][order]") {
    constexpr Steps steps{1000, 100};
    for (const SchemeSample& scheme : all_schemes()) {
        check_order(scheme, 0.2, steps.of(scheme), scheme.order == 1.0 ? 0.05 : 0.02, measure_heavy_top);
    }
}

TEST_CASE("orders measured on the paper's problem", "[integrators][order]") {
    constexpr Steps steps{800, 160};
    for (const SchemeSample& scheme : all_schemes()) {
        // runge-kutta-4 and strong damping come near their orders from above: 4.06 and 2.06 here.
        check_order(scheme, rubin2007::period, steps.of(scheme), 0.1, measure_paper_problem);
    }
}

TEST_CASE("Newmark's schemes estimate the error of a step as it is", "[integrators]") {
    const Model model = heavy_top::make_model();
    const System system(model);
    SolverWorkspace workspace(system, LinearSolverKind::klu);
    NewtonSettings newton;
    newton.tolerance = 1e-13;
    const auto take_step = [&](const Integrator& integrator, double step) {
        State state = system.initial_state();
        REQUIRE(solve_accelerations(system, 0.0, {0.0, step}, workspace, state).converged());
        integrator.start(state);
        system.commit(state, 0.0);
        REQUIRE(solve_step({system, integrator, newton}, {0, 0.0, step, step}, workspace, state).converged());
        return state;
    };
    DynamicSettings exact;
    exact.scheme = Scheme::radau_5;
    for (const SchemeSample& scheme : all_schemes()) {
        const bool is_newmark = scheme.settings.scheme == Scheme::newmark_simplified ||
                                scheme.settings.scheme == Scheme::newmark_ibrahimbegovic;
        if (!is_newmark || scheme.settings.beta == 1.0 / 6.0) continue;
        INFO(scheme.name);
        const auto integrator = make_integrator(scheme.settings);
        CHECK(integrator->error_order() == 3);
        const double step = 2e-5;
        const State state = take_step(*integrator, step);
        const State right = take_step(*make_integrator(exact), step);
        const StepError error =
            integrator->estimate_error(state, step, [&](int) { return system.length_scale(); });
        const double off = state.trial[0].Lambda.angularDistance(right.trial[0].Lambda);
        const double rate_off = step * (state.trial[0].omega - right.trial[0].omega).norm();
        CHECK(error.size == Approx(std::max(off, rate_off)).epsilon(0.02));
    }
}

TEST_CASE("estimates of errors fall with the power of the step that a scheme states",
          "[integrators][order]") {
    for (const SchemeSample& scheme : all_schemes()) {
        const auto integrator = make_integrator(scheme.settings);
        if (integrator->error_order() != 3 || scheme.settings.beta == 1.0 / 6.0) continue;
        INFO(scheme.name);
        const Model model = heavy_top::make_model();
        std::vector<double> errors;
        for (const long steps : {2000, 4000, 8000}) {
            DynamicSettings settings = scheme.settings;
            settings.end_time = 0.1;
            settings.steps = steps;
            settings.newton.tolerance = 1e-12;
            settings.adaptive = AdaptiveSettings{
                .tolerance = 1.0, .min_step = settings.time_step(), .max_step = settings.time_step()};
            DynamicAnalysis analysis(model, settings);
            REQUIRE(analysis.start().converged());
            while (!analysis.finished()) REQUIRE(analysis.advance().converged());
            errors.push_back(analysis.largest_error());
        }
        INFO("errors " << errors[0] << " " << errors[1] << " " << errors[2]);
        CHECK(compute_orders(errors)[1] == Approx(3.0).margin(0.1));
    }
}
