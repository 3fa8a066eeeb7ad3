#include "check/motions/unsupported_motions.hpp"

#include <fmt/format.h>

#include "numerics/singular_values.hpp"
#include "rotation/rotation_map.hpp"
#include "rotation/vector_text.hpp"

namespace gxrod {
namespace {

// Singular values below this, relative to the largest, are zero; so are components of directions.
constexpr double round_off = 1e-9;
// A node this near to an axis, relative to the part's size, is on it.
constexpr double on_axis = 1e-9;

using Vectors = Eigen::Matrix<double, 3, Eigen::Dynamic>;

using Extent = PartExtent;

}  // namespace

PartExtent measure(const Model& model, const ModelPart& part) {
    Extent extent{Vec3::Zero(), 0.0};
    for (const int node : part.nodes) extent.centre += model.nodes[node].position;
    extent.centre /= static_cast<double>(part.nodes.size());
    for (const int node : part.nodes) {
        extent.size = std::max(extent.size, (model.nodes[node].position - extent.centre).norm());
    }
    if (extent.size == 0.0) extent.size = 1.0;
    return extent;
}

namespace {

std::vector<const Support*> find_supports(const Model& model, const ModelPart& part) {
    std::vector<bool> is_inside(model.nodes.size(), false);
    for (const int node : part.nodes) is_inside[node] = true;
    std::vector<const Support*> supports;
    for (const Support& support : model.supports) {
        if (is_inside[support.node]) supports.push_back(&support);
    }
    return supports;
}

}  // namespace

Eigen::MatrixXd build_support_rows(const Model& model, const ModelPart& part) {
    const Extent extent = measure(model, part);
    const std::vector<const Support*> supports = find_supports(model, part);
    Eigen::MatrixXd rows = Eigen::MatrixXd::Zero(6 + 6 * static_cast<Eigen::Index>(supports.size()), 6);
    Eigen::Index row = 0;
    for (int i = 0; i < 6; ++i) {
        if (model.plane && model.plane->holds(i)) rows(row++, i) = 1.0;
    }
    for (const Support* support : supports) {
        const Mat3 axes = support->axes.toRotationMatrix();
        const Vec3 arm = (model.nodes[support->node].position - extent.centre) / extent.size;
        for (int i = 0; i < 6; ++i) {
            if (!support->holds(i)) continue;
            const Vec3 axis = axes.col(i % 3);
            if (i < 3) {
                rows.row(row++) << axis.transpose(), arm.cross(axis).transpose();
            } else {
                rows.row(row++).tail<3>() = axis.transpose();
            }
        }
    }
    return rows.topRows(row);
}

namespace {

// Columns of length 1 whose product with the rows is zero.
Eigen::MatrixXd find_null_space(const Eigen::MatrixXd& rows) {
    if (rows.rows() == 0) return Eigen::MatrixXd::Identity(rows.cols(), rows.cols());
    const SingularValues svd = find_singular_values(rows.transpose());
    return svd.left.rightCols(rows.cols() - svd.rank(round_off));
}

// Combines columns of (direction; companion) so that the directions are as near to the global axes as can be,
// and of length 1: each holds one component that no other has. Columns whose direction is zero are left out;
// those that are given have length 1 or less.
Eigen::MatrixXd align(Eigen::MatrixXd columns) {
    Eigen::Index done = 0;
    std::array<bool, 3> is_used{};
    while (done < columns.cols()) {
        Eigen::Index pivot_row = -1;
        Eigen::Index pivot_column = -1;
        double largest = round_off;
        for (Eigen::Index row = 0; row < 3; ++row) {
            for (Eigen::Index column = done; column < columns.cols() && !is_used[row]; ++column) {
                if (std::abs(columns(row, column)) <= largest * (1.0 + round_off)) continue;
                largest = std::abs(columns(row, column));
                pivot_row = row;
                pivot_column = column;
            }
        }
        if (pivot_row < 0) break;
        columns.col(pivot_column).swap(columns.col(done));
        columns.col(done) /= columns(pivot_row, done);
        for (Eigen::Index column = 0; column < columns.cols(); ++column) {
            if (column != done) columns.col(column) -= columns(pivot_row, column) * columns.col(done);
        }
        is_used[static_cast<std::size_t>(pivot_row)] = true;
        ++done;
    }
    for (Eigen::Index column = 0; column < done; ++column) {
        columns.col(column) /= columns.col(column).head<3>().norm();
    }
    return columns.leftCols(done);
}

Vec3 clean(const Vec3& direction) {
    return direction.unaryExpr([](double x) { return std::abs(x) < round_off ? 0.0 : x; });
}

// The turn of the motion (ω; v about the centre), without the free translations.
UnsupportedMotion make_turn(const Eigen::Matrix<double, 6, 1>& motion,
                            const Vectors& translations,
                            const Extent& extent,
                            const Vec3& near) {
    UnsupportedMotion turn;
    turn.rotation = clean(motion.head<3>());
    const Vec3 velocity = motion.tail<3>();
    const double slide = velocity.dot(turn.rotation);
    if (std::abs(slide) > round_off * extent.size) turn.velocity = slide * turn.rotation;
    turn.has_place =
        (translations - turn.rotation * (turn.rotation.transpose() * translations)).norm() < round_off;
    const Vec3 on = extent.centre + turn.rotation.cross(velocity);
    turn.point = on + turn.rotation.dot(near - on) * turn.rotation;
    return turn;
}

// "x", "y", "z", or a vector.
std::string describe_direction(const Vec3& direction) {
    for (int i = 0; i < 3; ++i) {
        if (std::abs(std::abs(direction[i]) - 1.0) < round_off) return std::string(1, "xyz"[i]);
    }
    return in_parentheses(direction);
}

std::string describe_point(const Vec3& point, double size) {
    return in_parentheses(point, 6, round_off * size);
}

}  // namespace

std::vector<UnsupportedMotion> find_unsupported_motions(const Model& model,
                                                        const ModelPart& part,
                                                        const Eigen::MatrixXd& constraints) {
    const Extent extent = measure(model, part);
    const std::vector<const Support*> supports = find_supports(model, part);
    const Vectors translations = align(find_null_space(constraints.leftCols<3>()));
    std::vector<UnsupportedMotion> motions;
    for (Eigen::Index i = 0; i < translations.cols(); ++i) {
        motions.push_back({.velocity = clean(translations.col(i))});
    }

    // Turns: what is left of the free motions when translations are taken out.
    Eigen::MatrixXd turns = find_null_space(constraints);
    if (translations.cols() > 0) {
        const Vectors basis = find_singular_values(translations).left.leftCols(translations.cols());
        turns.topRows<3>() -= basis * (basis.transpose() * turns.topRows<3>()).eval();
    }
    Eigen::MatrixXd by_rotation(6, turns.cols());
    by_rotation << turns.bottomRows<3>(), extent.size * turns.topRows<3>();
    const Vec3 near = supports.empty() ? extent.centre : model.nodes[supports.front()->node].position;
    const Eigen::MatrixXd aligned = align(by_rotation);
    for (Eigen::Index i = 0; i < aligned.cols(); ++i) {
        motions.push_back(make_turn(aligned.col(i), translations, extent, near));
    }
    return motions;
}

std::vector<UnsupportedMotion> find_unsupported_motions(const Model& model, const ModelPart& part) {
    return find_unsupported_motions(model, part, build_support_rows(model, part));
}

bool is_twist(const Model& model, const ModelPart& part, const UnsupportedMotion& turn) {
    if (part.rods.size() != 1 || !turn.has_place || turn.rotation.isZero(0.0)) return false;
    const double size = measure(model, part).size;
    return std::all_of(part.nodes.begin(), part.nodes.end(), [&](int node) {
        return turn.rotation.cross(model.nodes[node].position - turn.point).norm() <= on_axis * size;
    });
}

std::string describe_unsupported_motion(const Model& model,
                                        const ModelPart& part,
                                        const UnsupportedMotion& motion) {
    if (motion.rotation.isZero(0.0)) return "move along " + describe_direction(motion.velocity);
    const double size = measure(model, part).size;
    const bool slides = !motion.velocity.isZero(0.0);
    if (!slides && is_twist(model, part, motion)) return "twist about its axis";
    std::string text = "turn about an axis along " + describe_direction(motion.rotation);
    if (motion.has_place) text += " through " + describe_point(motion.point, size);
    if (slides) text += fmt::format(" while it moves along it by {:.6g} per rad", motion.velocity.norm());
    return text;
}

}  // namespace gxrod
