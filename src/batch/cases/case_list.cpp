#include "batch/cases/case_list.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "batch/plan/latin_hypercube.hpp"
#include "batch/plan/value_range.hpp"

namespace gxrod {
namespace {

long count_cases(const Plan& plan) {
    switch (plan.combination) {
        case Combination::decks:
            return static_cast<long>(plan.decks.size());
        case Combination::latin_hypercube:
            return plan.count;
        case Combination::grid: {
            long count = 1;
            for (const Variation& variation : plan.variations)
                count *= static_cast<long>(variation.values.size());
            return count;
        }
        case Combination::zip:
        case Combination::table:
            break;
    }
    return static_cast<long>(plan.variations.front().values.size());
}

// Text in quotes, as TOML has it, without them.
std::string show(const std::string& value) {
    if (value.size() < 2 || value.front() != '"') return value;
    try {
        const DeckNode tree = read_toml("v = " + value, "");
        const std::string* text = tree.table()->front().node.text();
        return text == nullptr ? value : *text;
    } catch (const DeckError&) {
        return value;
    }
}

}  // namespace

CaseList::CaseList(const Plan& plan) : plan_(plan), count_(count_cases(plan)) {
    if (plan.combination != Combination::latin_hypercube) return;
    for (const Variation& variation : plan.variations)
        probabilities_.push_back(draw_probabilities(variation.key, plan.seed, plan.count));
}

std::vector<std::string> CaseList::parameter_names() const {
    if (plan_.combination == Combination::decks) return {"deck"};
    std::vector<std::string> names;
    for (const Variation& variation : plan_.variations) names.push_back(variation.key);
    return names;
}

std::string CaseList::value(std::size_t index, long number) const {
    const Variation& variation = plan_.variations[index];
    auto position = static_cast<std::size_t>(number - 1);
    if (plan_.combination == Combination::grid) {
        for (std::size_t later = index + 1; later < plan_.variations.size(); ++later)
            position /= plan_.variations[later].values.size();
        position %= variation.values.size();
    } else if (plan_.combination == Combination::latin_hypercube) {
        const double probability = probabilities_[index][position];
        if (variation.spread) return write_number(quantile(*variation.spread, probability));
        const std::size_t size = variation.values.size();
        position = std::min(static_cast<std::size_t>(probability * static_cast<double>(size)), size - 1);
    }
    return variation.values[position];
}

std::vector<std::string> CaseList::parameters(long number) const {
    if (plan_.combination == Combination::decks) return {plan_.decks[deck(number)].string()};
    std::vector<std::string> shown;
    for (std::size_t i = 0; i < plan_.variations.size(); ++i) shown.push_back(show(value(i, number)));
    return shown;
}

std::vector<std::string> CaseList::overrides(long number) const {
    std::vector<std::string> overrides;
    for (std::size_t i = 0; i < plan_.variations.size(); ++i)
        overrides.push_back(plan_.variations[i].key + "=" + value(i, number));
    return overrides;
}

std::string CaseList::describe(long number) const {
    const std::vector<std::string> names = parameter_names();
    const std::vector<std::string> values = parameters(number);
    std::string text;
    for (std::size_t i = 0; i < names.size(); ++i)
        text += fmt::format("{}{} = {}", i == 0 ? "" : ", ", names[i], values[i]);
    return text;
}

std::size_t CaseList::deck(long number) const {
    return plan_.combination == Combination::decks ? static_cast<std::size_t>(number - 1) : 0;
}

}  // namespace gxrod
