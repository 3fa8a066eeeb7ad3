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
// Of a Ritz pair, relative: it is usable if no better one is found, it is known roughly.
constexpr double usable = 1e-7, rough = 1e-2;
// θ of what has no inertia is round-off, relative to the largest.
constexpr double no_inertia = 1e-13;
// Of distances from the shift: so near to each other they are copies of one.
constexpr double near = 1e-6;
constexpr int most_rounds = 5;
constexpr double left_tolerance = 1e-9;

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
        if (factorize(0.0) && measure_inverse() < 1.0 / (1e3 * epsilon * ratio_)) {
            if (problem_.relaxing.empty()) return true;
            // What creeps lies along the negative axis, slow motions next to 0: from about as far on the
            // other side as the lowest vibration is, that has the largest θ.
            if (factorize(1.0 / std::sqrt(inverse_size_)) && measure_inverse() > 0.0) return true;
        }
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
            if (!settings_.counts || found_ == 0) break;
            result_.missing =
                count_more_within(problem_, result_.shift, result_.radius, list_known(result_.radius));
            if (result_.missing <= 0 || is_whole) break;
            const auto more = std::min<std::int64_t>(result_.missing, 8);
            for (int i = 0; i < more; ++i) arnoldi.add_noise();
            least_steps_ = arnoldi.steps() + 4 * more;
        }
        make_vectors(arnoldi);
        if (settings_.left) find_left_vectors();
        result_.steps = arnoldi.steps();
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
    // Leaves aside what has no inertia, what creeps, and values of no eigenvalue, such as come and go while
    // the basis grows.
    void take_ritz(const BandArnoldi::Ritz& all) {
        std::vector<Index> kept;
        for (Index i = 0; i < all.values.size(); ++i) {
            const bool is_finite = std::abs(all.values[i]) > no_inertia * std::abs(all.values[0]);
            if (!is_finite || all.residuals[i] >= rough) continue;
            if (!problem_.relaxing.empty() && creeps(result_.shift + 1.0 / all.values[i])) continue;
            kept.push_back(i);
        }
        ritz_ = {all.values(kept), all.residuals(kept), all.combinations(Eigen::all, kept)};
        finite_ = static_cast<Index>(kept.size());
    }
    Index count_within(double tolerance) const {
        Index count = 0;
        while (count < finite_ && ritz_.residuals[count] < tolerance) ++count;
        return count;
    }

    // Until those wanted, and roughly the next one, have converged; true if there are no others.
    bool converge(BandArnoldi& arnoldi) {
        const Index most = 12 * static_cast<Index>(wanted_) + 300;
        const auto first =
            settings_.first_steps > 0 ? static_cast<int>(settings_.first_steps) : 2 * wanted_ + 8;
        int step = std::max<int>(first - static_cast<int>(arnoldi.steps()), 4);
        while (true) {
            const bool is_whole = !arnoldi.grow(step);
            take_ritz(arnoldi.find_ritz());
            found_ = count_within(settings_.tolerance);
            const bool has_next = found_ > wanted_ || (found_ == wanted_ && found_ < finite_);
            if (is_whole) {
                found_ = count_within(usable);
                return found_ == finite_;
            }
            if (has_next && arnoldi.steps() >= least_steps_) return false;
            if (arnoldi.steps() > most) {
                found_ = count_within(usable);
                return false;
            }
            step = std::max<int>(4, static_cast<int>(arnoldi.steps()) / 8);
        }
    }

    // Whether more are wanted: rough values that grow by more than their error, which can be the root of the
    // residual where two are near to each other.
    bool follow_growth() {
        constexpr double errors = 10.0;
        Index last = -1;
        for (Index i = found_; i < finite_; ++i) {
            const std::complex<double> lambda = result_.shift + mu(i);
            const double error = errors * std::sqrt(ritz_.residuals[i]) + near;
            if (lambda.real() > error * std::abs(mu(i))) last = i;
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

    // By the symmetry of the problem, if it has one: y = x if all matrices are symmetric, the conjugate if K
    // and M are, D is skew and nothing grows. Else by the transposed problem.
    void find_left_vectors() {
        const QuadraticProblem transposed = problem_.transposed();
        for (const bool conjugates : {true, false}) {
            result_.left = conjugates ? result_.vectors.conjugate() : result_.vectors;
            if (measure_left(transposed) < usable) return;
        }
        QuadraticSettings settings{.wanted = static_cast<int>(taken_),
                                   .counts = false,
                                   .follows_growth = false,
                                   .tolerance = left_tolerance};
        result_.left.setZero();
        if (const auto found = find_nearest_pairs(transposed, settings, team_)) match_left_vectors(*found);
    }

    // The largest |S⁻¹ T(λ)ᵀ y| / |y|, with S for its transposed.
    double measure_left(const QuadraticProblem& transposed) {
        double largest = 0.0;
        Eigen::VectorXd product, rest;
        for (Index i = 0; i < taken_ && largest < usable; ++i) {
            const std::complex<double> lambda = result_.values[i];
            const Eigen::VectorXcd y = result_.left.col(i);
            Eigen::VectorXcd residual = Eigen::VectorXcd::Zero(y.size());
            const auto add = [&](const std::vector<double>& values, std::complex<double> factor) {
                multiply(*problem_.pattern, values, y.real(), product);
                residual += factor * product;
                multiply(*problem_.pattern, values, y.imag(), product);
                residual += std::complex<double>(0.0, 1.0) * factor * product;
            };
            add(transposed.K, 1.0);
            add(transposed.D, lambda);
            add(transposed.M, lambda * lambda);
            for (const RelaxingMatrix& one : transposed.relaxing) add(one.values, one.factor(lambda));
            double square = 0.0;
            for (const Eigen::VectorXd& part :
                 {Eigen::VectorXd(residual.real()), Eigen::VectorXd(residual.imag())}) {
                rest = part;
                solver_->solve(rest);
                square += rest.cwiseProduct(weights_).squaredNorm();
            }
            largest = std::max(largest, std::sqrt(square) / y.cwiseProduct(weights_).norm());
        }
        return largest;
    }

    // Those of the transposed problem that have the same λ, each once.
    void match_left_vectors(const QuadraticPairs& found) {
        std::vector<char> is_taken(static_cast<std::size_t>(found.values.size()), 0);
        for (Index i = 0; i < taken_; ++i) {
            const std::complex<double> lambda = result_.values[i];
            Index nearest = -1;
            for (Index j = 0; j < found.values.size(); ++j) {
                if (is_taken[static_cast<std::size_t>(j)] != 0) continue;
                if (nearest < 0 ||
                    std::abs(found.values[j] - lambda) < std::abs(found.values[nearest] - lambda))
                    nearest = j;
            }
            if (nearest < 0 ||
                std::abs(found.values[nearest] - lambda) > near * std::abs(lambda - found.shift))
                continue;
            is_taken[static_cast<std::size_t>(nearest)] = 1;
            result_.left.col(i) = found.vectors.col(nearest);
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
