#include "study/method_traits.hpp"

#include <algorithm>

#include "deck/output/sample_times.hpp"
#include "model/settings/scheme_card.hpp"

namespace gxrod {

namespace {

constexpr long most_samples = 2000;
constexpr long samples_of_adaptive = 1000;

}  // namespace

const AdaptiveSettings* adaptive_of(const AnalysisSettings& analysis) {
    const auto* dynamic = std::get_if<DynamicSettings>(&analysis);
    return dynamic != nullptr && dynamic->adaptive ? &*dynamic->adaptive : nullptr;
}

double order_of(const AnalysisSettings& analysis) {
    const auto* dynamic = std::get_if<DynamicSettings>(&analysis);
    if (dynamic == nullptr) return 1.0;
    const SchemeCard& card = card_of(dynamic->scheme);
    // Newmark's schemes of other gamma damp, and have order 1.
    return card.parameters == SchemeParameters::newmark && dynamic->gamma != 0.5 ? 1.0 : card.order;
}

int lowest_order_of(const Model& model) {
    int order = 4;
    for (const Rod& rod : model.rods) order = std::min(order, rod.order);
    return order;
}

bool has_elements_simo(const Model& model) {
    return std::any_of(
        model.rods.begin(), model.rods.end(), [](const Rod& rod) { return rod.kind == ElementKind::simo; });
}

std::vector<double> choose_times(const AnalysisSettings& analysis) {
    if (adaptive_of(analysis) == nullptr) return sample_times(analysis, most_samples);
    std::vector<double> times;
    const double end_time = std::get<DynamicSettings>(analysis).end_time;
    for (long i = 0; i <= samples_of_adaptive; ++i)
        times.push_back(end_time * (static_cast<double>(i) / static_cast<double>(samples_of_adaptive)));
    return times;
}

}  // namespace gxrod
