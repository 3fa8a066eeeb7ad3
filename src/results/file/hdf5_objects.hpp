#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "results/file/hdf5_handle.hpp"

// Groups, attributes and datasets of a results file. All throw Hdf5Error.
namespace gxrod {

// What the attributes of a dataset say about it.
struct DatasetLabel {
    std::string name;
    std::string description;
    std::string frame = "none";  // "spatial", "material", "axes of POINT" or "none"
    std::string dimension;       // "force·length"; "1" for plain numbers
};

bool has_link(const Hdf5Handle& group, const std::string& name);
// The group of that name, new if there is none.
Hdf5Handle require_group(const Hdf5Handle& parent, const std::string& name);

// Another name for a dataset, unless the group has it already.
void link_dataset(hid_t dataset, const Hdf5Handle& group, const std::string& name);

// What a group has, groups and datasets, by name.
std::vector<std::string> list_members(hid_t group);

// Size of a dataset in each direction; empty for a scalar.
std::vector<hsize_t> extent_of(hid_t dataset);

// Whether rows can be appended to a dataset.
bool grows(hid_t dataset);

// The first row of the last chunk; nullopt if there is no chunk.
std::optional<hsize_t> find_last_chunk(hid_t dataset);

// The most bytes that a dataset, or another object, can have in its file: deflate makes at most a thousand
// bytes of one. Small files can have rows that were never written.
double most_bytes_of(hid_t object);

// The most texts that a dataset has.
inline constexpr std::size_t most_texts = std::size_t{1} << 16;
// A string of any kind; `read` reads it as a type into a buffer.
std::string read_string(const Hdf5Handle& type, const std::function<herr_t(hid_t, void*)>& read);
std::string read_text_attribute(hid_t object, const std::string& name);

// A variable-length UTF-8 string, which h5py reads as str.
void write_attribute(hid_t object, const std::string& name, const std::string& text);
// A string of exactly its own length, as VTK demands of /VTKHDF@Type.
void write_fixed_attribute(hid_t object, const std::string& name, const std::string& text);
void write_attribute(hid_t object, const std::string& name, std::span<const std::int64_t> values);
void write_attribute(hid_t object, const std::string& name, double value);
void remove_attribute(hid_t object, const std::string& name);
// Replaces an attribute. Writing over a text would free it in HDF5 1.14, in a write before that of what
// refers to it, and a kill between the two would leave a file that cannot be read.
template <class Value>
void rewrite_attribute(hid_t object, const std::string& name, const Value& value) {
    remove_attribute(object, name);
    write_attribute(object, name, value);
}
void write_label(hid_t dataset, const DatasetLabel& label);

// Datasets that are written once.
void write_dataset(const Hdf5Handle& group, const DatasetLabel& label, const std::string& text);
void write_dataset(const Hdf5Handle& group, const DatasetLabel& label, std::span<const std::string> texts);
void write_dataset(const Hdf5Handle& group, const DatasetLabel& label, std::span<const double> values);
void write_dataset(const Hdf5Handle& group, const DatasetLabel& label, std::span<const std::int64_t> values);
void write_dataset(const Hdf5Handle& group, const DatasetLabel& label, std::span<const std::uint8_t> values);
// An array of this size in each direction.
void write_dataset(const Hdf5Handle& group,
                   const DatasetLabel& label,
                   std::span<const hsize_t> size,
                   std::span<const double> values);
// Of doubles, not yet written.
Hdf5Handle create_dataset(const Hdf5Handle& group, const DatasetLabel& label, hsize_t rows, hsize_t columns);

}  // namespace gxrod
