#include "assembly/tendons/tendon_rows.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "constraints/joints/joint_motors.hpp"
#include "model/evaluation_error.hpp"
#include "state/increment.hpp"

namespace gxrod {
namespace {

constexpr double taut = 1e-9;        // of the length
constexpr double still_taut = 1e-4;  // likewise, where accelerations alone keep it taut

// ℓ₀ − what the winch leaves.
TimeFunction find_shortening(const TendonWinch& winch, double start_length) {
    if (!winch.length) return winch.shortening;
    return TimeFunction([share = winch.share, length = *winch.length, start_length](double time) {
        return share(time) * (start_length - length(time));
    });
}

// Stacked entries of nodes, three of displacements and three of rotations each.
template <class Entry>
Eigen::VectorXd stack(const std::vector<int>& nodes, const Entry& entry) {
    Eigen::VectorXd stacked(6 * static_cast<Eigen::Index>(nodes.size()));
    Eigen::Index row = 0;
    for (const int node : nodes) {
        stacked.segment<6>(row) = entry(static_cast<std::size_t>(node));
        row += 6;
    }
    return stacked;
}

}  // namespace

TendonRows::TendonRows(const Model& model, const Tendon& tendon)
    : name_("tendon " + tendon.name), winch_(&*tendon.winch), line_(model, tendon) {
    shortening_ = winch_->gas ? winch_->gas->pressure : find_shortening(*winch_, line_.start_length());
    if (winch_->gas) gas_.emplace(*winch_->gas, tendon.area, line_.start_length());
    const Rod& rod = model.rods[static_cast<std::size_t>(tendon.rod)];
    rod_stiffness_ =
        model.sections[static_cast<std::size_t>(rod.section)].stiffness(0, 0) / line_.start_length();
}

double TendonRows::compute_prescribed(double time, const TimeSpan& step, ConstraintLevel level) const {
    const PrescribedCoordinate motor = compute_motor(shortening_, time, step, level);
    switch (level) {
        case ConstraintLevel::position:
            return line_.start_length() - motor.value;
        case ConstraintLevel::velocity:
            return -motor.rate;
        default:
            return -motor.acceleration;
    }
}

Eigen::VectorXd TendonRows::stack_rates(const WidePlace& place) const {
    return stack(line_.nodes(), [&](std::size_t node) {
        return (Vec6() << place.nodes[node].v, place.nodes[node].omega).finished();
    });
}

Eigen::VectorXd TendonRows::stack_accelerations(const WidePlace& place) const {
    return stack(line_.nodes(), [&](std::size_t node) {
        return (Vec6() << place.nodes[node].a, place.nodes[node].alpha).finished();
    });
}

Eigen::VectorXd TendonRows::compute_values(const WidePlace& place,
                                           ConstraintLevel level,
                                           const TimeSpan& step) const {
    double value = 0.0;
    if (count() == 0) return {};
    if (level == ConstraintLevel::position) {
        value = length_at(place);
    } else {
        const Eigen::VectorXd gradient = line_.compute_gradient(place.nodes, place.state);
        const Eigen::VectorXd rates = stack_rates(place);
        value = level == ConstraintLevel::velocity
                    ? gradient.dot(rates)
                    : gradient.dot(stack_accelerations(place)) +
                          rates.dot(line_.compute_hessian(place.nodes, place.state) * rates);
    }
    return Eigen::VectorXd::Constant(1, compute_prescribed(place.time, step, level) - value);
}

// Accelerations are those of a place where the tendon is known to be taut or loose: it is taut if it has a
// tension already, even one that pushes while they are being found.
bool TendonRows::hold(const WidePlace& place,
                      const Eigen::VectorXd& multipliers,
                      ConstraintLevel level) const {
    if (count() == 0) return true;
    if (winch_->is_released) return false;
    if (!winch_->pulls_only) return true;
    const double gap = compute_prescribed(place.time, {}, ConstraintLevel::position) - length_at(place);
    switch (level) {
        case ConstraintLevel::position:
            return multipliers[0] >= rod_stiffness_ * gap;
        case ConstraintLevel::velocity:
            return gap < taut * line_.start_length();
        default:
            return gap < (multipliers[0] != 0.0 ? still_taut : taut) * line_.start_length();
    }
}

Eigen::MatrixXd TendonRows::compute_gradient(const WidePlace& place) const {
    if (count() == 0) return Eigen::MatrixXd(0, 6 * static_cast<Eigen::Index>(line_.nodes().size()));
    return -line_.compute_gradient(place.nodes, place.state).transpose();
}

// ∂(q̇ · H q̇)/∂q = d(H q̇)/dε · q̇ along the motion by q̇, by a central difference of order 4, and what it takes
// for spins to change places, for each node w × ω with w the part of its spin in q̇ · H.
Eigen::VectorXd TendonRows::differentiate_square(const WidePlace& place, const Eigen::VectorXd& rates) const {
    constexpr double part = 1e-3;
    double size = 0.0;
    for (Eigen::Index i = 0; i < rates.size(); i += 6)
        size = std::max(
            {size, rates.segment<3>(i).norm() / line_.start_length(), rates.segment<3>(i + 3).norm()});
    if (size == 0.0) return Eigen::VectorXd::Zero(rates.size());
    const double step = part / size;
    const auto compute_at = [&](double by) -> Eigen::VectorXd {
        std::vector<NodeMotion> moved = place.nodes;
        for (const int node : line_.nodes()) {
            const auto index = static_cast<std::size_t>(node);
            const NodeMotion& motion = place.nodes[index];
            apply_spin(place.state.previous[index], by * motion.v, by * motion.omega, moved[index]);
        }
        return line_.compute_hessian(moved, place.state).transpose() * rates;
    };
    Eigen::VectorXd derivative =
        (8.0 * (compute_at(step) - compute_at(-step)) - compute_at(2.0 * step) + compute_at(-2.0 * step)) /
        (12.0 * step);
    const Eigen::VectorXd weights = compute_at(0.0);
    for (Eigen::Index i = 3; i < rates.size(); i += 6)
        derivative.segment<3>(i) += Vec3(weights.segment<3>(i)).cross(Vec3(rates.segment<3>(i)));
    return derivative;
}

Eigen::MatrixXd TendonRows::compute_acceleration_derivative(
    const WidePlace& place, const std::vector<NodeLinearization>& linearizations) const {
    if (count() == 0) return compute_gradient(place);
    const Eigen::VectorXd gradient = line_.compute_gradient(place.nodes, place.state);
    const bool has_placement = linearizations.front().placement != 0.0;
    const bool has_rates = linearizations.front().rate != 0.0 || !linearizations.front().d_omega.isZero(0.0);
    Eigen::VectorXd change = Eigen::VectorXd::Zero(gradient.size());
    Eigen::VectorXd by_rates = change;
    if (has_placement || has_rates) {
        const Eigen::MatrixXd hessian = line_.compute_hessian(place.nodes, place.state);
        const Eigen::VectorXd rates = stack_rates(place);
        by_rates = hessian * rates + hessian.transpose() * rates;
        if (has_placement)
            change = hessian.transpose() * stack_accelerations(place) + differentiate_square(place, rates);
    }
    Eigen::Index row = 0;
    for (const int node : line_.nodes()) {
        const NodeLinearization& by = linearizations[static_cast<std::size_t>(node)];
        change.segment<3>(row) +=
            by.acceleration * gradient.segment<3>(row) + by.rate * by_rates.segment<3>(row);
        change.segment<3>(row + 3) += by.d_alpha.transpose() * gradient.segment<3>(row + 3) +
                                      by.d_omega.transpose() * by_rates.segment<3>(row + 3);
        row += 6;
    }
    return -change.transpose();
}

Eigen::MatrixXd TendonRows::compute_force_derivative(const WidePlace& place,
                                                     const Eigen::VectorXd& multipliers) const {
    if (count() == 0) return Eigen::MatrixXd::Zero(6 * line_.nodes().size(), 6 * line_.nodes().size());
    return -multipliers[0] * line_.compute_hessian(place.nodes, place.state);
}

double TendonRows::compute_tension(const WidePlace& place) const {
    if (winch_->is_released) return 0.0;
    if (gas_) return gas_->compute_tension(length_at(place), shortening_(place.time));
    const double free = compute_prescribed(place.time, {}, ConstraintLevel::position);
    const double tension = winch_->stiffness * (length_at(place) - free) / line_.start_length();
    return winch_->pulls_only ? std::max(tension, 0.0) : tension;
}

double TendonRows::compute_stiffness(const WidePlace& place) const {
    return gas_ ? gas_->compute_stiffness(length_at(place), shortening_(place.time))
                : winch_->stiffness / line_.start_length();
}

Eigen::VectorXd TendonRows::compute_law_force(const WidePlace& place) const {
    return -compute_tension(place) * line_.compute_gradient(place.nodes, place.state);
}

Eigen::MatrixXd TendonRows::compute_law_tangent(const WidePlace& place,
                                                const std::vector<NodeLinearization>& linearizations) const {
    const double tension = compute_tension(place);
    const Eigen::Index size = 6 * static_cast<Eigen::Index>(line_.nodes().size());
    const double placement = linearizations.front().placement;
    if (placement == 0.0 || winch_->is_released || (winch_->pulls_only && tension == 0.0))
        return Eigen::MatrixXd::Zero(size, size);
    const Eigen::VectorXd gradient = line_.compute_gradient(place.nodes, place.state);
    return -placement * (tension * line_.compute_hessian(place.nodes, place.state) +
                         compute_stiffness(place) * gradient * gradient.transpose());
}

double TendonRows::compute_strain_energy(const WidePlace& place) const {
    if (!is_elastic()) return 0.0;
    if (gas_)
        return winch_->is_released ? 0.0 : gas_->compute_energy(length_at(place), shortening_(place.time));
    const double tension = compute_tension(place);
    return 0.5 * tension * tension * line_.start_length() / winch_->stiffness;
}

// An unstretched tendon is drawn in as it gets shorter; of one that stretches the winch moves the free
// length. Gas is pumped in by the pressure in its reference volume.
Vec6 TendonRows::compute_driving_forces(const WidePlace& place, const Eigen::VectorXd& multipliers) const {
    Vec6 forces = Vec6::Zero();
    if (gas_)
        forces[3] = winch_->is_released ? 0.0 : gas_->compute_pumping(length_at(place));
    else
        forces[is_elastic() ? 3 : 1] = compute_tension(place, multipliers);
    return forces;
}

Vec6 TendonRows::compute_coordinates(const WidePlace& place) const {
    Vec6 coordinates = Vec6::Zero();
    if (gas_) {
        coordinates[3] = shortening_(place.time);
    } else if (is_elastic()) {
        coordinates[3] = -compute_prescribed(place.time, {}, ConstraintLevel::position);
    } else {
        coordinates[1] = -length_at(place);
    }
    return coordinates;
}

double TendonRows::compute_driving_power(const WidePlace& place,
                                         const Eigen::VectorXd& multipliers,
                                         const TimeSpan& step) const {
    if (gas_) {
        if (winch_->is_released) return 0.0;
        return gas_->compute_pumping(length_at(place)) * differentiate(shortening_, place.time, step);
    }
    const double tension = compute_tension(place, multipliers);
    if (tension == 0.0) return 0.0;
    if (is_elastic()) return tension * differentiate(shortening_, place.time, step);
    return -tension * line_.compute_gradient(place.nodes, place.state).dot(stack_rates(place));
}

JointValues TendonRows::compute_joint_values(const WidePlace& place,
                                             const Eigen::VectorXd& multipliers) const {
    JointValues values;
    values.slide = length_at(place);
    values.slide_rate = line_.compute_gradient(place.nodes, place.state).dot(stack_rates(place));
    values.drive_slide = compute_tension(place, multipliers);
    return values;
}

void TendonRows::check_range(const WidePlace& place) const {
    if (!gas_ || winch_->is_released) return;
    const double absolute = gas_->find_filling(shortening_(place.time));
    if (absolute > 0.0) return;
    throw EvaluationError(fmt::format(
        "chamber.{}.gas.pressure: with ambient it is {:.6g} at t = {:.6g}, which is no gas; expected "
        "more than −ambient",
        name_.substr(name_.find(' ') + 1),
        absolute,
        place.time));
}

std::vector<std::unique_ptr<const WideRows>> list_tendon_rows(const Model& model) {
    std::vector<std::unique_ptr<const WideRows>> rows;
    for (const Tendon& tendon : model.tendons) {
        if (tendon.winch) rows.push_back(std::make_unique<TendonRows>(model, tendon));
    }
    return rows;
}

}  // namespace gxrod
