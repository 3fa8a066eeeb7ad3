#include "constraints/joints/sleeve_turn.hpp"

#include <Eigen/Geometry>
#include <Eigen/LU>

#include "constraints/joints/pull_back.hpp"
#include "rotation/cross_products.hpp"

namespace gxrod {

SleeveTurn::Carrier carry_axes(const NodeMotion* motion, const Mat3& axes) {
    SleeveTurn::Carrier carrier{motion, {}};
    for (int j = 0; j < 3; ++j) {
        VectorJet& axis = carrier.axes[static_cast<std::size_t>(j)];
        axis = {axes.col(j), Vec3::Zero(), Vec3::Zero()};
        if (motion == nullptr) continue;
        axis.value = motion->Lambda * axis.value;
        axis.rate = motion->omega.cross(axis.value);
        axis.acceleration = motion->alpha.cross(axis.value) + motion->omega.cross(axis.rate);
    }
    return carrier;
}

// By Newton's method from the axes that are nearly those: where the rod is straight they are.
Mat3 find_turn_axes(const Mat3& section) {
    Mat3 axes;
    axes.col(0) = section.col(0).normalized();
    axes.col(1) = (section.col(1) - section.col(1).dot(axes.col(0)) * axes.col(0)).normalized();
    axes.col(2) = axes.col(0).cross(axes.col(1));
    constexpr int iterations = 8;
    for (int i = 0; i < iterations; ++i) {
        Vec3 miss;
        Mat3 by_turn;
        for (int j = 0; j < 3; ++j) {
            const Vec3 a = section.col(j), b = axes.col((j + 1) % 3);
            miss[j] = a.dot(b);
            by_turn.row(j) = b.cross(a).transpose();
        }
        const Vec3 turn = -by_turn.lu().solve(miss);
        if (turn.norm() < 1e-16) break;
        axes = Eigen::AngleAxisd(turn.norm(), turn.normalized()) * axes;
    }
    return axes;
}

SleeveTurn::SleeveTurn(const SmoothLine::Piece& piece,
                       const ScalarJet& place,
                       std::vector<Carrier> nodes,
                       const Carrier& b)
    : weights_(piece.compute_weights<4>(place.value)), place_(place), nodes_(std::move(nodes)), b_(b) {}

Vec3 SleeveTurn::sum(int order, int axis, Vec3 VectorJet::*part) const {
    Vec3 total = Vec3::Zero();
    for (std::size_t i = 0; i < nodes_.size(); ++i)
        total += weights_[static_cast<std::size_t>(order)][i] *
                 (nodes_[i].axes[static_cast<std::size_t>(axis)].*part);
    return total;
}

VectorJet SleeveTurn::section_axis(int axis) const {
    const double rate = place_.rate;
    const Vec3 slope = sum(1, axis, &VectorJet::value);
    return {sum(0, axis, &VectorJet::value),
            sum(0, axis, &VectorJet::rate) + rate * slope,
            sum(0, axis, &VectorJet::acceleration) + 2.0 * rate * sum(1, axis, &VectorJet::rate) +
                rate * rate * sum(2, axis, &VectorJet::value) + place_.acceleration * slope};
}

SleeveTurn::Rows SleeveTurn::compute_jets() const {
    Rows rows;
    for (int row = 0; row < row_count; ++row) {
        const VectorJet a = section_axis(row);
        const VectorJet& b = partner(row);
        rows[static_cast<std::size_t>(row)] = {
            a.value.dot(b.value),
            a.rate.dot(b.value) + a.value.dot(b.rate),
            a.acceleration.dot(b.value) + 2.0 * a.rate.dot(b.rate) + a.value.dot(b.acceleration)};
    }
    return rows;
}

double SleeveTurn::compute_push(const Vec3& multipliers) const {
    double push = 0.0;
    for (int row = 0; row < row_count; ++row)
        push += multipliers[row] * sum(1, row, &VectorJet::value).dot(partner(row).value);
    return push;
}

Vec3 SleeveTurn::compute_moment(const Vec3& multipliers) const {
    Vec3 moment = Vec3::Zero();
    for (int row = 0; row < row_count; ++row)
        moment += multipliers[row] * partner(row).value.cross(sum(0, row, &VectorJet::value));
    return moment;
}

SleeveTurn::Row SleeveTurn::compute_product_gradient(int row, int order, const Row& place_gradient) const {
    const Vec3& b = partner(row).value;
    Row gradient = sum(order + 1, row, &VectorJet::value).dot(b) * place_gradient;
    if (b_.motion != nullptr)
        gradient.segment<3>(3) += b.cross(sum(order, row, &VectorJet::value)).transpose();
    for (std::size_t i = 0; i < nodes_.size(); ++i) {
        const Vec3& a = nodes_[i].axes[static_cast<std::size_t>(row)].value;
        gradient.segment<3>(first_of_nodes() + 6 * static_cast<int>(i) + 3) +=
            weights_[static_cast<std::size_t>(order)][i] * a.cross(b).transpose();
    }
    return gradient;
}

Eigen::MatrixXd SleeveTurn::compute_gradient(const Row& place_gradient) const {
    Eigen::MatrixXd gradient(row_count, unknowns());
    for (int row = 0; row < row_count; ++row)
        gradient.row(row) = compute_product_gradient(row, 0, place_gradient);
    return gradient;
}

// The parts of δ(Gᵀλ) are those of (J32): of the slope of a product by s, of B's moment and of the nodes'.
Eigen::MatrixXd SleeveTurn::compute_force_derivative(const Vec3& multipliers,
                                                     const Row& place_gradient) const {
    Eigen::MatrixXd derivative = Eigen::MatrixXd::Zero(unknowns(), unknowns());
    const bool has_b = b_.motion != nullptr;
    for (int row = 0; row < row_count; ++row) {
        const double lambda = multipliers[row];
        const Vec3& b = partner(row).value;
        const Mat3 B = cross_matrix(b);
        const Vec3 a = sum(0, row, &VectorJet::value);
        const Vec3 slope = sum(1, row, &VectorJet::value);
        derivative += lambda * place_gradient.transpose() * compute_product_gradient(row, 1, place_gradient);
        if (has_b) {
            derivative.block<3, 3>(3, 3) += lambda * cross_matrix(a) * B;
            derivative.middleRows<3>(3) += lambda * b.cross(slope) * place_gradient;
        }
        for (std::size_t i = 0; i < nodes_.size(); ++i) {
            const int at = first_of_nodes() + 6 * static_cast<int>(i) + 3;
            const Vec3& of_node = nodes_[i].axes[static_cast<std::size_t>(row)].value;
            const Mat3 A = cross_matrix(of_node);
            derivative.middleRows<3>(at) += lambda * weights_[1][i] * of_node.cross(b) * place_gradient;
            derivative.block<3, 3>(at, at) += lambda * weights_[0][i] * B * A;
            if (!has_b) continue;
            derivative.block<3, 3>(3, at) -= lambda * weights_[0][i] * B * A;
            derivative.block<3, 3>(at, 3) -= lambda * weights_[0][i] * A * B;
        }
    }
    return derivative;
}

Eigen::MatrixXd SleeveTurn::compute_acceleration_derivative(
    const PlaceChange& place, const std::vector<const NodeLinearization*>& linearizations) const {
    const double rate = place_.rate, acceleration = place_.acceleration;
    Eigen::MatrixXd derivative(row_count, unknowns());
    for (int row = 0; row < row_count; ++row) {
        const VectorJet& b = partner(row);
        const Vec3 slope = sum(1, row, &VectorJet::value);
        const Vec3 bend = sum(2, row, &VectorJet::value);
        const Vec3 turned = sum(1, row, &VectorJet::rate) + rate * bend;
        const Vec3 by_place = sum(1, row, &VectorJet::acceleration) +
                              2.0 * rate * sum(2, row, &VectorJet::rate) +
                              rate * rate * sum(3, row, &VectorJet::value) + acceleration * bend;
        auto all = derivative.row(row);
        all = (b.value.dot(by_place) + 2.0 * b.rate.dot(turned) + b.acceleration.dot(slope)) * place[0] +
              2.0 * (b.value.dot(turned) + b.rate.dot(slope)) * place[1] + b.value.dot(slope) * place[2];
        std::size_t next = 0;
        if (b_.motion != nullptr) {
            const VectorJet a = section_axis(row);
            all.segment<3>(3) +=
                pull_back_carried(
                    b, {a.acceleration, 2.0 * a.rate, a.value}, *b_.motion, *linearizations[next++])
                    .transpose();
        }
        for (std::size_t i = 0; i < nodes_.size(); ++i) {
            const double M = weights_[0][i], M1 = weights_[1][i], M2 = weights_[2][i];
            const VectorJet g{(rate * rate * M2 + acceleration * M1) * b.value + 2.0 * rate * M1 * b.rate +
                                  M * b.acceleration,
                              2.0 * (rate * M1 * b.value + M * b.rate),
                              M * b.value};
            all.segment<3>(first_of_nodes() + 6 * static_cast<int>(i) + 3) +=
                pull_back_carried(nodes_[i].axes[static_cast<std::size_t>(row)],
                                  g,
                                  *nodes_[i].motion,
                                  *linearizations[next++])
                    .transpose();
        }
    }
    return derivative;
}

}  // namespace gxrod
