#pragma once

#include <cstddef>
#include <vector>

namespace gxrod {

// Thins columns with a value for each step without losing their extremes: keeps the first and the last step,
// and of each group of steps between them the least and the largest value, in order. Groups of less than
// three keep every step.
class StepThinning {
  public:
    StepThinning(std::size_t steps, std::size_t group) : steps_(steps), group_(group) {}

    bool keeps_all() const { return group_ < 3 || steps_ < 4; }
    std::size_t group() const { return keeps_all() ? 1 : group_; }
    // Counts the values that are left of a column.
    std::size_t count() const;
    // Lists the steps at which the values are drawn: the first and the last of each group.
    std::vector<std::size_t> steps() const;

    // Finds the size of a group that leaves at most `count` values of so many steps; 1 if all can stay.
    static std::size_t group_for(std::size_t steps, std::size_t count);

  private:
    friend class ColumnThinning;
    std::size_t steps_, group_;
};

// Thins one column as its values arrive. A NaN is left out if its group has a number.
class ColumnThinning {
  public:
    explicit ColumnThinning(const StepThinning& thinning);

    void add(double value);
    // Returns, after all steps, as many values as the thinning's count().
    const std::vector<float>& values() const { return values_; }

  private:
    void end_group();

    StepThinning thinning_;
    std::size_t step_ = 0;
    std::size_t in_group_ = 0;
    double least_ = 0.0, largest_ = 0.0;
    bool least_first_ = true;
    std::vector<float> values_;
};

}  // namespace gxrod
