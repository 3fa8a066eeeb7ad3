#include "deck/output/stress_checks.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <vector>

#include "cross_section/failure_criteria.hpp"
#include "deck/schema/suggestion.hpp"

namespace gxrod {
namespace {

using Materials = std::span<const ElasticMaterial>;

// "steel", "carbon, foam": names of the materials that are meant, each once.
template <class Predicate>
std::vector<std::string> list_names(Materials materials, const Predicate& is_meant) {
    std::vector<std::string> names;
    for (const ElasticMaterial& one : materials) {
        if (is_meant(one) && std::ranges::find(names, one.name) == names.end()) names.push_back(one.name);
    }
    return names;
}

// "; give it, or take "von-mises"", of the criteria for which some material has what they need.
std::string suggest_criterion(Materials materials) {
    std::vector<std::string> words;
    for (const FailureCriterion& one : failure_criteria()) {
        if (std::ranges::any_of(materials, one.applies_to)) words.emplace_back(one.word);
    }
    return words.empty() ? "; give it" : "; give it, or take " + quoted_list(words);
}

const char* has_or_have(const std::vector<std::string>& names) { return names.size() == 1 ? "has" : "have"; }

void add_note(std::string note, const BuildContext& context) {
    if (std::ranges::find(context.notes, note) == context.notes.end())
        context.notes.push_back(std::move(note));
}

}  // namespace

void check_materials_of(std::string_view word,
                        std::span<const ElasticMaterial> materials,
                        const Place& place,
                        const std::string& path,
                        const BuildContext& context) {
    const FailureCriterion* wanted = find_failure_criterion(word);
    if (wanted == nullptr) return;  // another fault
    if (std::ranges::any_of(materials, wanted->applies_to))
        return note_other_criteria(word, materials, path, context);
    const std::vector<std::string> names = list_names(materials, [](const auto&) { return true; });
    context.faults.add(place,
                       path,
                       fmt::format("\"{}\" needs the {} of a material, and {} {} none{}",
                                   word,
                                   wanted->needs,
                                   plain_list(names),
                                   has_or_have(names),
                                   suggest_criterion(materials)));
}

void note_other_criteria(std::string_view word,
                         std::span<const ElasticMaterial> materials,
                         const std::string& path,
                         const BuildContext& context) {
    const FailureCriterion* wanted = find_failure_criterion(word);
    const auto chosen = [&](const ElasticMaterial& one) { return choose_failure_criterion(wanted, one); };
    const std::vector<std::string> by_yield = list_names(materials, [&](const ElasticMaterial& one) {
        return chosen(one) != nullptr && chosen(one) != wanted;
    });
    const std::vector<std::string> by_none =
        list_names(materials, [&](const ElasticMaterial& one) { return chosen(one) == nullptr; });
    if (!by_yield.empty())
        add_note(fmt::format("{}: {} {} no {}: exposure there is by \"{}\"",
                             path,
                             plain_list(by_yield),
                             has_or_have(by_yield),
                             wanted->needs,
                             failure_criteria().front().word),
                 context);
    if (!by_none.empty())
        add_note(
            fmt::format("{}: {} {} no {}: no exposure there",
                        path,
                        plain_list(by_none),
                        has_or_have(by_none),
                        wanted->needs == failure_criteria().front().needs
                            ? std::string(wanted->needs)
                            : fmt::format("{} and no {}", wanted->needs, failure_criteria().front().needs)),
            context);
}

void check_section_point(const PlanePoint& point,
                         const CrossSection& shape,
                         const Place& place,
                         const std::string& path,
                         const BuildContext& context) {
    // Over the largest extent of the section.
    constexpr double noted = 0.01, refused = 0.1;
    PlanePoint low = shape.stresses.points.front().at, high = low, nearest = low;
    for (const StressPoint& one : shape.stresses.points) {
        low = low.cwiseMin(one.at);
        high = high.cwiseMax(one.at);
        if ((one.at - point).norm() < (nearest - point).norm()) nearest = one.at;
    }
    const double distance = (nearest - point).norm(), extent = (high - low).maxCoeff();
    if (distance <= noted * extent) return;
    const std::string found =
        fmt::format("({:.4g}, {:.4g}), {:.3g} away", nearest.x(), nearest.y(), distance);
    if (distance <= refused * extent)
        return add_note(
            fmt::format("{}: stresses are those of the nearest point of {}, {}", path, shape.source, found),
            context);
    context.faults.add(place,
                       path,
                       fmt::format("({:.6g}, {:.6g}) is not in {}; its nearest point is {}",
                                   point.x(),
                                   point.y(),
                                   shape.source,
                                   found));
}

}  // namespace gxrod
