#include "analyses/path/critical_points.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <type_traits>

#include "analyses/static_work.hpp"
#include "numerics/lagrange.hpp"
#include "solvers/newton_steps.hpp"
#include "solvers/path/root_search.hpp"
#include "solvers/path/soft_modes.hpp"

namespace gxrod {

namespace {

constexpr double not_found = std::numeric_limits<double>::quiet_NaN();

// An equilibrium close to a bifurcation.
struct Sample {
    double place = 0.0;  // along the path's direction, from the last accepted equilibrium
    PathTrial trial;
    std::vector<Vec6> movement;
    SoftModes modes;
    Eigen::VectorXd tests;  // what passes zero at the bifurcation
};

// What is looked for: eigenvalues of the tangent that pass zero, or the rate of the load factor where it
// does.
enum class Seek { softness, turning };

constexpr int sample_count = 6;
using Samples = std::array<Sample, sample_count>;

// The value at a place of the polynomial through some of the samples, from `first` on.
template <int Count, class ValueOf>
auto interpolate(const Samples& samples, int first, double place, const ValueOf& value_of) {
    NodeValues<Count> places;
    for (int i = 0; i < Count; ++i)
        places[i] = samples[static_cast<std::size_t>(first) + static_cast<std::size_t>(i)].place;
    const NodeValues<Count> weights = compute_lagrange<Count>(places, place);
    using Value = std::remove_cvref_t<decltype(value_of(samples[0]))>;
    Value value = weights[0] * value_of(samples[static_cast<std::size_t>(first)]);
    for (int i = 1; i < Count; ++i)
        value = value +
                weights[i] * value_of(samples[static_cast<std::size_t>(first) + static_cast<std::size_t>(i)]);
    return value;
}

class BifurcationSearch {
  public:
    BifurcationSearch(PathContext& work, const PathVector& start, Seek seek, int count)
        : work_(work), start_(start), row_(work.metric.row(start)), seek_(seek), count_(count) {}

    std::optional<LocatedPoint> locate(const PathTrial& end, std::int64_t pivots_at_start) {
        const double place = find_rough_place(end);
        // Where two paths cross at a turn, equilibria close to it are worse to find.
        const double width = (seek_ == Seek::turning ? 0.2 : 0.04) * std::abs(end.step);
        if (!std::isfinite(place) || !take_samples(place, width)) return std::nullopt;
        const std::vector<double> roots = find_roots(width);
        if (roots.empty() || (seek_ == Seek::turning && !softens_at(roots[0]))) return std::nullopt;
        const double first = *std::min_element(roots.begin(), roots.end());
        multiplicity_ = 0;
        for (const double root : roots) multiplicity_ += root - first < same * width ? 1 : 0;
        const int gained = end.pivots > pivots_at_start ? multiplicity_ : -multiplicity_;
        return make_point(first, pivots_at_start + gained);
    }

  private:
    static constexpr double same = 1e-3;  // of the samples' distance, within which roots are one

    SoftModes find_modes(int count) const {
        const FactorizedTangent tangent = factorized_tangent(work_.system, work_.workspace);
        return find_soft_modes(tangent.solver,
                               tangent.pattern,
                               tangent.values,
                               work_.metric.weights(),
                               count,
                               work_.is_symmetric,
                               vectors_);
    }

    // By the vectors of the sample before: eigenvalues may pass zero together and change their order there.
    void keep_order(SoftModes& modes) const {
        if (vectors_.cols() != modes.vectors.cols()) return;
        Eigen::MatrixXd common =
            (vectors_.transpose() * work_.metric.weights().asDiagonal() * modes.vectors).cwiseAbs();
        const SoftModes found = modes;
        for (Eigen::Index left = common.rows(); left > 0; --left) {
            Eigen::Index before = 0, now = 0;
            common.maxCoeff(&before, &now);
            modes.values[before] = found.values[now];
            modes.vectors.col(before) = found.vectors.col(now);
            common.row(before).setConstant(-1.0);
            common.col(now).setConstant(-1.0);
        }
    }

    bool sample(double step, Sample& sample) {
        if (!solve_exact_step(work_, start_, step, sample.trial)) return false;
        sample.modes = find_modes(count_);
        if (sample.modes.values.size() != count_) return false;
        keep_order(sample.modes);
        vectors_ = sample.modes.vectors;
        sample.tests = seek_ == Seek::softness ? sample.modes.values
                                               : Eigen::VectorXd::Constant(1, sample.trial.direction.load);
        sample.movement = compute_movement(work_.state);
        sample.place = row_.u.dot(compute_step(work_.system, work_.state)) +
                       row_.load * (sample.trial.load_factor - work_.state.time);
        return true;
    }

    // By the mean of what is looked for.
    double find_rough_place(const PathTrial& end) {
        // The last accepted equilibrium itself may be a critical point.
        const double close = 0.02 * end.step;
        Sample last, first;
        if (!sample(end.step, last) || !sample(close, first)) return not_found;
        const double at_start = first.tests.mean();
        const double at_end = last.tests.mean();
        if ((at_start > 0.0) == (at_end > 0.0)) return not_found;
        return find_root(
            {close, at_start, end.step, at_end}, {0.02 * std::abs(end.step), 0.0, 12}, [&](double step) {
                Sample middle;
                return sample(step, middle) ? middle.tests.mean() : not_found;
            });
    }

    bool take_samples(double place, double width) {
        constexpr std::array<double, sample_count> offsets{-1.5, -1.0, -0.5, 0.5, 1.0, 1.5};
        for (std::size_t i = 0; i < offsets.size(); ++i) {
            if (!sample(place + offsets[i] * width, samples_[i])) return false;
        }
        return true;
    }

    double test_at(int i, double place) const {
        return interpolate<sample_count>(
            samples_, 0, place, [i](const Sample& sample) { return sample.tests[i]; });
    }

    // Of what passes zero among the samples, where it does.
    std::vector<double> find_roots(double width) const {
        std::vector<double> roots;
        for (int i = 0; i < samples_[0].tests.size(); ++i) {
            const double a = samples_.front().place, b = samples_.back().place;
            const double at_a = test_at(i, a), at_b = test_at(i, b);
            if ((at_a > 0.0) == (at_b > 0.0) || !is_smooth(i, at_b - at_a)) continue;
            roots.push_back(find_root({a, at_a, b, at_b}, {1e-12 * width, 0.0, 60}, [&](double place) {
                return test_at(i, place);
            }));
        }
        return roots;
    }

    // Whether the samples lie on one curve: then those inside say what the outer ones are.
    bool is_smooth(int i, double range) const {
        constexpr double tolerable = 0.05;
        for (const Sample* outer : {&samples_.front(), &samples_.back()}) {
            const double expected = interpolate<sample_count - 2>(
                samples_, 1, outer->place, [i](const Sample& sample) { return sample.tests[i]; });
            if (std::abs(expected - outer->tests[i]) > tolerable * std::abs(range)) return false;
        }
        return true;
    }

    // Whether the softest eigenvalue touches zero there without passing it.
    bool softens_at(double place) const {
        constexpr double tolerable = 0.05;
        const auto softness = [](const Sample& sample) { return sample.modes.values[0]; };
        const double before = softness(samples_.front()), after = softness(samples_.back());
        const double there = interpolate<sample_count>(samples_, 0, place, softness);
        return (before > 0.0) == (after > 0.0) &&
               std::abs(there) < tolerable * std::max(std::abs(before), std::abs(after));
    }

    std::optional<LocatedPoint> make_point(double place, std::int64_t pivots) {
        const auto at_place = [&](const auto& value_of) {
            return interpolate<sample_count>(samples_, 0, place, value_of);
        };
        LocatedPoint point;
        point.trial.direction = at_place([](const Sample& sample) { return sample.trial.direction; });
        point.trial.direction = (1.0 / work_.metric.norm(point.trial.direction)) * point.trial.direction;
        point.trial.load_factor = at_place([](const Sample& sample) { return sample.trial.load_factor; });
        point.trial.step = place;
        point.trial.pivots = pivots;
        point.multiplicity = multiplicity_;
        point.turns = seek_ == Seek::turning;
        const double a = samples_.front().place, b = samples_.back().place;
        point.softening = (test_at(0, b) - test_at(0, a)) / (b - a);
        std::vector<Vec6> movement(work_.state.trial.size());
        for (std::size_t i = 0; i < movement.size(); ++i)
            movement[i] = at_place([i](const Sample& sample) -> Vec6 { return sample.movement[i]; });
        if (!place_trial(work_, movement, point.trial.load_factor)) return std::nullopt;
        find_kernel(point);
        return point;
    }

    void find_kernel(LocatedPoint& point) {
        compute_consistent_tangent(
            work_.system, work_.integrator, point.trial.load_factor, work_.workspace, work_.state);
        EquilibriumReport report;
        if (factorize(work_.system, work_.workspace, report)) {
            const SoftModes modes = find_modes(multiplicity_);
            if (modes.vectors.allFinite() && modes.vectors.cols() == multiplicity_) vectors_ = modes.vectors;
        }
        point.kernel = vectors_.leftCols(multiplicity_);
        measure_residual(work_.system, work_.workspace.residual, report);
        point.trial.residual = report.residual;
    }

    PathContext& work_;
    const PathVector& start_;
    PathVector row_;
    Seek seek_;
    int count_;
    int multiplicity_ = 1;
    Eigen::MatrixXd vectors_;
    Samples samples_;
};

}  // namespace

std::optional<LocatedPoint> locate_limit(PathContext& work, const PathVector& start, const PathTrial& end) {
    LocatedPoint point;
    const auto rate = [&](double step) {
        return solve_exact_step(work, start, step, point.trial) ? point.trial.direction.load : not_found;
    };
    const double scale = std::abs(start.load) + std::abs(end.direction.load);
    const double root = find_root(
        {0.0, start.load, end.step, end.direction.load}, {1e-11 * end.step, 1e-13 * scale, 25}, rate);
    if (!std::isfinite(root)) return std::nullopt;
    // Where the load factor is continuous but its rate jumps, the path has jumped.
    if (std::abs(point.trial.direction.load) > 1e-4 * scale) return std::nullopt;
    point.trial.pivots = end.pivots;
    point.turns = true;
    point.kernel = point.trial.direction.u / work.metric.norm(point.trial.direction.u);
    return point;
}

std::optional<LocatedPoint> locate_bifurcation(PathContext& work,
                                               const PathVector& start,
                                               std::int64_t pivots_at_start,
                                               const PathTrial& end) {
    const int count = static_cast<int>(std::abs(end.pivots - pivots_at_start));
    BifurcationSearch search(work, start, Seek::softness, count);
    return search.locate(end, pivots_at_start);
}

std::optional<LocatedPoint> locate_crossing(PathContext& work,
                                            const PathVector& start,
                                            std::int64_t pivots_at_start,
                                            const PathTrial& end) {
    BifurcationSearch search(work, start, Seek::turning, 1);
    std::optional<LocatedPoint> point = search.locate(end, pivots_at_start);
    if (point) point->trial.pivots = end.pivots;
    return point;
}

}  // namespace gxrod
