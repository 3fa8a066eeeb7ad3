#include "results/chunk_check.hpp"

#include <libdeflate.h>

#include <cstddef>
#include <cstdint>
#include <memory>
#include <new>
#include <vector>

#include "results/hdf5_objects.hpp"

namespace gxrod {
namespace {

// What a filter makes of a chunk, as far as its length goes.
enum class Packing { none, deflate, unknown };

Packing read_packing(const Hdf5Handle& properties) {
    Packing packing = Packing::none;
    const int filters = H5Pget_nfilters(properties.id());
    for (int i = 0; i < filters; ++i) {
        unsigned flags = 0, configuration = 0;
        std::size_t values = 0;
        const H5Z_filter_t filter = H5Pget_filter2(
            properties.id(), static_cast<unsigned>(i), &flags, &values, nullptr, 0, nullptr, &configuration);
        if (filter == H5Z_FILTER_SHUFFLE) continue;
        if (filter != H5Z_FILTER_DEFLATE || packing != Packing::none) return Packing::unknown;
        packing = Packing::deflate;
    }
    return packing;
}

struct FreeInflater {
    void operator()(libdeflate_decompressor* inflater) const { libdeflate_free_decompressor(inflater); }
};

// The chunks of a dataset, by the place of their first value.
class ChunkCheck {
  public:
    ChunkCheck(hid_t dataset, const Hdf5Handle& properties)
        : dataset_(dataset), packing_(read_packing(properties)), extent_(extent_of(dataset)) {
        size_.resize(extent_.size());
        const auto rank = static_cast<int>(size_.size());
        if (H5Pget_chunk(properties.id(), rank, size_.data()) != rank) throw Hdf5Error("the size of chunks");
        const Hdf5Handle type(H5Dget_type(dataset), H5Tclose, "type");
        bytes_ = static_cast<double>(H5Tget_size(type.id()));
        for (const hsize_t length : size_) bytes_ *= static_cast<double>(length);
        const Hdf5Handle space(H5Dget_space(dataset), H5Sclose, "dataspace");
        check_hdf5(H5Dget_num_chunks(dataset, space.id(), &count_), "counting chunks");
        const Hdf5Handle file(H5Iget_file_id(dataset), H5Fclose, "file of a dataset");
        check_hdf5(H5Fget_filesize(file.id(), &file_bytes_), "size of the file");
    }

    bool is_sound(const std::function<void()>& come_along) {
        if (count_ == 0) return true;
        if (packing_ == Packing::unknown) return false;
        if (packing_ == Packing::none)
            return static_cast<double>(H5Dget_storage_size(dataset_)) == static_cast<double>(count_) * bytes_;
        std::vector<hsize_t> place(extent_.size(), 0);
        hsize_t seen = 0;
        do {
            hsize_t stored = 0;
            // There is none, or no reader comes to it.
            if (H5Dget_chunk_storage_size(dataset_, place.data(), &stored) < 0 || stored == 0) continue;
            come_along();
            if (!is_sound(place, stored)) return false;
            ++seen;
        } while (seen < count_ && advance(place));
        return true;
    }

  private:
    // To the next chunk; false after the last.
    bool advance(std::vector<hsize_t>& place) const {
        for (std::size_t i = place.size(); i-- > 0;) {
            place[i] += size_[i];
            if (place[i] < extent_[i]) return true;
            place[i] = 0;
        }
        return false;
    }

    bool is_sound(const std::vector<hsize_t>& place, hsize_t stored) {
        if (stored > file_bytes_ || bytes_ > most_inflated * static_cast<double>(stored)) return false;
        if (!inflater_) throw std::bad_alloc();
        stored_.resize(stored);
        std::uint32_t skipped = 0;
        check_hdf5(H5Dread_chunk(dataset_, H5P_DEFAULT, place.data(), &skipped, stored_.data()),
                   "reading a chunk");
        // Where deflate had no memory, HDF5 keeps a chunk as it is.
        if (skipped != 0) return static_cast<double>(stored) == bytes_;
        inflated_.resize(static_cast<std::size_t>(bytes_));
        const libdeflate_result result = libdeflate_zlib_decompress(
            inflater_.get(), stored_.data(), stored_.size(), inflated_.data(), inflated_.size(), nullptr);
        return result == LIBDEFLATE_SUCCESS || result == LIBDEFLATE_BAD_DATA;  // HDF5 tells of the latter
    }

    hid_t dataset_;
    Packing packing_;
    std::vector<hsize_t> extent_, size_;
    double bytes_ = 0.0;  // of a whole chunk
    hsize_t count_ = 0, file_bytes_ = 0;
    std::unique_ptr<libdeflate_decompressor, FreeInflater> inflater_{libdeflate_alloc_decompressor()};
    std::vector<std::byte> stored_, inflated_;
};

}  // namespace

bool has_sound_chunks(hid_t dataset, const std::function<void()>& come_along) {
    const Hdf5Handle properties(H5Dget_create_plist(dataset), H5Pclose, "properties of a dataset");
    if (H5Pget_layout(properties.id()) != H5D_CHUNKED) return true;
    return ChunkCheck(dataset, properties).is_sound(come_along);
}

}  // namespace gxrod
