#pragma once

#include <Eigen/Core>
#include <random>

#include "rotation/rotation_map.hpp"

namespace gxrod::tools {

// Random numbers that are the same in every run.
class RandomValues {
  public:
    explicit RandomValues(unsigned seed) : generator_(seed) {}

    double number(double low, double high) {
        return std::uniform_real_distribution<double>(low, high)(generator_);
    }
    // Components within [−size, size].
    Vec3 vector(double size = 1.0) { return size * matrix<3, 1>(); }
    Vec3 direction() { return vector().normalized(); }
    // By up to 2.5 rad about any axis.
    Quat rotation() { return exp_quaternion(number(0.5, 2.5) * direction()); }
    // Entries within [−1, 1].
    template <int Rows, int Columns = Rows>
    Eigen::Matrix<double, Rows, Columns> matrix() {
        Eigen::Matrix<double, Rows, Columns> result;
        for (double& entry : result.reshaped()) entry = number(-1.0, 1.0);
        return result;
    }
    // Symmetric with eigenvalues of 0.5 and more.
    template <int Size>
    Eigen::Matrix<double, Size, Size> positive_definite() {
        const Eigen::Matrix<double, Size, Size> root = matrix<Size>();
        return root * root.transpose() + 0.5 * Eigen::Matrix<double, Size, Size>::Identity();
    }

  private:
    std::mt19937_64 generator_;
};

}  // namespace gxrod::tools
