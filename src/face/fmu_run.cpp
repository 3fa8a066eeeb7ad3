#include "face/fmu_run.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <iterator>
#include <sstream>
#include <stdexcept>

#include "deck/problem.hpp"
#include "machine/file_error.hpp"

namespace gxrod {
namespace {

constexpr const char* deck_file = "deck.toml";
constexpr const char* list_file = "files.txt";  // the names that the deck has for files/0, files/1, …

std::string read_bytes(const std::filesystem::path& path) {
    std::ifstream file(path, std::ios::binary);
    if (!file) throw FileError(path, "cannot be read");
    return {std::istreambuf_iterator<char>(file), {}};
}

DeckRecord read_record(const std::filesystem::path& resources) {
    DeckRecord record;
    record.name = deck_file;
    record.text = read_bytes(resources / deck_file);
    if (!std::filesystem::exists(resources / list_file)) return record;
    std::istringstream names(read_bytes(resources / list_file));
    for (std::string name; std::getline(names, name);)
        record.meshes.push_back(
            {name, read_bytes(resources / "files" / std::to_string(record.meshes.size()))});
    return record;
}

}  // namespace

FmuRun::FmuRun(const std::filesystem::path& resources)
    : record_(read_record(resources)), variables_(list_fmu_variables(rebuild_problem(record_))) {}

const FmuVariable& FmuRun::find(std::size_t reference) const {
    if (reference >= variables_.size())
        throw std::invalid_argument(fmt::format("there is no variable with the reference {}", reference));
    return variables_[reference];
}

Problem FmuRun::build() const {
    std::vector<std::string> overrides;
    for (const auto& [reference, value] : parameters_)
        overrides.push_back(fmt::format("parameters.{}={}", variables_[reference].name, value));
    return rebuild_problem(record_, overrides);
}

void FmuRun::initialize() {
    if (simulation_) return;
    Simulation::Options options;
    options.record = std::vector<std::string>{};
    simulation_ = std::make_unique<Simulation>(build(), options);
    for (const auto& [reference, value] : inputs_) simulation_->set(variables_[reference].name, value);
}

double FmuRun::get(std::size_t reference) {
    const FmuVariable& variable = find(reference);
    const auto set_value = [&](const std::map<std::size_t, double>& values) {
        const auto found = values.find(reference);
        return found == values.end() ? variable.start : found->second;
    };
    switch (variable.causality) {
        case FmuVariable::Causality::independent:
            return time();
        case FmuVariable::Causality::parameter:
            return set_value(parameters_);
        case FmuVariable::Causality::input:
            return set_value(inputs_);
        case FmuVariable::Causality::output:
            break;
    }
    initialize();
    std::vector<double>& values = seen_[{variable.history, variable.quantity}];
    if (values.empty()) values = simulation_->compute(variable.history, variable.quantity);
    return values.at(variable.component);
}

void FmuRun::set(std::size_t reference, double value) {
    const FmuVariable& variable = find(reference);
    if (variable.causality == FmuVariable::Causality::input) {
        inputs_[reference] = value;
        if (simulation_) simulation_->set(variable.name, value);
    } else if (variable.causality == FmuVariable::Causality::parameter) {
        if (simulation_ && simulation_->time() > 0.0)
            throw std::invalid_argument(
                fmt::format("{} is a parameter: it is set before the first step", variable.name));
        parameters_[reference] = value;
        simulation_.reset();
        seen_.clear();
    } else {
        throw std::invalid_argument(
            fmt::format("{} cannot be set; inputs and parameters can", variable.name));
    }
}

void FmuRun::advance(double until) {
    initialize();
    seen_.clear();
    if (until > time()) simulation_->advance(until - start_);
    constexpr double round_off = 1e-9;
    if (time() < until - round_off * std::max(1.0, std::abs(until)))
        throw std::out_of_range(
            fmt::format("the deck ends at t = {}; a later end_time lets it go on", time()));
}

void FmuRun::reset() {
    simulation_.reset();
    seen_.clear();
    parameters_.clear();
    inputs_.clear();
}

FmuRun::State FmuRun::save() {
    initialize();
    return {simulation_->save(), inputs_};
}

void FmuRun::restore(const State& state) {
    initialize();
    seen_.clear();
    simulation_->restore(state.checkpoint);
    inputs_ = state.inputs;
    for (const auto& [reference, value] : inputs_) simulation_->set(variables_[reference].name, value);
}

std::map<std::string, std::string> list_fmu_files(const Problem& problem) {
    std::map<std::string, std::string> files{{"modelDescription.xml", describe_fmu(problem)},
                                             {"resources/deck.toml", problem.record.text}};
    std::string names;
    for (std::size_t i = 0; i < problem.record.meshes.size(); ++i) {
        names += problem.record.meshes[i].file + "\n";
        files[fmt::format("resources/files/{}", i)] = problem.record.meshes[i].bytes;
    }
    if (!names.empty()) files["resources/files.txt"] = names;
    return files;
}

}  // namespace gxrod
