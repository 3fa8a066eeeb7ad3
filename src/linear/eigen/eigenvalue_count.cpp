#include "linear/eigen/eigenvalue_count.hpp"

#include "linear/eigen/pencil.hpp"

namespace gxrod {

std::int64_t EigenvalueCount::factorize(const std::vector<double>& a,
                                        double factor,
                                        const std::vector<double>& b) {
    values_ = combine(a, factor, b);
    const std::int64_t negative = solver_->factorize(values_).negative_pivots;
    return negative < 0 ? negative : negative - multipliers_;
}

std::int64_t EigenvalueCount::count(const std::vector<double>& a,
                                    double factor,
                                    const std::vector<double>& b) {
    for (const double nudge : {0.0, 1e-9, -1e-9, 1e-8}) {
        const std::int64_t negative = factorize(a, factor * (1.0 + nudge), b);
        if (negative >= 0) return negative;
    }
    return -1;
}

}  // namespace gxrod
