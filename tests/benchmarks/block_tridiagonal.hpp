#pragma once

#include <Eigen/Dense>
#include <vector>

namespace gxrod::speed {

// The yardstick of whole runs: a system of 6 × 6 blocks, each coupled to the one before and after, factorized
// and solved with Eigen's PartialPivLU, as anybody would write it.
class BlockTridiagonal {
  public:
    explicit BlockTridiagonal(int blocks);

    // The first unknown.
    double factorize_and_solve();
    // Microseconds per block, the least of a few.
    static double measure(int blocks);

  private:
    using Block = Eigen::Matrix<double, 6, 6>;
    using Vector = Eigen::Matrix<double, 6, 1>;

    std::vector<Block> diagonal_, above_, below_, eliminated_;
    std::vector<Vector> load_, solution_;
    std::vector<Eigen::PartialPivLU<Block>> factors_;
};

}  // namespace gxrod::speed
