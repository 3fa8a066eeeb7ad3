#include "results/structure_sum.hpp"

#include <algorithm>
#include <array>
#include <functional>
#include <stdexcept>
#include <string_view>

#include "machine/checksum.hpp"
#include "results/file_seal.hpp"
#include "results/object_walk.hpp"
#include "results/row_sums.hpp"

namespace gxrod {
namespace {

constexpr std::array<std::string_view, 5> changing_attributes = {
    "/@status", "/@reason", "/@reason_nodes", "/@warnings", "/VTKHDF/Steps@NSteps"};

// 0 stands for none.
std::uint32_t not_none(std::uint32_t sum) { return std::max<std::uint32_t>(sum, 1); }

class StructureSum {
  public:
    std::uint32_t compute(hid_t root) {
        ObjectWalk([this](hid_t object, const std::string& path, bool is_new) {
            add(path);
            if (is_new) add_object(object, path);
        }).walk(root, "/");
        const Hdf5Handle restart(H5Gopen2(root, "restart", H5P_DEFAULT), H5Gclose, "opening a group");
        add_header(restart.id());
        // A run that goes on writes there.
        const std::array<std::uint64_t, 1> seal{find_seal(restart)};
        sum_ = checksum(std::span<const std::uint64_t>(seal), sum_);
        return not_none(sum_);
    }

    // Of the attributes that StructureSum::compute leaves out, and of rows.
    std::uint32_t compute_end(hid_t root, const PlaceSums& rows) {
        sum_ = checksum(std::span<const std::uint32_t>(std::array{rows.steps, rows.frames}));
        for (const std::string_view full : changing_attributes) {
            const std::size_t at = full.find('@');
            const std::string path(full.substr(0, at)), name(full.substr(at + 1));
            const Hdf5Handle object(H5Oopen(root, path.c_str(), H5P_DEFAULT), H5Oclose, "opening an object");
            add_attribute(
                Hdf5Handle(H5Aopen(object.id(), name.c_str(), H5P_DEFAULT), H5Aclose, "opening an attribute"),
                std::string(full));
        }
        return not_none(sum_);
    }

  private:
    void add(std::string_view text) { sum_ = checksum(std::span<const char>(text), sum_); }

    void add_header(hid_t object) { sum_ = checksum(std::span<const hsize_t>(header_form(object)), sum_); }

    void add_object(hid_t object, const std::string& path) {
        H5O_info_t information{};
        // All of it, so that HDF5 goes along the leaves of its trees, as other programs do.
        check_hdf5(H5Oget_info2(object, &information, H5O_INFO_ALL), "looking at an object");
        sum_ = checksum(std::span<const unsigned>(&information.rc, 1), sum_);  // how many names it has
        // The root's header changes where a run ends at other nodes.
        if (path != "/") add_header(object);
        for (hsize_t i = 0; i < information.num_attrs; ++i) add_attribute_by_index(object, path, i);
        if (H5Iget_type(object) == H5I_DATASET) add_dataset(object);
    }

    void add_attribute_by_index(hid_t object, const std::string& path, hsize_t index) {
        const Hdf5Handle attribute(
            H5Aopen_by_idx(object, ".", H5_INDEX_NAME, H5_ITER_INC, index, H5P_DEFAULT, H5P_DEFAULT),
            H5Aclose,
            "opening an attribute");
        std::array<char, 64> name{};
        check_hdf5(H5Aget_name(attribute.id(), name.size(), name.data()) < 0 ? -1 : 0, "reading a name");
        const std::string full = path + "@" + name.data();
        if (std::find(changing_attributes.begin(), changing_attributes.end(), full) ==
            changing_attributes.end())
            add_attribute(attribute, full);
        else
            check_type(Hdf5Handle(H5Aget_type(attribute.id()), H5Tclose, "type").id(), full);
    }

    void add_attribute(const Hdf5Handle& attribute, const std::string& full) {
        add(full);
        const Hdf5Handle type(H5Aget_type(attribute.id()), H5Tclose, "type");
        const Hdf5Handle space(H5Aget_space(attribute.id()), H5Sclose, "dataspace");
        add_values(type, H5Sget_simple_extent_npoints(space.id()), full, [&](hid_t memory, void* values) {
            return H5Aread(attribute.id(), memory, values);
        });
    }

    // Texts, and attributes' numbers, of which there are few.
    void add_values(const Hdf5Handle& type,
                    hssize_t count,
                    const std::string& name,
                    const std::function<herr_t(hid_t, void*)>& read) {
        constexpr hssize_t most = 1 << 16;
        if (count < 0 || count > most) throw std::runtime_error(name + " has more values than gxrod writes");
        check_type(type.id(), name);
        if (count == 0) return;
        if (H5Tget_class(type.id()) == H5T_STRING) {
            if (count != 1) throw std::runtime_error(name + " is not one text");
            add(read_string(type, read));
            return;
        }
        const std::size_t bytes = H5Tget_size(type.id());
        std::vector<std::byte> values(static_cast<std::size_t>(count) * bytes);
        check_hdf5(read(type.id(), values.data()), "reading an attribute");
        sum_ = checksum(std::span<const std::byte>(values), sum_);
    }

    void add_dataset(hid_t dataset) {
        const Hdf5Handle type(H5Dget_type(dataset), H5Tclose, "type");
        const H5T_class_t kind = H5Tget_class(type.id());
        if (kind == H5T_STRING && H5Tis_variable_str(type.id()) > 0 && !extent_of(dataset).empty()) {
            for (const std::string& text : read_texts(dataset, "a list of texts")) {
                add(text);
                add(std::string_view("\0", 1));  // where one ends
            }
            return;
        }
        if (kind == H5T_STRING) {
            const Hdf5Handle space(H5Dget_space(dataset), H5Sclose, "dataspace");
            add_values(
                type, H5Sget_simple_extent_npoints(space.id()), "a text", [&](hid_t memory, void* values) {
                    return H5Dread(dataset, memory, H5S_ALL, H5S_ALL, H5P_DEFAULT, values);
                });
            return;
        }
        check_type(type.id(), "a dataset");
        const std::vector<hsize_t> extent = extent_of(dataset);
        const std::array<hsize_t, 3> form = {
            H5Tget_size(type.id()), extent.size(), extent.size() > 1 ? extent[1] : 1};
        sum_ = checksum(std::span<const hsize_t>(form), sum_);
        if (grows(dataset)) return;
        sum_ = sum_rows(dataset, {0, extent.empty() ? 1 : extent[0]}, sum_);
    }

    std::uint32_t sum_ = 0;
};

}  // namespace

std::uint32_t sum_structure(hid_t root) { return StructureSum().compute(root); }

std::uint32_t sum_end(hid_t root, const PlaceSums& rows) { return StructureSum().compute_end(root, rows); }

}  // namespace gxrod
