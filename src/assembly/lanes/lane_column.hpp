#pragma once

#include "rotation/types.hpp"

namespace gxrod {

// Writes one lane of the rows of kernels (elements/lanes/kernels.hpp), from the first row on.
class LaneColumn {
  public:
    LaneColumn(double* rows, int lane, int width) : entry_(rows + lane), width_(width) {}

    void write(double value) {
        *entry_ = value;
        entry_ += width_;
    }
    void write(const Vec3& vector) { write_entries<3>(vector.data()); }
    void write(const Quat& quaternion) { write_entries<4>(quaternion.coeffs().data()); }
    void write(const Mat3& matrix) { write_entries<9>(matrix.data()); }

  private:
    template <int count>
    void write_entries(const double* entries) {
        for (int i = 0; i < count; ++i) write(entries[i]);
    }

    double* entry_;
    int width_;
};

}  // namespace gxrod
