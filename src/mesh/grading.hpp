#pragma once

#include <utility>
#include <vector>

namespace gxrod {

// The grading of a rod's element lengths along it: a size h(x) at the fraction x of its length; only its
// ratios matter. Elements end at equal steps of the measure
//   m(x) = ∫₀ˣ dx/h  /  ∫₀¹ dx/h.
class Grading {
  public:
    // Makes elements of equal length.
    Grading() = default;
    // Takes fractions, from 0 to 1 and not falling, and sizes above 0: linear between them, with a jump at a
    // repeated fraction.
    explicit Grading(std::vector<std::pair<double, double>> sizes);

    bool is_even() const { return sizes_.empty(); }
    // Returns ∫₀¹ dx/h: how many elements there are if h is their length over that of the line.
    double count_steps() const { return sums_.back(); }
    // Returns m of a fraction, from 0 to 1.
    double measure(double fraction) const;
    // Returns the fraction at which m has a value.
    double fraction_at(double measure) const;

  private:
    std::vector<std::pair<double, double>> sizes_;
    std::vector<double> sums_;  // ∫ dx/h from the start to each size
};

}  // namespace gxrod
