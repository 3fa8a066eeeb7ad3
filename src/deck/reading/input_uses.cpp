#include "deck/reading/input_uses.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "deck/expressions/expression.hpp"
#include "deck/expressions/expression_tokens.hpp"
#include "deck/schema/schema.hpp"
#include "deck/table/binding.hpp"

namespace gxrod {
namespace {

// Walks through a deck along its schema: only keys that take functions have expressions with inputs.
class UseFinder {
  public:
    explicit UseFinder(const DeckNode& deck) {
        for (const char* kind : {"input", "signal"}) {
            const DeckEntry* entries = deck.find(kind);
            if (entries == nullptr || entries->node.table() == nullptr) continue;
            for (const DeckEntry& entry : *entries->node.table()) uses_[entry.key];
        }
        visit_table(deck, "", deck_schema());
    }

    std::map<std::string, std::vector<std::string>> release() { return std::move(uses_); }

  private:
    void visit_table(const DeckNode& node, const std::string& path, const TableSpec& spec) {
        if (node.table() == nullptr) return;
        for (const DeckEntry& entry : *node.table()) {
            const KeySpec* key = spec.find(entry.key);
            if (key != nullptr) visit(entry.node, path.empty() ? entry.key : path + "." + entry.key, *key);
        }
    }

    void visit(const DeckNode& node, const std::string& path, const KeySpec& key) {
        if (key.shape == KeyShape::named_tables && node.table() != nullptr) {
            for (const DeckEntry& entry : *node.table())
                visit_table(entry.node, path + "." + entry.key, *key.table);
        } else if (key.shape == KeyShape::table_list && node.array() != nullptr) {
            const DeckNode::Array& items = *node.array();
            for (std::size_t i = 0; i < items.size(); ++i)
                visit_table(items[i], fmt::format("{}[{}]", path, i), *key.table);
        } else if (key.table != nullptr && node.table() != nullptr) {
            visit_table(node, path, *key.table);
        } else if (const ValueKind* kind = find_kind(key);
                   kind != nullptr && kind->column(key).find("f(") != std::string::npos) {
            visit_value(node, path);
        }
    }

    void visit_value(const DeckNode& node, const std::string& path) {
        if (const std::string* text = node.text()) return note(*text, path);
        if (const DeckNode::Array* items = node.array()) {
            for (std::size_t i = 0; i < items->size(); ++i)
                visit_value((*items)[i], fmt::format("{}[{}]", path, i));
        } else if (const DeckNode::Table* entries = node.table()) {
            for (const DeckEntry& entry : *entries) visit_value(entry.node, path + "." + entry.key);
        }
    }

    void note(const std::string& text, const std::string& path) {
        std::vector<Token> tokens;
        try {
            tokens = split_expression(text);
        } catch (const ExpressionError&) {
            return;  // a word, not an expression
        }
        for (const Token& token : tokens) {
            const auto use = token.kind == TokenKind::name ? uses_.find(token.text) : uses_.end();
            if (use == uses_.end()) continue;
            if (use->second.empty() || use->second.back() != path) use->second.push_back(path);
        }
    }

    std::map<std::string, std::vector<std::string>> uses_;
};

}  // namespace

std::map<std::string, std::vector<std::string>> find_input_uses(const DeckNode& deck) {
    return UseFinder(deck).release();
}

std::set<std::string> list_table_names(const DeckNode& deck, std::string_view kind) {
    std::set<std::string> names;
    const DeckEntry* tables = deck.find(kind);
    if (tables == nullptr || tables->node.table() == nullptr) return names;
    for (const DeckEntry& entry : *tables->node.table()) names.insert(entry.key);
    return names;
}

}  // namespace gxrod
