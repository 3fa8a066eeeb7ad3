#include "linear/eigen/band_arnoldi.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "linear/eigen/pencil.hpp"
#include "numerics/eigenvalues.hpp"

namespace gxrod {

namespace {

// What orthogonalization may leave of a vector that depends on the others.
constexpr double dependent = 1e-11;

}  // namespace

BandArnoldi::BandArnoldi(const QuadraticProblem& problem,
                         double shift,
                         LinearSolver& inverse,
                         const Eigen::VectorXd& weights,
                         double scale)
    : problem_(problem),
      inverse_(inverse),
      damping_(combine(problem.D, 2.0 * shift, problem.M)),
      shift_(shift),
      weights_(weights),
      scale_(scale) {}

void BandArnoldi::reserve(Index columns) {
    if (columns <= V_.cols()) return;
    constexpr Index least = 64;
    const Index capacity = std::max({least, columns, 2 * V_.cols()});
    V_.conservativeResize(unknowns(), capacity);
    Eigen::MatrixXd larger = Eigen::MatrixXd::Zero(capacity, capacity);
    larger.topLeftCorner(H_.rows(), H_.cols()) = H_;
    H_.swap(larger);
}

double BandArnoldi::dashpot_scale(Index i) const {
    return 1.0 + (shift_ + scale_) * problem_.relaxing[static_cast<std::size_t>(i)].time;
}

void BandArnoldi::apply_top(const Eigen::VectorXd& x,
                            const Eigen::VectorXd& y,
                            const Eigen::VectorXd& w,
                            Eigen::VectorXd& top) {
    multiply(*problem_.pattern, damping_, x, top);
    multiply(*problem_.pattern, problem_.M, y, product_);
    top = -(top + product_);
    const Index n = problem_.size();
    for (Index i = 0; i < relaxing_count(); ++i) {
        const auto& [time, values] = problem_.relaxing[static_cast<std::size_t>(i)];
        multiply(*problem_.pattern, values, w.segment(i * n, n), product_);
        top -= time / (1.0 + shift_ * time) * product_;
    }
    inverse_.solve(top);
}

void BandArnoldi::apply(const Ref& z, Eigen::VectorXd& image) {
    const Index n = problem_.size();
    x_ = z.head(n).cwiseQuotient(weights_);
    y_ = scale_ * z.segment(n, n).cwiseQuotient(weights_);
    w_.resize(relaxing_count() * n);
    for (Index i = 0; i < relaxing_count(); ++i)
        w_.segment(i * n, n) = z.segment((2 + i) * n, n).cwiseQuotient(weights_) / dashpot_scale(i);
    apply_top(x_, y_, w_, top_);
    image.resize(unknowns());
    image.head(n) = top_.cwiseProduct(weights_);
    image.segment(n, n) = z.head(n) / scale_;
    for (Index i = 0; i < relaxing_count(); ++i) {
        const double time = problem_.relaxing[static_cast<std::size_t>(i)].time;
        image.segment((2 + i) * n, n) =
            (dashpot_scale(i) * image.head(n) - time * z.segment((2 + i) * n, n)) / (1.0 + shift_ * time);
    }
}

bool BandArnoldi::append(Index j) {
    const double norm_before = image_.norm();
    double norm = norm_before;
    for (int pass = 0; pass < 4 && norm > dependent * norm_before; ++pass) {
        const double norm_of_pass = norm;
        const auto basis = V_.leftCols(end_);
        const Eigen::VectorXd h = basis.transpose() * image_;
        image_.noalias() -= basis * h;
        if (j >= 0) H_.col(j).head(end_) += h;
        norm = image_.norm();
        if (norm > 0.5 * norm_of_pass) break;
    }
    largest_norm_ = std::max(largest_norm_, norm_before);
    if (!(norm > dependent * norm_before) || !(norm_before > 1e-14 * largest_norm_)) return false;
    reserve(end_ + 1);
    V_.col(end_) = image_ / norm;
    if (j >= 0) H_(end_, j) = norm;
    ++end_;
    return true;
}

bool BandArnoldi::add_noise() {
    const Index size = unknowns();
    if (end_ >= size) return false;
    Eigen::VectorXd noise(size);
    for (double& component : noise) {
        // Knuth's generator (MMIX).
        seed_ = 6364136223846793005U * seed_ + 1442695040888963407U;
        component = static_cast<double>(seed_ >> 11) * 0x1p-52 - 1.0;
    }
    // Within the range of the operator's square, so that it has no part without inertia.
    apply(noise, image_);
    noise = image_ / image_.norm();
    apply(noise, image_);
    reserve(end_ + 1);
    return append(-1);
}

bool BandArnoldi::grow(int steps) {
    for (int i = 0; i < steps; ++i) {
        if (done_ == end_) return false;
        reserve(end_ + 1);
        apply(V_.col(done_), image_);
        append(done_);
        ++done_;
    }
    return true;
}

BandArnoldi::Ritz BandArnoldi::find_ritz() const {
    const ComplexEigen eigen = find_complex_eigen(H_.topLeftCorner(done_, done_));
    const Eigen::VectorXcd& all = eigen.values;
    std::vector<Index> order;
    for (Index i = 0; i < done_; ++i) {
        if (all[i].imag() <= 0.0) order.push_back(i);
    }
    std::stable_sort(
        order.begin(), order.end(), [&](Index a, Index b) { return std::abs(all[a]) > std::abs(all[b]); });
    Ritz ritz;
    ritz.values = all(order);
    ritz.combinations = eigen.vectors(Eigen::all, order);
    // What the operator does beyond the columns to which it was applied.
    const auto beyond = H_.block(done_, 0, end_ - done_, done_);
    ritz.residuals.resize(ritz.values.size());
    for (Index i = 0; i < ritz.values.size(); ++i) {
        const auto combination = ritz.combinations.col(i);
        ritz.residuals[i] = (beyond * combination).norm() / combination.norm() / std::abs(ritz.values[i]);
    }
    return ritz;
}

BandArnoldi::Vector BandArnoldi::make_vector(const Ritz& ritz, Index index) {
    const Index n = problem_.size();
    const auto combination = ritz.combinations.col(index);
    Eigen::VectorXcd z(unknowns());
    z.real() = V_.leftCols(done_) * combination.real();
    z.imag() = V_.leftCols(done_) * combination.imag();
    Vector vector;
    vector.mu = 1.0 / ritz.values[index];
    // Twice: the image, and that of (x, μ x, x/(1 + λτ)) of the image.
    const auto image_of =
        [&](const Eigen::VectorXcd& x, const Eigen::VectorXcd& y, const Eigen::VectorXcd& w) {
            Eigen::VectorXcd image(n);
            apply_top(x.real(), y.real(), w.real(), top_);
            image.real() = top_;
            apply_top(x.imag(), y.imag(), w.imag(), top_);
            image.imag() = top_;
            return image;
        };
    const Eigen::VectorXcd x = z.head(n).cwiseQuotient(weights_);
    const Eigen::VectorXcd y = scale_ * z.segment(n, n).cwiseQuotient(weights_);
    Eigen::VectorXcd w(relaxing_count() * n);
    for (Index i = 0; i < relaxing_count(); ++i)
        w.segment(i * n, n) = z.segment((2 + i) * n, n).cwiseQuotient(weights_) / dashpot_scale(i);
    vector.x = image_of(x, y, w);
    vector.x /= vector.x.cwiseProduct(weights_).norm();
    for (Index i = 0; i < relaxing_count(); ++i) {
        const double time = problem_.relaxing[static_cast<std::size_t>(i)].time;
        w.segment(i * n, n) = vector.x / (1.0 + (shift_ + vector.mu) * time);
    }
    const Eigen::VectorXcd again = image_of(vector.x, vector.mu * vector.x, w);
    // x = μ again, if it is a vector of μ: the best μ, and what is left.
    const Eigen::VectorXcd weighed = vector.x.cwiseProduct(weights_);
    const Eigen::VectorXcd weighed_again = again.cwiseProduct(weights_);
    vector.residual = (weighed - vector.mu * weighed_again).norm();
    return vector;
}

}  // namespace gxrod
