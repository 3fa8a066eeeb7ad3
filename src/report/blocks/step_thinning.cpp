#include "report/blocks/step_thinning.hpp"

#include <algorithm>
#include <cmath>

namespace gxrod {

std::size_t StepThinning::count() const {
    if (keeps_all()) return steps_;
    return 2 + 2 * ((steps_ - 2 + group_ - 1) / group_);
}

std::vector<std::size_t> StepThinning::steps() const {
    std::vector<std::size_t> steps;
    if (keeps_all()) {
        for (std::size_t step = 0; step < steps_; ++step) steps.push_back(step);
        return steps;
    }
    steps.push_back(0);
    for (std::size_t first = 1; first + 1 < steps_; first += group_) {
        steps.push_back(first);
        steps.push_back(std::min(first + group_, steps_ - 1) - 1);
    }
    steps.push_back(steps_ - 1);
    return steps;
}

std::size_t StepThinning::group_for(std::size_t steps, std::size_t count) {
    if (steps <= count) return 1;
    const std::size_t pairs = std::max<std::size_t>(count, 4) / 2 - 1;
    return std::max<std::size_t>(3, (steps - 2 + pairs - 1) / pairs);
}

ColumnThinning::ColumnThinning(const StepThinning& thinning) : thinning_(thinning) {
    values_.reserve(thinning.count());
}

void ColumnThinning::add(double value) {
    const std::size_t step = step_++;
    if (thinning_.keeps_all() || step == 0 || step + 1 == thinning_.steps_) {
        if (in_group_ > 0) end_group();
        values_.push_back(static_cast<float>(value));
        return;
    }
    if (in_group_ == 0 || std::isnan(least_)) {
        least_ = largest_ = value;
        least_first_ = true;
    } else if (value < least_) {
        least_ = value;
        least_first_ = false;
    } else if (value > largest_) {
        largest_ = value;
        least_first_ = true;
    }
    if (++in_group_ == thinning_.group_) end_group();
}

void ColumnThinning::end_group() {
    values_.push_back(static_cast<float>(least_first_ ? least_ : largest_));
    values_.push_back(static_cast<float>(least_first_ ? largest_ : least_));
    in_group_ = 0;
}

}  // namespace gxrod
