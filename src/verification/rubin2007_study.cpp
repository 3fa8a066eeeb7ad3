#include "verification/rubin2007_study.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "analyses/dynamic.hpp"
#include "rotation/rotation_map.hpp"
#include "verification/rubin2007_matrix_rk4.hpp"

namespace gxrod::rubin2007 {

namespace {

DynamicSettings make_settings(StudyScheme scheme, long steps) {
    DynamicSettings settings;
    settings.end_time = period;
    settings.steps = steps;
    settings.newton.absolute_residual = 1e-12 * momentum_scale;
    switch (scheme) {
        case StudyScheme::newmark_ibrahimbegovic:
            settings.scheme = Scheme::newmark_ibrahimbegovic;
            break;
        case StudyScheme::sdirk_4:
            settings.scheme = Scheme::sdirk_4;
            break;
        case StudyScheme::radau_5:
            settings.scheme = Scheme::radau_5;
            break;
        case StudyScheme::gauss_4:
            settings.scheme = Scheme::gauss_4;
            break;
        case StudyScheme::quaternion_rk4:
            settings.scheme = Scheme::runge_kutta_4;
            break;
        default:
            settings.scheme = Scheme::newmark_simplified;
    }
    return settings;
}

// Adds a sample and raises the maxima; true as long as the run makes sense.
bool take_sample(Trace& trace, double time, const Errors& errors) {
    trace.samples.push_back({time, errors});
    Errors& worst = *trace.row.errors;
    worst.orientation = std::max(worst.orientation, errors.orientation);
    worst.momentum = std::max(worst.momentum, errors.momentum);
    worst.energy = std::max(worst.energy, errors.energy);
    // Two orthogonal matrices are at most 2√2 apart, and energy and momentum are errors relative to 1.
    const bool bounded = errors.orientation < 10.0 && errors.momentum < 10.0 && errors.energy < 10.0;
    return bounded;
}

void mark_diverged(Trace& trace) {
    trace.row = Row{trace.row.scheme, trace.row.steps, true, std::nullopt, std::nullopt, std::nullopt};
}

Trace run_matrix_rk4(long steps) {
    Trace trace{{StudyScheme::matrix_rk4, steps, false, std::nullopt, Errors{}, std::nullopt}, {}};
    const double time_step = period / static_cast<double>(steps);
    MatrixMotion motion{exact_rotation(0.0), exact_angular_velocity(0.0)};
    for (long n = 0; n <= steps; ++n) {
        const double time = static_cast<double>(n) * time_step;
        if (n > 0) motion = step_matrix_rk4(motion, time - time_step, time_step);
        const Vec3 momentum = compute_momentum(motion);
        const Errors errors = compute_errors(time, motion.Lambda, momentum, 0.5 * motion.omega.dot(momentum));
        if (!take_sample(trace, time, errors)) {
            mark_diverged(trace);
            break;
        }
    }
    return trace;
}

Trace run_integrator(StudyScheme scheme, long steps) {
    Trace trace{{scheme, steps, false, 0.0, Errors{}, std::nullopt}, {}};
    const Model model = make_model();
    DynamicAnalysis analysis(model, make_settings(scheme, steps));
    const Quat attitude = model.bodies[0].attitude;
    long iterations = 0;
    bool going = analysis.start().converged();
    Quat previous = Quat::Identity();
    while (going) {
        const NodeMotion& motion = analysis.state().trial[0];
        const LedgerRow ledger = analysis.ledger_row();
        const double angle = log(motion.Lambda * previous.conjugate()).norm() * 180.0 / std::numbers::pi;
        trace.row.max_theta_deg = std::max(*trace.row.max_theta_deg, angle);
        previous = motion.Lambda;
        const Mat3 Lambda = (motion.Lambda * attitude).toRotationMatrix();
        const double time = analysis.state().time;
        going = take_sample(
            trace, time, compute_errors(time, Lambda, ledger.angular_momentum, ledger.kinetic_energy));
        if (!going || analysis.finished()) break;
        // A step that had to be cut is no longer the scheme at N steps.
        going = analysis.advance().converged() && analysis.solver_row().rejected_steps == 0;
        iterations += analysis.solver_row().newton_iterations;
    }
    if (!going) {
        mark_diverged(trace);
    } else if (scheme != StudyScheme::quaternion_rk4) {
        trace.row.iterations_per_step = static_cast<double>(iterations) / static_cast<double>(steps);
    }
    return trace;
}

bool agrees(double value, double reference, int digits) {
    return std::abs(value - reference) <= half_unit(reference, digits);
}

}  // namespace

double half_unit(double reference, int digits) {
    return 0.5 * std::pow(10.0, std::floor(std::log10(std::abs(reference))) - (digits - 1));
}

std::string name_of(StudyScheme scheme) {
    switch (scheme) {
        case StudyScheme::newmark_simplified:
            return "S";
        case StudyScheme::newmark_ibrahimbegovic:
            return "I";
        case StudyScheme::matrix_rk4:
            return "RK4";
        case StudyScheme::sdirk_4:
            return "SDIRK4";
        case StudyScheme::radau_5:
            return "RADAU5";
        case StudyScheme::gauss_4:
            return "GAUSS4";
        case StudyScheme::quaternion_rk4:
            break;
    }
    return "RK4Q";
}

Trace run_scheme(StudyScheme scheme, long steps) {
    return scheme == StudyScheme::matrix_rk4 ? run_matrix_rk4(steps) : run_integrator(scheme, steps);
}

Comparison compare(const Row& row) {
    for (const Reference& reference : references()) {
        if (reference.scheme != row.scheme || reference.steps != row.steps) continue;
        if (reference.diverges || row.diverged) return {&reference, reference.diverges == row.diverged};
        bool matches =
            agrees(row.errors->orientation, reference.errors.orientation, reference.orientation_digits);
        if (reference.errors.momentum > 0.0) {
            const int digits = reference.momentum_digits;
            matches = matches && agrees(row.errors->momentum, reference.errors.momentum, digits) &&
                      agrees(row.errors->energy, reference.errors.energy, digits);
        }
        if (reference.max_theta_deg)
            matches = matches && agrees(*row.max_theta_deg, *reference.max_theta_deg, 5);
        return {&reference, matches};
    }
    return {};
}

std::vector<Row> run_study(const std::vector<long>& steps) {
    std::vector<Row> rows;
    for (const StudyScheme scheme : {StudyScheme::newmark_simplified,
                                     StudyScheme::newmark_ibrahimbegovic,
                                     StudyScheme::matrix_rk4,
                                     StudyScheme::sdirk_4,
                                     StudyScheme::radau_5,
                                     StudyScheme::gauss_4,
                                     StudyScheme::quaternion_rk4}) {
        for (const long n : steps) rows.push_back(run_scheme(scheme, n).row);
    }
    return rows;
}

}  // namespace gxrod::rubin2007
