#include "batch/plan/plan_schema.hpp"

#include <nlohmann/json.hpp>

#include "batch/plans.hpp"
#include "deck/text/csv_reading.hpp"
#include "deck/text/text_file.hpp"
#include "tools/catch.hpp"

namespace gxrod::test {

TEST_CASE("The page docs/plan.md is what the schema says", "[batch]") {
    const bool is_current = read_text_file(GXROD_SOURCE_DIR "/docs/plan.md") == plan_reference() + "\n";
    INFO("Regenerate it: gxrod schema --plan --markdown > docs/plan.md");
    CHECK(is_current);
}

TEST_CASE("The examples of the plan reference, one after the other, are a plan", "[batch]") {
    std::string text = plan_schema().example;
    for (const KeySpec& key : plan_schema().keys) {
        if (key.table != nullptr) text += key.table->example + "\n";
    }
    const PlanFiles files(text);
    files.write("flying_rod.toml", "");
    const Plan plan = files.read();
    CHECK(plan.variations.size() == 2);
    CHECK(plan.variations[1].values.size() == 5);
    CHECK(plan.collections.size() == 5);
    CHECK(plan.keeping == Keeping::failed);
    CHECK(plan.time_limit == 600.0);
}

TEST_CASE("The JSON Schema of plans has every key", "[batch]") {
    const nlohmann::json schema = nlohmann::json::parse(json_schema(plan_schema(), "gxrod plan"));
    CHECK(schema.at("title") == "gxrod plan");
    CHECK(schema.at("required") == nlohmann::json{"deck"});
    for (const KeySpec& key : plan_schema().keys) CHECK(schema.at("properties").contains(key.name));
    const nlohmann::json& vary = schema.at("properties").at("vary").at("additionalProperties").at("anyOf");
    CHECK(vary.at(0).at("type") == "array");
    for (const KeySpec& key : variation_table().keys) CHECK(vary.at(1).at("properties").contains(key.name));
}

}  // namespace gxrod::test
