#include "linear/eigen/lowest_pairs.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "linear/eigen/eigenvalue_count.hpp"

namespace gxrod {

namespace {

using Eigen::VectorXd;

// Of eigenvalues, relative to their distance from the shift: so near to each other they are copies of one.
constexpr double near = 1e-6;
// θ of a motion without inertia is round-off, relative to the largest.
constexpr double no_inertia = 1e-13;
constexpr int most_searches = 12;

class LowestSearch {
  public:
    LowestSearch(const SparsePattern& pattern,
                 const std::vector<double>& K,
                 const std::vector<double>& M,
                 const ThreadTeam& team,
                 std::int64_t multipliers)
        : pattern_(pattern),
          K_(K),
          M_(M),
          shifted_(pattern, team, multipliers),
          counter_(pattern, team, multipliers) {}

    bool find_shift() {
        scale_ = find_typical_ratio(pattern_, K_, M_);
        if (scale_ == 0.0) return false;
        // A hundred units of rounding below zero, where rigid motions are.
        first_shift_ = -100.0 * std::numeric_limits<double>::epsilon() * scale_;
        return find_shift_from(first_shift_);
    }

    LowestPairs find(int count, std::optional<double> below) {
        if (below) {
            count_below(*below);
            count = static_cast<int>(std::max<std::int64_t>(0, result_.counted));
        }
        search_from_good_shift(below ? count : count + 2);
        for (int search = 1; search < most_searches && found() > 0; ++search) {
            count_below(below ? *below : find_gap(count));
            const std::int64_t missing = result_.counted - result_.found;
            const std::int64_t short_of = below || pairs_.exhausted ? 0 : count - found();
            if (missing <= 0 && short_of <= 0) break;
            if (!search_more(static_cast<int>(std::max(missing, short_of)) + 1)) break;
        }
        finish(below ? result_.found : std::min<std::int64_t>(count, found()));
        return result_;
    }

  private:
    bool find_shift_from(double shift) {
        constexpr int most = 40;
        for (int i = 0; i < most; ++i, shift *= 8.0) {
            if (shifted_.factorize(K_, -shift, M_) != 0) continue;
            result_.shift = shift;
            return true;
        }
        return false;
    }

    Pencil pencil() {
        return {pattern_, M_, shifted_.values(), shifted_.solver(), Pencil::InnerProduct::of_a};
    }
    Eigen::Index found() const { return pairs_.values.size(); }
    double eigenvalue(Eigen::Index i) const { return result_.shift + 1.0 / pairs_.values[i]; }

    // So near to rigid motions as the first shift is, these drown the vibrations in round-off: about as far
    // from them as the lowest vibration is, they do not. How far that is, is known better each time.
    void search_from_good_shift(int wanted) {
        constexpr int most = 8;
        search_more(wanted);
        for (int i = 0; i < most && found() > 0; ++i) {
            const double size = -result_.shift;
            // A shift that had to pass negative eigenvalues lies far from the others anyway.
            if (i == 0 && size > -64.0 * first_shift_) return;
            if (eigenvalue(0) > 3.0 * size) return;
            Eigen::Index vibration = 0;
            while (vibration < found() && eigenvalue(vibration) <= 3.0 * size) ++vibration;
            if (vibration == found()) {
                if (search_more(2)) continue;
                // Vibrations may be so fast that nothing is left of their θ.
                if (1e4 * size > scale_ || !find_shift_from(1e4 * result_.shift)) return;
            } else if (eigenvalue(vibration) <= 30.0 * size || !find_shift_from(-eigenvalue(vibration))) {
                return;
            }
            pairs_ = {};
            search_more(wanted);
        }
    }

    // Adds so many of the lowest that are not known yet; false if there are no more.
    bool search_more(int wanted) {
        LanczosSettings settings;
        settings.wanted = wanted;
        settings.block = found() > 0 ? std::clamp(wanted, 2, 8) : 2;
        EigenPairs more = find_largest(pencil(), settings, pairs_.vectors);
        pairs_.exhausted = more.exhausted;
        if (more.values.size() == 0) return false;
        const double largest = std::max(more.values[0], found() > 0 ? pairs_.values[0] : 0.0);
        Eigen::Index usable = 0;
        while (usable < more.values.size() && more.values[usable] > no_inertia * largest) ++usable;
        if (usable == 0) return false;
        more.values.conservativeResize(usable);
        more.vectors.conservativeResize(Eigen::NoChange, usable);
        merge(more, pairs_);
        return true;
    }

    // Between the last eigenvalue that is wanted, with its copies, and the next one.
    double find_gap(int count) const {
        const Eigen::Index last = found() - 1;
        const auto distance = [&](Eigen::Index i) { return 1.0 / pairs_.values[i]; };
        for (Eigen::Index i = std::clamp<Eigen::Index>(count - 1, 0, last); i < last; ++i) {
            if (distance(i + 1) - distance(i) > near * distance(i + 1)) {
                return result_.shift + 0.5 * (distance(i) + distance(i + 1));
            }
        }
        return eigenvalue(last) + (pairs_.exhausted ? 0.5 : near) * distance(last);
    }

    void count_below(double limit) {
        if (result_.counted < 0 || limit != result_.limit) result_.counted = counter_.count(K_, -limit, M_);
        result_.limit = limit;
        result_.found = 0;
        while (result_.found < found() && eigenvalue(result_.found) < limit) ++result_.found;
    }

    // Each vector by one more application of the operator, which frees it of parts without inertia: (V6).
    void finish(Eigen::Index count) {
        result_.is_all = pairs_.exhausted && count == found();
        result_.values.resize(count);
        result_.residuals.resize(count);
        result_.vectors.resize(pattern_.size(), count);
        const Pencil pencil = this->pencil();
        VectorXd image, y, y_image, rest;
        for (Eigen::Index i = 0; i < count; ++i) {
            const VectorXd x = pairs_.vectors.col(i);
            pencil.compute_image(x, image);
            pencil.apply(x, image, y);
            pencil.compute_image(y, y_image);
            const double square = y.dot(y_image);
            const double theta = y.dot(image) / x.dot(image);
            result_.values[i] = result_.shift + y.dot(image) / square;
            rest = y - theta * x;
            pencil.compute_image(rest, image);
            result_.residuals[i] = std::sqrt(std::max(0.0, rest.dot(image)) / square);
            for (Eigen::Index k = 0; k < i; ++k) {
                y -= result_.vectors.col(k).dot(y_image) * result_.vectors.col(k);
            }
            pencil.compute_image(y, y_image);
            result_.vectors.col(i) = y / std::sqrt(y.dot(y_image));
        }
    }

    const SparsePattern& pattern_;
    const std::vector<double>& K_;
    const std::vector<double>& M_;
    EigenvalueCount shifted_, counter_;
    double scale_ = 0.0, first_shift_ = 0.0;
    EigenPairs pairs_;  // of θ = 1 / (μ − shift)
    LowestPairs result_;
};

}  // namespace

std::optional<LowestPairs> find_lowest_pairs(const SparsePattern& pattern,
                                             const std::vector<double>& K,
                                             const std::vector<double>& M,
                                             int count,
                                             std::optional<double> below,
                                             const ThreadTeam& team,
                                             std::int64_t multipliers) {
    LowestSearch search(pattern, K, M, team, multipliers);
    if (!search.find_shift()) return std::nullopt;
    return search.find(count, below);
}

}  // namespace gxrod
