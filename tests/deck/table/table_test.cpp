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

// Values for the key, as a deck has them; of a table, one with a key.
std::vector<std::string> samples_of(const KeySpec& key) {
    std::vector<std::string> samples;
    if (key.default_text == "false") return {"true"};
    if (!key.choices.empty() && key.default_text == key.choices.back())
        return {"\"" + key.choices.front() + "\""};
    if (key.binding->kind != nullptr) samples.push_back(key.binding->kind->sample(key));
    if (key.table == nullptr) return samples;
    const KeySpec& first = key.table->keys.front();
    const std::string inner = "{ " + first.name + " = " + samples_of(first).front() + " }";
    samples.push_back(key.shape == KeyShape::table_list     ? "[" + inner + "]"
                      : key.shape == KeyShape::named_tables ? "{ some = " + inner + " }"
                                                            : inner);
    return samples;
}

// What a key prints; of a table, whether it is there.
std::string print(const KeySpec& key, const TableHead& table) {
    const std::string text = key.binding->print ? key.binding->print(table) : "";
    return text.empty() && key.table != nullptr && key.binding->value(table) != nullptr ? "there" : text;
}

// What it prints of a sample.
std::string print_of(const KeySpec& key, const std::string& sample) {
    return key.table != nullptr && sample.find('{') != std::string::npos ? "there" : sample;
}

void check_key(const KeySpec& key, const std::string& sample, const TableSpec& spec) {
    INFO(spec.path << "." << key.name << " = " << sample);
    const std::shared_ptr<TableHead> fresh = spec.make();
    FaultList faults("x.toml", {});
    const CheckedTable checked =
        check_table(read_toml("\n" + key.name + " = " + sample, "x.toml"), "it", spec, faults);
    const TableHead& read = *checked.record;
    CHECK(print(key, read) == print_of(key, sample));
    CHECK(print(key, read) != print(key, *fresh));
    for (const KeySpec& other : spec.keys) {
        if (other.binding && other.name != key.name) CHECK(print(other, read) == print(other, *fresh));
    }
    const void* field = key.binding->field(read);
    CHECK(&read.key_of(field) == &key);
    CHECK(read.path_of(field) == "it." + key.name);
    CHECK(read.place_of(field) == Place{-1, 2, static_cast<int>(key.name.size()) + 4});
    for (const DeckFault& fault : faults.list())  // of other keys alone
        CHECK((fault.key != "it." + key.name || fault.message.starts_with("goes with") ||
               fault.message.starts_with("missing")));
}

}  // namespace

TEST_CASE("Each key of a bound table is read as it is written, into its own field", "[deck]") {
    for (const TableSpec* spec : bound_tables()) {
        for (const KeySpec& key : spec->keys) {
            if (!key.binding) continue;  // tables of the top level
            for (const std::string& sample : samples_of(key)) check_key(key, sample, *spec);
        }
    }
}

TEST_CASE("Every table of a deck is read into a struct", "[deck]") {
    const std::function<void(const TableSpec&)> check = [&](const TableSpec& table) {
        INFO(table.path);
        CHECK((table.make != nullptr || table.keys.empty()));  // any names in [parameters]
        for (const KeySpec& key : table.keys) {
            if (key.table != nullptr) check(*key.table);
        }
    };
    check(deck_schema());
}

}  // namespace gxrod::test
