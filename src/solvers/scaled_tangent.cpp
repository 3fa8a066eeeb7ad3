#include "solvers/scaled_tangent.hpp"

#include <algorithm>
#include <cmath>

namespace gxrod {

ScaledTangent::ScaledTangent(const System& system, const std::vector<double>& values)
    : pattern_(&system.pattern()), values_(values) {
    const auto scale = [&system](std::int64_t equation) {
        return system.equations().unknown(equation).component < 3 ? system.length_scale() : 1.0;
    };
    double longest = 0.0;
    for (std::int64_t j = 0; j < pattern_->size(); ++j) {
        double square = 0.0;
        for (std::int64_t k = pattern_->column_starts[j]; k < pattern_->column_starts[j + 1]; ++k) {
            values_[k] *= scale(pattern_->rows[k]) * scale(j);
            square += values_[k] * values_[k];
        }
        if (!std::isfinite(square)) is_finite_ = false;
        longest = std::max(longest, std::sqrt(square));
    }
    if (longest == 0.0) return;
    for (double& value : values_) value /= longest;
}

Eigen::VectorXd ScaledTangent::multiply(const Eigen::VectorXd& x) const {
    Eigen::VectorXd product = Eigen::VectorXd::Zero(x.size());
    for (std::int64_t j = 0; j < pattern_->size(); ++j) {
        for (std::int64_t k = pattern_->column_starts[j]; k < pattern_->column_starts[j + 1]; ++k) {
            product[pattern_->rows[k]] += values_[k] * x[j];
        }
    }
    return product;
}

std::vector<double> ScaledTangent::compute_transpose() const {
    std::vector<double> transpose(values_.size());
    for (std::int64_t j = 0; j < pattern_->size(); ++j) {
        for (std::int64_t k = pattern_->column_starts[j]; k < pattern_->column_starts[j + 1]; ++k) {
            transpose[pattern_->slot(j, pattern_->rows[k])] = values_[k];
        }
    }
    return transpose;
}

}  // namespace gxrod
