#include "results/append_dataset.hpp"

#include <algorithm>
#include <array>
#include <type_traits>

namespace gxrod {
namespace {

template <class Number>
hid_t disk_type() {
    if constexpr (std::is_same_v<Number, double>)
        return H5T_IEEE_F64LE;
    else
        return H5T_STD_I64LE;
}

template <class Number>
hid_t memory_type() {
    if constexpr (std::is_same_v<Number, double>)
        return H5T_NATIVE_DOUBLE;
    else
        return H5T_NATIVE_INT64;
}

}  // namespace

template <class Number>
AppendDataset<Number>::AppendDataset(const Hdf5Handle& group,
                                     const DatasetLabel& label,
                                     RowShape shape,
                                     std::size_t chunk_bytes)
    : shape_(shape) {
    const auto columns = static_cast<hsize_t>(shape.columns);
    const int rank = shape.is_vector ? 2 : 1;
    const std::array<hsize_t, 2> size{0, columns};
    const std::array<hsize_t, 2> limit{H5S_UNLIMITED, columns};
    const std::array<hsize_t, 2> chunk{std::max<hsize_t>(1, chunk_bytes / (columns * sizeof(Number))),
                                       columns};

    const Hdf5Handle space(H5Screate_simple(rank, size.data(), limit.data()), H5Sclose, "dataspace");
    const Hdf5Handle properties(H5Pcreate(H5P_DATASET_CREATE), H5Pclose, "dataset properties");
    check_hdf5(H5Pset_chunk(properties.id(), rank, chunk.data()), "chunks");
    check_hdf5(H5Pset_obj_track_times(properties.id(), false), "dataset properties");
    dataset_ = Hdf5Handle(H5Dcreate2(group.id(),
                                     label.name.c_str(),
                                     disk_type<Number>(),
                                     space.id(),
                                     H5P_DEFAULT,
                                     properties.id(),
                                     H5P_DEFAULT),
                          H5Dclose,
                          "creating a dataset");
    write_label(dataset_.id(), label);
}

template <class Number>
void AppendDataset<Number>::flush() {
    const auto columns = static_cast<hsize_t>(shape_.columns);
    const hsize_t new_rows = buffer_.size() / columns;
    if (new_rows == 0) return;

    const int rank = shape_.is_vector ? 2 : 1;
    const std::array<hsize_t, 2> size{rows_ + new_rows, columns};
    const std::array<hsize_t, 2> start{rows_, 0};
    const std::array<hsize_t, 2> count{new_rows, columns};
    check_hdf5(H5Dset_extent(dataset_.id(), size.data()), "extending a dataset");
    const Hdf5Handle on_disk(H5Dget_space(dataset_.id()), H5Sclose, "dataspace");
    check_hdf5(
        H5Sselect_hyperslab(on_disk.id(), H5S_SELECT_SET, start.data(), nullptr, count.data(), nullptr),
        "selecting rows");
    const Hdf5Handle in_memory(H5Screate_simple(rank, count.data(), nullptr), H5Sclose, "dataspace");
    check_hdf5(
        H5Dwrite(
            dataset_.id(), memory_type<Number>(), in_memory.id(), on_disk.id(), H5P_DEFAULT, buffer_.data()),
        "writing rows");
    rows_ += new_rows;
    buffer_.clear();
}

template class AppendDataset<double>;
template class AppendDataset<std::int64_t>;

}  // namespace gxrod
