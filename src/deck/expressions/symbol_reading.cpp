#include "deck/expressions/symbol_reading.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>

#include "deck/expressions/expression_syntax.hpp"
#include "deck/expressions/function_table.hpp"
#include "deck/expressions/use_order.hpp"
#include "deck/reading/number_reader.hpp"
#include "deck/schema/schema_tables.hpp"
#include "deck/schema/suggestion.hpp"
#include "deck/table/kinds.hpp"

namespace gxrod {
namespace {

const DeckNode::Table& entries_of(const DeckNode& deck, std::string_view key) {
    static const DeckNode::Table none;
    const DeckEntry* entry = deck.find(key);
    return entry == nullptr || entry->node.table() == nullptr ? none : *entry->node.table();
}

// The names of one kind that an expression uses; none if it cannot be read, which is reported elsewhere.
std::set<std::string> names_used(const DeckNode& node, const Symbols& symbols, Variables variables) {
    if (node.text() == nullptr) return {};
    try {
        const ExpressionNames names = check_expression(*node.text(), symbols, variables);
        return variables == Variables::none ? names.parameters : names.functions;
    } catch (const ExpressionError&) {
        return {};
    }
}

// A key of the top level that was written after [parameters].
bool is_misplaced_top_level_value(const DeckEntry& entry) {
    const KeySpec* key = deck_schema().find(entry.key);
    if (key == nullptr) return false;
    return (find_kind(*key) == &value_kind<std::string> && entry.node.text() != nullptr) ||
           (key->name == "gravity" && entry.node.array() != nullptr);
}

std::vector<std::string> keys_of(const DeckNode::Table& entries) {
    std::vector<std::string> keys;
    for (const DeckEntry& entry : entries) keys.push_back(entry.key);
    return keys;
}

// "a → b → a"
std::string describe_cycle(const std::vector<std::string>& cycle) {
    return fmt::format("{} → {}", fmt::join(cycle, " → "), cycle.front());
}

std::string explain_depth() {
    return fmt::format("is used through {} others, each by the one before; no more can be followed",
                       most_use_depth);
}

void read_parameters(const DeckNode& deck, Symbols& symbols, FaultList& faults) {
    const DeckNode* const table =
        deck.find("parameters") == nullptr ? nullptr : &deck.find("parameters")->node;
    const DeckNode::Table& entries = entries_of(deck, "parameters");
    for (const DeckEntry& entry : entries) symbols.parameters[entry.key] = std::nullopt;
    Uses uses;
    for (const DeckEntry& entry : entries) uses[entry.key] = names_used(entry.node, symbols, Variables::none);
    const UseOrder order = find_use_order(keys_of(entries), uses);
    for (const std::vector<std::string>& cycle : order.cycles) {
        faults.add(table->find(cycle.front())->node.place,
                   "parameters." + cycle.front(),
                   "the value depends on itself: " + describe_cycle(cycle));
    }
    for (const std::string& name : order.too_deep) {
        faults.add(table->find(name)->place, "parameters." + name, explain_depth());
    }
    const KeySpec number{.name = "parameter"};
    for (const std::string& name : order.names) {
        const DeckEntry& entry = *table->find(name);
        const std::string path = "parameters." + name;
        if (is_misplaced_top_level_value(entry)) {
            faults.add(entry.place, path, explain_misplaced_key(name, "[parameters]"));
        } else if (const std::string reason = explain_unusable_name(name); !reason.empty()) {
            faults.add(entry.place, path, reason);
        } else if (!order.in_cycle.contains(name)) {
            symbols.parameters[name] = NumberReader(number, {symbols, faults}).number(entry.node, path);
        }
    }
}

// What a function is made of, if nothing is wrong with it; faults stay unreported.
std::optional<FunctionDefinition> read_definition(const DeckNode& node,
                                                  const std::string& name,
                                                  const Symbols& symbols) {
    if (node.table() == nullptr || !explain_unusable_name(name).empty()) return std::nullopt;
    const DeckEntry* table = node.find("table");
    const DeckEntry* expression = node.find("expression");
    if ((table == nullptr) == (expression == nullptr)) return std::nullopt;
    FaultList unreported("", {});
    const ReadingContext context{symbols, unreported};
    if (table != nullptr) {
        FunctionTable function;
        const auto reads = [&](const DeckEntry& entry) {
            const KeySpec& key = *function_table().find(entry.key);
            return key.binding->read({entry.node, "", key, context}, function);
        };
        const DeckEntry* interpolation = node.find("interpolation");
        if (!reads(*table) || (interpolation != nullptr && !reads(*interpolation))) return std::nullopt;
        FunctionDefinition definition{*function.table, ""};
        definition.interpolation = function.interpolation.value_or(Interpolation::linear);
        definition.curve = std::make_shared<const TableFunction>(*function.table, definition.interpolation);
        return definition;
    }
    if (const auto* integer = std::get_if<std::int64_t>(&expression->node.value)) {
        return FunctionDefinition{{{0.0, static_cast<double>(*integer)}}, ""};
    }
    if (const auto* real = std::get_if<double>(&expression->node.value))
        return FunctionDefinition{{{0.0, *real}}, ""};
    if (expression->node.text() == nullptr) return std::nullopt;
    return FunctionDefinition{{}, *expression->node.text()};
}

// The functions that each function calls.
Uses find_function_uses(const DeckNode::Table& entries, const Symbols& symbols) {
    Uses uses;
    for (const DeckEntry& entry : entries) {
        const DeckEntry* expression = entry.node.table() == nullptr ? nullptr : entry.node.find("expression");
        uses[entry.key] = expression == nullptr ? std::set<std::string>{}
                                                : names_used(expression->node, symbols, Variables::time);
    }
    return uses;
}

// Whether the expression of a function whose own functions are right can be compiled.
bool compiles(const std::string& expression, const Symbols& symbols) {
    try {
        return compile_time_function(expression, "", symbols).has_value();
    } catch (const ExpressionError&) {
        return false;
    }
}

void read_functions(const DeckNode& deck, Symbols& symbols, FaultList& faults) {
    const DeckNode* const table = deck.find("function") == nullptr ? nullptr : &deck.find("function")->node;
    const DeckNode::Table& entries = entries_of(deck, "function");
    for (const DeckEntry& entry : entries) {
        if (!symbols.parameters.contains(entry.key)) continue;
        faults.add(entry.place, "function." + entry.key, "a parameter has this name too; choose another one");
    }
    const UseOrder order = find_use_order(keys_of(entries), find_function_uses(entries, symbols));
    for (const std::vector<std::string>& cycle : order.cycles) {
        faults.add(table->find(cycle.front())->node.find("expression")->node.place,
                   "function." + cycle.front() + ".expression",
                   "the function depends on itself: " + describe_cycle(cycle));
    }
    for (const std::string& name : order.too_deep) {
        faults.add(table->find(name)->place, "function." + name, explain_depth());
    }
    for (const std::string& name : order.names) {
        if (order.in_cycle.contains(name)) continue;
        auto definition = read_definition(table->find(name)->node, name, symbols);
        if (!definition) continue;
        if (definition->table.empty()) {
            if (!compiles(definition->expression, symbols)) continue;
            const ExpressionNames names = check_expression(definition->expression, symbols, Variables::time);
            definition->operations = names.operations;
            definition->depth = names.depth + 1;
        }
        symbols.functions[name] = std::move(definition);
    }
}

// An input whose course rests on inputs could rest on itself.
void check_course(const DeckEntry& input, const Symbols& symbols, FaultList& faults) {
    const DeckEntry* value = input.node.table() == nullptr ? nullptr : input.node.find("value");
    if (value == nullptr || value->node.text() == nullptr) return;
    try {
        const ExpressionNames names = check_expression(*value->node.text(), symbols, Variables::time);
        if (names.inputs.empty()) return;
        faults.add(
            value->node.place,
            fmt::format("input.{}.value", input.key),
            fmt::format("\"{}\" is an input; the value of an input can have t, parameters and functions",
                        *names.inputs.begin()));
    } catch (const ExpressionError&) {
        return;  // reported with the other keys
    }
}

void add_inputs(const DeckNode& deck, const std::string& table, Symbols& symbols, FaultList& faults) {
    for (const DeckEntry& entry : entries_of(deck, table)) {
        const char* other = symbols.parameters.contains(entry.key)  ? "a parameter"
                            : symbols.functions.contains(entry.key) ? "a function"
                            : symbols.inputs.contains(entry.key)    ? "an input"
                                                                    : nullptr;
        if (other != nullptr) {
            faults.add(entry.place,
                       table + "." + entry.key,
                       fmt::format("{} has this name too; choose another one", other));
        } else if (explain_unusable_name(entry.key).empty()) {
            symbols.inputs[entry.key] = std::make_shared<Input>(entry.key);
        }
    }
}

// The signals whose values a signal reads.
std::set<std::string> find_read_signals(const DeckEntry& signal,
                                        const Uses& signals,
                                        const Symbols& symbols) {
    std::set<std::string> read;
    const DeckEntry* value = signal.node.table() == nullptr ? nullptr : signal.node.find("value");
    if (value == nullptr || value->node.text() == nullptr) return read;
    try {
        for (const std::string& name :
             check_expression(*value->node.text(), symbols, Variables::time).inputs) {
            if (signals.contains(name)) read.insert(name);
        }
    } catch (const ExpressionError&) {
        // reported with the other keys
    }
    return read;
}

// Each signal is set after those that it reads.
void order_signals(const DeckNode& deck, const Symbols& symbols, FaultList& faults) {
    const DeckNode::Table& entries = entries_of(deck, "signal");
    std::vector<std::string> names;
    Uses uses;
    for (const DeckEntry& entry : entries) {
        names.push_back(entry.key);
        uses[entry.key];
    }
    for (const DeckEntry& entry : entries) uses[entry.key] = find_read_signals(entry, uses, symbols);
    const UseOrder order = find_use_order(names, uses);
    for (const std::vector<std::string>& cycle : order.cycles) {
        const auto entry = std::ranges::find(entries, cycle.front(), &DeckEntry::key);
        faults.add(entry->place,
                   "signal." + cycle.front(),
                   fmt::format("signals read each other in a circle: {}", fmt::join(cycle, ", ")));
    }
    int rank = 0;
    for (const std::string& name : order.names) {
        const auto input = symbols.inputs.find(name);
        if (input != symbols.inputs.end()) input->second->make_signal(rank++);
    }
}

void read_inputs(const DeckNode& deck, Symbols& symbols, FaultList& faults) {
    add_inputs(deck, "input", symbols, faults);
    add_inputs(deck, "signal", symbols, faults);
    for (const DeckEntry& entry : entries_of(deck, "input")) check_course(entry, symbols, faults);
    order_signals(deck, symbols, faults);
}

}  // namespace

Symbols read_symbols(const DeckNode& deck, FaultList& faults) {
    Symbols symbols;
    for (const DeckEntry& entry : entries_of(deck, "function")) symbols.functions[entry.key] = std::nullopt;
    read_parameters(deck, symbols, faults);
    read_inputs(deck, symbols, faults);
    read_functions(deck, symbols, faults);
    return symbols;
}

}  // namespace gxrod
