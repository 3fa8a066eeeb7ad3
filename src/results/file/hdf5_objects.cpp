#include "results/file/hdf5_objects.hpp"

#include <algorithm>
#include <array>
#include <stdexcept>

namespace gxrod {
namespace {

Hdf5Handle text_type() {
    Hdf5Handle type(H5Tcopy(H5T_C_S1), H5Tclose, "string type");
    check_hdf5(H5Tset_size(type.id(), H5T_VARIABLE), "string type");
    check_hdf5(H5Tset_cset(type.id(), H5T_CSET_UTF8), "string type");
    return type;
}

Hdf5Handle scalar_space() { return {H5Screate(H5S_SCALAR), H5Sclose, "scalar dataspace"}; }

Hdf5Handle list_space(hsize_t count) { return {H5Screate_simple(1, &count, nullptr), H5Sclose, "dataspace"}; }

void write_attribute(hid_t object,
                     const std::string& name,
                     const Hdf5Handle& type,
                     const Hdf5Handle& space,
                     const void* value) {
    const Hdf5Handle attribute(
        H5Acreate2(object, name.c_str(), type.id(), space.id(), H5P_DEFAULT, H5P_DEFAULT),
        H5Aclose,
        "creating an attribute");
    if (H5Sget_simple_extent_npoints(space.id()) == 0) return;
    check_hdf5(H5Awrite(attribute.id(), type.id(), value), "writing an attribute");
}

Hdf5Handle array_space(std::span<const hsize_t> size) {
    return {H5Screate_simple(static_cast<int>(size.size()), size.data(), nullptr), H5Sclose, "dataspace"};
}

// Without times of modification, so that equal runs give equal files.
Hdf5Handle creation_properties() {
    Hdf5Handle properties(H5Pcreate(H5P_DATASET_CREATE), H5Pclose, "dataset properties");
    check_hdf5(H5Pset_obj_track_times(properties.id(), false), "dataset properties");
    return properties;
}

// A small buffer for converting texts: the library's own, a megabyte, takes a millisecond to clear.
Hdf5Handle transfer_properties() {
    constexpr std::size_t bytes = 65536;
    Hdf5Handle properties(H5Pcreate(H5P_DATASET_XFER), H5Pclose, "transfer properties");
    check_hdf5(H5Pset_buffer(properties.id(), bytes, nullptr, nullptr), "transfer properties");
    return properties;
}

Hdf5Handle create_dataset(const Hdf5Handle& group,
                          const DatasetLabel& label,
                          hid_t type,
                          const Hdf5Handle& space) {
    const Hdf5Handle properties = creation_properties();
    Hdf5Handle dataset(
        H5Dcreate2(
            group.id(), label.name.c_str(), type, space.id(), H5P_DEFAULT, properties.id(), H5P_DEFAULT),
        H5Dclose,
        "creating a dataset");
    write_label(dataset.id(), label);
    return dataset;
}

void write_dataset(const Hdf5Handle& group,
                   const DatasetLabel& label,
                   hid_t type,
                   const Hdf5Handle& space,
                   const void* values) {
    const Hdf5Handle dataset = create_dataset(group, label, type, space);
    const Hdf5Handle transfer = transfer_properties();
    check_hdf5(H5Dwrite(dataset.id(), type, H5S_ALL, H5S_ALL, transfer.id(), values), "writing a dataset");
}

}  // namespace

bool has_link(const Hdf5Handle& group, const std::string& name) {
    return H5Lexists(group.id(), name.c_str(), H5P_DEFAULT) > 0;
}

Hdf5Handle require_group(const Hdf5Handle& parent, const std::string& name) {
    if (has_link(parent, name)) {
        return {H5Gopen2(parent.id(), name.c_str(), H5P_DEFAULT), H5Gclose, "opening a group"};
    }
    return {H5Gcreate2(parent.id(), name.c_str(), H5P_DEFAULT, H5P_DEFAULT, H5P_DEFAULT),
            H5Gclose,
            "creating a group"};
}

void link_dataset(hid_t dataset, const Hdf5Handle& group, const std::string& name) {
    if (has_link(group, name)) return;
    check_hdf5(H5Olink(dataset, group.id(), name.c_str(), H5P_DEFAULT, H5P_DEFAULT), "linking a dataset");
}

void write_attribute(hid_t object, const std::string& name, const std::string& text) {
    const char* value = text.c_str();
    write_attribute(object, name, text_type(), scalar_space(), &value);
}

void remove_attribute(hid_t object, const std::string& name) {
    check_hdf5(H5Adelete(object, name.c_str()), "removing an attribute");
}

void write_fixed_attribute(hid_t object, const std::string& name, const std::string& text) {
    const Hdf5Handle type(H5Tcopy(H5T_C_S1), H5Tclose, "string type");
    check_hdf5(H5Tset_size(type.id(), text.size()), "string type");
    check_hdf5(H5Tset_strpad(type.id(), H5T_STR_NULLPAD), "string type");
    write_attribute(object, name, type, scalar_space(), text.data());
}

void write_attribute(hid_t object, const std::string& name, std::span<const std::int64_t> values) {
    const Hdf5Handle type(H5Tcopy(H5T_STD_I64LE), H5Tclose, "integer type");
    write_attribute(object, name, type, list_space(values.size()), values.data());
}

void write_attribute(hid_t object, const std::string& name, double value) {
    const Hdf5Handle type(H5Tcopy(H5T_IEEE_F64LE), H5Tclose, "number type");
    write_attribute(object, name, type, scalar_space(), &value);
}

void write_label(hid_t dataset, const DatasetLabel& label) {
    write_attribute(dataset, "description", label.description);
    write_attribute(dataset, "frame", label.frame);
    if (!label.dimension.empty()) write_attribute(dataset, "dimension", label.dimension);
}

void write_dataset(const Hdf5Handle& group, const DatasetLabel& label, const std::string& text) {
    const char* value = text.c_str();
    write_dataset(group, label, text_type().id(), scalar_space(), &value);
}

void write_dataset(const Hdf5Handle& group, const DatasetLabel& label, std::span<const std::string> texts) {
    std::vector<const char*> pointers;
    for (const std::string& text : texts) pointers.push_back(text.c_str());
    write_dataset(group, label, text_type().id(), list_space(texts.size()), pointers.data());
}

void write_dataset(const Hdf5Handle& group, const DatasetLabel& label, std::span<const double> values) {
    write_dataset(group, label, H5T_IEEE_F64LE, list_space(values.size()), values.data());
}

void write_dataset(const Hdf5Handle& group, const DatasetLabel& label, std::span<const std::int64_t> values) {
    write_dataset(group, label, H5T_STD_I64LE, list_space(values.size()), values.data());
}

void write_dataset(const Hdf5Handle& group, const DatasetLabel& label, std::span<const std::uint8_t> values) {
    write_dataset(group, label, H5T_STD_U8LE, list_space(values.size()), values.data());
}

void write_dataset(const Hdf5Handle& group,
                   const DatasetLabel& label,
                   std::span<const hsize_t> size,
                   std::span<const double> values) {
    write_dataset(group, label, H5T_IEEE_F64LE, array_space(size), values.data());
}

void write_dataset(const Hdf5Handle& group,
                   const DatasetLabel& label,
                   std::span<const hsize_t> size,
                   std::span<const std::int64_t> values) {
    write_dataset(group, label, H5T_STD_I64LE, array_space(size), values.data());
}

void write_compressed(const Hdf5Handle& group,
                      const DatasetLabel& label,
                      hsize_t columns,
                      std::span<const float> values) {
    const std::array<hsize_t, 2> size{values.size() / columns, columns};
    const std::array<hsize_t, 2> chunk{std::clamp<hsize_t>(size[0], 1, 1024), columns};
    const Hdf5Handle space = array_space(size);
    const Hdf5Handle properties = creation_properties();
    check_hdf5(H5Pset_chunk(properties.id(), 2, chunk.data()), "chunks");
    check_hdf5(H5Pset_shuffle(properties.id()), "compression");
    check_hdf5(H5Pset_deflate(properties.id(), 1), "compression");
    const Hdf5Handle dataset(H5Dcreate2(group.id(),
                                        label.name.c_str(),
                                        H5T_IEEE_F32LE,
                                        space.id(),
                                        H5P_DEFAULT,
                                        properties.id(),
                                        H5P_DEFAULT),
                             H5Dclose,
                             "creating a dataset");
    write_label(dataset.id(), label);
    check_hdf5(H5Dwrite(dataset.id(), H5T_NATIVE_FLOAT, H5S_ALL, H5S_ALL, H5P_DEFAULT, values.data()),
               "writing a dataset");
}

Hdf5Handle create_dataset(const Hdf5Handle& group,
                          const DatasetLabel& label,
                          hid_t type,
                          std::span<const hsize_t> size) {
    return create_dataset(group, label, type, array_space(size));
}

Hdf5Handle create_dataset(const Hdf5Handle& group, const DatasetLabel& label, hsize_t rows, hsize_t columns) {
    return create_dataset(group, label, H5T_IEEE_F64LE, std::array{rows, columns});
}

std::vector<std::string> list_members(hid_t group) {
    H5G_info_t information;
    check_hdf5(H5Gget_info(group, &information), "listing a group");
    std::vector<std::string> names;
    for (hsize_t i = 0; i < information.nlinks; ++i) {
        const auto get = [&](char* name, std::size_t size) {
            return H5Lget_name_by_idx(group, ".", H5_INDEX_NAME, H5_ITER_INC, i, name, size, H5P_DEFAULT);
        };
        const auto length = static_cast<std::size_t>(std::max<ssize_t>(get(nullptr, 0), 0));
        std::string name(length + 1, '\0');
        get(name.data(), name.size());
        name.resize(length);
        names.push_back(name);
    }
    return names;
}

std::vector<hsize_t> extent_of(hid_t dataset) {
    const Hdf5Handle space(H5Dget_space(dataset), H5Sclose, "dataspace");
    const int rank = H5Sget_simple_extent_ndims(space.id());
    if (rank < 0) throw Hdf5Error("the size of a dataset");
    std::vector<hsize_t> extent(static_cast<std::size_t>(rank));
    H5Sget_simple_extent_dims(space.id(), extent.data(), nullptr);
    return extent;
}

bool grows(hid_t dataset) {
    const Hdf5Handle space(H5Dget_space(dataset), H5Sclose, "dataspace");
    std::vector<hsize_t> most(extent_of(dataset).size());
    H5Sget_simple_extent_dims(space.id(), nullptr, most.data());
    return !most.empty() && most[0] == H5S_UNLIMITED;
}

std::optional<hsize_t> find_last_chunk(hid_t dataset) {
    const Hdf5Handle space(H5Dget_space(dataset), H5Sclose, "dataspace");
    hsize_t chunks = 0;
    check_hdf5(H5Dget_num_chunks(dataset, space.id(), &chunks), "counting chunks");
    if (chunks == 0) return std::nullopt;
    std::array<hsize_t, H5S_MAX_RANK> first{};
    check_hdf5(H5Dget_chunk_info(dataset, space.id(), chunks - 1, first.data(), nullptr, nullptr, nullptr),
               "looking at a chunk");
    return first[0];
}

double most_bytes_of(hid_t object) {
    constexpr double always_fine = 1e8;
    constexpr double most_inflated = 1100.0;  // bytes that deflate makes of one
    const Hdf5Handle file(H5Iget_file_id(object), H5Fclose, "file of an object");
    hsize_t file_bytes = 0;
    check_hdf5(H5Fget_filesize(file.id(), &file_bytes), "the file's size");
    return always_fine + most_inflated * static_cast<double>(file_bytes);
}

std::string read_string(const Hdf5Handle& type, const std::function<herr_t(hid_t, void*)>& read) {
    if (H5Tis_variable_str(type.id()) > 0) {
        char* text = nullptr;
        check_hdf5(read(type.id(), &text), "reading a string");
        std::string result = text ? text : "";
        H5free_memory(text);
        return result;
    }
    // What is read in the type of the file; no text of another kind is that long.
    constexpr std::size_t most = 1 << 20;
    const std::size_t size = H5Tget_size(type.id());
    if (H5Tget_class(type.id()) != H5T_STRING || size > most)
        throw std::runtime_error("a text has another type, or is too long");
    std::string text(size, '\0');
    check_hdf5(read(type.id(), text.data()), "reading a string");
    return text;
}

std::string read_text_attribute(hid_t object, const std::string& name) {
    const Hdf5Handle attribute(H5Aopen(object, name.c_str(), H5P_DEFAULT), H5Aclose, "opening an attribute");
    const Hdf5Handle type(H5Aget_type(attribute.id()), H5Tclose, "type");
    return read_string(
        type, [&](hid_t memory_type, void* buffer) { return H5Aread(attribute.id(), memory_type, buffer); });
}

}  // namespace gxrod
