#include "deck/places/part.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "deck/places/name_pattern.hpp"
#include "deck/schema/suggestion.hpp"

namespace gxrod {

std::optional<int> find_index(const std::vector<CheckedTable>& tables, std::string_view name) {
    for (std::size_t i = 0; i < tables.size(); ++i) {
        if (tables[i].name == name) return static_cast<int>(i);
    }
    return std::nullopt;
}

namespace {

// What is wrong with a name that is not one of the parts that the key takes.
std::string explain(const std::string& text, const KeySpec& key, const CheckedTable& deck) {
    std::vector<std::string> known;
    for (const std::string& kind : key.refers_to) {
        for (const CheckedTable& table : deck.tables(kind)) known.push_back(table.name);
    }
    const std::string name = text.substr(0, text.find_first_of(".@"));
    if (name != text && find_index(deck.tables("rod"), name)) {
        return fmt::format("\"{}\" is a point; expected the rod \"{}\"", text, name);
    }
    if (find_index(deck.tables("body"), text)) return fmt::format("\"{}\" is a body; expected a rod", text);
    const std::string kinds = fmt::format("{}", fmt::join(key.refers_to, " or "));
    const std::string nearest = did_you_mean(text, known);
    const std::string hint = !nearest.empty() ? nearest
                             : known.empty()  ? fmt::format("; the deck has no {}", kinds)
                                              : "; the deck has " + plain_list(known);
    return fmt::format("no {} \"{}\"{}", kinds, text, hint);
}

std::optional<Part> find_named(const CheckedWord& name, const KeySpec& key, const BuildContext& context) {
    Part part;
    for (const std::string& kind : key.refers_to) {
        (kind == "rod" ? part.rod : part.body) =
            find_index(context.deck.tables(kind), name.word).value_or(-1);
    }
    if (part.rod >= 0 || part.body >= 0) return part;
    context.faults.add(name.place, name.path, explain(name.word, key, context.deck));
    return std::nullopt;
}

// The parts whose names match a text with *; a fault if there is none.
std::vector<Part> find_matching(const CheckedWord& name, const KeySpec& key, const BuildContext& context) {
    std::vector<Part> parts;
    std::vector<std::string> known;
    for (const std::string& kind : key.refers_to) {
        const auto& tables = context.deck.tables(kind);
        for (std::size_t i = 0; i < tables.size(); ++i) {
            known.push_back(tables[i].name);
            if (!matches_pattern(tables[i].name, name.word)) continue;
            Part& part = parts.emplace_back();
            (kind == "rod" ? part.rod : part.body) = static_cast<int>(i);
        }
    }
    if (parts.empty())
        context.faults.add(name.place,
                           name.path,
                           fmt::format("no {} matches \"{}\"; the deck has {}",
                                       fmt::join(key.refers_to, " or "),
                                       name.word,
                                       known.empty() ? "none" : plain_list(known)));
    return parts;
}

}  // namespace

std::optional<Part> find_part(const TableHead& table, const TableName& field, const BuildContext& context) {
    return find_named(field, table.key_of(&field), context);
}

std::vector<Part> find_parts(const TableHead& table, const TableNames& field, const BuildContext& context) {
    std::vector<Part> parts;
    const KeySpec& key = table.key_of(&field);
    const auto add = [&](const Part& part) {
        const auto is_same = [&](const Part& one) { return one.rod == part.rod && one.body == part.body; };
        if (std::ranges::none_of(parts, is_same)) parts.push_back(part);
    };
    for (const CheckedWord& name : field.names) {
        if (name.word.find('*') != std::string::npos) {
            for (const Part& part : find_matching(name, key, context)) add(part);
        } else if (const std::optional<Part> part = find_named(name, key, context)) {
            add(*part);
        }
    }
    return parts;
}

}  // namespace gxrod
