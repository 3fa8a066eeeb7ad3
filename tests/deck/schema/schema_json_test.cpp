#include <nlohmann/json.hpp>

#include "deck/schema/schema.hpp"
#include "tools/catch.hpp"

namespace gxrod {
namespace {

using Json = nlohmann::json;

// The part of the JSON Schema that describes the inside of a key's table or tables.
const Json& inside(const Json& schema, KeyShape shape) {
    if (shape == KeyShape::table_list)  // or one table
        return (schema.contains("items") ? schema : schema.at("anyOf").back()).at("items");
    if (shape == KeyShape::named_tables) {
        const Json& named = schema.at("patternProperties").begin().value();
        return named.contains("type") ? named : named.at("anyOf").front();  // and a short form
    }
    if (shape == KeyShape::value) return schema.at("anyOf").back();
    return schema;
}

void check_table(const Json& schema, const TableSpec& table) {
    CHECK(schema.at("type") == "object");
    CHECK(schema.at("additionalProperties") == false);
    CHECK(schema.at("properties").size() == table.keys.size());
    std::vector<std::string> required;
    for (const KeySpec& key : table.keys) {
        INFO(table.path << "." << key.name);
        REQUIRE(schema.at("properties").contains(key.name));
        const Json& property = schema.at("properties").at(key.name);
        CHECK(property.contains("description"));
        CHECK(property.contains("default") == !std::holds_alternative<std::monostate>(key.default_value));
        const bool is_conditional = !key.only_for.empty() || !key.only_with.empty();
        if (key.presence == Presence::required && !is_conditional) required.push_back(key.name);
        if (key.table != nullptr && key.shape != KeyShape::parameters)
            check_table(inside(property, key.shape), *key.table);
    }
    CHECK(schema.value("required", std::vector<std::string>{}) == required);
}

}  // namespace

TEST_CASE("The JSON Schema has every key", "[deck]") {
    const Json schema = Json::parse(json_schema(deck_schema(), "gxrod deck"));
    CHECK(schema.at("$schema") == "https://json-schema.org/draft/2020-12/schema");
    check_table(schema, deck_schema());
}

TEST_CASE("The JSON Schema has ranges, words, sizes and exclusions", "[deck]") {
    const Json properties = Json::parse(json_schema(deck_schema(), "gxrod deck")).at("properties");
    const Json& analysis = properties.at("analysis").at("properties");
    CHECK(analysis.at("beta").at("anyOf")[0] ==
          Json({{"type", "number"}, {"exclusiveMinimum", 0.0}, {"maximum", 0.5}}));
    CHECK(analysis.at("steps").at("anyOf")[0].at("minimum") == 1);
    CHECK(analysis.at("integrator").at("enum").size() == 9);
    CHECK(analysis.at("integrator").at("default") == "newmark-simplified");
    CHECK(properties.at("gravity").at("anyOf")[0].at("minItems") == 3);
    CHECK(properties.at("gravity").at("anyOf")[0].at("maxItems") == 3);
    const Json& body = properties.at("body").at("patternProperties").begin().value();
    CHECK(body.at("not").at("required").size() == 2);
    CHECK(properties.at("connect").at("items").at("properties").at("points").at("anyOf")[0].at("minItems") ==
          1);
    CHECK(properties.at("support").at("items").at("anyOf")[1] == Json({{"required", {"where"}}}));
}

TEST_CASE("The JSON Schema has the conditions of keys and groups", "[deck]") {
    const Json properties = Json::parse(json_schema(deck_schema(), "gxrod deck")).at("properties");
    const Json is_timed = {
        {"allOf",
         {{{"properties", {{"kind", {{"enum", {"dynamic", "quasi-static"}}}}}}, {"required", {"kind"}}}}}};
    const auto requires_key = [](const char* key) { return Json({{"required", {key}}}); };
    const auto has = [](const Json& table, const Json& condition, const Json& consequence) {
        const Json& all = table.at("allOf");
        return std::find(all.begin(), all.end(), Json({{"if", condition}, {"then", consequence}})) !=
               all.end();
    };
    const Json& analysis = properties.at("analysis");
    CHECK(has(analysis, is_timed, requires_key("end_time")));
    CHECK(has(analysis, requires_key("end_time"), is_timed));
    CHECK(has(analysis,
              is_timed,
              {{"oneOf", {requires_key("time_step"), requires_key("steps"), requires_key("accuracy")}}}));
    const Json& load = properties.at("load").at("items");
    const Json with_on = {{"allOf", Json::array({requires_key("on")})}};
    CHECK(load.at("anyOf") == Json::array({requires_key("at"), requires_key("on"), requires_key("where")}));
    CHECK(load.at("not") == Json({{"required", {"at", "on"}}}));
    CHECK(
        has(load,
            with_on,
            {{"anyOf",
              {requires_key("force_per_length"), requires_key("moment_per_length"), requires_key("file")}}}));
}

}  // namespace gxrod
