#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include "results/file/hdf5_handle.hpp"

namespace gxrod {

// Reads an HDF5 file through the library's own file driver, as any other program would, also while another
// program writes it. Throws Hdf5Error, and std::runtime_error where something is not what gxrod writes.
class Hdf5Reader {
  public:
    explicit Hdf5Reader(const std::filesystem::path& path);

    // Size in each direction; empty for a scalar.
    std::vector<hsize_t> size(const std::string& dataset) const;
    // The product of `extent`. Throws std::runtime_error if the file is too small for so many values.
    std::size_t count_values(const std::string& dataset, const std::vector<hsize_t>& extent) const;
    // How many numbers a row has. Throws std::runtime_error if they are more than gxrod writes.
    hsize_t width(const std::string& dataset) const;
    // All numbers, the last direction fastest.
    std::vector<double> numbers(const std::string& dataset) const;
    // `count` rows from `first` on; all of them must be there.
    std::vector<double> rows(const std::string& dataset, hsize_t first, hsize_t count) const;
    // The same; each row must have `width` numbers.
    std::vector<double> rows(const std::string& dataset, hsize_t first, hsize_t count, hsize_t width) const;
    // The first number, which must be an integer from 0 to the largest int.
    int count(const std::string& dataset) const;
    std::string text(const std::string& dataset) const;
    // All texts of a list.
    std::vector<std::string> texts(const std::string& dataset) const;
    // Of a dataset of bytes.
    std::string bytes(const std::string& dataset) const;
    // Attributes of the object at `path`.
    std::string text_attribute(const std::string& path, const std::string& name) const;
    std::int64_t integer_attribute(const std::string& path, const std::string& name) const;
    // A list of any length.
    std::vector<std::int64_t> integers_attribute(const std::string& path, const std::string& name) const;
    bool has_attribute(const std::string& path, const std::string& name) const;
    // Every dataset of the file, by all of its names.
    std::vector<std::string> datasets() const;
    // What a group has, groups and datasets, by name.
    std::vector<std::string> members(const std::string& group) const;
    bool has(const std::string& path) const;
    hid_t id() const { return file_.id(); }

  private:
    Hdf5Handle open_dataset(const std::string& name) const;
    Hdf5Handle file_;
};

}  // namespace gxrod
