#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <span>
#include <vector>

#include "linear/sparse_pattern.hpp"
#include "parallel/thread_team.hpp"

namespace gxrod {

// Computes entries of the inverse of a sparse matrix near its diagonal, such as those of an element of a rod.
// The unknowns of each connected part lie in levels, by the least number of couplings from one of its ends; a
// level is coupled only to itself and its neighbours. With the Schur complements F of all levels before and B
// of all behind, the inverse at adjacent levels is the inverse of their K, with F of the first and B of the
// last.
class NearInverse {
  public:
    // The pattern must be symmetric.
    explicit NearInverse(const SparsePattern& pattern);

    // The largest number of unknowns of a level: work grows with its third power.
    std::int64_t widest() const { return widest_; }

    void factorize(const std::vector<double>& values, const ThreadTeam& team);
    // Returns the inverse at some unknowns, by blocks of unknowns with adjacent levels; zero between others.
    // It needs factorize() only; not finite if a pivot vanished.
    Eigen::MatrixXd invert(std::span<const std::int64_t> unknowns) const;

  private:
    // An entry of a level's matrices, and its place among the values.
    struct Entry {
        std::int64_t slot;
        std::int32_t row, column;  // in the level; beyond its size, in the next level
    };
    struct Level {
        std::int64_t size = 0;
        bool is_last = false;  // last of its part
        std::vector<Entry> entries;
        Eigen::MatrixXd own, to_next,
            from_next;                   // K of the level, and its columns, or rows, for the next level
        Eigen::MatrixXd before, behind;  // F, B
    };
    struct Place {
        std::int32_t level, index;
    };

    void find_levels(const SparsePattern& pattern);
    void sort_entries(const SparsePattern& pattern);
    void factorize_part(const std::vector<double>& values, std::size_t first, std::size_t end);
    Eigen::MatrixXd invert_levels(std::size_t first,
                                  std::size_t last,
                                  std::span<const std::int64_t> columns) const;

    std::vector<Level> levels_;
    std::vector<std::size_t> parts_;  // the first level of each part, and the number of levels
    std::vector<Place> places_;       // for each unknown
    std::int64_t widest_ = 0;
};

}  // namespace gxrod
