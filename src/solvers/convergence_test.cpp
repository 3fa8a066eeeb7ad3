#include "solvers/convergence_test.hpp"

#include <algorithm>

#include "assembly/contact/contacts.hpp"
#include "solvers/newton_steps.hpp"

namespace gxrod {

ConvergenceTest::ConvergenceTest(const System& system, const NewtonSettings& settings, ConstraintLevel level)
    : system_(&system),
      tolerance_(settings.tolerance.value_or(usual_newton_tolerance)),
      absolute_residual_(settings.absolute_residual),
      of_accelerations_(level == ConstraintLevel::acceleration) {}

void ConvergenceTest::measure(const Residual& residual, EquilibriumReport& report) {
    if (report.iterations == 1) first_gap_ = report.joint_gap.size;
    gap_before_ = report.iterations > 0 ? report.joint_gap.size : gap_before_;
    residual_before_ = report.iterations > 0 ? report.residual : residual_before_;
    measure_residual(*system_, residual, report);
}

void ConvergenceTest::add_increment(const std::vector<Vec6>& deltas, const State& state) {
    increment_before_ = last_increment_;
    last_increment_ = system_->team().find_largest(deltas.size(), [&](std::size_t node) {
        const Vec6& delta = deltas[node];
        const double scale =
            std::max(system_->scale_groups().length_at(static_cast<int>(node)), state.trial[node].r.norm());
        return std::max(delta.head<3>().lpNorm<Eigen::Infinity>() / scale,
                        delta.tail<3>().lpNorm<Eigen::Infinity>());
    });
}

bool ConvergenceTest::is_met(const Residual& residual, const EquilibriumReport& report) const {
    const bool is_small = absolute_residual_ > 0.0
                              ? largest_component(*system_, residual) <= absolute_residual_
                              : report.residual <= tolerance_;
    return (is_small && are_closed(report)) || has_reached_round_off(residual, report);
}

// Whether the equations of joints are met; or, of accelerations, come no nearer to it: where some of them are
// redundant, they contradict each other in the inner stages of a step, whose positions are not exact.
bool ConvergenceTest::are_closed(const EquilibriumReport& report) const {
    constexpr double closed = 1e-12;
    const double gap = report.joint_gap.size;
    if (!of_accelerations_) return gap <= closed;
    // In short steps even wrong accelerations make small gaps.
    return gap <= std::min(closed, tolerance_ * first_gap_) || gap >= 0.5 * gap_before_;
}

// Whether round-off is all that is left of the increments: far below the tolerance, a few units of the
// last place, or small and no longer shrinking; or the next one would be, going by the last two, and the
// residual no longer falls. Where round-off is as large as the forces, the tangent has lost digits too,
// and two increments do not predict a third.
bool ConvergenceTest::has_reached_round_off(const Residual& residual, const EquilibriumReport& report) const {
    constexpr double rounding = 4.0 * std::numeric_limits<double>::epsilon();
    const double nothing = std::max(1e-4 * tolerance_, rounding);
    constexpr double hardly = 1e-10;
    // A stop that is to be let go has held all in its place.
    if (!of_accelerations_ && system_->joints().have_stops() && report.joint_gap.size > hardly) return false;
    // What an increment takes into touch has a force from the next one on.
    if (Contacts(*system_).are_possible() && increment_before_ > hardly) return false;
    if (last_increment_ <= nothing) return true;
    if (last_increment_ <= hardly && last_increment_ >= 0.5 * increment_before_) return true;
    if (report.iterations < 2) return false;
    if (is_as_large_as_forces(*system_, residual, report)) return false;
    const double next_increment = last_increment_ * (last_increment_ / increment_before_);
    return next_increment <= nothing && report.residual >= 0.5 * residual_before_;
}

}  // namespace gxrod
