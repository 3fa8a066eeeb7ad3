#include "deck/loads/combinations.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <set>

#include "deck/drives/chamber_table.hpp"
#include "deck/loads/acting.hpp"
#include "deck/loads/case_factors.hpp"
#include "deck/rods/imperfections.hpp"
#include "deck/schema/schema_tables.hpp"
#include "deck/schema/suggestion.hpp"
#include "deck/schema/top_level.hpp"
#include "deck/surroundings/surroundings_tables.hpp"

namespace gxrod {

std::string Kind<CaseFactors>::schema(const KeySpec&) {
    return fmt::format(
        R"({{"type": "object", "patternProperties": {{"^[A-Za-z0-9_-]+$": {}}}, "additionalProperties": false}})",
        any_number_schema);
}

std::optional<CaseFactors> Kind<CaseFactors>::read(const ValueSource& from) {
    if (from.node.table() == nullptr) {
        from.context.faults.add(
            from.node.place,
            from.path,
            fmt::format("expected {}, found {}", words(from.key), describe_found(from.node)));
        return std::nullopt;
    }
    std::optional<StageFunctions> named = Kind<StageFunctions>::read(from);
    if (!named) return std::nullopt;
    for (const CheckedNamedFunction& one : *named) {
        if (one.value.function.is_constant()) continue;
        from.context.faults.add(one.value.place,
                                one.value.path,
                                "a factor of a load case is a number; `factor` of a load can change with t");
        return std::nullopt;
    }
    return CaseFactors{std::move(*named)};
}

namespace {

struct CombinationTable : TableHead {
    CaseFactors factors;
};

std::vector<std::reference_wrapper<const CombinationTable>> combinations_of(const CheckedTable& deck) {
    return tables_of<CombinationTable>(deck, combination_table());
}

// The combination that acts: the one that the deck chooses, or the first one; nullptr without any.
const CombinationTable* find_acting_combination(const BuildContext& context) {
    const auto all = combinations_of(context.deck);
    const std::optional<std::string>& chosen = top_level_of(context.deck).apply;
    for (const CombinationTable& one : all) {
        if (!chosen || one.name == *chosen) return &one;
    }
    return nullptr;
}

const CheckedNamedFunction* find_case_entry(const CombinationTable& combination, const std::string& name) {
    const auto found = std::ranges::find(combination.factors.named, name, &CheckedNamedFunction::name);
    return found == combination.factors.named.end() ? nullptr : &*found;
}

bool names_case(const std::string& load_case, const BuildContext& context) {
    return std::ranges::any_of(combinations_of(context.deck), [&](const CombinationTable& one) {
        return find_case_entry(one, load_case) != nullptr;
    });
}

// The cases of loads, and how many loads have none.
struct ListedCases {
    std::set<std::string> names;
    std::vector<std::string> without;
};

ListedCases list_cases(const BuildContext& context) {
    ListedCases cases;
    const auto add = [&](const ActingTable& table) {
        if (table.load_case)
            cases.names.insert(*table.load_case);
        else
            cases.without.push_back(table.path);
    };
    for (const TableSpec* spec : {&load_table(),
                                  &actuation_table(),
                                  &tendon_table(),
                                  &chamber_table(),
                                  &magnetic_table(),
                                  &wave_table()}) {
        for (const ActingTable& table : tables_of<ActingTable>(context.deck, *spec)) add(table);
    }
    for (const FluidTable& fluid : tables_of<FluidTable>(context.deck, fluid_table())) {
        if (fluid.current) add(*fluid.current);
    }
    for (const AirTable& air : tables_of<AirTable>(context.deck, air_table())) {
        if (air.wind) add(*air.wind);
    }
    for (const std::string& name : list_imperfection_cases(context.deck)) cases.names.insert(name);
    return cases;
}

void check_factors(const CombinationTable& table, const ListedCases& cases, const BuildContext& context) {
    for (const CheckedNamedFunction& one : table.factors.named) {
        if (cases.names.contains(one.name)) continue;
        if (one.name == gravity_case) {
            if (!top_level_of(context.deck).gravity)
                context.faults.add(one.value.place, one.value.path, "the deck has no gravity");
            continue;
        }
        if (!context.faults.empty()) continue;  // the load that has it may be at fault itself
        const std::vector<std::string> known(cases.names.begin(), cases.names.end());
        const std::string hint = did_you_mean(one.name, known);
        const std::string list =
            known.empty() ? "; nothing has the key `case`" : "; there is " + plain_list(known);
        context.faults.add(
            one.value.place,
            one.value.path,
            fmt::format("no load has the case \"{}\"{}", one.name, hint.empty() ? list : hint));
    }
}

// Faults of the key `apply`.
void check_choice(const BuildContext& context) {
    const TopLevelTable& top = top_level_of(context.deck);
    if (!top.apply) return;
    std::vector<std::string> names;
    for (const CombinationTable& one : combinations_of(context.deck)) names.push_back(one.name);
    if (std::ranges::find(names, *top.apply) != names.end()) return;
    const std::string hint = did_you_mean(*top.apply, names);
    const std::string list =
        names.empty() ? "; the deck has no [combination.NAME]" : "; the deck has " + plain_list(names);
    context.add_fault(
        top, top.apply, fmt::format("no combination \"{}\"{}", *top.apply, hint.empty() ? list : hint));
}

void note_combinations(const ListedCases& cases, BuildContext& context) {
    const auto all = combinations_of(context.deck);
    if (!top_level_of(context.deck).apply && all.size() > 1)
        context.notes.push_back(
            fmt::format("combination.{} acts, the first of {}; apply = \"NAME\" takes another one, and gxrod "
                        "batch runs them all",
                        all.front().get().name,
                        all.size()));
    std::vector<std::string> always = cases.without;
    if (top_level_of(context.deck).gravity && !names_case(gravity_case, context)) always.push_back("gravity");
    if (!always.empty())
        context.notes.push_back(
            fmt::format("{} act{} as written in every combination: no case of {} is named",
                        plain_list(always),
                        always.size() == 1 ? "s" : "",
                        always.size() == 1 ? "its" : "theirs"));
    for (const std::string& name : cases.names) {
        if (!names_case(name, context))
            context.notes.push_back(fmt::format("case \"{}\" is in no combination, so it never acts", name));
    }
}

}  // namespace

const TableSpec& combination_table() {
    using T = CombinationTable;
    // clang-format off
    static const TableSpec table = Table<T>("[combination.NAME]",
            "A combination of load cases. One acts in a run, the first one or that of `apply`; gxrod batch DECK runs "
            "each and makes a table of the forces along members.")
        .key("factors", &T::factors, "By which the loads of each case are multiplied; cases that are not named do not "
             "act. gravity is the case of gravity, which acts in all combinations as written if none names it, as "
             "loads without a case do.")
            .required().unit("1").also("factor cases case")
        .shown_by(
            "[combination.ULS1]\n"
            "factors = { gravity = 1.35, pull = 1.5 }\n");
    // clang-format on
    return table;
}

double find_case_factor(const std::optional<std::string>& load_case, const BuildContext& context) {
    const CombinationTable* acting = find_acting_combination(context);
    if (!load_case || acting == nullptr) return 1.0;
    const CheckedNamedFunction* factor = find_case_entry(*acting, *load_case);
    return factor == nullptr ? 0.0 : factor->value.function(0.0);
}

void refuse_case_factor(const ActingTable& table, const std::string& what, const BuildContext& context) {
    const double factor = find_case_factor(table.load_case, context);
    if (factor == 0.0 || factor == 1.0 || context.stage > 0) return;
    context.add_fault(
        table,
        table.load_case,
        fmt::format("has the factor {:.6g} in the combination that acts, and {} is not proportional to "
                    "anything: it goes with the square of velocities; expected the factor 1 or 0, and {} "
                    "with the numbers of the design",
                    factor,
                    what,
                    table.path));
}

double find_gravity_factor(const BuildContext& context) {
    return names_case(gravity_case, context) ? find_case_factor(gravity_case, context) : 1.0;
}

void check_combinations(BuildContext& context) {
    check_choice(context);
    const auto all = combinations_of(context.deck);
    if (all.empty()) return;
    const ListedCases cases = list_cases(context);
    for (const CombinationTable& table : all) check_factors(table, cases, context);
    note_combinations(cases, context);
}

}  // namespace gxrod
