#include <algorithm>
#include <sstream>

#include "assembly/joints/joint_assembly.hpp"
#include "constraints/joints/joint_motors.hpp"
#include "constraints/joints/play/bound_push.hpp"
#include "model/evaluation_error.hpp"

// What is measured of joints, once a step.
namespace gxrod {

namespace {

// By so much of its length a roller may pass the end of an open curve, or be lifted without a gap.
constexpr double end_tolerance = 1e-9;

}  // namespace

std::vector<Vec6> JointAssembly::compute_driving_forces(const State& state, double time) const {
    if (!are_driven_) return std::vector<Vec6>(count(), Vec6::Zero());
    std::vector<Vec6> forces(joints_.size(), Vec6::Zero());
    const std::vector<Vec6> coordinates = compute_coordinates(state.trial, time, state);
    for (std::size_t i = 0; i < joints_.size(); ++i) {
        if (!holds(state, i)) continue;
        const Joint& joint = model_->joints[i];
        const JointRows& rows = joints_[i];
        const auto exerted = [&](const JointCoordinate& laws, int motor_row) {
            return laws.drive(time) + (motor_row >= 0 ? state.joints_trial[i].multipliers[motor_row] : 0.0);
        };
        forces[i][0] = exerted(joint.turn, rows.turn_motor_row());
        forces[i][1] = exerted(joint.slide, rows.slide_motor_row());
        forces[i][2] = joint.turn.stiffness * (coordinates[i][2] - coordinates[i][0]);
        forces[i][3] = joint.slide.stiffness * (coordinates[i][3] - coordinates[i][1]);
    }
    wide_.add_driving_forces(state, time, forces);
    return forces;
}

std::vector<Vec6> JointAssembly::compute_coordinates(const std::vector<NodeMotion>& nodes,
                                                     double time,
                                                     const State& state) const {
    if (!are_driven_) return std::vector<Vec6>(count(), Vec6::Zero());
    std::vector<Vec6> coordinates(joints_.size(), Vec6::Zero());
    for (std::size_t i = 0; i < joints_.size(); ++i) {
        const Joint& joint = model_->joints[i];
        const JointPlace place = place_of(nodes, i, state);
        coordinates[i].head<4>() << place.turn.value, place.slide.value, joint.turn.rest(time),
            joint.slide.rest(time);
    }
    wide_.add_coordinates(nodes, time, state, coordinates);
    return coordinates;
}

std::vector<Vec6> JointAssembly::compute_movement(const State& state, double time) const {
    std::vector<Vec6> movement = compute_coordinates(state.trial, time, state);
    const std::vector<Vec6> before = compute_coordinates(state.previous, state.time, state);
    for (std::size_t i = 0; i < movement.size(); ++i) movement[i] -= before[i];
    return movement;
}

double JointAssembly::compute_driving_power(const State& state, double time, const TimeSpan& step) const {
    double power = 0.0;
    if (!are_driven_) return power;
    const std::vector<Vec6> forces = compute_driving_forces(state, time);
    for (std::size_t i = 0; i < joints_.size(); ++i) {
        const Joint& joint = model_->joints[i];
        const JointPlace place = place_of(state.trial, i, state);
        power += forces[i][0] * place.turn.rate + forces[i][1] * place.slide.rate +
                 forces[i][2] * differentiate(joint.turn.rest, time, step) +
                 forces[i][3] * differentiate(joint.slide.rest, time, step);
    }
    return power + wide_.compute_driving_power(state, time, step);
}

JointAssembly::JointPlace JointAssembly::place_of(const std::vector<NodeMotion>& nodes,
                                                  std::size_t index,
                                                  const State& state) const {
    const auto& [turn, slide] = joints_[index].coordinates();
    JointPlace place;
    if (turn) place.turn = turn->compute_jet(motions(nodes, index), state.joints_previous[index].turn);
    if (slide) place.slide = slide->compute_jet(motions(nodes, index));
    return place;
}

double JointAssembly::compute_strain_energy(const State& state, double time) const {
    double energy = 0.0;
    for (std::size_t i = 0; i < joints_.size() && have_forces_; ++i) {
        if (!holds(state, i) || breaks(state, time, i)) continue;
        // Of the last accepted step, and also of one that has not been committed.
        const JointState& before = state.joints_previous[i];
        const JointMotions at = motions(state.trial, i);
        const JointSlips slips = forces_[i].compute_slips(at, before.turn, slips_before(state, i));
        energy += forces_[i].compute_strain_energy(at, before.turn, inputs_at(i, state, time), slips);
    }
    return energy + wide_.compute_strain_energy(state, time);
}

double JointAssembly::compute_damping_power(const State& state) const {
    double power = 0.0;
    for (std::size_t i = 0; i < joints_.size() && is_damped_; ++i) {
        if (!holds(state, i)) continue;
        power += forces_[i].compute_damping_power(motions(state.trial, i), state.joints_previous[i].turn);
    }
    return power + wide_.compute_damping_power(state);
}

double JointAssembly::compute_damping_action(const State& state) const {
    const double step = state.trial_time - state.time;
    double action = 0.0;
    for (std::size_t i = 0; i < joints_.size() && is_damped_; ++i) {
        if (!holds(state, i)) continue;
        const Joint& joint = model_->joints[i];
        const JointPlace before = place_of(state.previous, i, state);
        const JointPlace after = place_of(state.trial, i, state);
        action += compute_coordinate_damping_action(joint.turn, before.turn, after.turn, step) +
                  compute_coordinate_damping_action(joint.slide, before.slide, after.slide, step) +
                  compute_contact_action(state, i);
    }
    return action + wide_.compute_damping_action(state);
}

// Of contact in a clearance, whose dissipation is not quadratic in rates: the mean power at both ends.
double JointAssembly::compute_contact_action(const State& state, std::size_t index) const {
    const std::optional<ClearanceForce>& clearance = forces_[index].clearance();
    if (!clearance) return 0.0;
    const double step = state.trial_time - state.time;
    return 0.5 * step * step *
           (clearance->compute_damping_power(motions(state.previous, index)) +
            clearance->compute_damping_power(motions(state.trial, index)));
}

double JointAssembly::compute_slip_dissipation(const State& state) const {
    double dissipated = 0.0;
    for (std::size_t i = 0; i < joints_.size() && have_forces_; ++i) {
        if (!holds(state, i)) continue;
        const JointMotions at = motions(state.trial, i);
        const double turn = state.joints_previous[i].turn;
        const JointSlips before = slips_before(state, i);
        const JointSlips after = forces_[i].compute_slips(at, turn, before);
        if (is_damped_)
            dissipated += forces_[i].compute_dissipation(inputs_at(i, state, state.time), before, after);
        // What a joint stores that breaks is lost.
        if (breaks(state, state.trial_time, i))
            dissipated +=
                forces_[i].compute_strain_energy(at, turn, inputs_at(i, state, state.trial_time), after);
    }
    return dissipated + wide_.compute_slip_dissipation(state);
}

std::vector<JointValues> JointAssembly::compute_joint_values(const State& state, double time) const {
    std::vector<JointValues> all(joints_.size());
    for (std::size_t i = 0; i < joints_.size(); ++i) {
        const Joint& joint = model_->joints[i];
        const JointMotions at = motions(state.trial, i);
        const JointPlace place = place_of(state.trial, i, state);
        JointValues& values = all[i];
        values.turn = place.turn.value;
        values.turn_rate = place.turn.rate;
        values.slide = place.slide.value;
        values.slide_rate = place.slide.rate;
        const Vec3 point = at.b.r + at.b.Lambda * joint.b.anchor.arm;
        const PairVector force = compute_force(state, time, i);
        // On B, or the opposite of that on A.
        const bool of_b = !joint.b.anchor.is_ground();
        const Vec6 wrench = of_b ? Vec6(force.tail<6>()) : Vec6(-force.head<6>());
        const Vec3& r = of_b ? at.b.r : at.a.r;
        values.force = wrench.head<3>();
        values.moment = wrench.tail<3>() + (r - point).cross(values.force);
        const Mat3 axes = at.a.Lambda.toRotationMatrix() * joint.a.axes;
        values.force_in_joint = axes.transpose() * values.force;
        values.moment_in_joint = axes.transpose() * values.moment;
        if (const auto& cam = joints_[i].cam()) {
            const JointFrames frames = joints_[i].compute_frames(at, ConstraintLevel::position);
            values.curve_place = cam->find_place(frames).arc_length;
            values.curve_gap = cam->compute_jet(frames).value - cam->cam().roller;
            values.normal_force = cam->find_normal(frames).dot(values.force);
        }
        values.holds = holds(state, i);
        if (!values.holds) continue;
        if (const auto& clearance = forces_[i].clearance()) values.play = clearance->compute_distance(at);
        const auto drive = [&](const JointCoordinate& laws, int motor_row) {
            return motor_row < 0 ? laws.drive(time) : state.joints_trial[i].multipliers[motor_row];
        };
        values.drive_turn = drive(joint.turn, joints_[i].turn_motor_row());
        values.drive_slide = drive(joint.slide, joints_[i].slide_motor_row());
        const JointInputs inputs = inputs_at(i, state, time);
        const JointSlips slips = slips_before(state, i);
        values.friction =
            compute_friction_force(joint.turn.friction, inputs.turn.held, place.turn.value, slips.turn) +
            compute_friction_force(joint.slide.friction, inputs.slide.held, place.slide.value, slips.slide);
        const JointMotors motors = compute_motors(joint, time, {}, ConstraintLevel::position);
        const JointGap gap = joints_[i].compute_gap(at, state.joints_previous[i].turn, motors);
        values.gap = std::max(gap.length, gap.angle * length_);
    }
    wide_.add_joint_values(state, time, all);
    return all;
}

void JointAssembly::check_ranges(const State& state, double time) const {
    for (std::size_t i = 0; i < joints_.size(); ++i) {
        const auto& cam = joints_[i].cam();
        if (!cam || cam->cam().curve->is_closed() || !holds(state, i)) continue;
        const JointFrames frames =
            joints_[i].compute_frames(motions(state.trial, i), ConstraintLevel::position);
        const double gap = cam->compute_jet(frames).value - cam->cam().roller;
        if (cam->cam().lifts && gap > end_tolerance * cam->cam().curve->length()) continue;
        const double length = cam->cam().curve->length(), place = cam->find_place(frames).arc_length;
        const double tolerance = end_tolerance * length;
        if (place >= -tolerance && place <= length + tolerance) continue;
        std::ostringstream at;
        at << time;
        throw EvaluationError(name(static_cast<int>(i)) + " runs off the " +
                              (place > length ? "end" : "start") + " of its curve at t = " + at.str() +
                              "; end the run before, or give a longer curve");
    }
    wide_.check_ranges(state, time);
}

}  // namespace gxrod
