#include "analyses/path/branch_switch.hpp"

#include <cmath>
#include <limits>

namespace gxrod {

namespace {

// The reduced equation of a simple bifurcation (Liapunov and Schmidt), solved numerically: with the amplitude
// of the shape and the distance along the path given, a disturbance of the size ε keeps equilibrium. The
// branch is where ε / amplitude vanishes.
class ReducedEquation {
  public:
    ReducedEquation(PathContext& work, const BranchStart& start, double amplitude)
        : work_(work),
          direction_(start.direction),
          shape_{start.side * start.shape, 0.0},
          amplitude_(amplitude) {
        // The path's direction, without what it shares with the shape.
        const double common = work.metric.multiply(direction_, shape_);
        direction_ = direction_ + (-common) * shape_;
        direction_ = (1.0 / work.metric.norm(direction_)) * direction_;
        problem_.rows = {work.metric.row(direction_), work.metric.row(shape_)};
        problem_.disturbances = {problem_.rows[1].u};
    }

    const PathVector& shape() const { return shape_; }

    // ε / amplitude, or NaN if no equilibrium was found.
    double evaluate(double distance) {
        problem_.prediction = distance * direction_ + amplitude_ * shape_;
        const EquilibriumReport report =
            solve_path_equilibrium({work_.system, work_.integrator, work_.newton},
                                   problem_,
                                   work_.workspace,
                                   work_.state,
                                   solution_);
        work_.iterations += report.iterations;
        if (!report.converged()) return std::numeric_limits<double>::quiet_NaN();
        return solution_.amplitudes[0] / amplitude_;
    }

    // From the bifurcation to the equilibrium last found.
    PathVector movement() const {
        return {compute_step(work_.system, work_.state), solution_.load_factor - work_.state.time};
    }

  private:
    PathContext& work_;
    PathVector direction_;
    PathVector shape_;
    double amplitude_;
    PathProblem problem_;
    PathSolution solution_;
};

}  // namespace

std::optional<PathTrial> step_on_branch(PathContext& work, const BranchStart& start, double step) {
    constexpr int most_evaluations = 8;
    constexpr double farthest = 0.7;  // along the path, of the amplitude: beyond it is the path's business
    ReducedEquation reduced(work, start, step);
    double distance = 0.0;
    double value = reduced.evaluate(distance);
    double slope = -start.softening;
    for (int i = 0; i < most_evaluations && std::isfinite(value); ++i) {
        const double change = -value / slope;
        if (!std::isfinite(change) || std::abs(distance + change) > farthest * step) return std::nullopt;
        distance += change;
        const double next = reduced.evaluate(distance);
        if (next != value) slope = (next - value) / change;
        value = next;
        if (std::abs(change) <= 1e-7 * step) break;
    }
    if (!std::isfinite(value)) return std::nullopt;
    // Without the disturbance, whose rest is now what Newton's method leaves.
    PathTrial trial;
    const PathVector movement = reduced.movement();
    if (!solve_path_step(work, movement, work.metric.row(reduced.shape()), trial).converged())
        return std::nullopt;
    const PathVector moved{compute_step(work.system, work.state), trial.load_factor - work.state.time};
    trial.step = work.metric.norm(moved);
    if (work.metric.multiply(trial.direction, moved) < 0.0) trial.direction = -1.0 * trial.direction;
    return trial;
}

}  // namespace gxrod
