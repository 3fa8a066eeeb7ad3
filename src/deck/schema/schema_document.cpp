#include <fmt/format.h>

#include "deck/expressions/expression_built_ins.hpp"
#include "deck/schema/schema.hpp"
#include "deck/schema/suggestion.hpp"
#include "deck/table/binding.hpp"

namespace gxrod {
namespace {

constexpr const char* introduction =
    R"md(# Deck reference

A deck is a [TOML 1.0](https://toml.io) text. This page is written by `gxrod schema --markdown`, from the declarations
that the reader itself checks a deck with; `gxrod schema` writes the same as a JSON Schema for editors.

- **Units** are any consistent ones. Dimensions below are in mass, length, time; angles are in radians. `units` is a
  label only.
- **Numbers** are finite. Where a key takes a number it also takes an expression in quotes, such as `"2*EI"`, with the
  names of `[parameters]`. Where the type says f(t), the expression may also use the time `t` and call the deck's
  functions, as in `"0.5*pulse(t)"`; f(t, s) has also the arc length `s` from a rod's start, and f(x, y, z, s) the
  reference position and `s`, but not `t`. In static analyses `t` is the load factor, from 0 to 1, and what has no `t`
  is multiplied by it. Each `[[stage]]` has its own `t`, from 0; what has no `t` grows in the first stage, if that is
  static, and stays.
- **Vectors** are arrays of three numbers, in the global axes unless the key says otherwise.
- **Points** are `NAME.start`, `NAME.end` and `NAME@0.25` of a rod (a fraction of its length, where a node is placed,
  but for what a history only looks at), and a body by its name. A rod and a body cannot have the same name.
- **Names** of sections, rods and bodies have letters, digits, `_` and `-`; those of parameters and functions letters,
  digits and `_`, no digit first.
- Unknown keys are errors. TOML wants a digit on both sides of a decimal point: `1.0` and `0.5`, not `1.` and `.5`.
- **Limits**: an expression has at most 10000 letters and, with the functions that it calls, takes at most 100000
  operations; functions call functions at most 100 deep; parameters rest on each other at most 1000 deep; keys have at
  most 16 parts; texts have no control characters but newlines and tabs. Models that need more memory than there is and
  results that need more room than the disk has are refused before they are begun, with their sizes.

## Expressions

| | |
|---|---|
| operators, tightest first | `^`, sign, `* /`, `+ -`, `< <= > >= == !=`, `&&`, `\|\|`, `condition ? a : b` |
| functions | {functions} |
| names | `pi`, the parameters; in f(…) also its variables and the functions of the deck; where there is t, inputs |

A sign binds less than a power: `-2^2` is −4 and `2^-1` is 0.5; powers go from the right: `2^3^2` is 512. Comparisons
are 1 or 0. `log` is the natural logarithm; `min` and `max` take any number of arguments. An expression that would
assign (`t = 15 ? 1 : 2`), that lists values (`1,2`), compares in a row (`0 < t < 5`) or has no finite value is an
error. f(t) is evaluated at the steps of the analysis (at 10001 of them, if there are more) before the run begins,
f(t, s) at 101 points of the rod at 101 of the steps.

)md";

std::string describe_type(const KeySpec& key) {
    const ValueKind* kind = find_kind(key);
    if (kind == nullptr) return key.takes_one ? "table or list of tables" : "table";
    const bool has_table =
        key.table != nullptr &&
        (kind->nature == ValueNature::number || kind->nature == ValueNature::word || !key.refers_to.empty());
    return has_table ? kind->column(key) + " or table" : kind->column(key);
}

struct DefaultText {
    std::string operator()(std::monostate) const { return ""; }
    std::string operator()(double value) const { return fmt::format("`{}`", value); }
    std::string operator()(long value) const { return fmt::format("`{}`", value); }
    std::string operator()(const std::string& value) const { return fmt::format("`\"{}\"`", value); }
    std::string operator()(const Vec3& value) const {
        return fmt::format("`[{}, {}, {}]`", value[0], value[1], value[2]);
    }
};

std::string describe_default(const KeySpec& key) {
    if (key.presence == Presence::required) return "required";
    if (!key.default_text.empty()) return key.default_text;
    return std::visit(DefaultText{}, key.default_value);
}

// "For kind `dynamic`", "With `at`", or "".
std::string describe_uses(const std::vector<Condition>& only_for, const std::string& only_with) {
    std::vector<std::string> uses;
    for (const Condition& condition : only_for) {
        uses.push_back(condition.key + " " + code_list(condition.words));
    }
    if (!only_with.empty()) return "With `" + only_with + "`";
    return uses.empty() ? "" : fmt::format("For {}", fmt::join(uses, " and "));
}

std::string sentence_of(const KeySpec& key) {
    std::string sentence = key.sentence;
    const std::string uses = describe_uses(key.only_for, key.only_with);
    if (!uses.empty()) sentence += fmt::format(" {} only.", uses);
    if (nature_of(key) == ValueNature::word || nature_of(key) == ValueNature::integer) {
        if (!key.remark.empty()) sentence += " Note: " + key.remark + ".";
    }
    return sentence;
}

// Rows of the keys of a table; those of tables inside it as "line.from".
std::string write_rows(const TableSpec& table, const std::string& prefix) {
    std::string rows;
    for (const KeySpec& key : table.keys) {
        if (table.path.empty() && !is_top_level_value(table, key.name)) continue;
        rows += fmt::format("| `{}{}` | {} | {} | {} | {} | {} |\n",
                            prefix,
                            key.name,
                            describe_type(key),
                            key.dimension,
                            describe_range(key.range),
                            describe_default(key),
                            sentence_of(key));
        const bool has_table = key.shape == KeyShape::table || key.shape == KeyShape::value;
        if (has_table && key.table != nullptr) rows += write_rows(*key.table, prefix + key.name + ".");
        if (key.shape == KeyShape::named_tables && key.binding)
            rows += write_rows(*key.table, prefix + key.name + ".NAME.");
        if (key.shape == KeyShape::table_list)
            rows += write_rows(*key.table, prefix + key.name + (key.takes_one ? "." : "[]."));
    }
    return rows;
}

const char* describe_rule(GroupRule rule) {
    switch (rule) {
        case GroupRule::exactly_one:
            return "Exactly one of";
        case GroupRule::at_least_one:
            return "At least one of";
        case GroupRule::at_most_one:
            break;
    }
    return "At most one of";
}

std::string describe_group(const KeyGroup& group, const TableSpec& table) {
    std::vector<std::string> spellings;
    for (const std::string& key : group.keys) {
        spellings.push_back(spell(*table.find(key)));
    }
    const std::string uses = describe_uses(group.only_for, group.only_with);
    const std::string lead = uses.empty() ? "" : uses + ": ";
    return fmt::format("{}{} {}.\n\n", lead, describe_rule(group.rule), code_list(spellings));
}

std::string write_table(const TableSpec& table, const std::string& heading) {
    std::string text = fmt::format("## {}\n\n{}\n\n", heading, table.sentence);
    text += "| key | type | dimension | range | default | meaning |\n|---|---|---|---|---|---|\n";
    text += table.keys.empty() ? "| any name | number | | | | |\n\n" : write_rows(table, "") + "\n";
    for (const KeyGroup& group : table.groups) text += describe_group(group, table);
    return table.example.empty() ? text : text + "```toml\n" + table.example + "```\n\n";
}

}  // namespace

std::string deck_reference() {
    std::string text = introduction;
    const std::string mark = "{functions}";
    text.replace(text.find(mark), mark.size(), code_list(built_in_functions()));
    return text + table_reference(deck_schema());
}

std::string table_reference(const TableSpec& root) {
    std::string text = write_table(root, "Top level");
    for (const KeySpec& key : root.keys) {
        if (key.table != nullptr) text += write_table(*key.table, key.table->heading);
    }
    while (text.ends_with('\n')) text.pop_back();
    return text;
}

}  // namespace gxrod
