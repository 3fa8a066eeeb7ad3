#pragma once

#include <cstdint>

namespace gxrod {

// A generator of pseudorandom numbers that are the same on every machine: splitmix64 (G. L. Steele Jr., D.
// Lea, C. H. Flood, Fast splittable pseudorandom number generators, 2014).
class Splitmix64 {
  public:
    explicit Splitmix64(std::uint64_t seed) : state_(seed) {}

    std::uint64_t next() {
        state_ += 0x9E3779B97F4A7C15U;
        std::uint64_t z = state_;
        z = (z ^ (z >> 30U)) * 0xBF58476D1CE4E5B9U;
        z = (z ^ (z >> 27U)) * 0x94D049BB133111EBU;
        return z ^ (z >> 31U);
    }
    // Returns a fraction of 53 bits, 0 included, 1 not.
    double next_fraction() { return static_cast<double>(next() >> 11U) * 0x1p-53; }

  private:
    std::uint64_t state_;
};

}  // namespace gxrod
