#include "batch/plan/faulty_plan.hpp"

#include <algorithm>
#include <deque>

#include "batch/cases/case_check.hpp"
#include "batch/cases/case_list.hpp"
#include "batch/collector.hpp"
#include "batch/plan/value_range.hpp"
#include "machine/file_error.hpp"

namespace gxrod {
namespace {

// Beyond so many cases only the first values are examined.
constexpr std::size_t most_cases = 100;

// A value within a distribution.
std::string pick_value(const Spread& spread) {
    return write_number(spread.kind == Spread::Kind::uniform ? spread.from : spread.mean);
}

// A plan that takes the values of all keys together, those of shorter lists again.
Plan make_simple(const Plan& plan) {
    Plan simple = plan;
    std::erase_if(simple.variations, [](const Variation& variation) {
        return variation.is_faulty || (variation.values.empty() && !variation.spread);
    });
    std::size_t count = 1;
    for (Variation& variation : simple.variations) {
        if (variation.spread) variation.values = {pick_value(*variation.spread)};
        variation.spread.reset();
        count = std::max(count, std::min(variation.values.size(), most_cases));
    }
    for (Variation& variation : simple.variations) {
        if (!variation.column) variation.values.resize(count, variation.values.back());
    }
    const bool is_table =
        !simple.variations.empty() && std::all_of(simple.variations.begin(),
                                                  simple.variations.end(),
                                                  [](const Variation& v) { return v.column.has_value(); });
    if (!is_table) std::erase_if(simple.variations, [](const Variation& v) { return v.column.has_value(); });
    simple.combination = is_table ? Combination::table : Combination::zip;
    return simple;
}

}  // namespace

std::vector<DeckFault> find_faults_of_cases(const Plan& plan) {
    const Plan simple = make_simple(plan);
    try {
        std::deque<DeckTemplate> decks;
        decks.emplace_back(simple.decks.front());
        if (simple.variations.empty()) {
            FaultList faults(simple.file, {});
            check_collections(simple.collections, decks.front().build({}), faults);
            return faults.list();
        }
        const CaseList cases(simple);
        const std::vector<MeshDigests> meshes(1);
        check_cases({simple, cases, decks, meshes, ""}, {1, cases.count()}, [](long) {});
    } catch (const DeckError& error) {
        return error.faults;
    } catch (const FileError&) {
        return {};
    }
    return {};
}

}  // namespace gxrod
