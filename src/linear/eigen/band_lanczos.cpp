#include "linear/eigen/band_lanczos.hpp"

#include <algorithm>
#include <cmath>
#include <deque>
#include <numeric>

#include "numerics/eigenvalues.hpp"

namespace gxrod {

namespace {

// What orthogonalization may leave of a vector that depends on the others.
constexpr double negligible = 1e-11;

std::vector<Eigen::Index> order_by_size(const Eigen::VectorXd& values) {
    std::vector<Eigen::Index> order(static_cast<std::size_t>(values.size()));
    std::iota(order.begin(), order.end(), 0);
    std::stable_sort(order.begin(), order.end(), [&](Eigen::Index a, Eigen::Index b) {
        return std::abs(values[a]) > std::abs(values[b]);
    });
    return order;
}

// Components of both signs and any size, so that no eigenvector is orthogonal to it.
class Noise {
  public:
    explicit Noise(std::int64_t size) : size_(size) {}
    Eigen::VectorXd next() {
        Eigen::VectorXd vector(size_);
        for (double& component : vector) {
            // Knuth's generator (MMIX).
            seed_ = 6364136223846793005U * seed_ + 1442695040888963407U;
            component = static_cast<double>(seed_ >> 11) * 0x1p-52 - 1.0;
        }
        return vector;
    }

  private:
    std::int64_t size_;
    std::uint64_t seed_ = 29;
};

class BandLanczos {
  public:
    BandLanczos(const Pencil& pencil, const LanczosSettings& settings, const Eigen::MatrixXd& known)
        : pencil_(pencil),
          settings_(settings),
          known_(known.cols()),
          capacity_(known_ + 3 * settings.wanted + 30 + 3 * settings.block),
          vectors_(pencil.size(), capacity_),
          projected_(Eigen::MatrixXd::Zero(capacity_, capacity_)),
          noise_(pencil.size()) {
        if (known_ > 0) vectors_.leftCols(known_) = known;
        done_ = end_ = known_;
    }

    EigenPairs run() {
        for (int i = 0; i < settings_.block; ++i) add_noise();
        Eigen::Index next_look = known_ + settings_.wanted + 2;
        while (true) {
            if (end_ == capacity_) {
                look();
                restart();
                next_look = 0;
            }
            if (done_ == end_) {
                if (add_noise()) continue;
                look();
                return collect(done_ - known_, true);
            }
            step();
            if (done_ < next_look) continue;
            next_look = done_ + 2 + settings_.block;
            look();
            if (converged_ >= settings_.wanted) return collect(settings_.wanted, false);
            if (products_ >= settings_.most_products) return collect(converged_, false);
        }
    }

  private:
    using Index = Eigen::Index;

    // Applies the operator to the first vector that waits.
    void step() {
        const Index j = done_;
        pencil_.apply(vectors_.col(j), images_.front(), w_);
        spare_.swap(images_.front());
        images_.pop_front();
        ++products_;
        const Index added = append(std::max(known_, j - settings_.block), j);
        ++done_;
        if (added >= 0) projected_(added, j) = projected_(j, added) = last_norm_;
    }

    // Makes w orthogonal to the basis, first to the columns from `near` on, and appends what is left. Its
    // parts along the basis go into column j of T, if j ≥ 0. Returns its column, or −1 if nothing is left.
    Index append(Index near, Index j) {
        pencil_.compute_image(w_, image_);
        const double norm_before = compute_norm();
        double norm = norm_before;
        Index first = near;
        for (int pass = 0; pass < 4 && norm > negligible * norm_before; ++pass) {
            const double norm_of_pass = norm;
            const auto basis = vectors_.middleCols(first, end_ - first);
            const Eigen::VectorXd h = basis.transpose() * image_;
            w_.noalias() -= basis * h;
            if (j >= 0) record(j, first, h);
            pencil_.compute_image(w_, image_);
            norm = compute_norm();
            const bool was_full = first == 0;
            first = 0;
            if (was_full && norm > 0.5 * norm_of_pass) break;
        }
        largest_norm_ = std::max(largest_norm_, norm_before);
        last_norm_ = norm;
        if (!(norm > negligible * norm_before) || !(norm_before > 1e-14 * largest_norm_)) return -1;
        vectors_.col(end_) = w_ / norm;
        spare_ = image_ / norm;
        images_.push_back(std::move(spare_));
        return end_++;
    }

    // Columns that were processed before have their couplings to j already: T is symmetric.
    void record(Index j, Index first, const Eigen::VectorXd& h) {
        for (Index i = std::max(first, j); i < end_; ++i) {
            projected_(i, j) += h[i - first];
            if (i != j) projected_(j, i) = projected_(i, j);
        }
    }

    double compute_norm() const { return std::sqrt(std::max(0.0, w_.dot(image_))); }

    bool add_noise() {
        if (end_ >= std::min<Index>(capacity_, pencil_.size())) return false;
        const Eigen::VectorXd start = noise_.next();
        pencil_.compute_image(start, image_);
        // Within the range of the operator, so that it has no part without inertia.
        pencil_.apply(start, image_, w_);
        ++products_;
        return append(0, -1) >= 0;
    }

    // Ritz pairs of the processed columns, and how many of the best have converged.
    void look() {
        const Index size = done_ - known_;
        if (size == 0) return;
        const SymmetricEigen ritz = find_symmetric_eigen(projected_.block(known_, known_, size, size));
        const std::vector<Index> order = order_by_size(ritz.values);
        ritz_values_ = ritz.values(order);
        ritz_vectors_ = ritz.vectors(Eigen::all, order);
        // What the operator does beyond the processed columns.
        residuals_ = projected_.block(done_, known_, end_ - done_, size) * ritz_vectors_;
        converged_ = 0;
        while (converged_ < size &&
               residuals_.col(converged_).norm() <= settings_.tolerance * std::abs(ritz_values_[converged_]))
            ++converged_;
    }

    // The best Ritz vectors take the places of the processed columns.
    void restart() {
        const Index size = done_ - known_;
        const Index kept = std::min<Index>(size, settings_.wanted + (size - settings_.wanted) / 3);
        const Index waiting = end_ - done_;
        const Eigen::MatrixXd best = vectors_.middleCols(known_, size) * ritz_vectors_.leftCols(kept);
        const Eigen::MatrixXd rest = vectors_.middleCols(done_, waiting);
        vectors_.middleCols(known_, kept) = best;
        vectors_.middleCols(known_ + kept, waiting) = rest;
        const Eigen::MatrixXd between = projected_.block(done_, done_, waiting, waiting);
        projected_.setZero();
        projected_.block(known_, known_, kept, kept) = ritz_values_.head(kept).asDiagonal();
        projected_.block(known_ + kept, known_, waiting, kept) = residuals_.leftCols(kept);
        projected_.block(known_, known_ + kept, kept, waiting) = residuals_.leftCols(kept).transpose();
        projected_.block(known_ + kept, known_ + kept, waiting, waiting) = between;
        done_ = known_ + kept;
        end_ = done_ + waiting;
    }

    EigenPairs collect(Index count, bool exhausted) const {
        count = std::min<Index>(count, ritz_values_.size());
        EigenPairs pairs;
        pairs.values = ritz_values_.head(count);
        pairs.vectors = vectors_.middleCols(known_, ritz_vectors_.rows()) * ritz_vectors_.leftCols(count);
        pairs.exhausted = exhausted;
        return pairs;
    }

    const Pencil& pencil_;
    LanczosSettings settings_;
    Index known_, capacity_;
    Index done_ = 0;                      // columns to which the operator was applied, known ones included
    Index end_ = 0;                       // columns of the basis
    Eigen::MatrixXd vectors_;             // V, the basis, a column each
    Eigen::MatrixXd projected_;           // Vᵀ (image of) B⁻¹A V, of the processed columns
    std::deque<Eigen::VectorXd> images_;  // of the columns that wait
    Eigen::VectorXd w_, image_, spare_;   // what is worked on; large vectors are not allocated each time
    Noise noise_;
    double last_norm_ = 0.0, largest_norm_ = 0.0;
    int products_ = 0;
    Eigen::VectorXd ritz_values_;
    Eigen::MatrixXd ritz_vectors_, residuals_;
    Index converged_ = 0;
};

}  // namespace

EigenPairs find_largest(const Pencil& pencil, const LanczosSettings& settings, const Eigen::MatrixXd& known) {
    if (settings.wanted <= 0 || pencil.size() == 0) return {};
    return BandLanczos(pencil, settings, known).run();
}

void merge(const EigenPairs& more, EigenPairs& pairs) {
    const Eigen::Index before = pairs.values.size();
    Eigen::VectorXd values(before + more.values.size());
    values << pairs.values, more.values;
    const std::vector<Eigen::Index> order = order_by_size(values);
    Eigen::MatrixXd vectors(more.vectors.rows(), values.size());
    if (before > 0) vectors.leftCols(before) = pairs.vectors;
    vectors.rightCols(more.values.size()) = more.vectors;
    pairs.values = values(order);
    pairs.vectors = vectors(Eigen::all, order);
    pairs.exhausted = more.exhausted;
}

}  // namespace gxrod
