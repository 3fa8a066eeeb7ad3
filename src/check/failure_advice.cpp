#include "check/failure_advice.hpp"

#include <fmt/format.h>

namespace gxrod {

namespace {

using Phase = Failure::Phase;
using Advice = std::vector<std::string>;

std::string join(const std::vector<std::string>& words, const char* separator) {
    return fmt::format("{}", fmt::join(words, separator));
}

std::string shorter_steps(const Failure& failure) {
    if (failure.phase == Phase::instant) return "a load that grows over a time, not at once";
    return failure.phase == Phase::load_step ? "more steps" : "a smaller time_step";
}

void add_stability(const Failure& failure, Advice& advice) {
    if (failure.phase != Phase::explicit_step) return;
    advice.push_back(
        "a smaller time_step: runge-kutta-4 is stable only while the step is short compared with the "
        "shortest "
        "period, which the shortest and stiffest element has");
    advice.push_back("an implicit integrator, such as generalized-alpha");
}

void advise_on_iterations(const Failure& failure, Advice& advice) {
    advice.push_back(shorter_steps(failure));
    advice.push_back("a finer mesh (elements, order) there");
    advice.push_back("a larger newton.max_iterations");
    if (!failure.open_joint.empty()) {
        advice.push_back(
            "a look at the mechanism near this position: at the end of its stroke, or where it can fold up "
            "in two "
            "ways, a motor cannot move it further");
    }
    if (failure.phase == Phase::load_step || failure.phase == Phase::instant) {
        advice.push_back(
            "a dynamic analysis, if this is a load that the structure cannot carry without a jump to another "
            "shape");
    }
}

constexpr const char* damping_scheme =
    "integrator = \"generalized-alpha\", which damps what is too fast for the steps";
constexpr const char* keeping_scheme =
    "integrator = \"gauss-4\", where a model turns almost without vibrating";

void advise_on_singularity(const Failure& failure, Advice& advice) {
    if (failure.phase == Phase::load_step || failure.phase == Phase::instant) {
        advice.push_back("a support that holds this motion, or stiffness against it");
        advice.push_back("a small load sideways, if the structure buckles here");
        return;
    }
    advice.push_back(
        "inertia for this motion: rhoA, rhoJ, rhoIy, rhoIz of a section, mass and inertia of a body");
    if (failure.phase == Phase::implicit_step) advice.push_back("a smaller time_step");
}

Advice advise_on_contrast(const Failure& failure) {
    Advice advice{failure.contrast_advice};
    if (failure.outcome == Outcome::out_of_iterations) advice.push_back("a larger newton.max_iterations");
    return advice;
}

std::string describe_start(const Failure& failure) {
    switch (failure.phase) {
        case Phase::initial_accelerations:
            return "the initial accelerations cannot be found: ";
        case Phase::load_step:
            return fmt::format("the step from load factor {:.10g} failed, even with one of {:.3g}: ",
                               failure.time,
                               failure.time_step);
        case Phase::instant:
            return fmt::format(
                "there is no equilibrium under what acts at once at t = {:.10g}, not even where it grows in "
                "parts: ",
                failure.time);
        case Phase::implicit_step:
        case Phase::explicit_step:
            break;
    }
    return fmt::format(
        "the step from t = {:.10g} failed, even with Δt = {:.3g}: ", failure.time, failure.time_step);
}

std::string describe_gap(const Failure& failure) {
    if (failure.open_joint.empty()) return "";
    return fmt::format(
        "; {} stays open by {:.2e} of the model's length", failure.open_joint, failure.joint_gap);
}

std::string describe_outcome(const Failure& failure) {
    const std::string at = failure.places.empty() ? "" : " at " + join(failure.places, ", ");
    switch (failure.outcome) {
        case Outcome::converged:
            break;
        case Outcome::out_of_iterations:
            return fmt::format(
                       "Newton's method did not converge in {} iterations; the residual, {:.2e} of the "
                       "largest "
                       "force or "
                       "moment, is largest{}",
                       failure.iterations,
                       failure.residual,
                       at) +
                   describe_gap(failure);
        case Outcome::singular:
            return "the system of equations is singular" + at;
        case Outcome::not_finite:
            return "a force or increment is not a finite number" + at +
                   (failure.shrunk_spring.empty()
                        ? ""
                        : ": spring " + failure.shrunk_spring +
                              " has almost no length left, and at none no direction");
        case Outcome::rotation_too_large:
            return "the rotation within one step reaches half a turn" + at;
        case Outcome::element_too_turned:
            return "one element's nodes turn against each other by half a turn" + at;
        case Outcome::error_too_large:
            return fmt::format(
                "the estimated error of the step, {:.2e}, is above the tolerance{}", failure.step_error, at);
        case Outcome::energy_out_of_reach:
            return failure.limits_energy
                       ? "the step gains energy by contact, more than can be taken from its vibrations"
                       : "the energy of the step is off by more than the vibrations of the model can take up";
        case Outcome::joints_open:
            return fmt::format(
                "no velocities near those of the step fit {}, which are off by {:.2e} of the largest",
                failure.open_joint,
                failure.joint_gap);
        case Outcome::control_turned:
            return "the displacement or rotation that controls the path turns back here";
        case Outcome::path_crawls:
            return "the path crawls: each of its last steps was shorter than a thousandth of its longest one";
        case Outcome::lost_stability:
            return "the equilibrium found is less stable than the one before" + at;
    }
    return "";
}

}  // namespace

std::vector<std::string> advise(const Failure& failure) {
    if (!failure.contrast.empty()) return advise_on_contrast(failure);
    Advice advice;
    switch (failure.outcome) {
        case Outcome::converged:
            break;
        case Outcome::out_of_iterations:
            advise_on_iterations(failure, advice);
            break;
        case Outcome::singular:
            advise_on_singularity(failure, advice);
            break;
        case Outcome::not_finite:
            add_stability(failure, advice);
            advice.push_back(failure.shrunk_spring.empty()
                                 ? "a look at the values of the loads and functions at this time"
                                 : "a spring with length = 0, which pulls its points together");
            break;
        case Outcome::rotation_too_large:
            add_stability(failure, advice);
            if (advice.empty()) advice.push_back(shorter_steps(failure));
            break;
        case Outcome::element_too_turned:
            add_stability(failure, advice);
            advice.push_back("more elements");
            if (failure.phase != Phase::explicit_step) advice.push_back(shorter_steps(failure));
            break;
        case Outcome::error_too_large:
            advice.push_back("a smaller adaptive.min_step");
            advice.push_back("a larger adaptive.tolerance");
            break;
        case Outcome::energy_out_of_reach:
            advice.push_back(shorter_steps(failure));
            advice.push_back(failure.limits_energy ? damping_scheme : keeping_scheme);
            break;
        case Outcome::joints_open:
            advice.push_back(shorter_steps(failure));
            advice.push_back(
                "a look at the mechanism there: near a position where it locks, velocities have no limit");
            break;
        case Outcome::control_turned:
            advice.push_back("a path without control: its arc length goes on where displacements turn back");
            break;
        case Outcome::path_crawls:
            advice.push_back("a look at functions of t with a kink or a jump there");
            advice.push_back("a smaller newton.tolerance");
            advice.push_back("until.steps, which ends the path where it is");
            break;
        case Outcome::lost_stability:
            advice.push_back(shorter_steps(failure));
            break;
    }
    return advice;
}

std::string describe_failure(const Failure& failure) {
    std::string text = describe_start(failure) + describe_outcome(failure);
    if (!failure.contrast.empty()) text += ". Likely because " + failure.contrast;
    if (!failure.weakness.empty()) text += ". Nothing resists this motion: " + failure.weakness;
    const std::vector<std::string> advice = advise(failure);
    if (!advice.empty()) text += ". Try " + join(advice, "; or ");
    return text;
}

}  // namespace gxrod
