#include "laws/viscoelastic_law.hpp"

#include <algorithm>
#include <cmath>

// Numbers of equations: docs/theory/laws.md.
namespace gxrod {
namespace {

constexpr double series_end = 0.5;  // where the closed form of (L16) has lost two digits
constexpr int series_terms = 20;    // the last one is below 1e-18 of the first there

// What a branch keeps and gains over a step of x relaxation times, x infinite included: (L13) and (L16).
struct StepFactors {
    double kept, gained;        // e⁻ˣ, (1 − e⁻ˣ)/x
    double own, mixed, driven;  // of the dissipation
};

// (x − (1 − e⁻ˣ)(3 − e⁻ˣ)/2)/x², without cancellation: Σ (−1)ⁿ⁺¹ (2ⁿ⁻¹ − 2)/n! xⁿ⁻², n ≥ 3.
double sum_driven(double x) {
    double term = 0.5;  // (−1)ⁿ⁺¹ xⁿ⁻²/n!, negative at n = 2
    double power = 2.0;
    double sum = 0.0;
    for (int n = 3; n < 3 + series_terms; ++n) {
        term *= -x / n;
        power *= 2.0;
        sum -= (power - 2.0) * term;
    }
    return sum;
}

StepFactors compute_factors(double x) {
    if (x == 0.0) return {1.0, 1.0, 0.0, 0.0, 0.0};
    const double lost = -std::expm1(-x);
    const double kept = std::exp(-x);
    const double driven = x < series_end ? sum_driven(x) : (1.0 - lost * (2.0 + lost) / (2.0 * x)) / x;
    return {kept, lost / x, -0.5 * std::expm1(-2.0 * x), lost * (lost / x), driven};
}

Mat6 restrict_to(const Mat6& C, const std::vector<StrainPart>& on) {
    if (on.empty()) return C;
    Vec6 is_on = Vec6::Zero();
    for (const StrainPart part : on) {
        for (const int i : entries_of(part).list()) is_on[i] = 1.0;
    }
    return is_on.asDiagonal() * C * is_on.asDiagonal();
}

}  // namespace

ViscoelasticLaw::ViscoelasticLaw(const Mat6& C,
                                 std::vector<PronyBranch> branches,
                                 const std::vector<StrainPart>& on)
    : stiffness_(C), relaxing_(restrict_to(C, on)), branches_(std::move(branches)) {}

SectionResponse ViscoelasticLaw::respond(const Vec6& strain,
                                         std::span<const double> memory,
                                         double elapsed,
                                         std::span<double> after) const {
    const Vec6 change = strain - Vec6(memory.data());
    Vec6 sum = Vec6::Zero();  // Σ r u
    double gained = 0.0;
    SectionResponse response;
    if (!after.empty()) std::ranges::copy(strain, after.begin());
    for (std::size_t i = 0; i < branches_.size(); ++i) {
        const auto& [ratio, time] = branches_[i];
        const StepFactors factors = compute_factors(elapsed / time);
        const Vec6 before(&memory[6 * (i + 1)]);
        const Vec6 now = factors.kept * before + factors.gained * change;
        const Vec6 driving = relaxing_ * change;
        sum += ratio * now;
        gained += ratio * factors.gained;
        response.stored += 0.5 * ratio * now.dot(relaxing_ * now);
        response.dissipated +=
            ratio * (factors.own * before.dot(relaxing_ * before) + factors.mixed * before.dot(driving) +
                     factors.driven * change.dot(driving));
        if (!after.empty()) std::ranges::copy(now, after.begin() + 6 * static_cast<std::ptrdiff_t>(i + 1));
    }
    const Vec6 relaxed = stiffness_ * strain;
    response.resultants = relaxed + relaxing_ * sum;
    response.tangent = stiffness_ + gained * relaxing_;
    response.stored += 0.5 * strain.dot(relaxed);
    response.dissipated = std::max(response.dissipated, 0.0);  // of round-off
    return response;
}

// (L27)
std::vector<RelaxingStiffness> ViscoelasticLaw::relaxing_stiffness() const {
    std::vector<RelaxingStiffness> list;
    for (const auto& [ratio, time] : branches_) {
        const auto same = [&](const RelaxingStiffness& one) { return one.time == time; };
        auto found = std::ranges::find_if(list, same);
        if (found == list.end()) found = list.insert(list.end(), {time, Mat6::Zero()});
        found->stiffness += ratio * relaxing_;
    }
    return list;
}

}  // namespace gxrod
