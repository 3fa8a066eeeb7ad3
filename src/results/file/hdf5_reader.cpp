#include "results/file/hdf5_reader.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <numeric>
#include <stdexcept>

#include "machine/child_process.hpp"
#include "results/file/hdf5_objects.hpp"

namespace gxrod {
namespace {

void add_datasets(hid_t group, const std::string& path, std::vector<std::string>& names) {
    for (const std::string& name : list_members(group)) {
        const Hdf5Handle child(H5Oopen(group, name.c_str(), H5P_DEFAULT), H5Oclose, "opening an object");
        const std::string child_path = fmt::format("{}/{}", path, name);
        if (H5Iget_type(child.id()) == H5I_DATASET)
            names.push_back(child_path);
        else
            add_datasets(child.id(), child_path, names);
    }
}

}  // namespace

Hdf5Reader::Hdf5Reader(const std::filesystem::path& path) {
    silence_hdf5();
    if (H5Fis_hdf5(path.c_str()) == 0) throw std::runtime_error("it is not an HDF5 file");
    const Hdf5Handle access(H5Pcreate(H5P_FILE_ACCESS), H5Pclose, "file properties");
    check_hdf5(H5Pset_file_locking(access.id(), false, true), "file properties");
    file_ = Hdf5Handle(H5Fopen(path.c_str(), H5F_ACC_RDONLY, access.id()), H5Fclose, "opening a file");
}

Hdf5Handle Hdf5Reader::open_dataset(const std::string& name) const {
    restart_processor_clock();
    return {H5Dopen2(file_.id(), name.c_str(), H5P_DEFAULT), H5Dclose, name.c_str()};
}

std::vector<hsize_t> Hdf5Reader::size(const std::string& name) const {
    return extent_of(open_dataset(name).id());
}

hsize_t Hdf5Reader::width(const std::string& name) const {
    constexpr hsize_t most_numbers = 64;
    const std::vector<hsize_t> extent = size(name);
    const hsize_t width = extent.size() > 1 ? extent[1] : 1;
    if (width > most_numbers) throw std::runtime_error(fmt::format("{} has rows of {} numbers", name, width));
    return width;
}

std::vector<double> Hdf5Reader::numbers(const std::string& name) const {
    const std::vector<hsize_t> extent = size(name);
    return rows(name, 0, extent.empty() ? 1 : extent[0]);
}

std::size_t Hdf5Reader::count_values(const std::string& name, const std::vector<hsize_t>& extent) const {
    double bytes = sizeof(double);
    for (const hsize_t length : extent) bytes *= static_cast<double>(length);
    if (bytes > most_bytes_of(file_.id())) {
        throw std::runtime_error(
            fmt::format("{} would have {:.3g} bytes, more than its file can hold", name, bytes));
    }
    return std::accumulate(extent.begin(), extent.end(), std::size_t{1}, std::multiplies<>());
}

std::vector<double> Hdf5Reader::rows(const std::string& name, hsize_t first, hsize_t count) const {
    std::vector<hsize_t> extent = size(name);
    if (extent.empty()) extent = {1};
    if (first > extent[0] || count > extent[0] - first) throw std::runtime_error(name + " is too short");
    extent[0] = count;
    std::vector<double> values(count_values(name, extent));
    if (values.empty()) return values;

    const Hdf5Handle dataset = open_dataset(name);
    const Hdf5Handle space(H5Dget_space(dataset.id()), H5Sclose, "dataspace");
    std::vector<hsize_t> start(extent.size(), 0);
    start[0] = first;
    check_hdf5(H5Sselect_hyperslab(space.id(), H5S_SELECT_SET, start.data(), nullptr, extent.data(), nullptr),
               "selecting rows");
    const Hdf5Handle memory(
        H5Screate_simple(static_cast<int>(extent.size()), extent.data(), nullptr), H5Sclose, "dataspace");
    check_hdf5(H5Dread(dataset.id(), H5T_NATIVE_DOUBLE, memory.id(), space.id(), H5P_DEFAULT, values.data()),
               "reading numbers");
    return values;
}

std::vector<double> Hdf5Reader::rows(const std::string& name,
                                     hsize_t first,
                                     hsize_t count,
                                     hsize_t width) const {
    std::vector<double> values = rows(name, first, count);
    if (values.size() != count * width) throw std::runtime_error(name + " has rows of another width");
    return values;
}

int Hdf5Reader::count(const std::string& name) const {
    const double number = rows(name, 0, 1).at(0);
    const bool is_count =
        number >= 0.0 && number <= std::numeric_limits<int>::max() && number == std::floor(number);
    if (!is_count) throw std::runtime_error(fmt::format("{} is {}, which is not a count", name, number));
    return static_cast<int>(number);
}

std::string Hdf5Reader::text(const std::string& name) const {
    const Hdf5Handle dataset = open_dataset(name);
    const Hdf5Handle type(H5Dget_type(dataset.id()), H5Tclose, "type");
    return read_string(type, [&](hid_t memory_type, void* buffer) {
        return H5Dread(dataset.id(), memory_type, H5S_ALL, H5S_ALL, H5P_DEFAULT, buffer);
    });
}

std::vector<std::string> Hdf5Reader::texts(const std::string& name) const {
    const std::vector<hsize_t> extent = size(name);
    if (extent.size() != 1 || extent[0] > most_texts)
        throw std::runtime_error(name + " is not a list of texts");
    const Hdf5Handle dataset = open_dataset(name);
    const Hdf5Handle type(H5Dget_type(dataset.id()), H5Tclose, "type");
    if (H5Tis_variable_str(type.id()) <= 0) throw std::runtime_error(name + " is not a list of texts");
    std::vector<char*> texts(extent[0], nullptr);
    check_hdf5(H5Dread(dataset.id(), type.id(), H5S_ALL, H5S_ALL, H5P_DEFAULT, texts.data()),
               "reading texts");
    std::vector<std::string> result;
    for (char* text : texts) {
        result.emplace_back(text != nullptr ? text : "");
        H5free_memory(text);
    }
    return result;
}

std::string Hdf5Reader::bytes(const std::string& name) const {
    const std::vector<hsize_t> extent = size(name);
    if (extent.size() != 1) throw std::runtime_error(name + " is not a list of bytes");
    std::string bytes(count_values(name, extent), '\0');
    const Hdf5Handle dataset = open_dataset(name);
    check_hdf5(H5Dread(dataset.id(), H5T_NATIVE_UINT8, H5S_ALL, H5S_ALL, H5P_DEFAULT, bytes.data()),
               "reading bytes");
    return bytes;
}

std::string Hdf5Reader::text_attribute(const std::string& path, const std::string& name) const {
    const Hdf5Handle object(H5Oopen(file_.id(), path.c_str(), H5P_DEFAULT), H5Oclose, path.c_str());
    return read_text_attribute(object.id(), name);
}

std::int64_t Hdf5Reader::integer_attribute(const std::string& path, const std::string& name) const {
    const std::vector<std::int64_t> values = integers_attribute(path, name);
    if (values.size() != 1) throw std::runtime_error(path + "@" + name + " is not one value");
    return values[0];
}

std::vector<std::int64_t> Hdf5Reader::integers_attribute(const std::string& path,
                                                         const std::string& name) const {
    const Hdf5Handle attribute(
        H5Aopen_by_name(file_.id(), path.c_str(), name.c_str(), H5P_DEFAULT, H5P_DEFAULT),
        H5Aclose,
        "opening an attribute");
    const Hdf5Handle space(H5Aget_space(attribute.id()), H5Sclose, "dataspace");
    std::vector<std::int64_t> values(static_cast<std::size_t>(H5Sget_simple_extent_npoints(space.id())));
    if (values.empty()) return values;
    check_hdf5(H5Aread(attribute.id(), H5T_NATIVE_INT64, values.data()), "reading an attribute");
    return values;
}

bool Hdf5Reader::has_attribute(const std::string& path, const std::string& name) const {
    return H5Aexists_by_name(file_.id(), path.c_str(), name.c_str(), H5P_DEFAULT) > 0;
}

std::vector<std::string> Hdf5Reader::members(const std::string& name) const {
    const Hdf5Handle group(H5Gopen2(file_.id(), name.c_str(), H5P_DEFAULT), H5Gclose, "opening a group");
    return list_members(group.id());
}

bool Hdf5Reader::has(const std::string& path) const {
    // Each link on the way must exist before HDF5 can be asked for the next.
    for (std::size_t end = path.find('/', 1);; end = path.find('/', end + 1)) {
        const std::string part = path.substr(0, end);
        if (H5Lexists(file_.id(), part.c_str(), H5P_DEFAULT) <= 0) return false;
        if (end == std::string::npos) return true;
    }
}

std::vector<std::string> Hdf5Reader::datasets() const {
    std::vector<std::string> names;
    add_datasets(file_.id(), "", names);
    return names;
}

}  // namespace gxrod
