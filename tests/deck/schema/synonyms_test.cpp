#include "deck/schema/synonyms.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <map>

#include "batch/plan/plan_schema.hpp"
#include "deck/decks.hpp"
#include "deck/schema/schema.hpp"
#include "tools/catch.hpp"
#include "watch/quantities.hpp"

namespace gxrod::test {
namespace {

void add_tables(const TableSpec& table, std::map<std::string, const TableSpec*>& tables) {
    if (!tables.emplace(table.path, &table).second) return;
    for (const KeySpec& key : table.keys) {
        if (key.table != nullptr) add_tables(*key.table, tables);
    }
}

// By path; plans have tables of their own, and a top level.
std::map<std::string, const TableSpec*> all_tables(const TableSpec& root) {
    std::map<std::string, const TableSpec*> tables;
    add_tables(root, tables);
    return tables;
}

// The beginning of a path that is a list of tables; "" if none is.
std::string find_list(const std::string& path) {
    const TableSpec* table = &deck_schema();
    const KeySpec* key = nullptr;
    for (std::size_t from = 0, end = 0; table != nullptr && end < path.size(); from = end + 1) {
        end = std::min(path.find('.', from), path.size());
        const bool is_name = key != nullptr && key->shape == KeyShape::named_tables;
        if (is_name) {
            key = nullptr;
            continue;
        }
        key = table->find(path.substr(from, end - from));
        if (key == nullptr) return "";
        if (key->shape == KeyShape::table_list) return path.substr(0, end);
        table = key->table;
    }
    return "";
}

// A deck of one key in the table of this path, and the path of the key in messages.
std::pair<std::string, std::string> place_key(const std::string& table, const std::string& key) {
    if (table.empty()) return {key + " = 1\n", key};
    const std::string list = find_list(table);
    if (list.empty()) return {fmt::format("[{}]\n{} = 1\n", table, key), fmt::format("{}.{}", table, key)};
    const std::string inner = list == table ? "" : fmt::format("[{}]\n", table);
    return {fmt::format("[[{}]]\n{}{} = 1\n", list, inner, key),
            fmt::format("{}[0]{}.{}", list, table.substr(list.size()), key)};
}

void collect_choices(const TableSpec& table, std::vector<std::vector<std::string>>& choices) {
    for (const KeySpec& key : table.keys) {
        if (!key.choices.empty()) choices.push_back(key.choices);
    }
}

}  // namespace

TEST_CASE("Every synonym of a key leads to an existing key", "[deck]") {
    const auto of_deck = all_tables(deck_schema());
    const auto of_plan = all_tables(plan_schema());
    std::vector<std::pair<std::string, OtherNames>> all;
    for (const auto* tables : {&of_deck, &of_plan}) {
        for (const auto& [path, table] : *tables) {
            for (const OtherNames& names : table->other_names) all.emplace_back(path, names);
        }
    }
    for (const auto& [path_of_table, synonyms] : all) {
        CHECK((of_deck.contains(path_of_table) || of_plan.contains(path_of_table)));
        for (const std::string& word : split_words(synonyms.words)) {
            INFO(path_of_table << ": " << word);
            const bool is_of_deck =
                of_deck.contains(path_of_table) && find_synonym(*of_deck.at(path_of_table), word) == synonyms;
            const bool is_of_plan =
                of_plan.contains(path_of_table) && find_synonym(*of_plan.at(path_of_table), word) == synonyms;
            REQUIRE((is_of_deck || is_of_plan));
            const TableSpec& table = *(is_of_deck ? of_deck : of_plan).at(path_of_table);
            // What is a key of the table is no synonym in its decks.
            CHECK(table.find(word) == nullptr);
            CHECK((!synonyms.key.empty() || !synonyms.remark.empty()));
            if (!is_of_deck) continue;
            const auto [deck, path] = place_key(path_of_table, word);
            const std::string wanted = path + ": unknown key" + explain_synonym(table, word) + "\n";
            CHECK((faults_of(deck) + "\n").find(wanted) != std::string::npos);
        }
    }
}

TEST_CASE("Every synonym of a word leads to a word of some key", "[deck]") {
    std::vector<std::vector<std::string>> choices;
    for (const TableSpec* root : {&deck_schema(), &plan_schema(), &variation_table()}) {
        for (const auto& [path, table] : all_tables(*root)) collect_choices(*table, choices);
    }
    for (const char* table : {"rod", "body", "spring", "bushing", "joint", "gear", "tendon", "contact"})
        choices.push_back(list_quantity_words(table));
    // A joint that cannot turn.
    choices.push_back({"slide", "slide_rate", "force", "moment"});
    for (const WordSynonyms& synonyms : word_synonyms()) {
        for (const std::string& word : split_words(synonyms.words)) {
            INFO(synonyms.choice << ": " << word);
            const bool leads = std::any_of(choices.begin(), choices.end(), [&](const auto& known) {
                return find_choice(word, known) == synonyms.choice;
            });
            CHECK(leads);
        }
    }
}

TEST_CASE("What other programs call otherwise is understood", "[deck]") {
    const auto unknown = [](const std::string& deck) { return faults_of(deck); };
    CHECK(unknown(rod_deck + "[[load]]\npos = \"r.end\"\nforce = [0, 0, 1]\n") ==
          "x.toml:14:1: load[0].pos: unknown key; did you mean \"at\"?");
    CHECK(unknown(rod_deck + "[[support]]\nat = \"r.end\"\nfix = \"clamped\"\n") ==
          "x.toml:15:7: support[0].fix: expected one of \"x\", \"y\", \"z\", \"rx\", \"ry\", \"rz\", "
          "\"all\", \"position\", \"rotation\", found the text \"clamped\"; did you mean \"all\"?");
    CHECK(unknown(replaced(replaced(rod_deck, "end_time", "duration"), "steps", "dt")) ==
          "x.toml:11:1: analysis.duration: unknown key; did you mean \"end_time\"?\n"
          "x.toml:12:1: analysis.dt: unknown key; did you mean \"time_step\"?");
    CHECK(unknown("g = [0, 0, -9.81]\n" + rod_deck) ==
          "x.toml:1:1: g: unknown key; did you mean \"gravity\"?");
    CHECK(unknown("dt = 1\n" + rod_deck) ==
          "x.toml:1:1: dt: unknown key; did you mean \"analysis.time_step\"?");
    const std::size_t first = rod_deck.find("stiffness");
    const std::string wire = std::string(rod_deck).replace(
        first,
        rod_deck.find("[rod.r]") - first,
        "shape = { circle = { diameter = 2 } }\nmaterial = { Youngs_Modulus = 1, poisson = 0, rho = 1 }\n");
    CHECK(unknown(wire) ==
          "x.toml:2:22: section.s.shape.circle.diameter: unknown key; did you mean \"radius\", half the "
          "diameter?\n"
          "x.toml:3:14: section.s.material.Youngs_Modulus: unknown key; did you mean \"E\"?\n"
          "x.toml:3:34: section.s.material.poisson: unknown key; did you mean \"nu\"?\n"
          "x.toml:3:47: section.s.material.rho: unknown key; did you mean \"density\"?");
}

TEST_CASE("A key of another table is looked for there", "[deck]") {
    const auto hint_of = [](const std::string& key, const std::string& before) {
        const std::string fault = faults_of(replaced(rod_deck, before, key + " = 1\n" + before));
        const std::size_t begin = fault.find("unknown key");
        return begin == std::string::npos ? fault : fault.substr(begin, fault.find("; known here") - begin);
    };
    CHECK(hint_of("shear_factor", "stiffness") ==
          "unknown key; section.NAME.material has a key of this name");
    CHECK(hint_of("end_time", "stiffness") == "unknown key; analysis and stage have a key of this name");
    CHECK(hint_of("zzz_zzz", "stiffness") == "unknown key");
    // Very many tables have one.
    CHECK(hint_of("at", "line") == "unknown key");
}

TEST_CASE("An initial displacement is explained, not reported as a missing velocity", "[deck]") {
    CHECK(faults_of(rod_deck + "[[initial]]\non = \"r\"\ndisplacement = [0, 0, 1]\n") ==
          "x.toml:15:1: initial[0].displacement: unknown key; a deck says where things are at t = 0, so that "
          "there "
          "is no other displacement: draw the rods where they start, and what is not free of stress there "
          "comes "
          "from a static analysis");
    CHECK(faults_of(rod_deck + "[[initial]]\non = \"r\"\n") ==
          "x.toml:13:1: initial[0]: missing; expected velocity or angular_velocity or spin = { … }");
    CHECK(faults_of(rod_deck + "[[initial]]\non = \"r\"\nv = [0, 0, 1]\n") ==
          "x.toml:15:1: initial[0].v: unknown key; did you mean \"velocity\"?");
}

TEST_CASE("Quantities of a history are suggested by what its point is", "[deck]") {
    const auto hint = [](const std::string& at, const std::string& word) {
        const std::string things =
            "[body.b]\nmass = 1\ninertia = [1, 1, 1]\nat = [0, 5, 0]\n"
            "[spring.k]\nbetween = [\"r.end\", \"b\"]\nstiffness = 1\n"
            "[joint.h]\ntype = \"hinge\"\nbetween = [\"b\", \"ground\"]\naxis = [0, 0, 1]\n"
            "[tendon.t]\non = \"r\"\noffset = [0, 0.1]\ntension = 1\n";
        const std::string fault = faults_of(rod_deck + things + "[[history]]\nname = \"n\"\nat = \"" + at +
                                            "\"\nquantities = \"" + word + "\"\n");
        INFO(fault);
        CHECK(fault.find("history[0].quantities: ") != std::string::npos);
        const std::size_t begin = fault.find("; did you mean \"");
        return begin == std::string::npos ? "" : fault.substr(begin + 16, fault.rfind('"') - begin - 16);
    };
    CHECK(hint("r.end", "pos") == "position");
    CHECK(hint("r@0.3", "torque") == "moment");
    CHECK(hint("r.end", "stress") == "force");
    CHECK(hint("b", "pos") == "position");
    CHECK(hint("k", "stress") == "axial_force");
    CHECK(hint("k", "force") == "axial_force");
    CHECK(hint("k", "pos") == "elongation");
    CHECK(hint("h", "pos") == "angle");
    CHECK(hint("h", "torque") == "moment");
    CHECK(hint("h", "velocity") == "angle_rate");
    CHECK(hint("t", "force") == "tendon_tension");
    CHECK(hint("t", "stress") == "tendon_tension");
    CHECK(hint("k", "quaternion") == "");
    // Only what suits is listed.
    CHECK(faults_of(rod_deck +
                    "[spring.k]\nbetween = [\"r.end\", \"ground\"]\nat_b = [11, 0, 0]\nstiffness = 1\n"
                    "[[history]]\nname = \"n\"\nat = \"k\"\nquantities = \"pull\"\n") ==
          "x.toml:20:14: history[0].quantities: expected one of \"elongation\", \"axial_force\", found the "
          "text "
          "\"pull\"");
}

}  // namespace gxrod::test
