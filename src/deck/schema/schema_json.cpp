#include <fmt/format.h>

#include <nlohmann/json.hpp>

#include "deck/schema/schema.hpp"
#include "deck/schema/schema_tables.hpp"
#include "deck/table/binding.hpp"

namespace gxrod {
namespace {

using Json = nlohmann::ordered_json;

Json make_table(const TableSpec& table);

Json reference(const char* definition) { return {{"$ref", std::string("#/$defs/") + definition}}; }

Json any_of(std::initializer_list<Json> options) {
    Json json;
    for (const Json& option : options) json["anyOf"].push_back(option);
    return json;
}

Json named_tables(const char* pattern, const Json& table) {
    Json json{{"type", "object"}};
    json["patternProperties"][pattern] = table;
    json["additionalProperties"] = false;
    return json;
}

Json make_type(const KeySpec& key) {
    switch (key.shape) {
        case KeyShape::value: {
            Json json = Json::parse(find_kind(key)->schema(key));
            if (key.table == nullptr) return json;
            if (!json.contains("anyOf")) json = any_of({json});
            json["anyOf"].push_back(make_table(*key.table));
            return json;
        }
        case KeyShape::table:
            return make_table(*key.table);
        case KeyShape::named_tables:
            if (key.binding) {
                const Json short_form{{"type", "string"}};
                return named_tables("^.+$", any_of({make_table(*key.table), short_form}));
            }
            return named_tables(is_for_expressions(key) ? "^[A-Za-z_][A-Za-z0-9_]*$" : "^[A-Za-z0-9_-]+$",
                                make_table(*key.table));
        case KeyShape::table_list: {
            Json list{{"type", "array"}, {"items", make_table(*key.table)}};
            return key.takes_one ? any_of({make_table(*key.table), list}) : list;
        }
        case KeyShape::parameters:
            return named_tables("^[A-Za-z_][A-Za-z0-9_]*$", reference("number"));
        case KeyShape::variations:
            return {{"type", "object"},
                    {"additionalProperties",
                     any_of({{{"type", "array"}, {"minItems", 1}}, make_table(*key.table)})}};
    }
    return {};
}

struct DefaultWriter {
    Json operator()(std::monostate) const { return nullptr; }
    Json operator()(double value) const { return value; }
    Json operator()(long value) const { return value; }
    Json operator()(const std::string& value) const { return value; }
    Json operator()(const Vec3& value) const { return {value[0], value[1], value[2]}; }
};

Json make_key(const KeySpec& key) {
    Json json = make_type(key);
    std::string description =
        key.sentence.empty() && key.table != nullptr ? key.table->sentence : key.sentence;
    if (!key.dimension.empty()) description += fmt::format(" Dimension: {}.", key.dimension);
    if (!key.default_text.empty()) description += fmt::format(" Default: {}.", key.default_text);
    if (!description.empty()) json["description"] = description;
    const Json value = std::visit(DefaultWriter{}, key.default_value);
    if (!value.is_null()) json["default"] = value;
    return json;
}

Json require(const std::vector<std::string>& keys) { return {{"required", keys}}; }

// No two of the keys.
Json exclude_pairs(const std::vector<std::string>& keys) {
    if (keys.size() == 2) return require(keys);
    Json pairs;
    for (std::size_t i = 0; i < keys.size(); ++i) {
        for (std::size_t j = i + 1; j < keys.size(); ++j)
            pairs["anyOf"].push_back(require({keys[i], keys[j]}));
    }
    return pairs;
}

// What a group asks of its table.
Json make_group(const KeyGroup& group) {
    if (group.rule == GroupRule::at_most_one) return {{"not", exclude_pairs(group.keys)}};
    Json json;
    Json& options = json[group.rule == GroupRule::exactly_one ? "oneOf" : "anyOf"];
    for (const std::string& key : group.keys) options.push_back(require({key}));
    return json;
}

// That a key has one of some words, its default being one of them or not.
Json make_condition(const Condition& condition, const TableSpec& table) {
    Json json;
    json["properties"][condition.key] = {{"enum", condition.words}};
    const auto* chosen = std::get_if<std::string>(&table.find(condition.key)->default_value);
    const auto& words = condition.words;
    const bool holds_by_default =
        chosen != nullptr && std::find(words.begin(), words.end(), *chosen) != words.end();
    if (!holds_by_default) json["required"] = {condition.key};
    return json;
}

// Where a key or group of a table is used; null if everywhere.
template <class Spec>
Json make_use(const Spec& spec, const TableSpec& table) {
    Json json;
    for (const Condition& condition : spec.only_for)
        json["allOf"].push_back(make_condition(condition, table));
    if (!spec.only_with.empty()) json["allOf"].push_back(require({spec.only_with}));
    return json;
}

bool is_conditional(const KeySpec& key) { return !key.only_for.empty() || !key.only_with.empty(); }

void add_groups(const TableSpec& table, Json& json) {
    for (const KeyGroup& group : table.groups) {
        const Json use = make_use(group, table);
        const Json rule = make_group(group);
        if (!use.is_null()) {
            json["allOf"].push_back({{"if", use}, {"then", rule}});
        } else if (json.contains(rule.begin().key())) {
            json["allOf"].push_back(rule);
        } else {
            json.update(rule);
        }
    }
}

// "If beta is given, integrator is one of …", and the reverse for a key that is required there.
void add_conditions(const TableSpec& table, Json& json) {
    for (const KeySpec& key : table.keys) {
        if (!is_conditional(key)) continue;
        const Json use = make_use(key, table);
        json["allOf"].push_back({{"if", require({key.name})}, {"then", use}});
        if (key.presence == Presence::required) {
            json["allOf"].push_back({{"if", use}, {"then", require({key.name})}});
        }
    }
}

Json make_table(const TableSpec& table) {
    Json json{{"type", "object"}};
    if (!table.sentence.empty()) json["description"] = table.sentence;
    json["properties"] = Json::object();
    std::vector<std::string> required;
    for (const KeySpec& key : table.keys) {
        json["properties"][key.name] = make_key(key);
        if (key.presence == Presence::required && !is_conditional(key)) required.push_back(key.name);
    }
    if (!required.empty()) json["required"] = required;
    json["additionalProperties"] = false;
    add_groups(table, json);
    add_conditions(table, json);
    return json;
}

}  // namespace

std::string json_schema(const TableSpec& root, const std::string& title) {
    Json json{{"$schema", "https://json-schema.org/draft/2020-12/schema"}, {"title", title}};
    json.update(make_table(root));
    json["$defs"]["expression"] = {{"type", "string"}, {"description", "An expression, such as \"2*EI\"."}};
    json["$defs"]["number"] = any_of({{{"type", "number"}}, reference("expression")});
    return json.dump(2);
}

}  // namespace gxrod
