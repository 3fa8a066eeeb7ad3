#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <span>
#include <vector>

#include "linear/sparse_pattern.hpp"
#include "parallel/thread_team.hpp"

namespace gxrod {

// Entries of the inverse of a sparse matrix next to its diagonal, such as those of an element of a rod. The
// unknowns of each connected part lie in levels, by the least number of couplings from one of its ends; a
// level is coupled to itself and to its neighbours alone. With the Schur complements F of all levels before
// and B of all behind, the inverse of levels next to each other is that of K of these, with F of the first
// and B of the last.
class NearInverse {
  public:
    // The pattern must be symmetric.
    explicit NearInverse(const SparsePattern& pattern);

    // Of a level, unknowns at most: work grows with its third power.
    std::int64_t widest() const { return widest_; }

    void factorize(const std::vector<double>& values, const ThreadTeam& team);
    // The inverse at some unknowns, by blocks of those whose levels follow each other; zero between others.
    // After factorize() alone; not finite where a pivot vanished.
    Eigen::MatrixXd invert(std::span<const std::int64_t> unknowns) const;

  private:
    // An entry of a level's matrices, and its place among the values.
    struct Entry {
        std::int64_t slot;
        std::int32_t row, column;  // in the level, or from its size on in the next one
    };
    struct Level {
        std::int64_t size = 0;
        bool is_last = false;  // of its part
        std::vector<Entry> entries;
        Eigen::MatrixXd own, to_next, from_next;  // K of the level, with columns, or rows, of the next one
        Eigen::MatrixXd before, behind;           // F, B
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
    std::vector<Place> places_;       // of each unknown
    std::int64_t widest_ = 0;
};

}  // namespace gxrod
