#include "deck/text/deck_comparison.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "deck/text/toml_writing.hpp"

namespace gxrod {
namespace {

std::string join(const std::string& path, const std::string& key) {
    return path.empty() ? key : path + "." + write_toml_key(key);
}

bool is_leaf(const DeckNode& node) { return node.table() == nullptr && node.array() == nullptr; }

const double* number_of(const DeckNode& node, double& storage) {
    if (const auto* whole = std::get_if<std::int64_t>(&node.value)) {
        storage = static_cast<double>(*whole);
        return &storage;
    }
    return std::get_if<double>(&node.value);
}

bool are_equal_leaves(const DeckNode& before, const DeckNode& now) {
    double a = 0.0;
    double b = 0.0;
    const double* first = number_of(before, a);
    const double* second = number_of(now, b);
    if (first != nullptr && second != nullptr) return *first == *second;
    return write_toml_value(before) == write_toml_value(now);
}

bool holds_tables(const DeckNode& node) {
    const DeckNode::Array* array = node.array();
    return node.table() != nullptr ||
           (array != nullptr && std::any_of(array->begin(), array->end(), holds_tables));
}

// A value in a message; "another one" if it has tables or is long.
std::string describe(const DeckNode& node) {
    constexpr std::size_t longest = 60;
    const std::string text = write_toml_value(node);
    return text.size() <= longest && !holds_tables(node) ? text : "another one";
}

class TreeComparison {
  public:
    TreeComparison(const ComparisonRules& rules, FaultList& faults) : rules_(rules), faults_(faults) {}

    void compare(const DeckNode& before, const DeckNode& now, const std::string& path) {
        if (is_free(path)) return;
        if (before.table() != nullptr && now.table() != nullptr) {
            compare_tables(before, now, path);
        } else if (before.array() != nullptr && now.array() != nullptr &&
                   before.array()->size() == now.array()->size()) {
            for (std::size_t i = 0; i < now.array()->size(); ++i) {
                compare(before.array()->at(i), now.array()->at(i), fmt::format("{}[{}]", path, i));
            }
        } else if (!is_leaf(before) || !is_leaf(now) || !are_equal_leaves(before, now)) {
            faults_.add(now.place, path, rules_.before_has + describe(before));
        }
    }

  private:
    bool is_free(const std::string& path) const {
        std::string pattern;
        for (std::size_t i = 0; i < path.size(); ++i) {
            pattern += path[i];
            if (path[i] == '[') i = std::min(path.find(']', i), path.size()) - 1;
        }
        return std::find(rules_.free_paths.begin(), rules_.free_paths.end(), pattern) !=
               rules_.free_paths.end();
    }

    void compare_tables(const DeckNode& before, const DeckNode& now, const std::string& path) {
        for (const DeckEntry& entry : *now.table()) {
            const DeckEntry* same = before.find(entry.key);
            const std::string key = join(path, entry.key);
            if (same != nullptr) {
                compare(same->node, entry.node, key);
            } else if (!is_free(key)) {
                faults_.add(entry.place, key, rules_.before_has + "none");
            }
        }
        for (const DeckEntry& entry : *before.table()) {
            const std::string key = join(path, entry.key);
            if (now.find(entry.key) != nullptr || is_free(key)) continue;
            faults_.add(
                now.place,
                key,
                "missing; " + rules_.before_has + (is_leaf(entry.node) ? describe(entry.node) : "it"));
        }
    }

    const ComparisonRules& rules_;
    FaultList& faults_;
};

}  // namespace

void compare_decks(const DeckNode& before,
                   const DeckNode& now,
                   const ComparisonRules& rules,
                   FaultList& faults,
                   const std::string& path) {
    TreeComparison(rules, faults).compare(before, now, path);
}

}  // namespace gxrod
