#include "deck/places/axes.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>

namespace gxrod {
namespace {

// Errors of the entries of axes that are taken.
constexpr double nearly_orthonormal = 1e-6;

// What is wrong with rows that are to be axes, or "".
std::string explain_axes(const Mat3& rows) {
    const Mat3 products = rows * rows.transpose();
    static constexpr std::array<const char*, 3> names{"first", "second", "third"};
    for (int i = 0; i < 3; ++i) {
        if (std::abs(products(i, i) - 1.0) > 2.0 * nearly_orthonormal) {
            return fmt::format("the {} row has length {:.9g}", names[i], rows.row(i).norm());
        }
    }
    for (int i = 0; i < 3; ++i) {
        const int next = (i + 1) % 3;
        if (std::abs(products(i, next)) > nearly_orthonormal) {
            return fmt::format("the {} and {} row are not at right angles",
                               names[std::min(i, next)],
                               names[std::max(i, next)]);
        }
    }
    return rows.determinant() < 0.0 ? "the third row is opposite to first × second" : "";
}

}  // namespace

Quat find_axes(const TableHead& table, const std::optional<Mat3>& field, const BuildContext& context) {
    return field ? find_axes(table, &field, *field, context) : Quat::Identity();
}

Quat find_axes(const TableHead& table, const void* field, const Mat3& rows, const BuildContext& context) {
    const std::string reason = explain_axes(rows);
    if (reason.empty()) return Quat(Mat3(rows.transpose())).normalized();
    context.faults.add(
        table.place_of(field),
        table.path_of(field),
        "expected three rows of length 1 at right angles to each other, right-handed; " + reason);
    return Quat::Identity();
}

}  // namespace gxrod
