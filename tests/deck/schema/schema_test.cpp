#include "deck/schema/schema.hpp"

#include "deck/schema/schema_tables.hpp"
#include "deck/table/kinds.hpp"
#include "tools/catch.hpp"

namespace gxrod {
namespace {

// Every table of the schema, the top level first.
void collect_tables(const TableSpec& table, std::vector<const TableSpec*>& tables) {
    tables.push_back(&table);
    for (const KeySpec& key : table.keys) {
        if (key.table != nullptr) collect_tables(*key.table, tables);
    }
}

std::vector<const TableSpec*> all_tables() {
    std::vector<const TableSpec*> tables;
    collect_tables(deck_schema(), tables);
    return tables;
}

bool takes_words(const KeySpec& key) {
    const ValueKind* kind = find_kind(key);
    return nature_of(key) == ValueNature::word || kind == &value_kind<WordList>;
}

bool takes_names(const KeySpec& key) {
    const ValueKind* kind = find_kind(key);
    return kind == &value_kind<TableName> || kind == &value_kind<TableNames>;
}

}  // namespace

TEST_CASE("Every key is declared in full", "[deck]") {
    for (const TableSpec* table : all_tables()) {
        for (const KeySpec& key : table->keys) {
            INFO(table->path << "." << key.name);
            CHECK(table->find(key.name) == &key);
            CHECK((find_kind(key) != nullptr) == (key.shape == KeyShape::value));
            CHECK((key.table != nullptr || key.shape == KeyShape::value));
            if (takes_words(key)) CHECK_FALSE(key.choices.empty());
            const bool described_by_its_table = table == &deck_schema() && key.table != nullptr;
            CHECK((described_by_its_table || key.sentence.ends_with('.')));
            const bool has_default =
                !std::holds_alternative<std::monostate>(key.default_value) || !key.default_text.empty();
            CHECK_FALSE((has_default && key.presence == Presence::required));
        }
        for (const KeyGroup& group : table->groups) {
            for (const std::string& key : group.keys) CHECK(table->find(key) != nullptr);
        }
    }
}

TEST_CASE("Defaults are in their ranges and among their words", "[deck]") {
    for (const TableSpec* table : all_tables()) {
        for (const KeySpec& key : table->keys) {
            INFO(table->path << "." << key.name);
            if (const auto* number = std::get_if<double>(&key.default_value))
                CHECK(key.range.contains(*number));
            if (const auto* integer = std::get_if<long>(&key.default_value)) {
                CHECK(key.range.contains(static_cast<double>(*integer)));
            }
            if (nature_of(key) != ValueNature::word || key.presence == Presence::required) continue;
            if (!key.default_text.empty()) continue;
            const auto& word = std::get<std::string>(key.default_value);
            CHECK(std::find(key.choices.begin(), key.choices.end(), word) != key.choices.end());
        }
    }
}

TEST_CASE("A condition on a key or group names words of another key of the table", "[deck]") {
    int conditions = 0;
    const auto check = [&](const TableSpec& table, const std::vector<Condition>& only_for) {
        for (const Condition& condition : only_for) {
            ++conditions;
            const KeySpec* other = table.find(condition.key);
            REQUIRE(other != nullptr);
            for (const std::string& word : condition.words) {
                CHECK(std::find(other->choices.begin(), other->choices.end(), word) != other->choices.end());
            }
        }
    };
    for (const TableSpec* table : all_tables()) {
        for (const KeySpec& key : table->keys) {
            check(*table, key.only_for);
            CHECK((key.only_with.empty() || table->find(key.only_with) != nullptr));
            CHECK(takes_names(key) == !key.refers_to.empty());
            for (const std::string& kind : key.refers_to) CHECK(deck_schema().find(kind) != nullptr);
        }
        for (const KeyGroup& group : table->groups) {
            check(*table, group.only_for);
            CHECK((group.only_with.empty() || table->find(group.only_with) != nullptr));
        }
    }
    CHECK(conditions == 103);
}

TEST_CASE("Ranges know and describe their bounds", "[deck]") {
    const Range half_open{.lower = 0.0, .at_lower = Bound::open, .upper = 0.5};
    CHECK_FALSE(half_open.contains(0.0));
    CHECK(half_open.contains(1e-300));
    CHECK(half_open.contains(0.5));
    CHECK_FALSE(half_open.contains(0.50001));
    CHECK(describe_range(half_open) == "greater than 0, at most 0.5");
    CHECK(describe_range({.lower = 0.0, .upper = 1.0}) == "from 0 to 1");
    CHECK(describe_range({.lower = 1.0}) == "at least 1");
    CHECK(describe_range(positive) == "greater than 0");
    CHECK(describe_range({.upper = 2.0, .at_upper = Bound::open}) == "less than 2");
    CHECK(describe_range({.lower = 1.0, .upper = 1.0}) == "equal to 1");
    CHECK(describe_range({}).empty());
    CHECK(Range{}.contains(-1e300));
}

}  // namespace gxrod
