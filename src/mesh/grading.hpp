#pragma once

#include <utility>
#include <vector>

namespace gxrod {

// How the lengths of a rod's elements follow each other along it: by a size h(x) at the fraction x of its
// length, of which only the ratios count. Elements end at equal steps of the measure
//   m(x) = ∫₀ˣ dx/h  /  ∫₀¹ dx/h.
class Grading {
  public:
    // Elements of equal length.
    Grading() = default;
    // Fractions, from 0 to 1 and not falling, and sizes above 0: linear between them, with a jump where a
    // fraction stands twice.
    explicit Grading(std::vector<std::pair<double, double>> sizes);

    bool is_even() const { return sizes_.empty(); }
    // m of a fraction, from 0 to 1.
    double measure(double fraction) const;
    // The fraction at which m has a value.
    double fraction_at(double measure) const;

  private:
    std::vector<std::pair<double, double>> sizes_;
    std::vector<double> sums_;  // ∫ dx/h from the start to each of them
};

}  // namespace gxrod
