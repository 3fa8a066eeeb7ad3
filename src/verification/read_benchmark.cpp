#include <fmt/format.h>

#include <limits>

#include "deck/text/deck_tree.hpp"
#include "verification/benchmark.hpp"

// The keys of a reference.toml:
//   sentence, kind, source = "…"
//   [[value]]       history = "tip" (or ledger = true), quantity, time = 1 (or "all": every step), is =
//   number or
//                   vector, scale = 1, uncertainty = 0
//   [[value]]       stage = "tones", quantity = "frequency", "omega", "growth" or "factor", is = those of the
//                   first shapes, or "load_factor" of the critical points of a path; errors are relative, the
//                   largest counts
//   Of a sweep "omega" and "growth" of all modes, with at = the value of the sweep, or "onset" and
//   "onset_omega"
//   On a path, where = { history, displacement = "x", "y" or "z", is = number } or { stage, t = number } is
//   in the place of time, and "load_factor" and "limit_load_factor" are quantities, too
//   [[refinement]]  name, set = ["KEY=VALUE"] for all rows, rows = [["KEY=VALUE"], …], order, tolerance,
//   floor
namespace gxrod {

namespace {

class ReferenceReader {
  public:
    ReferenceReader(std::string file, const DeckNode& root) : faults_(std::move(file), {}), root_(&root) {}

    Benchmark read() {
        Benchmark benchmark;
        allow(*root_, {"sentence", "kind", "source", "value", "refinement"});
        benchmark.sentence = text(*root_, "sentence");
        benchmark.kind = text(*root_, "kind");
        benchmark.source = text(*root_, "source");
        for (const DeckNode& table : tables("value")) benchmark.values.push_back(read_value(table));
        for (const DeckNode& table : tables("refinement")) {
            benchmark.refinements.push_back(read_refinement(table));
        }
        const std::vector<Refinement>& refinements = benchmark.refinements;
        if (std::none_of(refinements.begin(), refinements.end(), [](const Refinement& refinement) {
                return refinement.tolerance > 0.0;
            })) {
            faults_.add(
                root_->place, "refinement", "one must have a tolerance, for the values to be held to");
        }
        faults_.throw_if_any();
        return benchmark;
    }

  private:
    void allow(const DeckNode& table, const std::vector<std::string>& keys) {
        for (const DeckEntry& entry : *table.table()) {
            if (std::find(keys.begin(), keys.end(), entry.key) == keys.end()) {
                faults_.add(entry.place,
                            entry.key,
                            fmt::format("unknown key; known here: {}", fmt::join(keys, ", ")));
            }
        }
    }

    const DeckNode* find(const DeckNode& table, const std::string& key) const {
        const DeckEntry* entry = table.find(key);
        return entry == nullptr ? nullptr : &entry->node;
    }

    std::vector<DeckNode> tables(const std::string& key) const {
        const DeckNode* list = find(*root_, key);
        return list == nullptr || list->array() == nullptr ? std::vector<DeckNode>() : *list->array();
    }

    std::string text(const DeckNode& table, const std::string& key) {
        const DeckNode* node = find(table, key);
        if (node != nullptr && node->text() != nullptr) return *node->text();
        faults_.add(table.place, key, "expected a text");
        return "";
    }

    double number(const DeckNode& node, const std::string& key) {
        if (const auto* real = std::get_if<double>(&node.value)) return *real;
        if (const auto* integer = std::get_if<std::int64_t>(&node.value)) {
            return static_cast<double>(*integer);
        }
        faults_.add(node.place, key, "expected a number");
        return 0.0;
    }

    double number_or(const DeckNode& table, const std::string& key, double otherwise) {
        const DeckNode* node = find(table, key);
        return node == nullptr ? otherwise : number(*node, key);
    }

    std::vector<double> numbers(const DeckNode& table, const std::string& key) {
        const DeckNode* node = find(table, key);
        std::vector<double> values;
        if (node == nullptr) {
            faults_.add(table.place, key, "expected a number or an array of them");
        } else if (node->array() == nullptr) {
            values.push_back(number(*node, key));
        } else {
            for (const DeckNode& element : *node->array()) values.push_back(number(element, key));
        }
        const bool is_of_shapes = table.find("stage") != nullptr;
        if (!is_of_shapes && values.size() > 4) faults_.add(node->place, key, "expected at most 4 numbers");
        return values;
    }

    std::vector<std::string> texts(const DeckNode& array, const std::string& key) {
        std::vector<std::string> values;
        if (array.array() == nullptr) {
            faults_.add(array.place, key, "expected an array of texts");
            return values;
        }
        for (const DeckNode& element : *array.array()) {
            if (element.text() == nullptr) {
                faults_.add(element.place, key, "expected a text \"KEY=VALUE\"");
            } else {
                values.push_back(*element.text());
            }
        }
        return values;
    }

    bool is_word(const DeckNode& table, const std::string& key, const std::string& word) const {
        const DeckNode* node = find(table, key);
        return node != nullptr && node->text() != nullptr && *node->text() == word;
    }

    PlaceOnPath read_place(const DeckNode& where) {
        PlaceOnPath place;
        if (where.table() == nullptr) {
            faults_.add(where.place, "where", "expected { history, displacement, is }");
            return place;
        }
        if (where.find("t") != nullptr) {
            allow(where, {"stage", "t"});
            if (where.find("stage") != nullptr) place.stage = text(where, "stage");
            place.is = number_or(where, "t", 0.0);
            return place;
        }
        allow(where, {"history", "displacement", "is"});
        place.history = text(where, "history");
        const std::string direction = text(where, "displacement");
        const std::size_t component = std::string("xyz").find(direction);
        if (direction.size() != 1 || component == std::string::npos)
            faults_.add(where.place, "displacement", "expected x, y or z");
        else
            place.component = static_cast<int>(component);
        place.is = number_or(where, "is", 0.0);
        return place;
    }

    BenchmarkValue read_value(const DeckNode& table) {
        allow(
            table,
            {"history", "ledger", "stage", "quantity", "time", "where", "at", "is", "scale", "uncertainty"});
        BenchmarkValue value;
        value.is_of_shapes = table.find("stage") != nullptr;
        value.source = table.find("ledger") != nullptr
                           ? "ledger"
                           : text(table, value.is_of_shapes ? "stage" : "history");
        value.quantity = text(table, "quantity");
        if (const DeckNode* where = find(table, "where")) value.where = read_place(*where);
        value.is_constant = is_word(table, "time", "all");
        if (!value.is_constant) value.time = number_or(table, "time", 1.0);
        value.reference = numbers(table, "is");
        if (table.find("at") != nullptr) value.at = number_or(table, "at", 0.0);
        value.scale = number_or(table, "scale", 1.0);
        value.uncertainty = number_or(table, "uncertainty", 0.0);
        return value;
    }

    Refinement read_refinement(const DeckNode& table) {
        allow(table, {"name", "set", "rows", "order", "tolerance", "floor"});
        Refinement refinement;
        refinement.name = text(table, "name");
        const DeckNode* common = find(table, "set");
        const std::vector<std::string> shared =
            common == nullptr ? std::vector<std::string>() : texts(*common, "set");
        const DeckNode* rows = find(table, "rows");
        if (rows == nullptr || rows->array() == nullptr || rows->array()->empty()) {
            faults_.add(table.place, "rows", "expected an array of arrays of \"KEY=VALUE\"");
            return refinement;
        }
        for (const DeckNode& row : *rows->array()) {
            refinement.rows.push_back(shared);
            for (std::string& key : texts(row, "rows")) refinement.rows.back().push_back(std::move(key));
        }
        refinement.order = number_or(table, "order", 0.0);
        refinement.tolerance = number_or(table, "tolerance", 0.0);
        refinement.floor = number_or(table, "floor", 0.0);
        return refinement;
    }

    FaultList faults_;
    const DeckNode* root_;
};

}  // namespace

Benchmark read_benchmark(const std::string& name, const std::string& deck, const std::string& reference) {
    const std::string file = name + "/reference.toml";
    const DeckNode root = read_toml(reference, file);
    Benchmark benchmark = ReferenceReader(file, root).read();
    benchmark.name = name;
    benchmark.deck = deck;
    return benchmark;
}

}  // namespace gxrod
