#include "analyses/step_interior.hpp"

#include "analyses/shown_surroundings.hpp"
#include "assembly/contact/contacts.hpp"
#include "assembly/system_measures.hpp"
#include "assembly/system_values.hpp"
#include "elements/tie_values.hpp"
#include "rotation/tangent_map.hpp"

namespace gxrod {

StepInterior::StepInterior(const System& system, const Integrator& integrator)
    : system_(system), integrator_(integrator), fractions_(integrator.inner_fractions()) {
    fractions_.insert(fractions_.begin(), 0.0);
    fractions_.push_back(1.0);
}

void StepInterior::keep(const State& state, double end_time, bool is_settled) {
    state_ = state;
    state_.resultants.clear();
    end_time_ = end_time;
    places_.assign(fractions_.size(), Place{});
    has_contacts_ = has_frame_contacts_ = false;
    starts_at_rest_ = !system_.model().has_inertia && (state.time == 0.0 || is_settled);
    if (starts_at_rest_) find_first_rates();
}

// Those with which the motion to the end has no third derivative.
void StepInterior::find_first_rates() {
    const double by_time = 2.0 / (end_time_ - state_.time);
    for (std::size_t i = 0; i < state_.trial.size(); ++i) {
        NodeMotion& start = state_.previous[i];
        const NodeMotion& end = state_.trial[i];
        start.v = by_time * (end.r - start.r) - end.v;
        start.omega = by_time * end.theta - tangent_map_inverse(end.theta) * end.omega;
    }
}

std::vector<double> StepInterior::weights_at(double fraction) const {
    if (starts_at_rest_) return {0.0, 1.0};
    return integrator_.interpolation_weights(fraction);
}

State StepInterior::state_at(std::size_t place) const {
    State state = state_;
    const bool is_start = place == 0;
    const bool is_end = place + 1 == fractions_.size();
    if (is_start) {
        undo_trial(state);
    } else if (is_end) {
        state.trial_time = end_time_;
    } else {
        state.trial = state.stage_motions[place - 1];
        state.joints_trial = state.stage_joints[place - 1];
        state.trial_time = state.time + fractions_[place] * (end_time_ - state.time);
    }
    return state;
}

void StepInterior::find_values(bool with_elements, const std::vector<RodPlace>& watched) {
    for (std::size_t i = 0; i < places_.size(); ++i) {
        Place& place = places_[i];
        if (place.has_others && (place.has_sections || !with_elements)) continue;
        const State state = state_at(i);
        if (with_elements && !place.has_sections) {
            place.sections = SystemValues(system_).compute_section_values(state);
            place.has_sections = true;
        }
        if (place.has_others) continue;
        place.points = SystemValues(system_).compute_point_values(state, state.trial_time, watched);
        Residual residual;
        if (!system_.model().supports.empty())
            system_.compute_residual(state, state.trial_time, residual);
        else
            residual.nodal.assign(state.trial.size(), Vec6::Zero());
        place.reactions = SystemMeasures(system_).compute_reactions(residual);
        place.has_others = true;
    }
}

void StepInterior::find_contacts(bool is_for_frame, const std::vector<ContactWatch>& watched) {
    if (!Contacts(system_).are_possible() || has_frame_contacts_ || (has_contacts_ && !is_for_frame)) return;
    State end = state_at(fractions_.size() - 1);
    system_.commit(end, end_time_);
    contact_record_ = record_contacts(system_, end, end_time_, watched, is_for_frame);
    has_contacts_ = true;
    has_frame_contacts_ = is_for_frame;
}

void StepInterior::mix_joints(const std::vector<double>& weights) {
    const auto joints_at = [&](std::size_t place) -> const std::vector<JointState>& {
        if (place == 0) return state_.joints_previous;
        return place + 1 == weights.size() ? state_.joints_trial : state_.stage_joints[place - 1];
    };
    between_.joints_trial.assign(state_.joints_trial.size(), JointState{});
    for (std::size_t k = 0; k < weights.size(); ++k) {
        for (std::size_t i = 0; i < between_.joints_trial.size(); ++i) {
            const JointState& at = joints_at(k)[i];
            JointState& joint = between_.joints_trial[i];
            for (std::size_t row = 0; row < at.multipliers.size(); ++row)
                joint.multipliers[row] += weights[k] * at.multipliers[row];
            joint.turn += weights[k] * at.turn;
            joint.slide += weights[k] * at.slide;
        }
    }
}

// Axes are those of the interpolated motions.
void StepInterior::mix_sections(const std::vector<double>& weights) {
    sections_ = SystemValues(system_).compute_section_values(between_);
    for (std::size_t i = 0; i < sections_.size(); ++i) {
        SectionValues& section = sections_[i];
        section.force = section.moment = section.strain = section.curvature = Vec3::Zero();
        for (std::size_t k = 0; k < weights.size(); ++k) {
            const SectionValues& at = places_[k].sections[i];
            section.force += weights[k] * at.force;
            section.moment += weights[k] * at.moment;
            section.strain += weights[k] * at.strain;
            section.curvature += weights[k] * at.curvature;
        }
    }
}

// Motions and surroundings, too.
void StepInterior::mix_points(const std::vector<double>& weights) {
    for (std::size_t i = 0; i < points_.size(); ++i) {
        PointValues& point = points_[i];
        point.force = point.moment = point.strain = point.curvature = Vec3::Zero();
        for (std::size_t k = 0; k < weights.size(); ++k) {
            const PointValues& at = places_[k].points[i];
            point.force += weights[k] * at.force;
            point.moment += weights[k] * at.moment;
            point.strain += weights[k] * at.strain;
            point.curvature += weights[k] * at.curvature;
        }
    }
}

void StepInterior::mix_reactions(const std::vector<double>& weights) {
    reactions_.assign(state_.trial.size(), Vec6::Zero());
    for (std::size_t k = 0; k < weights.size(); ++k) {
        for (std::size_t i = 0; i < reactions_.size(); ++i)
            reactions_[i] += weights[k] * places_[k].reactions[i];
    }
}

Snapshot StepInterior::snapshot(double time,
                                bool with_elements,
                                const std::vector<RodPlace>& watched,
                                const std::vector<ContactWatch>& watched_contacts) {
    const double time_step = end_time_ - state_.time;
    const double fraction = (time - state_.time) / time_step;
    const std::vector<double> weights = weights_at(fraction);
    find_values(with_elements, watched);
    between_ = state_;
    between_.trial_time = time;
    integrator_.interpolate(state_, time_step, fraction, between_.trial, system_.team());
    mix_joints(weights);
    sections_.clear();
    if (with_elements) mix_sections(weights);
    points_ = SystemValues(system_).compute_point_values(between_, time, watched);
    mix_points(weights);
    mix_reactions(weights);
    bodies_ = SystemValues(system_).compute_body_surroundings(between_, time);
    joints_ = system_.joints().compute_joint_values(between_, time);
    if (!system_.model().tendons.empty())
        tendons_ = SystemValues(system_).compute_tendon_values(between_, time);
    Snapshot snapshot{time, between_.trial, sections_, reactions_, points_};
    ties_ = compute_tie_values(system_.model(), between_.trial);
    snapshot.ties = &ties_;
    snapshot.joints = joints_;
    snapshot.bodies = bodies_;
    snapshot.tendons = tendons_;
    find_contacts(with_elements, watched_contacts);
    contact_record_.show_in(snapshot);
    show_surroundings(system_, between_, time, with_elements, snapshot);
    return snapshot;
}

}  // namespace gxrod
