#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "results/file/hdf5_handle.hpp"

// Functions for groups, attributes and datasets of a results file. All throw Hdf5Error.
namespace gxrod {

// The attributes of a dataset.
struct DatasetLabel {
    std::string name;
    std::string description;
    std::string frame = "none";  // "spatial", "material", "axes of POINT" or "none"
    std::string dimension;       // "force·length"; "1" for plain numbers
};

bool has_link(const Hdf5Handle& group, const std::string& name);
// Opens the group of that name, or creates it.
Hdf5Handle require_group(const Hdf5Handle& parent, const std::string& name);

// Gives a dataset another name, unless the group has it already.
void link_dataset(hid_t dataset, const Hdf5Handle& group, const std::string& name);

// Lists the names of all groups and datasets in a group.
std::vector<std::string> list_members(hid_t group);

// Returns the size of a dataset in each direction; empty for a scalar.
std::vector<hsize_t> extent_of(hid_t dataset);

// Returns whether rows can be appended to a dataset.
bool grows(hid_t dataset);

// Returns the first row of the last chunk; nullopt if there is no chunk.
std::optional<hsize_t> find_last_chunk(hid_t dataset);

// Returns the most bytes that a dataset or another object of this file can expand to: deflate makes at most a
// thousand bytes of one. Small files can have rows that were never written.
double most_bytes_of(hid_t object);

// Largest number of texts in a dataset.
inline constexpr std::size_t most_texts = std::size_t{1} << 16;
// Reads a string of any kind; `read` reads it as a type into a buffer.
std::string read_string(const Hdf5Handle& type, const std::function<herr_t(hid_t, void*)>& read);
std::string read_text_attribute(hid_t object, const std::string& name);

// Writes a variable-length UTF-8 string, which h5py reads as str.
void write_attribute(hid_t object, const std::string& name, const std::string& text);
// Writes a string of exactly its own length, as VTK requires for /VTKHDF@Type.
void write_fixed_attribute(hid_t object, const std::string& name, const std::string& text);
void write_attribute(hid_t object, const std::string& name, std::span<const std::int64_t> values);
void write_attribute(hid_t object, const std::string& name, double value);
void remove_attribute(hid_t object, const std::string& name);
// Replaces an attribute. If a text were written over, HDF5 1.14 would free the old one in an earlier write
// than its reference, and a kill between the two would leave a file that cannot be read.
template <class Value>
void rewrite_attribute(hid_t object, const std::string& name, const Value& value) {
    remove_attribute(object, name);
    write_attribute(object, name, value);
}
void write_label(hid_t dataset, const DatasetLabel& label);

// Write datasets that are written once.
void write_dataset(const Hdf5Handle& group, const DatasetLabel& label, const std::string& text);
void write_dataset(const Hdf5Handle& group, const DatasetLabel& label, std::span<const std::string> texts);
void write_dataset(const Hdf5Handle& group, const DatasetLabel& label, std::span<const double> values);
void write_dataset(const Hdf5Handle& group, const DatasetLabel& label, std::span<const std::int64_t> values);
void write_dataset(const Hdf5Handle& group, const DatasetLabel& label, std::span<const std::uint8_t> values);
// Writes an array of this size in each direction.
void write_dataset(const Hdf5Handle& group,
                   const DatasetLabel& label,
                   std::span<const hsize_t> size,
                   std::span<const double> values);
// Writes an array of integers of this size in each direction.
void write_dataset(const Hdf5Handle& group,
                   const DatasetLabel& label,
                   std::span<const hsize_t> size,
                   std::span<const std::int64_t> values);
// Writes rows of numbers of single precision, compressed.
void write_compressed(const Hdf5Handle& group,
                      const DatasetLabel& label,
                      hsize_t columns,
                      std::span<const float> values);
// Creates a dataset of this type and size in each direction, not yet written.
Hdf5Handle create_dataset(const Hdf5Handle& group,
                          const DatasetLabel& label,
                          hid_t type,
                          std::span<const hsize_t> size);
// Creates a dataset of doubles, not yet written.
Hdf5Handle create_dataset(const Hdf5Handle& group, const DatasetLabel& label, hsize_t rows, hsize_t columns);

}  // namespace gxrod
