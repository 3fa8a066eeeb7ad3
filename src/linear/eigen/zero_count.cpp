#include "linear/eigen/zero_count.hpp"

#include <cmath>
#include <numbers>
#include <optional>

#include "linear/suite_sparse/complex_solver.hpp"

namespace gxrod {

namespace {

using Complex = std::complex<double>;
using std::numbers::pi;
// Between neighbouring points the direction turns by less.
constexpr double small_turn = pi / 3.0;
constexpr int most_points = 2000;

class Circle {
  public:
    Circle(const QuadraticProblem& problem, double centre, double radius, const Eigen::VectorXcd& known)
        : problem_(problem), solver_(*problem.pattern), centre_(centre), radius_(radius), known_(known) {}

    // From the right end through the upper half to the left end; in the lower half it is the same again,
    // since the matrices are real.
    std::optional<double> turn_along_upper_half() {
        constexpr int parts = 8;
        double turn = 0.0;
        std::optional<Complex> from = direction_at(0.0);
        for (int i = 0; i < parts && from; ++i) {
            const double start = pi * i / parts, end = pi * (i + 1) / parts;
            const std::optional<Complex> to = direction_at(end);
            if (!to || !add_turn(start, *from, end, *to, turn)) return std::nullopt;
            from = to;
        }
        if (!from) return std::nullopt;
        return turn;
    }

  private:
    std::optional<Complex> direction_at(double angle) {
        if (++points_ > most_points) return std::nullopt;
        // The ends are real.
        const Complex z = angle == 0.0  ? Complex(centre_ + radius_)
                          : angle == pi ? Complex(centre_ - radius_)
                                        : centre_ + std::polar(radius_, angle);
        if (!solver_.factorize(problem_.at(z))) return std::nullopt;
        Complex direction = solver_.determinant_direction();
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
    int points_ = 0;
};

}  // namespace

std::int64_t count_more_within(const QuadraticProblem& problem,
                               double centre,
                               double radius,
                               const Eigen::VectorXcd& known) {
    const std::optional<double> turn = Circle(problem, centre, radius, known).turn_along_upper_half();
    if (!turn) return -1;
    // All the way around is twice that, and 2π for each zero.
    return std::llround(*turn / pi);
}

}  // namespace gxrod
