#include "linear/eigen/smallest_factors.hpp"

#include <algorithm>
#include <cmath>

#include "linear/eigen/eigenvalue_count.hpp"

namespace gxrod {

namespace {

using Eigen::VectorXd;

// Of factors, relative: so near to each other they are copies of one.
constexpr double near = 1e-6;
// 1/λ of what the loads do not change is round-off, relative to the largest.
constexpr double not_loaded = 1e-10;
constexpr int most_searches = 12;

class FactorSearch {
  public:
    FactorSearch(const SparsePattern& pattern,
                 const std::vector<double>& K,
                 const std::vector<double>& S,
                 const ThreadTeam& team,
                 std::int64_t multipliers)
        : pattern_(pattern),
          K_(K),
          S_(S),
          negative_S_(S),
          stiffness_(pattern, team, multipliers),
          counter_(pattern, team, multipliers) {
        for (double& value : negative_S_) value = -value;
    }

    SmallestFactors find(int count) {
        result_.is_definite = stiffness_.factorize(K_, 0.0, S_) == 0;
        if (!result_.is_definite) return result_;
        bool has_more = search_more(count + 2);
        for (int search = 1; search < most_searches && found() > 0; ++search) {
            const int lacking = count - count_positive(found());
            if (lacking > 0 && has_more) {
                has_more = search_more(lacking + 2);
                continue;
            }
            count_within(find_gap(count));
            const std::int64_t missing = result_.counted_positive - result_.found_positive +
                                         result_.counted_negative - result_.found_negative;
            if (missing <= 0 || !has_more) break;
            has_more = search_more(static_cast<int>(missing) + 1);
        }
        finish(count);
        return result_;
    }

  private:
    Eigen::Index found() const { return pairs_.values.size(); }
    double factor(Eigen::Index i) const { return 1.0 / pairs_.values[i]; }
    int count_positive(Eigen::Index among) const {
        return static_cast<int>((pairs_.values.head(among).array() > 0.0).count());
    }
    Pencil pencil() { return {pattern_, negative_S_, K_, stiffness_.solver(), Pencil::InnerProduct::of_b}; }

    // False if there are no more.
    bool search_more(int wanted) {
        LanczosSettings settings;
        settings.wanted = wanted;
        settings.block = found() > 0 ? std::clamp(wanted, 2, 8) : 2;
        EigenPairs more = find_largest(pencil(), settings, pairs_.vectors);
        const Eigen::Index all = more.values.size();
        Eigen::Index usable = 0;
        const double largest = std::max(all > 0 ? std::abs(more.values[0]) : 0.0,
                                        found() > 0 ? std::abs(pairs_.values[0]) : 0.0);
        while (usable < all && std::abs(more.values[usable]) > not_loaded * largest) ++usable;
        if (usable > 0) {
            more.values.conservativeResize(usable);
            more.vectors.conservativeResize(Eigen::NoChange, usable);
            merge(more, pairs_);
        }
        return usable == wanted;
    }

    // Beyond the last positive factor that is wanted, with its copies; or beyond all, if there are fewer.
    double find_gap(int count) const {
        Eigen::Index i = 0;
        while (i + 1 < found() && count_positive(i + 1) < count) ++i;
        for (; i + 1 < found(); ++i) {
            const double here = std::abs(factor(i)), next = std::abs(factor(i + 1));
            if (next - here > near * next) return 0.5 * (here + next);
        }
        return std::abs(factor(i)) * (1.0 + near);
    }

    void count_within(double limit) {
        result_.limit = limit;
        result_.counted_positive = counter_.count(K_, limit, S_);
        result_.counted_negative = counter_.count(K_, -limit, S_);
        result_.found_positive = result_.found_negative = 0;
        for (Eigen::Index i = 0; i < found() && std::abs(factor(i)) < limit; ++i) {
            ++(factor(i) > 0.0 ? result_.found_positive : result_.found_negative);
        }
    }

    // Which of those within the limit are asked for: the positive ones up to the count, all negative ones.
    std::vector<Eigen::Index> choose(int count) const {
        std::vector<Eigen::Index> chosen;
        for (Eigen::Index i = 0; i < found() && std::abs(factor(i)) < result_.limit; ++i) {
            if (factor(i) < 0.0 || count_positive(i) < count) chosen.push_back(i);
        }
        return chosen;
    }

    // Each vector by one more application of the operator.
    void finish(int count) {
        const std::vector<Eigen::Index> chosen = choose(count);
        const auto size = static_cast<Eigen::Index>(chosen.size());
        result_.values.resize(size);
        result_.residuals.resize(size);
        result_.vectors.resize(pattern_.size(), size);
        const Pencil pencil = this->pencil();
        VectorXd image, y, Sx, Sy;
        for (Eigen::Index i = 0; i < size; ++i) {
            const VectorXd x = pairs_.vectors.col(chosen[static_cast<std::size_t>(i)]);
            pencil.compute_image(x, image);
            pencil.apply(x, image, y);
            const double theta = y.dot(image) / x.dot(image);
            // K y = −S x, without the round-off of a product by K.
            multiply(pattern_, negative_S_, x, Sx);
            multiply(pattern_, negative_S_, y, Sy);
            const double square = y.dot(Sx);
            result_.values[i] = square / y.dot(Sy);
            result_.vectors.col(i) = y / std::sqrt(square);
            const VectorXd rest = y - theta * x;
            pencil.compute_image(rest, image);
            result_.residuals[i] = std::sqrt(std::max(0.0, rest.dot(image)) / square);
        }
    }

    const SparsePattern& pattern_;
    const std::vector<double>& K_;
    const std::vector<double>& S_;
    std::vector<double> negative_S_;
    EigenvalueCount stiffness_, counter_;
    EigenPairs pairs_;  // of θ = 1/λ
    SmallestFactors result_;
};

}  // namespace

SmallestFactors find_smallest_factors(const SparsePattern& pattern,
                                      const std::vector<double>& K,
                                      const std::vector<double>& S,
                                      int count,
                                      const ThreadTeam& team,
                                      std::int64_t multipliers) {
    return FactorSearch(pattern, K, S, team, multipliers).find(count);
}

}  // namespace gxrod
