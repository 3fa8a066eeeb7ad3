#include "numerics/rainflow.hpp"

#include <cmath>

namespace gxrod {

void RainflowCounter::add(double value) {
    if (!std::isfinite(value)) {
        is_finite_ = false;
        return;
    }
    const double rise = value - last_;
    // The first value is a point of its own; repeated values count once.
    if (has_value_ && rise == 0.0) return;
    if (has_value_ && (rise_ == 0.0 || (rise > 0.0) != (rise_ > 0.0))) turn_at(last_);
    if (has_value_) rise_ = rise;
    has_value_ = true;
    last_ = value;
}

void RainflowCounter::close(double a, double b, double count) {
    ended_.push_back({std::abs(b - a), 0.5 * (a + b), count});
}

void RainflowCounter::turn_at(double point) {
    open_.push_back(point);
    while (open_.size() >= 3) {
        const double a = open_[open_.size() - 3], b = open_[open_.size() - 2];
        if (std::abs(point - b) < std::abs(b - a)) return;
        const bool has_start = open_.size() == 3;
        close(a, b, has_start ? 0.5 : 1.0);
        open_.erase(open_.end() - 3, open_.end() - (has_start ? 2 : 1));
    }
}

std::vector<RangeCycle> RainflowCounter::cycles() const {
    RainflowCounter whole = *this;
    if (has_value_) whole.turn_at(last_);
    for (std::size_t i = 1; i < whole.open_.size(); ++i) whole.close(whole.open_[i - 1], whole.open_[i], 0.5);
    return whole.ended_;
}

}  // namespace gxrod
