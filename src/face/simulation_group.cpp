#include "face/simulation_group.hpp"

#include <algorithm>
#include <cmath>

#include "face/convergence_error.hpp"
#include "model/evaluation_error.hpp"

namespace gxrod {

SimulationGroup::SimulationGroup(std::vector<Simulation*> members, Plan plan, int threads)
    : members_(std::move(members)), plan_(std::move(plan)), team_(threads) {
    for (Simulation* member : members_) {
        for (const std::string& input : plan_.inputs) member->input(input);  // throws if it is not there
        starts_.push_back(member->save());
    }
    if (!members_.empty()) {
        for (const auto& [history, quantity] : plan_.observed)
            width_ += static_cast<std::size_t>(members_.front()->width(history, quantity));
    }
    observations_.resize(size() * width_);
    team_.for_each(size(), [&](std::size_t i) { observe_one(i); });
}

std::vector<std::string> SimulationGroup::advance(std::span<const double> inputs,
                                                  std::span<const double> until) {
    const std::size_t count = plan_.inputs.size();
    std::vector<std::string> failures(size());
    team_.for_each(size(), [&](std::size_t i) {
        if (!std::isnan(until[i])) failures[i] = advance_one(i, inputs.subspan(i * count, count), until[i]);
    });
    return failures;
}

std::string SimulationGroup::advance_one(std::size_t member, std::span<const double> inputs, double until) {
    std::string failure;
    try {
        for (std::size_t i = 0; i < inputs.size(); ++i) members_[member]->set(plan_.inputs[i], inputs[i]);
        members_[member]->advance(until);
    } catch (const ConvergenceError& error) {
        failure = error.what();
    } catch (const EvaluationError& error) {
        failure = error.what();
    }
    observe_one(member);
    return failure;
}

void SimulationGroup::reset(const std::vector<std::size_t>& members) {
    team_.for_each(members.size(), [&](std::size_t i) {
        members_.at(members[i])->restore(starts_[members[i]]);
        observe_one(members[i]);
    });
}

void SimulationGroup::observe(const std::vector<std::size_t>& members) {
    team_.for_each(members.size(), [&](std::size_t i) { observe_one(members.at(i)); });
}

void SimulationGroup::observe_one(std::size_t member) {
    const std::vector<double> values = members_.at(member)->compute(plan_.observed);
    std::ranges::copy(values, observations_.begin() + static_cast<std::ptrdiff_t>(member * width_));
}

}  // namespace gxrod
