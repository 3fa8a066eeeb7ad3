#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include "results/file/hdf5_handle.hpp"

namespace gxrod {

// Reads an HDF5 file through the library's own file driver, as any other program would, also while another
// program writes it. Throws Hdf5Error, and std::runtime_error if the file has something that gxrod does not
// write.
class Hdf5Reader {
  public:
    explicit Hdf5Reader(const std::filesystem::path& path);

    // Returns the size in each direction; empty for a scalar.
    std::vector<hsize_t> size(const std::string& dataset) const;
    // Returns the product of `extent`. Throws std::runtime_error if the file is too small for so many values.
    std::size_t count_values(const std::string& dataset, const std::vector<hsize_t>& extent) const;
    // Returns how many numbers a row has. Throws std::runtime_error if there are more than gxrod writes.
    hsize_t width(const std::string& dataset) const;
    // Returns all numbers, the last direction fastest.
    std::vector<double> numbers(const std::string& dataset) const;
    // Returns `count` rows from `first` on; all of them must exist.
    std::vector<double> rows(const std::string& dataset, hsize_t first, hsize_t count) const;
    // Returns the same rows, each of which must have `width` numbers.
    std::vector<double> rows(const std::string& dataset, hsize_t first, hsize_t count, hsize_t width) const;
    // Returns the first number, which must be an integer from 0 to the largest int.
    int count(const std::string& dataset) const;
    std::string text(const std::string& dataset) const;
    // Returns all texts of a list.
    std::vector<std::string> texts(const std::string& dataset) const;
    // Returns a dataset of bytes.
    std::string bytes(const std::string& dataset) const;
    // Return attributes of the object at `path`.
    std::string text_attribute(const std::string& path, const std::string& name) const;
    std::int64_t integer_attribute(const std::string& path, const std::string& name) const;
    // Returns a list of any length.
    std::vector<std::int64_t> integers_attribute(const std::string& path, const std::string& name) const;
    bool has_attribute(const std::string& path, const std::string& name) const;
    // Lists every dataset of the file by all of its names.
    std::vector<std::string> datasets() const;
    // Lists the names of all groups and datasets in a group.
    std::vector<std::string> members(const std::string& group) const;
    bool has(const std::string& path) const;
    hid_t id() const { return file_.id(); }

  private:
    Hdf5Handle open_dataset(const std::string& name) const;
    Hdf5Handle file_;
};

}  // namespace gxrod
