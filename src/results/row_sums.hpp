#pragma once

#include <hdf5.h>

#include <cstdint>
#include <vector>

namespace gxrod {

// The checksum of the rows of a dataset that grows, which its address in the file stands for.
struct RowSum {
    haddr_t address = 0;
    std::uint32_t sum = 0;
};

// Rows of a dataset from `first` to before `end`.
struct RowRange {
    hsize_t first = 0;
    hsize_t end = 0;
};

// Their checksum, as they lie in the file, behind rows with the checksum `before`. A scalar is one row.
// Throws Hdf5Error, and std::runtime_error if the dataset lacks rows, or the file is too small for them.
std::uint32_t sum_rows(hid_t dataset, RowRange rows, std::uint32_t before = 0);

// One checksum of several datasets, in whatever order.
std::uint32_t combine(std::vector<RowSum> sums);

}  // namespace gxrod
