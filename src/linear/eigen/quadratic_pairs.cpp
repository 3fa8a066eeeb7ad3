#include "linear/eigen/quadratic_pairs.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "linear/eigen/band_arnoldi.hpp"
#include "linear/eigen/lowest_pairs.hpp"
#include "linear/eigen/zero_count.hpp"

namespace gxrod {

namespace {

using Eigen::Index;

constexpr double epsilon = std::numeric_limits<double>::epsilon();
// Of a Ritz pair, relative: it has converged, it is usable, it is known roughly.
constexpr double converged = 1e-11, usable = 1e-7, rough = 1e-2;
// θ of what has no inertia is round-off, relative to the largest.
constexpr double no_inertia = 1e-13;
// Of distances from the shift: so near to each other they are copies of one.
constexpr double near = 1e-6;
constexpr int most_rounds = 5;

class QuadraticSearch {
  public:
    QuadraticSearch(const QuadraticProblem& problem,
                    const QuadraticSettings& settings,
                    const ThreadTeam& team)
        : problem_(problem),
          settings_(settings),
          team_(team),
          solver_(make_linear_solver(LinearSolverKind::chains, *problem.pattern, team)) {}

    bool find_shift() {
        ratio_ = find_typical_ratio(*problem_.pattern, problem_.K, problem_.M);
        if (ratio_ == 0.0) return false;
        if (factorize(0.0) && measure_inverse() < 1.0 / (1e3 * epsilon * ratio_)) return true;
        // Rigid motions: the shift of the symmetric problem lies about as far from them as vibrations do.
        const auto pairs = find_lowest_pairs(
            *problem_.pattern, make_symmetric(*problem_.pattern, problem_.K), problem_.M, 2, {}, team_);
        double shift = pairs ? std::sqrt(-pairs->shift) : 1e-6 * std::sqrt(ratio_);
        for (int i = 0; i < 20; ++i, shift *= 2.0) {
            if (!factorize(shift)) continue;
            measure_inverse();
            return true;
        }
        return false;
    }

    QuadraticPairs find() {
        BandArnoldi arnoldi(problem_, result_.shift, *solver_, weights_, 1.0 / std::sqrt(inverse_size_));
        for (int i = 0; i < 2; ++i) arnoldi.add_noise();
        wanted_ = settings_.wanted;
        for (int round = 0; round < most_rounds; ++round) {
            const bool is_whole = converge(arnoldi);
            if (settings_.follows_growth && follow_growth()) continue;
            choose_radius(is_whole);
            if (!settings_.counts) break;
            result_.missing =
                count_more_within(problem_, result_.shift, result_.radius, list_known(result_.radius));
            if (result_.missing <= 0 || is_whole) break;
            const auto more = std::min<std::int64_t>(result_.missing, 8);
            for (int i = 0; i < more; ++i) arnoldi.add_noise();
            least_steps_ = arnoldi.steps() + 4 * more;
        }
        make_vectors(arnoldi);
        return result_;
    }

  private:
    bool factorize(double shift) {
        result_.shift = shift;
        shifted_ = problem_.at(shift);
        if (!solver_->factorize(shifted_).regular) return false;
        weights_.resize(problem_.size());
        for (Index i = 0; i < weights_.size(); ++i) {
            const auto slot = static_cast<std::size_t>(problem_.pattern->slot(i, i));
            weights_[i] = std::sqrt(std::abs(problem_.M[slot]) + std::abs(shifted_[slot]) / ratio_);
            if (weights_[i] == 0.0) weights_[i] = 1.0;
        }
        return true;
    }

    // About the largest 1/ω² there is, from the shift.
    double measure_inverse() {
        Eigen::VectorXd vector = weights_.cwiseInverse(), image;
        inverse_size_ = 0.0;
        for (int i = 0; i < 4; ++i) {
            vector /= vector.cwiseProduct(weights_).norm();
            multiply(*problem_.pattern, problem_.M, vector, image);
            solver_->solve(image);
            inverse_size_ = image.cwiseProduct(weights_).norm();
            if (!(inverse_size_ > 0.0)) break;
            vector = image;
        }
        if (!(inverse_size_ > 0.0) || !std::isfinite(inverse_size_)) inverse_size_ = 1.0 / ratio_;
        return inverse_size_;
    }

    std::complex<double> mu(Index i) const { return 1.0 / ritz_.values[i]; }
    Index count_finite() const {
        Index count = 0;
        while (count < ritz_.values.size() &&
               std::abs(ritz_.values[count]) > no_inertia * std::abs(ritz_.values[0]))
            ++count;
        return count;
    }
    Index count_within(double tolerance) const {
        Index count = 0;
        while (count < finite_ && ritz_.residuals[count] < tolerance) ++count;
        return count;
    }

    // Until those wanted, and roughly the next one, have converged; true if there are no others.
    bool converge(BandArnoldi& arnoldi) {
        const Index most = 12 * static_cast<Index>(wanted_) + 300;
        int step = std::max<int>(4 * wanted_ + 12 - static_cast<int>(arnoldi.steps()), 4);
        while (true) {
            const bool is_whole = !arnoldi.grow(step);
            ritz_ = arnoldi.find_ritz();
            finite_ = count_finite();
            found_ = count_within(converged);
            const bool has_next = found_ > wanted_ ||
                                  (found_ == wanted_ && found_ < finite_ && ritz_.residuals[found_] < rough);
            if (is_whole) {
                found_ = count_within(usable);
                return found_ == finite_;
            }
            if (has_next && arnoldi.steps() >= least_steps_) return false;
            if (arnoldi.steps() > most) {
                found_ = count_within(usable);
                return false;
            }
            step = std::max<int>(6, static_cast<int>(arnoldi.steps()) / 5);
        }
    }

    // Whether more are wanted: rough values that grow beyond what their error explains.
    bool follow_growth() {
        constexpr double errors = 30.0;
        Index last = -1;
        for (Index i = found_; i < finite_; ++i) {
            const double residual = ritz_.residuals[i];
            const std::complex<double> lambda = result_.shift + mu(i);
            if (residual < rough && lambda.real() > (errors * residual + near) * std::abs(mu(i))) last = i;
        }
        if (last < 0 || last + 1 > 4 * static_cast<Index>(settings_.wanted) || last + 1 <= wanted_)
            return false;
        wanted_ = static_cast<int>(last + 1);
        return true;
    }

    // In the gap behind the last wanted one and its copies; what is known beyond stays out.
    void choose_radius(bool is_whole) {
        result_.is_all = is_whole;
        if (found_ == 0) return;
        const auto distance = [&](Index i) { return std::abs(mu(i)); };
        for (Index i = std::min<Index>(wanted_, found_) - 1; i < found_; ++i) {
            const bool is_last = i + 1 == finite_;
            taken_ = i + 1;
            result_.radius = is_last ? 1.5 * distance(i) : std::sqrt(distance(i) * distance(i + 1));
            if (is_last || distance(i + 1) - distance(i) > near * distance(i + 1)) return;
        }
    }

    Eigen::VectorXcd list_known(double radius) const {
        std::vector<std::complex<double>> known;
        for (Index i = 0; i < finite_; ++i) {
            const std::complex<double> lambda = result_.shift + mu(i);
            if (i < found_ || (ritz_.residuals[i] < rough && std::abs(mu(i)) > radius))
                known.push_back(lambda);
        }
        return Eigen::VectorXcd::Map(known.data(), static_cast<Index>(known.size()));
    }

    void make_vectors(BandArnoldi& arnoldi) {
        result_.values.resize(taken_);
        result_.residuals.resize(taken_);
        result_.vectors.resize(problem_.size(), taken_);
        for (Index i = 0; i < taken_; ++i) {
            const BandArnoldi::Vector vector = arnoldi.make_vector(ritz_, i);
            result_.values[i] = result_.shift + vector.mu;
            result_.vectors.col(i) = vector.x;
            result_.residuals[i] = vector.residual;
        }
    }

    const QuadraticProblem& problem_;
    const QuadraticSettings& settings_;
    const ThreadTeam& team_;
    std::unique_ptr<LinearSolver> solver_;
    std::vector<double> shifted_;
    Eigen::VectorXd weights_;
    double ratio_ = 0.0, inverse_size_ = 0.0;
    int wanted_ = 0;
    Index found_ = 0, finite_ = 0, taken_ = 0, least_steps_ = 0;
    BandArnoldi::Ritz ritz_;
    QuadraticPairs result_;
};

}  // namespace

std::optional<QuadraticPairs> find_nearest_pairs(const QuadraticProblem& problem,
                                                 const QuadraticSettings& settings,
                                                 const ThreadTeam& team) {
    QuadraticSearch search(problem, settings, team);
    if (!search.find_shift()) return std::nullopt;
    return search.find();
}

}  // namespace gxrod
