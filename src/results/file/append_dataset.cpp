#include "results/file/append_dataset.hpp"

#include <algorithm>
#include <array>
#include <limits>
#include <optional>
#include <stdexcept>
#include <type_traits>

#include "results/file/ordered_driver.hpp"

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

// Rows come one after the other, so holding two chunks is enough. HDF5 would hold all that fit into its
// cache: the memory of a run would grow for a million steps.
Hdf5Handle make_access(std::size_t chunk_bytes) {
    Hdf5Handle access(H5Pcreate(H5P_DATASET_ACCESS), H5Pclose, "dataset properties");
    check_hdf5(
        H5Pset_chunk_cache(
            access.id(), H5D_CHUNK_CACHE_NSLOTS_DEFAULT, 2 * std::min(chunk_bytes, most_chunk_bytes), 1.0),
        "the cache of chunks");
    return access;
}

struct ChunkForm {
    hsize_t rows = 1;
    std::size_t bytes = 0;  // 0: no chunks
};

ChunkForm read_chunk_form(const Hdf5Handle& group, const std::string& name) {
    const Hdf5Handle dataset(H5Dopen2(group.id(), name.c_str(), H5P_DEFAULT), H5Dclose, "opening a dataset");
    const Hdf5Handle properties(H5Dget_create_plist(dataset.id()), H5Pclose, "dataset properties");
    const Hdf5Handle type(H5Dget_type(dataset.id()), H5Tclose, "type of a dataset");
    std::array<hsize_t, 2> chunk{1, 1};
    if (H5Pget_chunk(properties.id(), static_cast<int>(chunk.size()), chunk.data()) < 0) return {};
    return {std::max<hsize_t>(1, chunk[0]), chunk[0] * chunk[1] * H5Tget_size(type.id())};
}

// Rows up to the end of the last chunk on disk.
hsize_t find_chunk_end(const Hdf5Handle& dataset, const ChunkForm& chunk) {
    if (chunk.bytes == 0) return 0;
    const std::optional<hsize_t> last = find_last_chunk(dataset.id());
    return last ? *last + chunk.rows : 0;
}

// Rows of a dataset on disk, and as many in memory.
struct RowSelection {
    Hdf5Handle on_disk, in_memory;

    RowSelection(const Hdf5Handle& dataset, RowShape shape, hsize_t first, hsize_t rows)
        : on_disk(H5Dget_space(dataset.id()), H5Sclose, "dataspace") {
        const std::array<hsize_t, 2> start{first, 0};
        const std::array<hsize_t, 2> count{rows, static_cast<hsize_t>(shape.columns)};
        check_hdf5(
            H5Sselect_hyperslab(on_disk.id(), H5S_SELECT_SET, start.data(), nullptr, count.data(), nullptr),
            "selecting rows");
        in_memory = Hdf5Handle(
            H5Screate_simple(shape.is_vector ? 2 : 1, count.data(), nullptr), H5Sclose, "dataspace");
    }
};

}  // namespace

template <class Number>
AppendDataset<Number>::AppendDataset(
    const Hdf5Handle& group, const DatasetLabel& label, RowShape shape, hsize_t rows, RowChunks chunks)
    : shape_(shape), rows_(rows) {
    if (has_link(group, label.name)) {
        open(group, label);
    } else {
        create(group, label, chunks);
        if (rows > 0) set_extent(rows);
    }
}

template <class Number>
void AppendDataset<Number>::open(const Hdf5Handle& group, const DatasetLabel& label) {
    const ChunkForm chunk = read_chunk_form(group, label.name);
    const Hdf5Handle access = make_access(chunk.bytes);
    dataset_ = Hdf5Handle(
        H5Dopen2(group.id(), label.name.c_str(), access.id()), H5Dclose, "opening a dataset to append to");
    const Hdf5Handle space(H5Dget_space(dataset_.id()), H5Sclose, "dataspace");
    std::array<hsize_t, 2> size{0, 1};
    const int rank = H5Sget_simple_extent_ndims(space.id());
    if (rank != (shape_.is_vector ? 2 : 1)) throw std::runtime_error(label.name + " has another shape");
    H5Sget_simple_extent_dims(space.id(), size.data(), nullptr);
    if (size[1] != static_cast<hsize_t>(shape_.columns) || size[0] < rows_) {
        throw std::runtime_error(label.name + " has another shape, or lacks rows");
    }
    // A process killed within trim() has cut off rows, but not all of their chunks yet.
    const hsize_t end = find_chunk_end(dataset_, chunk);
    extent_ = end < size[0] + chunk.rows ? size[0] : end;
}

template <class Number>
void AppendDataset<Number>::create(const Hdf5Handle& group, const DatasetLabel& label, RowChunks chunks) {
    const auto columns = static_cast<hsize_t>(shape_.columns);
    const int rank = shape_.is_vector ? 2 : 1;
    const std::array<hsize_t, 2> size{0, columns};
    const std::array<hsize_t, 2> limit{H5S_UNLIMITED, columns};
    constexpr hsize_t usual_bytes =
        text_heap_bytes - sizeof(Number);  // so that no chunk is taken for a heap of texts
    const hsize_t usual_rows = std::max<hsize_t>(1, usual_bytes / (columns * sizeof(Number)));
    const std::array<hsize_t, 2> chunk{chunks.rows > 0 ? chunks.rows : usual_rows, columns};

    const Hdf5Handle space(H5Screate_simple(rank, size.data(), limit.data()), H5Sclose, "dataspace");
    const Hdf5Handle properties(H5Pcreate(H5P_DATASET_CREATE), H5Pclose, "dataset properties");
    check_hdf5(H5Pset_chunk(properties.id(), rank, chunk.data()), "chunks");
    check_hdf5(H5Pset_obj_track_times(properties.id(), false), "dataset properties");
    if (chunks.is_deflated) {
        constexpr unsigned fastest = 1;
        check_hdf5(H5Pset_shuffle(properties.id()), "compression");
        check_hdf5(H5Pset_deflate(properties.id(), fastest), "compression");
    }
    const Hdf5Handle access = make_access(chunk[0] * chunk[1] * sizeof(Number));
    const Number missing =
        std::numeric_limits<Number>::has_quiet_NaN ? std::numeric_limits<Number>::quiet_NaN() : 0;
    check_hdf5(H5Pset_fill_value(properties.id(), memory_type<Number>(), &missing), "dataset properties");
    dataset_ = Hdf5Handle(H5Dcreate2(group.id(),
                                     label.name.c_str(),
                                     disk_type<Number>(),
                                     space.id(),
                                     H5P_DEFAULT,
                                     properties.id(),
                                     access.id()),
                          H5Dclose,
                          "creating a dataset");
    write_label(dataset_.id(), label);
}

template <class Number>
void AppendDataset<Number>::set_extent(hsize_t rows) {
    const std::array<hsize_t, 2> size{rows, static_cast<hsize_t>(shape_.columns)};
    check_hdf5(H5Dset_extent(dataset_.id(), size.data()), "extending a dataset");
    extent_ = rows;
}

template <class Number>
void AppendDataset<Number>::trim() {
    if (extent_ == rows_) return;
    set_extent(extent_);  // so that HDF5 visits all chunks
    set_extent(rows_);
}

template <class Number>
std::vector<Number> AppendDataset<Number>::last_row() const {
    std::vector<Number> row(rows_ > 0 ? static_cast<std::size_t>(shape_.columns) : 0);
    if (row.empty()) return row;
    const RowSelection selection(dataset_, shape_, rows_ - 1, 1);
    check_hdf5(H5Dread(dataset_.id(),
                       memory_type<Number>(),
                       selection.in_memory.id(),
                       selection.on_disk.id(),
                       H5P_DEFAULT,
                       row.data()),
               "reading a row");
    return row;
}

template <class Number>
void AppendDataset<Number>::flush() {
    const hsize_t new_rows = buffer_.size() / static_cast<hsize_t>(shape_.columns);
    if (new_rows == 0) return;
    if (rows_ + new_rows > extent_) set_extent(rows_ + new_rows);
    const RowSelection selection(dataset_, shape_, rows_, new_rows);
    check_hdf5(H5Dwrite(dataset_.id(),
                        memory_type<Number>(),
                        selection.in_memory.id(),
                        selection.on_disk.id(),
                        H5P_DEFAULT,
                        buffer_.data()),
               "writing rows");
    rows_ += new_rows;
    buffer_.clear();
}

template class AppendDataset<double>;
template class AppendDataset<std::int64_t>;

}  // namespace gxrod
