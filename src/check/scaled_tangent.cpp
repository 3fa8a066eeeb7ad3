#include "check/scaled_tangent.hpp"

#include <algorithm>
#include <cmath>

namespace gxrod {

ScaledTangent::ScaledTangent(const System& system,
                             const SparsePattern& pattern,
                             const std::vector<double>& values)
    : pattern_(&pattern), values_(values) {
    const auto scale = [&system](std::int64_t equation) {
        const EquationNumbers::Unknown unknown = system.equations().unknown(equation);
        const bool is_length = unknown.attached >= 0
                                   ? system.joints().is_length(unknown.attached, unknown.place)
                                   : unknown.component < 3;
        return is_length ? system.length_scale() : 1.0;
    };
    double longest = 0.0;
    for (std::int64_t j = 0; j < pattern_->size(); ++j) {
        double square = 0.0;
        pattern_->visit_column(j, [&](std::int64_t i, std::int64_t slot) {
            values_[slot] *= scale(i) * scale(j);
            square += values_[slot] * values_[slot];
        });
        if (!std::isfinite(square)) is_finite_ = false;
        longest = std::max(longest, std::sqrt(square));
    }
    if (longest == 0.0) return;
    for (double& value : values_) value /= longest;
}

Eigen::VectorXd ScaledTangent::multiply(const Eigen::VectorXd& x) const {
    Eigen::VectorXd product = Eigen::VectorXd::Zero(x.size());
    pattern_->visit_entries(
        [&](std::int64_t i, std::int64_t j, std::int64_t slot) { product[i] += values_[slot] * x[j]; });
    return product;
}

std::vector<double> ScaledTangent::compute_transpose() const {
    std::vector<double> transpose(values_.size());
    pattern_->visit_entries([&](std::int64_t i, std::int64_t j, std::int64_t slot) {
        transpose[pattern_->slot(j, i)] = values_[slot];
    });
    return transpose;
}

}  // namespace gxrod
