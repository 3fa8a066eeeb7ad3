#include "assembly/contact/contacts.hpp"

#include "assembly/contact/contact_assembly.hpp"
#include "assembly/contact/contact_pairs.hpp"

namespace gxrod {

bool Contacts::couple_rods() const { return contact_ && !contact_->pairs().empty(); }

bool Contacts::are_impulses() const { return contact_ && contact_->has_impacts(); }

void Contacts::search(State& state) const {
    if (contact_) contact_->search(state);
}

bool Contacts::have_forces(const State& state, double time) const {
    return contact_ && contact_->has_forces(state, time);
}

std::vector<NodeGroup> Contacts::list_groups(const State& state) const {
    return contact_ ? contact_->pairs().list_groups(state) : std::vector<NodeGroup>{};
}

void Contacts::add_tangents(const State& state,
                            double time,
                            const ConstraintRequest& request,
                            const std::vector<NodeLinearization>& linearizations,
                            std::vector<double>& values) const {
    if (contact_) contact_->add_tangents(state, time, request, linearizations, values);
}

std::vector<PairBlock> Contacts::compute_tangents(
    const State& state, double weight, const std::vector<NodeLinearization>& linearizations) const {
    return contact_ ? contact_->pairs().compute_tangents(state, weight, linearizations)
                    : std::vector<PairBlock>{};
}

double Contacts::compute_energy(const State& state, double time) const {
    return contact_ ? contact_->compute_energy(state, time) : 0.0;
}

ContactPower Contacts::compute_power(const State& state, double time) const {
    return contact_ ? contact_->compute_power(state, time) : ContactPower{};
}

ContactWork Contacts::compute_work(const State& state, double time, double energy_before) const {
    return contact_ ? contact_->compute_work(state, time, energy_before) : ContactWork{};
}

ContactCount Contacts::count(const State& state, double time) const {
    return contact_ ? contact_->count(state, time) : ContactCount{};
}

std::string Contacts::describe_overlap(const State& state, double time) const {
    return contact_ ? contact_->describe_overlap(state, time) : "";
}

std::vector<ContactTouch> Contacts::list_touches(const State& state, double time) const {
    return contact_ ? contact_->list_touches(state, time) : std::vector<ContactTouch>{};
}

std::vector<ObstacleValues> Contacts::compute_obstacle_values(const State& state, double time) const {
    return contact_ ? contact_->compute_obstacle_values(state, time) : std::vector<ObstacleValues>{};
}

ObstacleValues Contacts::compute_watched(const ContactWatch& watch,
                                         const std::vector<ContactTouch>& touches,
                                         const State& state,
                                         double time) const {
    return contact_ ? contact_->compute_watched(watch, touches, state, time) : ObstacleValues{};
}

std::vector<Vec6> Contacts::compute_forces(const State& state, double time) const {
    return contact_ ? contact_->compute_forces(state, time) : std::vector<Vec6>{};
}

std::vector<double> Contacts::compute_gaps(const State& state, double time) const {
    return contact_ ? contact_->compute_gaps(state, time) : std::vector<double>{};
}

}  // namespace gxrod
