#include "results/row_sums.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <stdexcept>

#include "machine/checksum.hpp"
#include "results/hdf5_objects.hpp"

namespace gxrod {
namespace {

constexpr std::size_t most_piece_bytes = 1 << 20;

// Reads rows of a dataset in pieces.
class RowReading {
  public:
    explicit RowReading(hid_t dataset)
        : dataset_(dataset),
          type_(H5Dget_type(dataset), H5Tclose, "type of a dataset"),
          space_(H5Dget_space(dataset), H5Sclose, "dataspace"),
          extent_(extent_of(dataset)) {
        if (extent_.empty()) extent_ = {1};
        row_bytes_ = static_cast<double>(H5Tget_size(type_.id()));
        for (std::size_t i = 1; i < extent_.size(); ++i) row_bytes_ *= static_cast<double>(extent_[i]);
    }

    std::uint32_t sum(RowRange rows, std::uint32_t sum) const {
        if (rows.end > extent_[0]) throw std::runtime_error("a dataset lacks rows");
        check_room(rows);
        if (row_bytes_ == 0.0) return sum;
        const auto bytes = static_cast<std::size_t>(row_bytes_);
        const hsize_t most = std::max<hsize_t>(1, most_piece_bytes / bytes);
        std::vector<std::byte> piece;
        for (hsize_t first = rows.first; first < rows.end; first += most) {
            const hsize_t count = std::min(most, rows.end - first);
            piece.resize(count * bytes);
            read(first, count, piece.data());
            sum = checksum(std::span<const std::byte>(piece), sum);
        }
        return sum;
    }

  private:
    void check_room(RowRange rows) const {
        const double most = most_bytes_of(dataset_);
        if (row_bytes_ * static_cast<double>(rows.end) > most || row_bytes_ > most_piece_bytes) {
            throw std::runtime_error(fmt::format(
                "a dataset has {} rows of {:.3g} bytes, more than its file can hold", rows.end, row_bytes_));
        }
    }

    void read(hsize_t first, hsize_t count, std::byte* values) const {
        if (H5Sget_simple_extent_type(space_.id()) == H5S_SCALAR) {
            check_hdf5(H5Dread(dataset_, type_.id(), H5S_ALL, H5S_ALL, H5P_DEFAULT, values),
                       "reading a value");
            return;
        }
        std::vector<hsize_t> start(extent_.size(), 0), size = extent_;
        start[0] = first;
        size[0] = count;
        check_hdf5(
            H5Sselect_hyperslab(space_.id(), H5S_SELECT_SET, start.data(), nullptr, size.data(), nullptr),
            "selecting rows");
        const Hdf5Handle memory(
            H5Screate_simple(static_cast<int>(size.size()), size.data(), nullptr), H5Sclose, "dataspace");
        check_hdf5(H5Dread(dataset_, type_.id(), memory.id(), space_.id(), H5P_DEFAULT, values),
                   "reading rows");
    }

    hid_t dataset_;
    Hdf5Handle type_, space_;
    std::vector<hsize_t> extent_;
    double row_bytes_ = 0.0;
};

}  // namespace

std::uint32_t sum_rows(hid_t dataset, RowRange rows, std::uint32_t before) {
    return RowReading(dataset).sum(rows, before);
}

std::uint32_t combine(std::vector<RowSum> sums) {
    std::sort(
        sums.begin(), sums.end(), [](const RowSum& a, const RowSum& b) { return a.address < b.address; });
    std::uint32_t all = 0;
    for (const RowSum& one : sums) {
        all = checksum(std::span<const haddr_t>(&one.address, 1), all);
        all = checksum(std::span<const std::uint32_t>(&one.sum, 1), all);
    }
    return all;
}

}  // namespace gxrod
