#pragma once

#include <cstdint>
#include <span>
#include <string>

#include "results/hdf5_handle.hpp"

// Groups, attributes and datasets of a results file. All throw Hdf5Error.
namespace gxrod {

// What a dataset is, as its attributes tell a reader.
struct DatasetLabel {
    std::string name;
    std::string description;
    std::string frame = "none";  // "spatial", "material", "axes of POINT" or "none"
    std::string dimension;       // "force·length"; "1" for plain numbers
};

Hdf5Handle create_group(const Hdf5Handle& parent, const std::string& name);

// A variable-length UTF-8 string, which h5py reads as str.
void write_attribute(hid_t object, const std::string& name, const std::string& text);
// Writes over an attribute that exists.
void rewrite_attribute(hid_t object, const std::string& name, const std::string& text);
// A string of exactly its own length, as VTK demands of /VTKHDF@Type.
void write_fixed_attribute(hid_t object, const std::string& name, const std::string& text);
void write_attribute(hid_t object, const std::string& name, std::span<const std::int64_t> values);
// Replaces an attribute that exists; the number of values may change.
void rewrite_attribute(hid_t object, const std::string& name, std::span<const std::int64_t> values);
void write_label(hid_t dataset, const DatasetLabel& label);

// Datasets that are written once.
void write_dataset(const Hdf5Handle& group, const DatasetLabel& label, const std::string& text);
void write_dataset(const Hdf5Handle& group, const DatasetLabel& label, std::span<const std::int64_t> values);
void write_dataset(const Hdf5Handle& group, const DatasetLabel& label, std::span<const std::uint8_t> values);

}  // namespace gxrod
