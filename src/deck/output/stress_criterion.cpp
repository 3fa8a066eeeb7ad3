#include "deck/output/stress_criterion.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "cross_section/failure_criteria.hpp"
#include "deck/output/history_table.hpp"
#include "deck/output/output_table.hpp"
#include "deck/schema/schema_tables.hpp"
#include "deck/schema/suggestion.hpp"
#include "deck/schema/synonyms.hpp"
#include "watch/quantity_tables.hpp"

namespace gxrod {

void check_criterion(const TableHead& table,
                     const std::optional<std::string>& key,
                     const BuildContext& context) {
    if (!key || find_failure_criterion(*key) != nullptr) return;
    std::vector<std::string> known;
    for (const FailureCriterion& criterion : failure_criteria()) known.emplace_back(criterion.word);
    context.add_fault(
        table,
        key,
        fmt::format(
            "expected one of {}, found \"{}\"{}", quoted_list(known), *key, did_you_mean(*key, known)));
}

bool asks_for_stresses(const CheckedTable& deck) {
    if (records_stresses(deck)) return true;
    for (const HistoryKeys& table : tables_of<HistoryKeys>(deck, history_table())) {
        if (std::ranges::any_of(table.quantities.words, is_stress_quantity, &CheckedWord::word)) return true;
    }
    return false;
}

}  // namespace gxrod
