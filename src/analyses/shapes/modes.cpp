#include "analyses/shapes/modes.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "analyses/shapes/mode_name.hpp"
#include "analyses/shapes/shape_measures.hpp"
#include "assembly/small_motions.hpp"
#include "assembly/state_matrices.hpp"
#include "check/motions/stability.hpp"
#include "linear/eigen/lowest_pairs.hpp"

namespace gxrod {

namespace {

constexpr double cycle = 2.0 * std::numbers::pi;
// Frequencies so near are copies of one, relative to their distance from the shift.
constexpr double same = 1e-7;
// What is out of balance within Newton's tolerance makes less of K unsymmetric.
constexpr double most_unsymmetry = 1e-6;
// Of a frequency: what rigid motions have of ω² is round-off.
constexpr double round_off = 1e-9;

bool is_at_rest(const State& state) {
    return std::all_of(state.trial.begin(), state.trial.end(), [](const NodeMotion& motion) {
        return motion.v.isZero(0.0) && motion.a.isZero(0.0) && motion.omega.isZero(0.0) &&
               motion.alpha.isZero(0.0);
    });
}

class ModeFinder {
  public:
    ModeFinder(const System& system, const State& state, double time)
        : system_(system),
          state_(state),
          time_(time),
          matrices_(compute_state_matrices(system, state, time)) {}

    ModesRecord find(const ModesSettings& settings) {
        record_.time = time_;
        record_.cause = find_load_without_potential(system_.model());
        if (record_.cause.empty() && !is_at_rest(state_)) record_.cause = "the state moves";
        const SparsePattern& pattern = system_.pattern();
        std::optional<double> below;
        if (settings.below) below = std::pow(cycle * *settings.below, 2);
        const auto found = find_lowest_pairs(
            pattern,
            record_.cause.empty() ? matrices_.stiffness : make_symmetric(pattern, matrices_.stiffness),
            matrices_.mass,
            settings.count,
            below,
            system_.team(),
            system_.equations().attached_count());
        if (!found) {
            record_.failure = "nothing that moves has inertia";
            return record_;
        }
        pairs_ = *found;
        inertia_ = compute_whole_inertia(system_, state_, time_);
        take_over_count();
        align_copies();
        measure_unsymmetry();
        for (Eigen::Index i = 0; i < pairs_.values.size(); ++i) {
            if (is_held(i)) {
                leave_out(i);
            } else {
                add_mode(i);
            }
        }
        if (record_.modes.empty() && pairs_.values.size() > 0)
            record_.failure = "joints and supports hold all that has inertia";
        record_.total_mass = inertia_.total;
        for (int axis = 0; axis < 6; ++axis) {
            if (inertia_.total[axis] > 0.0) record_.effective_share[axis] /= inertia_.total[axis];
        }
        return record_;
    }

  private:
    void take_over_count() {
        record_.limit = pairs_.limit;
        record_.counted = pairs_.counted;
        record_.found = pairs_.found;
        record_.is_complete = pairs_.complete();
        record_.is_all = pairs_.is_all;
    }

    double distance(Eigen::Index i) const { return pairs_.values[i] - pairs_.shift; }

    void align_copies() {
        for (Eigen::Index first = 0; first < pairs_.values.size();) {
            Eigen::Index last = first + 1;
            while (last < pairs_.values.size() && distance(last) - distance(last - 1) < same * distance(last))
                ++last;
            align(first, last - first);
            first = last;
        }
    }

    // An orthogonal mixture of copies: the first takes all that they have to do with the motion along x, the
    // next what is left along y, and so on; the rest as they come.
    void align(Eigen::Index first, Eigen::Index count) {
        auto copies = pairs_.vectors.middleCols(first, count);
        Eigen::MatrixXd candidates(count, 6 + count);
        for (int axis = 0; axis < 6; ++axis) {
            const double total = inertia_.total[axis];
            candidates.col(axis) = copies.transpose() * inertia_.forces[axis];
            if (total > 0.0) candidates.col(axis) /= std::sqrt(total);
        }
        candidates.rightCols(count).setIdentity();
        constexpr double some = 1e-4;
        Eigen::MatrixXd mixture(count, count);
        Eigen::Index chosen = 0;
        for (Eigen::Index i = 0; i < candidates.cols() && chosen < count; ++i) {
            Eigen::VectorXd candidate = candidates.col(i);
            for (int pass = 0; pass < 2; ++pass) {
                const auto known = mixture.leftCols(chosen);
                candidate -= known * (known.transpose() * candidate);
            }
            if (candidate.norm() < some) continue;
            mixture.col(chosen++) = candidate.normalized();
        }
        copies = (copies * mixture).eval();
    }

    void measure_unsymmetry() {
        if (record_.cause.empty()) return;
        const Eigen::Index count = pairs_.values.size();
        Eigen::MatrixXd projected(count, count);
        Eigen::VectorXd product;
        for (Eigen::Index i = 0; i < count; ++i) {
            multiply(system_.pattern(), matrices_.stiffness, pairs_.vectors.col(i), product);
            projected.col(i) = pairs_.vectors.transpose() * product;
        }
        for (Eigen::Index i = 0; i < count; ++i) {
            for (Eigen::Index j = 0; j < i; ++j) {
                const double scale = std::max(std::abs(pairs_.values[i]), std::abs(pairs_.values[j]));
                if (scale == 0.0) continue;
                record_.unsymmetry =
                    std::max(record_.unsymmetry, std::abs(projected(i, j) - projected(j, i)) / scale);
            }
        }
        record_.is_symmetric = record_.unsymmetry < most_unsymmetry;
        if (record_.is_symmetric) record_.cause.clear();
    }

    // Whether joints hold the motion, so that only their equations yield.
    bool is_held(Eigen::Index i) const {
        return pairs_.values[i] > round_off * pairs_.shift &&
               measure_gap_share(system_, matrices_.stiffness, pairs_.vectors.col(i)) > 0.5;
    }

    // Where the fastest one found is held, all motions of the model are slower.
    void leave_out(Eigen::Index i) {
        if (i + 1 == pairs_.values.size()) record_.is_all = true;
        if (pairs_.values[i] >= record_.limit) return;
        --record_.found;
        if (record_.counted > 0) --record_.counted;
    }

    void add_mode(Eigen::Index i) {
        Mode mode;
        mode.omega_squared = pairs_.values[i];
        mode.omega = std::sqrt(std::max(0.0, mode.omega_squared));
        mode.growth = std::sqrt(std::max(0.0, -mode.omega_squared));
        mode.frequency = mode.omega / cycle;
        mode.residual = pairs_.residuals[i];
        const Eigen::VectorXd vector = pairs_.vectors.col(i);
        for (int axis = 0; axis < 6; ++axis)
            mode.effective_mass[axis] = std::pow(vector.dot(inertia_.forces[axis]), 2);
        mode.shape = make_shape(system_, state_, vector);
        mode.shape.words = name_mode(system_, state_, mode.shape);
        record_.effective_share += mode.effective_mass;
        if (mode.omega_squared < round_off * pairs_.shift) ++record_.unstable;
        record_.modes.push_back(std::move(mode));
    }

    const System& system_;
    const State& state_;
    double time_;
    StateMatrices matrices_;
    LowestPairs pairs_;
    WholeInertia inertia_;
    ModesRecord record_;
};

}  // namespace

ModesRecord find_modes(const System& system, const State& state, double time, const ModesSettings& settings) {
    const SmallMotions small(system, settings.linearization);
    ModesRecord record = ModeFinder(small.system(), state, time).find(settings);
    record.linearization = settings.linearization;
    return record;
}

}  // namespace gxrod
