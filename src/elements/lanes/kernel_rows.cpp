#include "elements/lanes/kernel_rows.hpp"

#include <algorithm>
#include <cassert>

namespace gxrod {

namespace {

template <std::size_t count>
class RowWriter {
  public:
    void write(double value) { rows_[written_++] = value; }
    template <class Derived>
    void write(const Eigen::MatrixBase<Derived>& values) {
        for (int column = 0; column < values.cols(); ++column) {
            for (int row = 0; row < values.rows(); ++row) write(values(row, column));
        }
    }
    const std::array<double, count>& rows() const {
        assert(written_ == count);
        return rows_;
    }

  private:
    std::array<double, count> rows_;
    std::size_t written_ = 0;
};

}  // namespace

template <int Nodes>
std::array<double, RodKernels<Nodes>::shared_rows> make_shared_rows(const ObjectiveElement<Nodes>& element) {
    RowWriter<RodKernels<Nodes>::shared_rows> writer;
    writer.write(element.inertia().has_offset() ? 1.0 : 0.0);
    writer.write(element.interpolated_rod().section(0).kelvin_voigt);
    writer.write(element.inertia().section(0).mass_proportional);
    if constexpr (Nodes > 2) {
        const auto rule = compute_gauss_rule<Nodes - 1>();
        for (const QuadraturePoint& point : rule) writer.write(point.weight);
        for (const QuadraturePoint& point : rule) writer.write(compute_shape_functions<Nodes>(point.xi));
        for (const QuadraturePoint& point : rule) writer.write(compute_shape_slopes<Nodes>(point.xi));
    }
    return writer.rows();
}

template <int Nodes>
std::array<double, RodKernels<Nodes>::section_rows> make_section_rows(
    const ObjectiveElement<Nodes>& element) {
    RowWriter<RodKernels<Nodes>::section_rows> writer;
    for (int p = 0; p < Nodes - 1; ++p) {
        const Mat6& C = element.interpolated_rod().section(p).stiffness;
        writer.write(C.topLeftCorner<3, 3>());
        writer.write(C.topRightCorner<3, 3>());
        writer.write(C.bottomRightCorner<3, 3>());
    }
    for (int i = 0; i < Nodes; ++i) writer.write(element.inertia().section(i).centre_of_mass);
    return writer.rows();
}

template <int Nodes>
std::array<double, RodKernels<Nodes>::constant_rows> make_constant_rows(
    const ObjectiveElement<Nodes>& element) {
    RowWriter<RodKernels<Nodes>::constant_rows> writer;
    for (int p = 0; p < Nodes - 1; ++p) {
        const auto [jacobian, strain] = element.interpolated_rod().reference(p);
        writer.write(Nodes == 2 ? 2.0 * jacobian : jacobian);
        writer.write(strain.Gamma);
        writer.write(strain.Kappa);
    }
    for (const Quat& triad : element.triads()) writer.write(triad.coeffs());
    for (int i = 0; i < Nodes; ++i) {
        for (int j = i; j < Nodes; ++j) writer.write(element.inertia().mass()(i, j));
    }
    return writer.rows();
}

template std::array<double, RodKernels<2>::shared_rows> make_shared_rows(const ObjectiveElement<2>&);
template std::array<double, RodKernels<2>::section_rows> make_section_rows(const ObjectiveElement<2>&);
template std::array<double, RodKernels<2>::constant_rows> make_constant_rows(const ObjectiveElement<2>&);
template std::array<double, RodKernels<3>::shared_rows> make_shared_rows(const ObjectiveElement<3>&);
template std::array<double, RodKernels<3>::section_rows> make_section_rows(const ObjectiveElement<3>&);
template std::array<double, RodKernels<3>::constant_rows> make_constant_rows(const ObjectiveElement<3>&);
template std::array<double, RodKernels<4>::shared_rows> make_shared_rows(const ObjectiveElement<4>&);
template std::array<double, RodKernels<4>::section_rows> make_section_rows(const ObjectiveElement<4>&);
template std::array<double, RodKernels<4>::constant_rows> make_constant_rows(const ObjectiveElement<4>&);
template std::array<double, RodKernels<5>::shared_rows> make_shared_rows(const ObjectiveElement<5>&);
template std::array<double, RodKernels<5>::section_rows> make_section_rows(const ObjectiveElement<5>&);
template std::array<double, RodKernels<5>::constant_rows> make_constant_rows(const ObjectiveElement<5>&);

}  // namespace gxrod
