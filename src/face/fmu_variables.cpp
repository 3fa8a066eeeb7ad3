#include "face/fmu_variables.hpp"

#include <fmt/format.h>

#include <array>
#include <map>
#include <stdexcept>

#include "deck/text/deck_tree.hpp"
#include "machine/digest.hpp"
#include "model/settings/analysis_traits.hpp"
#include "model/version.hpp"
#include "watch/quantities.hpp"

namespace gxrod {
namespace {

using Causality = FmuVariable::Causality;

std::string escape(const std::string& text) {
    std::string escaped;
    for (const char c : text) {
        switch (c) {
            case '&':
                escaped += "&amp;";
                break;
            case '<':
                escaped += "&lt;";
                break;
            case '>':
                escaped += "&gt;";
                break;
            case '"':
                escaped += "&quot;";
                break;
            default:
                escaped += c;
        }
    }
    return escaped;
}

void add_parameters(const Problem& problem, std::vector<FmuVariable>& variables) {
    const DeckNode deck = read_toml(problem.record.text, problem.record.name);
    const DeckEntry* parameters = deck.find("parameters");
    if (parameters == nullptr || parameters->node.table() == nullptr) return;
    for (const DeckEntry& entry : *parameters->node.table()) {
        const auto* whole = std::get_if<std::int64_t>(&entry.node.value);
        const auto* number = std::get_if<double>(&entry.node.value);
        if (whole == nullptr && number == nullptr) continue;
        variables.push_back({.name = entry.key,
                             .causality = Causality::parameter,
                             .start = whole != nullptr ? static_cast<double>(*whole) : *number});
    }
}

void add_outputs(const Problem& problem, std::vector<FmuVariable>& variables) {
    static constexpr std::array<const char*, 3> vector{".x", ".y", ".z"};
    static constexpr std::array<const char*, 4> quaternion{".w", ".x", ".y", ".z"};
    for (std::size_t history = 0; history < problem.output.histories.size(); ++history) {
        const HistoryRequest& request = problem.output.histories[history];
        const std::vector<const Quantity*> quantities = quantities_of(request);
        for (std::size_t quantity = 0; quantity < quantities.size(); ++quantity) {
            const auto columns = static_cast<std::size_t>(quantities[quantity]->columns);
            for (std::size_t i = 0; i < columns; ++i) {
                const char* component = columns == 1 ? "" : columns == 4 ? quaternion[i] : vector[i];
                variables.push_back(
                    {.name = fmt::format("{}.{}{}", request.name, request.quantities[quantity], component),
                     .causality = Causality::output,
                     .history = history,
                     .quantity = quantity,
                     .component = i});
            }
        }
    }
}

void check_names(const std::vector<FmuVariable>& variables) {
    std::map<std::string, int> count;
    for (const FmuVariable& variable : variables) {
        if (++count[variable.name] > 1)
            throw std::invalid_argument(
                fmt::format("two variables of the FMU are called \"{}\"; rename the parameter, input or "
                            "history",
                            variable.name));
    }
}

std::string describe_variable(const FmuVariable& variable, std::size_t reference) {
    static constexpr std::array<const char*, 4> words{
        "causality=\"independent\" variability=\"continuous\"",
        "causality=\"parameter\" variability=\"fixed\" initial=\"exact\"",
        "causality=\"input\" variability=\"continuous\"",
        "causality=\"output\" variability=\"continuous\" initial=\"calculated\""};
    const bool has_start =
        variable.causality == Causality::parameter || variable.causality == Causality::input;
    return fmt::format("    <Float64 name=\"{}\" valueReference=\"{}\" {}{}/>\n",
                       escape(variable.name),
                       reference,
                       words[static_cast<std::size_t>(variable.causality)],
                       has_start ? fmt::format(" start=\"{}\"", variable.start) : "");
}

std::string describe_experiment(const Problem& problem) {
    const auto* timed = std::get_if<DynamicSettings>(&problem.analysis());
    if (timed == nullptr) return "";
    return fmt::format("  <DefaultExperiment startTime=\"0\" stopTime=\"{}\" stepSize=\"{}\"/>\n",
                       timed->end_time,
                       timed->time_step());
}

}  // namespace

std::vector<FmuVariable> list_fmu_variables(const Problem& problem) {
    std::vector<FmuVariable> variables{{.name = "time", .causality = Causality::independent}};
    add_parameters(problem, variables);
    for (const std::shared_ptr<Input>& input : problem.model.inputs) {
        if (!input->is_signal())
            variables.push_back(
                {.name = input->name(), .causality = Causality::input, .start = (*input)(0.0)});
    }
    add_outputs(problem, variables);
    return variables;
}

std::string describe_fmu(const Problem& problem) {
    const std::vector<FmuVariable> variables = list_fmu_variables(problem);
    check_names(variables);
    std::string model, structure;
    for (std::size_t i = 0; i < variables.size(); ++i) {
        model += describe_variable(variables[i], i);
        if (variables[i].causality == Causality::output)
            structure += fmt::format("    <Output valueReference=\"{}\"/>\n", i);
    }
    for (std::size_t i = 0; i < variables.size(); ++i) {
        if (variables[i].causality == Causality::output)
            structure += fmt::format("    <InitialUnknown valueReference=\"{}\"/>\n", i);
    }
    const DeckRecord& record = problem.record;
    return fmt::format(
        "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n"
        "<fmiModelDescription fmiVersion=\"3.0\" modelName=\"{}\" instantiationToken=\"{}\"{} "
        "generationTool=\"gxrod {}\" variableNamingConvention=\"flat\">\n"
        "  <CoSimulation modelIdentifier=\"{}\" canHandleVariableCommunicationStepSize=\"true\" "
        "canGetAndSetFMUState=\"true\"/>\n"
        "{}"
        "  <ModelVariables>\n{}  </ModelVariables>\n"
        "  <ModelStructure>\n{}  </ModelStructure>\n"
        "</fmiModelDescription>\n",
        escape(record.name),
        sha256_hex(record.text),
        record.title.empty() ? "" : fmt::format(" description=\"{}\"", escape(record.title)),
        version,
        fmu_model_identifier,
        describe_experiment(problem),
        model,
        structure);
}

}  // namespace gxrod
