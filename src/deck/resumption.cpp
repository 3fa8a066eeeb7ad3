#include "deck/resumption.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>

#include "deck/toml_writing.hpp"

namespace gxrod {
namespace {

// Paths whose differences are of no matter to the state of a run.
constexpr std::array free_paths{"title",
                                "units",
                                "output",
                                "history",
                                "analysis.end_time",
                                "analysis.time_step",
                                "analysis.steps",
                                "analysis.adaptive",
                                "analysis.newton",
                                "analysis.linear_solver"};

bool is_free(const std::string& path) {
    return std::find(free_paths.begin(), free_paths.end(), path) != free_paths.end();
}

std::string join(const std::string& path, const std::string& key) {
    return path.empty() ? key : path + "." + key;
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

const std::string the_run_has = "the run that is to go on has ";

class Comparison {
  public:
    explicit Comparison(FaultList& faults) : faults_(faults) {}

    void compare(const DeckNode& before, const DeckNode& now, const std::string& path) {
        if (is_free(path)) return;
        if (before.table() != nullptr && now.table() != nullptr) {
            compare_tables(*before.table(), now, path);
        } else if (before.array() != nullptr && now.array() != nullptr &&
                   before.array()->size() == now.array()->size()) {
            for (std::size_t i = 0; i < now.array()->size(); ++i) {
                compare(before.array()->at(i), now.array()->at(i), fmt::format("{}[{}]", path, i));
            }
        } else if (!is_leaf(before) || !is_leaf(now) || !are_equal_leaves(before, now)) {
            add(now.place, path, the_run_has + describe(before));
        }
    }

    // Histories of one name must be of one point.
    void compare_histories(const DeckNode& before, const DeckNode& now) {
        const DeckEntry* earlier = before.find("history");
        const DeckEntry* later = now.find("history");
        if (earlier == nullptr || later == nullptr) return;
        if (earlier->node.array() == nullptr || later->node.array() == nullptr) return;
        for (std::size_t i = 0; i < later->node.array()->size(); ++i) {
            const DeckNode& history = later->node.array()->at(i);
            const DeckNode* same = find_history(*earlier->node.array(), history);
            if (same != nullptr) compare_history(*same, history, fmt::format("history[{}]", i));
        }
    }

  private:
    void add(const Place& place, const std::string& path, const std::string& message) {
        faults_.add(place, path, message);
    }

    static std::string describe(const DeckNode& node) {
        return is_leaf(node) ? write_toml_value(node) : "another one";
    }

    void compare_tables(const DeckNode::Table& before, const DeckNode& now, const std::string& path) {
        for (const DeckEntry& entry : *now.table()) {
            const auto same = std::find_if(
                before.begin(), before.end(), [&](const DeckEntry& other) { return other.key == entry.key; });
            const std::string key = join(path, entry.key);
            if (same != before.end()) {
                compare(same->node, entry.node, key);
            } else if (!is_free(key)) {
                add(entry.place, key, the_run_has + "none");
            }
        }
        for (const DeckEntry& entry : before) {
            const std::string key = join(path, entry.key);
            if (now.find(entry.key) != nullptr || is_free(key)) continue;
            add(now.place,
                key,
                "missing; " + the_run_has + (is_leaf(entry.node) ? describe(entry.node) : "it"));
        }
    }

    static const DeckNode* find_history(const DeckNode::Array& histories, const DeckNode& wanted) {
        const auto name_of = [](const DeckNode& history) {
            const DeckEntry* name = history.table() == nullptr ? nullptr : history.find("name");
            return name == nullptr ? nullptr : name->node.text();
        };
        const std::string* name = name_of(wanted);
        for (const DeckNode& history : histories) {
            const std::string* other = name_of(history);
            if (name != nullptr && other != nullptr && *name == *other) return &history;
        }
        return nullptr;
    }

    void compare_history(const DeckNode& before, const DeckNode& now, const std::string& path) {
        DeckNode::Table kept_before = *before.table();
        DeckNode kept_now = now;
        const auto is_list = [](const DeckEntry& entry) { return entry.key == "quantities"; };
        std::erase_if(kept_before, is_list);
        std::erase_if(*kept_now.table(), is_list);
        compare_tables(kept_before, kept_now, path);
    }

    FaultList& faults_;
};

}  // namespace

void check_resumption(const DeckNode& before, const DeckNode& now, FaultList& faults) {
    Comparison comparison(faults);
    comparison.compare(before, now, "");
    comparison.compare_histories(before, now);
}

bool have_same_mesh(const Model& before, const Model& now) {
    const auto same_node = [](const Node& a, const Node& b) { return a.position == b.position; };
    const auto same_rod = [](const Rod& a, const Rod& b) {
        return a.name == b.name && a.kind == b.kind && a.order == b.order &&
               a.element_nodes == b.element_nodes;
    };
    const auto same_body = [](const Body& a, const Body& b) { return a.name == b.name && a.node == b.node; };
    return std::ranges::equal(before.nodes, now.nodes, same_node) &&
           std::ranges::equal(before.rods, now.rods, same_rod) &&
           std::ranges::equal(before.bodies, now.bodies, same_body);
}

}  // namespace gxrod
