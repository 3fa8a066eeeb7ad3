#pragma once

#include <Eigen/Geometry>
#include <xsimd/xsimd.hpp>

// Several doubles as one scalar of Eigen's matrices, so that a kernel for one element works on several.
//
// Only for sources that are compiled for one instruction set: their instantiations must carry that set in
// their names, or the linker could choose their copy of a function for every machine.
namespace Eigen {

template <class Arch>
struct NumTraits<xsimd::batch<double, Arch>> : NumTraits<double> {
    using Real = xsimd::batch<double, Arch>;
    using NonInteger = Real;
    using Nested = Real;
    using Literal = double;
    // NOLINTNEXTLINE(readability-identifier-naming): Eigen's names
    enum { RequireInitialization = 0, ReadCost = 1, AddCost = 1, MulCost = 1 };
};

}  // namespace Eigen

namespace gxrod {

// Returns the largest component in each lane.
template <class Real>
Real largest(const Eigen::Matrix<Real, 3, 1>& a) {
    return xsimd::max(xsimd::max(xsimd::abs(a[0]), xsimd::abs(a[1])), xsimd::abs(a[2]));
}

// Reads rows of quantities, each with an entry for each lane: quantity k of element l is at [k · width + l].
template <class Real>
class LaneReader {
  public:
    explicit LaneReader(const double* rows) : rows_(rows) {}

    Real scalar() {
        const Real value = Real::load_unaligned(rows_);
        rows_ += Real::size;
        return value;
    }
    Eigen::Matrix<Real, 3, 1> vector() {
        Eigen::Matrix<Real, 3, 1> value;
        for (int i = 0; i < 3; ++i) value[i] = scalar();
        return value;
    }
    Eigen::Matrix<Real, 3, 3> matrix() {
        Eigen::Matrix<Real, 3, 3> value;
        for (int i = 0; i < 9; ++i) value.data()[i] = scalar();
        return value;
    }
    Eigen::Quaternion<Real> quaternion() {
        Eigen::Quaternion<Real> value;
        for (int i = 0; i < 4; ++i) value.coeffs()[i] = scalar();
        return value;
    }

  private:
    const double* rows_;
};

// Writes rows of quantities.
template <class Real>
class LaneWriter {
  public:
    explicit LaneWriter(double* rows) : rows_(rows) {}

    void scalar(const Real& value) {
        value.store_unaligned(rows_);
        rows_ += Real::size;
    }
    template <class Derived>
    void matrix(const Eigen::MatrixBase<Derived>& value) {
        for (int j = 0; j < value.cols(); ++j) {
            for (int i = 0; i < value.rows(); ++i) scalar(value(i, j));
        }
    }

  private:
    double* rows_;
};

}  // namespace gxrod
