#pragma once

#include <Eigen/Core>
#include <vector>

#include "linear/sparse_pattern.hpp"

namespace gxrod {

// A pattern with several copies of each unknown and equation of another one, all coupled to each other: for
// complex numbers, or for the stages of a step. Copies of a block are consecutive, so that blocks stay
// blocks.
class StackedPattern {
  public:
    // The pattern must outlive this.
    StackedPattern(const SparsePattern& pattern, int copies);

    const SparsePattern& pattern() const { return stacked_; }
    // Sets the entries of the equations of one copy and the unknowns of another to these values on the
    // original pattern, times `factor`.
    void set(int equations,
             int unknowns,
             const std::vector<double>& from,
             double factor,
             std::vector<double>& to) const;
    // Copy one copy of a vector into the stacked one and back.
    void set(int copy, const Eigen::VectorXd& from, Eigen::VectorXd& to) const;
    void get(int copy, const Eigen::VectorXd& from, Eigen::VectorXd& to) const;

  private:
    // The equations of a block: from `first`; in the stacked pattern from copies × first.
    struct Rows {
        std::int64_t first, count;
    };
    SparsePattern make_stacked();

    const SparsePattern* original_;
    std::int64_t copies_;
    std::vector<Rows> blocks_;
    SparsePattern stacked_;
};

}  // namespace gxrod
