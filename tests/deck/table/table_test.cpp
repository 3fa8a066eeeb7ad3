#include "deck/table/table.hpp"

#include <set>

#include "deck/decks.hpp"
#include "deck/reading/validation.hpp"
#include "deck/schema/schema.hpp"
#include "tools/catch.hpp"

// Tables whose keys are bound to fields of structs.
namespace gxrod::test {
namespace {

// A table and all tables in it.
void collect_bound_tables(const TableSpec& table, std::set<const TableSpec*>& tables) {
    if (table.make) tables.insert(&table);
    for (const KeySpec& key : table.keys) {
        if (key.table != nullptr) collect_bound_tables(*key.table, tables);
    }
}

std::set<const TableSpec*> bound_tables() {
    std::set<const TableSpec*> tables;
    collect_bound_tables(deck_schema(), tables);
    return tables;
}

// A value for the key, as a deck has it; of a table, one with a key.
std::string sample_of(const KeySpec& key) {
    if (key.binding->kind != nullptr) return key.binding->kind->sample(key);
    const std::string inner = key.table->keys.front().name + " = " + sample_of(key.table->keys.front());
    return key.type == ValueType::table_list ? "[{ " + inner + " }]" : "{ " + inner + " }";
}

// What a key prints; of a table, whether it is there.
std::string print(const KeySpec& key, const TableHead& table) {
    if (key.binding->print) return key.binding->print(table);
    return key.binding->value(table) == nullptr ? "" : "there";
}

}  // namespace

TEST_CASE("Each key of a bound table is read as it is written, into its own field", "[deck]") {
    for (const TableSpec* spec : bound_tables()) {
        const std::shared_ptr<TableHead> fresh = spec->make();
        for (const KeySpec& key : spec->keys) {
            const std::string sample = sample_of(key);
            INFO(spec->path << "." << key.name << " = " << sample);
            FaultList faults("x.toml", {});
            const CheckedTable checked =
                check_table(read_toml("\n" + key.name + " = " + sample, "x.toml"), "it", *spec, faults);
            const TableHead& read = *checked.record;
            CHECK(print(key, read) == (key.binding->kind == nullptr ? "there" : sample));
            CHECK(print(key, read) != print(key, *fresh));
            for (const KeySpec& other : spec->keys) {
                if (other.name != key.name) CHECK(print(other, read) == print(other, *fresh));
            }
            const void* field = key.binding->field(read);
            CHECK(&read.key_of(field) == &key);
            CHECK(read.path_of(field) == "it." + key.name);
            CHECK(read.place_of(field) == Place{-1, 2, static_cast<int>(key.name.size()) + 4});
            for (const DeckFault& fault : faults.list())  // of other keys alone
                CHECK((fault.key != "it." + key.name || fault.message.starts_with("goes with") ||
                       fault.message.starts_with("missing")));
        }
    }
}

// Lower the number with each table that becomes a struct; a new table must not raise it.
TEST_CASE("No more than so many tables have keys that are fetched by strings", "[deck]") {
    std::set<const TableSpec*> all;
    const std::function<void(const TableSpec&)> collect = [&](const TableSpec& table) {
        if (!table.make && !table.keys.empty()) all.insert(&table);
        for (const KeySpec& key : table.keys) {
            if (key.table != nullptr) collect(*key.table);
        }
    };
    collect(deck_schema());
    CHECK(all.size() == 31);
}

}  // namespace gxrod::test
