#include "loads/motion_load.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "numerics/kronrod_rule.hpp"
#include "rotation/rotation_map.hpp"

namespace gxrod {

namespace {

// The cube root of a double's round-off, where that of the difference and its truncation are about equal.
constexpr double share = 6e-6;

constexpr Eigen::Index first_of(std::size_t node) { return static_cast<Eigen::Index>(6 * node); }

// The derivative of a rotation vector by a spin that turns the rotation.
template <class Turn>
Mat3 differentiate_by_spin(const Turn& turn, const Vec3& here) {
    Mat3 derivative;
    for (Eigen::Index k = 0; k < 3; ++k) {
        const auto turned = [&](double angle) {
            return log_nearest(turn(Vec3(angle * Vec3::Unit(k))), here);
        };
        derivative.col(k) = (turned(share) - turned(-share)) / (2.0 * share);
    }
    return derivative;
}

// A point of an element: its share of the integral, and what nodes contribute there.
struct ElementPoint {
    double weight = 0.0;
    double arc_length = 0.0;
    std::array<double, most_element_nodes> shape{};
};

template <class Visit>
void visit_points(const LoadedElement& element, const Visit& visit) {
    const std::size_t nodes = element.nodes.size();
    const auto add_point = [&](double xi, double weight) {
        const ShapeValues shapes = element.shapes(xi);
        ElementPoint point{.shape = shapes.value};
        Vec3 tangent = Vec3::Zero();
        for (std::size_t i = 0; i < nodes; ++i) {
            point.arc_length += shapes.value[i] * element.arc_lengths[i];
            tangent += shapes.slope[i] * element.positions[i];
        }
        point.weight = weight * tangent.norm();
        visit(point);
    };
    for (const KronrodPoint& point : find_kronrod_rule(nodes)) {
        add_point(point.xi, point.weight);
        if (point.xi != 0.0) add_point(-point.xi, point.weight);
    }
}

// What the motions of the nodes make of a load at one point.
class LoadedPoint {
  public:
    LoadedPoint(const LoadedElement& element,
                const ElementPoint& point,
                const std::vector<NodeMotion>& motions)
        : element_(element), point_(point), motions_(motions) {
        for (std::size_t i = 0; i < element.nodes.size(); ++i) {
            const NodeMotion& node = motions[static_cast<std::size_t>(element.nodes[i])];
            const double part = point.shape[i];
            motion_.position += part * node.r;
            motion_.velocity += part * node.v;
            motion_.spin += part * node.omega;
            axes_ += part * find_axes(i);
        }
        if (element.load->by_motion.turns) motion_.rotation = log(interpolate(0, Vec3::Zero()));
    }

    const PointMotion& motion() const { return motion_; }
    const Mat3& axes() const { return axes_; }

    // The axes of node `i` in which the load is given.
    Mat3 find_axes(std::size_t i) const {
        if (element_.load->frame == Frame::spatial) return Mat3::Identity();
        const Quat& Lambda = motions_[static_cast<std::size_t>(element_.nodes[i])].Lambda;
        return (element_.load->frame == Frame::body ? Lambda * element_.triads[i] : Lambda)
            .toRotationMatrix();
    }

    // The derivative of the rotation vector by the spin of node `i`.
    Mat3 differentiate_rotation(std::size_t i) const {
        return differentiate_by_spin([&](const Vec3& spin) { return interpolate(i, spin); },
                                     motion_.rotation);
    }

  private:
    // The rotation, with `spin` in front of that of node `moved`.
    Quat interpolate(std::size_t moved, const Vec3& spin) const {
        const auto rotation_of = [&](std::size_t i) {
            const Quat& Lambda = motions_[static_cast<std::size_t>(element_.nodes[i])].Lambda;
            return i == moved ? Quat(exp_quaternion(spin) * Lambda) : Lambda;
        };
        const Quat first = rotation_of(0);
        Vec3 relative = Vec3::Zero();
        for (std::size_t i = 1; i < element_.nodes.size(); ++i)
            relative += point_.shape[i] * log(Quat(rotation_of(i) * first.conjugate()));
        return exp_quaternion(relative) * first;
    }

    const LoadedElement& element_;
    const ElementPoint& point_;
    const std::vector<NodeMotion>& motions_;
    PointMotion motion_;
    Mat3 axes_ = Mat3::Zero();
};

Vec6 turn(const Mat3& axes, const Vec6& value) {
    Vec6 turned;
    turned << axes * value.head<3>(), axes * value.tail<3>();
    return turned;
}

}  // namespace

MotionDerivative differentiate(const MotionLoad& load,
                               double time,
                               double arc_length,
                               const PointMotion& motion,
                               const NodeLinearization& linearization,
                               double length) {
    constexpr double share_at_rest = 0.1;
    const double speed = share_at_rest * std::abs(linearization.rate);
    MotionDerivative derivative = MotionDerivative::Zero();
    const auto differentiate_by = [&](Vec3 PointMotion::*member, Eigen::Index first, double size) {
        const double step = share * std::max((motion.*member).norm(), size);
        if (step == 0.0) return;
        for (Eigen::Index i = 0; i < 3; ++i) {
            PointMotion more = motion, less = motion;
            (more.*member)[i] += step;
            (less.*member)[i] -= step;
            derivative.col(first + i) = (1.0 / (2.0 * step)) * (load.value(time, arc_length, more) -
                                                                load.value(time, arc_length, less));
        }
    };
    if (linearization.placement != 0.0) {
        differentiate_by(&PointMotion::position, 0, length);
        if (load.turns) differentiate_by(&PointMotion::rotation, 6, 1.0);
    }
    if (linearization.rate != 0.0) {
        differentiate_by(&PointMotion::velocity, 3, speed * length);
        if (load.turns) differentiate_by(&PointMotion::spin, 9, speed);
    }
    return derivative;
}

PointMotion find_point_motion(const NodeMotion& motion) {
    return {motion.r, motion.v, log(motion.Lambda), motion.omega};
}

Mat3 differentiate_rotation_vector(const Quat& Lambda) {
    return differentiate_by_spin([&](const Vec3& spin) { return Quat(exp_quaternion(spin) * Lambda); },
                                 log(Lambda));
}

LoadVector compute_motion_load(const LoadedElement& element,
                               double time,
                               const std::vector<NodeMotion>& motions) {
    const std::size_t nodes = element.nodes.size();
    LoadVector force = LoadVector::Zero(first_of(nodes));
    visit_points(element, [&](const ElementPoint& point) {
        const LoadedPoint loaded(element, point, motions);
        const Vec6 q =
            turn(loaded.axes(), element.load->by_motion.value(time, point.arc_length, loaded.motion()));
        for (std::size_t i = 0; i < nodes; ++i)
            force.segment<6>(first_of(i)) += point.weight * point.shape[i] * q;
    });
    return force;
}

LoadMatrix compute_motion_load_tangent(const LoadedElement& element,
                                       double time,
                                       const std::vector<NodeMotion>& motions,
                                       const std::vector<NodeLinearization>& linearizations,
                                       double length) {
    const std::size_t nodes = element.nodes.size();
    const MotionLoad& load = element.load->by_motion;
    LoadMatrix tangent = LoadMatrix::Zero(first_of(nodes), first_of(nodes));
    visit_points(element, [&](const ElementPoint& point) {
        const LoadedPoint loaded(element, point, motions);
        const NodeLinearization& first = linearizations[static_cast<std::size_t>(element.nodes[0])];
        MotionDerivative by = differentiate(load, time, point.arc_length, loaded.motion(), first, length);
        for (Eigen::Index k = 0; k < by.cols(); ++k) by.col(k) = turn(loaded.axes(), by.col(k));
        const Vec6 q = element.load->frame == Frame::spatial
                           ? Vec6(Vec6::Zero())
                           : load.value(time, point.arc_length, loaded.motion());
        for (std::size_t j = 0; j < nodes; ++j) {
            const NodeLinearization& own = linearizations[static_cast<std::size_t>(element.nodes[j])];
            Mat6 columns = Mat6::Zero();
            const double part = point.shape[j];
            columns.leftCols<3>() =
                part * (own.placement * by.leftCols<3>() + own.rate * by.middleCols<3>(3));
            if (load.turns) {
                columns.rightCols<3>() =
                    own.placement * by.middleCols<3>(6) * loaded.differentiate_rotation(j) +
                    part * by.rightCols<3>() * own.d_omega;
            }
            if (element.load->frame != Frame::spatial) {
                const Vec6 turned = turn(loaded.find_axes(j), q);
                columns.topRightCorner<3, 3>() -= own.placement * part * spin(turned.head<3>());
                columns.bottomRightCorner<3, 3>() -= own.placement * part * spin(turned.tail<3>());
            }
            for (std::size_t i = 0; i < nodes; ++i)
                tangent.block<6, 6>(first_of(i), first_of(j)) += point.weight * point.shape[i] * columns;
        }
    });
    return tangent;
}

}  // namespace gxrod
