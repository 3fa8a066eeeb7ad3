#pragma once

#include <optional>
#include <vector>

#include "rotation/types.hpp"

namespace gxrod {

// Finds by which of many matrices A a vector x has the longest image A x. They are sorted into a tree of
// groups: images of a group are longer than that by its mean by r·|x| at most, where r has the largest
// distance of each column in the group. Most groups need no closer look.
class LongestImage {
  public:
    struct Image {
        int index;
        double length;
    };

    explicit LongestImage(std::vector<Mat6> matrices);

    // Returns the longest image that is longer than `floor`; of equal ones, up to round-off, that of the
    // first matrix.
    std::optional<Image> find(const Vec6& x, double floor) const;

  private:
    struct Group {
        Mat6 mean = Mat6::Zero();
        Vec6 radii = Vec6::Zero();  // of each column
        int first = 0, last = 0;    // in order_
        int left = -1, right = -1;  // groups; −1: none

        double bound(const Vec6& x) const { return (mean * x).norm() + radii.dot(x.cwiseAbs()); }
    };

    int build(int first, int last);

    std::vector<Mat6> matrices_;
    std::vector<int> order_;  // indices of matrices, group by group
    std::vector<Group> groups_;
};

}  // namespace gxrod
