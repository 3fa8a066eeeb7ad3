#include "linear/eigen/zero_count.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>

#include "linear/eigen/pencil.hpp"
#include "linear/suite_sparse/complex_solver.hpp"

namespace gxrod {

namespace {

using Complex = std::complex<double>;
using std::numbers::pi;
// Between neighbouring points the direction turns by less.
constexpr double small_turn = pi / 3.0;
constexpr int most_points = 2000;
constexpr int arc_parts = 8, side_parts = 25;
// Along the upper side of the wedge in which motions creep: wider than what creeps() says, since its many
// zeros would turn the direction fast there.
const Complex side(-0.87, std::sqrt(1.0 - 0.87 * 0.87));

// K + Σ λτ/(1 + λτ) R + m M, of K the symmetric part: its determinant has the poles of that of the problem
// and, m large enough, its zeros where motions creep, nearly, but no others.
QuadraticProblem make_creeping(const QuadraticProblem& problem, double m) {
    QuadraticProblem creeping = problem;
    creeping.K = combine(make_symmetric(*problem.pattern, problem.K), m, problem.M);
    std::ranges::fill(creeping.D, 0.0);
    std::ranges::fill(creeping.M, 0.0);
    return creeping;
}

// The boundary of a disc about a real centre; or, where something relaxes, of what is left of it without the
// wedge about the negative axis in which motions creep.
class Boundary {
  public:
    Boundary(const QuadraticProblem& problem, double centre, double radius, const Eigen::VectorXcd& known)
        : problem_(problem), solver_(*problem.pattern), centre_(centre), radius_(radius), known_(known) {
        if (problem.relaxing.empty()) return;
        const double growth = known.size() > 0 ? std::max(0.0, known.real().maxCoeff()) : 0.0;
        creeping_ = make_creeping(problem, std::pow(centre, 2) + 2.0 * std::pow(growth, 2));
        // Next to 0, where rigid motions are.
        apex_ = 1e-3 * centre;
        const double before = (centre - apex_) * side.real();
        side_length_ = before + std::sqrt(before * before + radius * radius - std::pow(centre - apex_, 2));
        last_angle_ = std::arg(apex_ + side_length_ * side - centre);
    }

    // From the right end through the upper half to the left end; in the lower half it is the same again,
    // since the matrices are real.
    std::optional<double> turn_along_upper_half() {
        const int parts = creeping_ ? arc_parts + side_parts : arc_parts;
        double turn = 0.0;
        std::optional<Complex> from = direction_at(0.0);
        for (int i = 0; i < parts && from; ++i) {
            const double start = i, end = i + 1;
            const std::optional<Complex> to = direction_at(end);
            if (!to || !add_turn(start, *from, end, *to, turn)) return std::nullopt;
            from = to;
        }
        if (!from) return std::nullopt;
        return turn;
    }

  private:
    // Goes along the upper half, first the arc, then the side of the wedge to its apex; the ends are real.
    // The directions of what creeps turn as the logarithm of the distance from the apex.
    Complex point_at(double part) const {
        if (part == 0.0) return centre_ + radius_;
        if (part == arc_parts && !creeping_) return centre_ - radius_;
        if (part <= arc_parts) return centre_ + std::polar(radius_, last_angle_ * part / arc_parts);
        const double last = side_parts - 1, gone = part - arc_parts;
        const double ratio = apex_ / side_length_;
        return apex_ + side * (gone < last ? side_length_ * std::pow(ratio, gone / last)
                                           : apex_ * (side_parts - gone));
    }

    std::optional<Complex> direction_at(double part) {
        if (++points_ > most_points) return std::nullopt;
        const Complex z = point_at(part);
        Complex direction = 1.0;
        if (creeping_) {
            if (!solver_.factorize(creeping_->at(z))) return std::nullopt;
            direction = std::conj(solver_.determinant_direction());
        }
        if (!solver_.factorize(problem_.at(z))) return std::nullopt;
        direction *= solver_.determinant_direction();
        const auto divide = [&](Complex zero) { direction *= std::conj(z - zero) / std::abs(z - zero); };
        for (const Complex& zero : known_) {
            divide(zero);
            if (zero.imag() != 0.0) divide(std::conj(zero));
        }
        return direction;
    }

    // False if it is not found by halving.
    bool add_turn(double start, Complex from, double end, Complex to, double& turn) {
        const double middle = 0.5 * (start + end);
        if (!(middle > start && middle < end)) return false;
        const std::optional<Complex> between = direction_at(middle);
        if (!between) return false;
        const double first = std::arg(*between * std::conj(from)),
                     second = std::arg(to * std::conj(*between));
        if (std::abs(first) < small_turn && std::abs(second) < small_turn) {
            turn += first + second;
            return true;
        }
        return add_turn(start, from, middle, *between, turn) && add_turn(middle, *between, end, to, turn);
    }

    const QuadraticProblem& problem_;
    ComplexSolver solver_;
    double centre_, radius_;
    const Eigen::VectorXcd& known_;
    std::optional<QuadraticProblem> creeping_{};
    double apex_ = 0.0, side_length_ = 0.0, last_angle_ = pi;
    int points_ = 0;
};

}  // namespace

std::int64_t count_more_within(const QuadraticProblem& problem,
                               double centre,
                               double radius,
                               const Eigen::VectorXcd& known) {
    const std::optional<double> turn = Boundary(problem, centre, radius, known).turn_along_upper_half();
    if (!turn) return -1;
    // All the way around is twice that, and 2π for each zero.
    return std::llround(*turn / pi);
}

}  // namespace gxrod
