#include "constraints/joints/joint_force.hpp"

#include <algorithm>
#include <cmath>

#include "constraints/joints/play/bound_push.hpp"

namespace gxrod {

namespace {

void add_limits(const CoordinateLimits& limits, const ScalarJet& coordinate, CoordinateForce& force) {
    const auto [depth, rate, direction, push] = compute_limit_push(limits, coordinate);
    if (push.force == 0.0) return;
    force.value += direction * push.force;
    force.by_coordinate -= push.by_depth;
    force.by_rate -= push.by_rate;
}

double compute_strength(const Friction& friction, double held) {
    return friction.force + friction.lever * held;
}

void add_friction(
    const Friction& friction, double held, double coordinate, double slip, CoordinateForce& force) {
    if (!friction.acts()) return;
    const double stretch = coordinate - slip;
    const double stiffness = compute_strength(friction, held) / friction.stick;
    const double elastic = std::clamp(stretch, -friction.stick, friction.stick);
    force.value -= stiffness * elastic;
    if (std::abs(stretch) < friction.stick) force.by_coordinate -= stiffness;
    force.by_held -= friction.lever * elastic / friction.stick;
}

// What a force on a coordinate adds to a joint's tangent, (J15). Coordinate: JointTurn or LinkProduct.
template <class Coordinate>
void add_coordinate_tangent(const Coordinate& coordinate,
                            const CoordinateForce& force,
                            const JointFrames& frames,
                            const JointLinearizations& linearizations,
                            PairMatrix& tangent) {
    PairRow gradient = PairRow::Zero(), change = PairRow::Zero();
    coordinate.add_gradient(frames, 1.0, gradient);
    coordinate.add_change(frames, linearizations, {force.by_coordinate, force.by_rate, 0.0}, change);
    JointReaction reaction;
    coordinate.add_reaction(frames, force.value, reaction);
    const PairMatrix turned = reaction.compute_derivative(frames);
    tangent.leftCols<6>() += linearizations.a.placement * turned.leftCols<6>();
    tangent.rightCols<6>() += linearizations.b.placement * turned.rightCols<6>();
    tangent += gradient.transpose() * change;
}

}  // namespace

bool is_acted_on(const JointCoordinate& laws) {
    const bool has_limits = laws.limits.act() && !laws.limits.are_rigid();
    return laws.stiffness != 0.0 || laws.damping != 0.0 || !laws.drive.is_zero() || laws.friction.acts() ||
           has_limits;
}

bool is_damped_by(const JointCoordinate& laws) {
    return laws.damping > 0.0 || laws.friction.acts() || laws.limits.damping > 0.0;
}

bool is_driven_by(const JointCoordinate& laws) {
    return laws.motion || !laws.drive.is_zero() || !laws.rest.is_constant();
}

double compute_friction_force(const Friction& friction, double held, double coordinate, double slip) {
    CoordinateForce force;
    add_friction(friction, held, coordinate, slip, force);
    return force.value;
}

CoordinateForce compute_coordinate_force(const JointCoordinate& laws,
                                         const ScalarJet& coordinate,
                                         const CoordinateInputs& inputs,
                                         double slip) {
    CoordinateForce force;
    force.value =
        inputs.drive - laws.stiffness * (coordinate.value - inputs.rest) - laws.damping * coordinate.rate;
    force.by_coordinate = -laws.stiffness;
    force.by_rate = -laws.damping;
    add_friction(laws.friction, inputs.held, coordinate.value, slip, force);
    add_limits(laws.limits, coordinate, force);
    return force;
}

double compute_coordinate_energy(const JointCoordinate& laws,
                                 double coordinate,
                                 const CoordinateInputs& inputs,
                                 double slip) {
    const double stretch = coordinate - inputs.rest;
    const double depth = compute_limit_push(laws.limits, {coordinate, 0.0, 0.0}).depth;
    double energy = 0.5 * laws.stiffness * stretch * stretch + compute_bound_energy(laws.limits, depth);
    if (laws.friction.acts()) {
        const double elastic = std::min(std::abs(coordinate - slip), laws.friction.stick);
        energy +=
            0.5 * compute_strength(laws.friction, inputs.held) / laws.friction.stick * elastic * elastic;
    }
    return energy;
}

double compute_coordinate_damping_power(const JointCoordinate& laws, const ScalarJet& coordinate) {
    const auto [depth, rate, direction, push] = compute_limit_push(laws.limits, coordinate);
    return laws.damping * coordinate.rate * coordinate.rate + (push.force - push.elastic) * rate;
}

double compute_slip(const Friction& friction, double coordinate, double slip) {
    return std::clamp(slip, coordinate - friction.stick, coordinate + friction.stick);
}

double compute_first_slip(const Friction& friction, const ScalarJet& coordinate, double speed) {
    constexpr double round_off = 1e-9;
    if (std::abs(coordinate.rate) <= round_off * speed) return coordinate.value;
    return coordinate.value - std::copysign(friction.stick, coordinate.rate);
}

double compute_slip_dissipation(const Friction& friction, double held, double slip_before, double slip) {
    return compute_strength(friction, held) * std::abs(slip - slip_before);
}

JointForces::JointForces(const Joint& joint)
    : arms_(arms_of(joint)), turn_laws_(joint.turn), slide_laws_(joint.slide) {
    const JointCoordinates coordinates(joint);
    if (is_acted_on(turn_laws_)) turn_ = coordinates.turn;
    if (is_acted_on(slide_laws_) && coordinates.slide) slide_ = coordinates.slide->product();
    if (joint.clearance) clearance_.emplace(joint);
}

template <class Visit>
void JointForces::visit(const JointFrames& frames, double turn_before, Visit&& visit_one) const {
    if (turn_) {
        const ScalarJet jet = turn_->compute_jet(frames, turn_before);
        visit_one(Acting<JointTurn>{*turn_, turn_laws_, jet, &JointInputs::turn, &JointSlips::turn});
    }
    if (slide_) {
        const ScalarJet jet = slide_->compute_jet(frames);
        visit_one(Acting<LinkProduct>{*slide_, slide_laws_, jet, &JointInputs::slide, &JointSlips::slide});
    }
}

PairRow JointForces::compute_force(const JointMotions& motions,
                                   double turn_before,
                                   const JointInputs& inputs,
                                   const JointSlips& slips) const {
    PairRow force = PairRow::Zero();
    const JointFrames frames = rates_at(motions);
    visit(frames, turn_before, [&](const auto& it) {
        const auto on_b = compute_coordinate_force(it.laws, it.jet, inputs.*it.inputs, slips.*it.slip);
        it.coordinate.add_gradient(frames, on_b.value, force);
    });
    if (clearance_) force += clearance_->compute_force(motions);
    return force;
}

PairMatrix JointForces::compute_tangent(const JointMotions& motions,
                                        const JointLinearizations& linearizations,
                                        double turn_before,
                                        const JointInputs& inputs,
                                        const JointSlips& slips) const {
    PairMatrix tangent = PairMatrix::Zero();
    const JointFrames frames(motions, arms_, ConstraintLevel::acceleration);
    visit(frames, turn_before, [&](const auto& it) {
        const auto force = compute_coordinate_force(it.laws, it.jet, inputs.*it.inputs, slips.*it.slip);
        add_coordinate_tangent(it.coordinate, force, frames, linearizations, tangent);
    });
    if (clearance_) tangent += clearance_->compute_tangent(motions, linearizations);
    return tangent;
}

PairRow JointForces::compute_held_derivative(const JointMotions& motions,
                                             double turn_before,
                                             const JointInputs& inputs,
                                             const JointSlips& slips) const {
    PairRow derivative = PairRow::Zero();
    const JointFrames frames = rates_at(motions);
    visit(frames, turn_before, [&](const auto& it) {
        const auto on_b = compute_coordinate_force(it.laws, it.jet, inputs.*it.inputs, slips.*it.slip);
        it.coordinate.add_gradient(frames, on_b.by_held, derivative);
    });
    return derivative;
}

double JointForces::compute_strain_energy(const JointMotions& motions,
                                          double turn_before,
                                          const JointInputs& inputs,
                                          const JointSlips& slips) const {
    double energy = 0.0;
    visit(rates_at(motions), turn_before, [&](const auto& it) {
        energy += compute_coordinate_energy(it.laws, it.jet.value, inputs.*it.inputs, slips.*it.slip);
    });
    if (clearance_) energy += clearance_->compute_energy(motions);
    return energy;
}

double JointForces::compute_damping_power(const JointMotions& motions, double turn_before) const {
    double power = 0.0;
    visit(rates_at(motions), turn_before, [&](const auto& it) {
        power += compute_coordinate_damping_power(it.laws, it.jet);
    });
    if (clearance_) power += clearance_->compute_damping_power(motions);
    return power;
}

JointSlips JointForces::compute_slips(const JointMotions& motions,
                                      double turn_before,
                                      const JointSlips& before) const {
    JointSlips slips = before;
    visit(rates_at(motions), turn_before, [&](const auto& it) {
        slips.*it.slip = compute_slip(it.laws.friction, it.jet.value, before.*it.slip);
    });
    return slips;
}

JointSlips JointForces::compute_first_slips(const JointMotions& motions, double turn_before) const {
    const auto speed_of = [](const NodeMotion& node, const Vec3& arm) {
        return node.v.norm() + node.omega.norm() * arm.norm();
    };
    JointSlips speeds;
    speeds.turn = motions.a.omega.norm() + motions.b.omega.norm();
    speeds.slide = speed_of(motions.a, arms_.a) + speed_of(motions.b, arms_.b);
    JointSlips slips;
    visit(rates_at(motions), turn_before, [&](const auto& it) {
        slips.*it.slip = compute_first_slip(it.laws.friction, it.jet, speeds.*it.slip);
    });
    return slips;
}

double JointForces::compute_dissipation(const JointInputs& inputs,
                                        const JointSlips& before,
                                        const JointSlips& slips) const {
    return compute_slip_dissipation(turn_laws_.friction, inputs.turn.held, before.turn, slips.turn) +
           compute_slip_dissipation(slide_laws_.friction, inputs.slide.held, before.slide, slips.slide);
}

}  // namespace gxrod
