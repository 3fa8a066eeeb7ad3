#include "integrators/scheme_samples.hpp"

#include "state/increment.hpp"
#include "tools/random_values.hpp"

namespace gxrod::tools {

namespace {

SchemeSample make_newmark(const std::string& name, Scheme scheme, double beta, double gamma) {
    DynamicSettings settings;
    settings.scheme = scheme;
    settings.beta = beta;
    settings.gamma = gamma;
    return {name, settings, gamma == 0.5 ? 2.0 : 1.0};
}

SchemeSample make_alpha(const std::string& name, double spectral_radius) {
    DynamicSettings settings;
    settings.scheme = Scheme::generalized_alpha;
    settings.spectral_radius = spectral_radius;
    return {name, settings, 2.0};
}

SchemeSample make_runge_kutta(const std::string& name, Scheme scheme, double order = 4.0) {
    DynamicSettings settings;
    settings.scheme = scheme;
    return {name, settings, order};
}

}  // namespace

const std::vector<SchemeSample>& all_schemes() {
    static const std::vector<SchemeSample> schemes{
        make_newmark("newmark-simplified", Scheme::newmark_simplified, 0.25, 0.5),
        make_newmark("newmark-simplified, beta 0.3", Scheme::newmark_simplified, 0.3, 0.5),
        make_newmark("newmark-simplified, gamma 0.6", Scheme::newmark_simplified, 0.3025, 0.6),
        make_newmark("newmark-ibrahimbegovic", Scheme::newmark_ibrahimbegovic, 0.25, 0.5),
        make_newmark("newmark-ibrahimbegovic, beta 1/6", Scheme::newmark_ibrahimbegovic, 1.0 / 6.0, 0.5),
        make_newmark("newmark-ibrahimbegovic, gamma 0.6", Scheme::newmark_ibrahimbegovic, 0.3025, 0.6),
        make_alpha("generalized-alpha, radius 0", 0.0),
        make_alpha("generalized-alpha, radius 0.5", 0.5),
        make_alpha("generalized-alpha, radius 0.9", 0.9),
        make_alpha("generalized-alpha, radius 1", 1.0),
        make_runge_kutta("sdirk-4", Scheme::sdirk_4),
        make_runge_kutta("radau-5", Scheme::radau_5, 5.0),
        make_runge_kutta("gauss-4", Scheme::gauss_4),
        make_runge_kutta("runge-kutta-4", Scheme::runge_kutta_4),
    };
    return schemes;
}

State make_random_state(const Integrator& integrator, unsigned seed) {
    RandomValues random(seed);
    State state;
    state.time = 0.3;
    state.previous.resize(2);
    for (NodeMotion& motion : state.previous) {
        motion = {random.vector(),
                  random.rotation(),
                  Vec3::Zero(),
                  random.vector(),
                  random.vector(),
                  random.vector(2.0),
                  random.vector(5.0)};
    }
    state.trial = state.previous;
    integrator.start(state);
    for (CarriedAcceleration& A : state.carried_previous) A = {random.vector(), random.vector(5.0)};
    return state;
}

Stage make_stage(int index) { return {index, 0.3, 0.2, 0.5}; }

void begin_random_stage(const Integrator& integrator, const Stage& stage, unsigned seed, State& state) {
    RandomValues random(seed);
    integrator.begin_stage(state, stage);
    for (int j = 0; j < stage.index && j < static_cast<int>(state.stages.size()); ++j) {
        for (StageRates& rates : state.stages[j]) {
            rates = {
                random.vector(), random.vector(), random.vector(), random.vector(), Eigen::Vector4d::Zero()};
        }
    }
    for (std::size_t i = 0; i < state.trial.size(); ++i) {
        const NodeMotion& previous = state.previous[i];
        const Vec3 theta = random.number(0.3, 2.5) * random.direction();
        place(previous, previous.r + random.vector(0.3), theta, state.trial[i]);
    }
    integrator.update_rates(state, stage);
}

Rates stack_rates(const NodeMotion& motion) {
    Rates rates;
    rates << motion.v, motion.a, motion.omega, motion.alpha;
    return rates;
}

}  // namespace gxrod::tools
