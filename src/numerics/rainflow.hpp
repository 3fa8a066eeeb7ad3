#pragma once

#include <vector>

namespace gxrod {

// Cycles of one range and mean: 1, or ½ for half a cycle.
struct RangeCycle {
    double range;  // maximum less minimum
    double mean;
    double count;
};

// Counts the cycles of a series of values by rainflow counting (ASTM E1049-85, 5.4.4), value by value. A
// range that contains the start of the series is half a cycle, and so is what is left at its end.
class RainflowCounter {
  public:
    void add(double value);

    // Returns the cycles of the values until now, in the order in which they end.
    std::vector<RangeCycle> cycles() const;
    // Returns whether all values were finite; others are not counted.
    bool is_finite() const { return is_finite_; }

  private:
    // Takes a point at which the series turns, or ends.
    void turn_at(double point);
    void close(double a, double b, double count);

    bool is_finite_ = true;
    bool has_value_ = false;
    double last_ = 0.0;
    double rise_ = 0.0;         // of the last two values that differ; 0 before that
    std::vector<double> open_;  // points whose ranges have not ended
    std::vector<RangeCycle> ended_;
};

}  // namespace gxrod
