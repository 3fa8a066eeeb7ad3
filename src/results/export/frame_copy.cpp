#include "results/export/frame_copy.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <cstdint>
#include <fstream>
#include <span>
#include <system_error>
#include <utility>

#include "machine/file_error.hpp"

namespace gxrod {
namespace {

Hdf5Handle open_dataset(hid_t file, const std::string& path) {
    return {H5Dopen2(file, path.c_str(), H5P_DEFAULT), H5Dclose, "opening a dataset"};
}

void read_rows(const Hdf5Handle& dataset, hsize_t first, DatasetCopy& copy) {
    const int rank = static_cast<int>(copy.size.size());
    std::vector<hsize_t> start(copy.size.size(), 0);
    start[0] = first;
    const Hdf5Handle space(H5Dget_space(dataset.id()), H5Sclose, "dataspace");
    check_hdf5(
        H5Sselect_hyperslab(space.id(), H5S_SELECT_SET, start.data(), nullptr, copy.size.data(), nullptr),
        "selecting rows");
    const Hdf5Handle memory(H5Screate_simple(rank, copy.size.data(), nullptr), H5Sclose, "dataspace");
    check_hdf5(H5Dread(dataset.id(), copy.type.id(), memory.id(), space.id(), H5P_DEFAULT, copy.bytes.data()),
               "reading rows");
}

// All datasets of a group with `rows` rows a frame, or `rows` rows for all frames.
void copy_data(
    const Hdf5Reader& file, const std::string& group, hsize_t frame, hsize_t rows, FrameCopy& copy) {
    for (const std::string& name : file.members(group)) {
        const std::string path = fmt::format("{}/{}", group, name);
        const bool is_of_all = !grows(open_dataset(file.id(), path).id());
        copy.push_back(copy_rows(file, path, is_of_all ? 0 : frame * rows, rows));
    }
}

// Creates the groups on the way to a dataset along with it.
Hdf5Handle make_groups_on_the_way() {
    Hdf5Handle properties(H5Pcreate(H5P_LINK_CREATE), H5Pclose, "link properties");
    check_hdf5(H5Pset_create_intermediate_group(properties.id(), 1), "link properties");
    return properties;
}

void write_copy(hid_t file, const DatasetCopy& copy) {
    const int rank = static_cast<int>(copy.size.size());
    const Hdf5Handle space(H5Screate_simple(rank, copy.size.data(), nullptr), H5Sclose, "dataspace");
    const Hdf5Handle creation(H5Pcreate(H5P_DATASET_CREATE), H5Pclose, "dataset properties");
    check_hdf5(H5Pset_obj_track_times(creation.id(), false), "dataset properties");
    const Hdf5Handle dataset(H5Dcreate2(file,
                                        copy.path.c_str(),
                                        copy.type.id(),
                                        space.id(),
                                        make_groups_on_the_way().id(),
                                        creation.id(),
                                        H5P_DEFAULT),
                             H5Dclose,
                             "creating a dataset");
    write_label(dataset.id(), copy.label);
    check_hdf5(H5Dwrite(dataset.id(), copy.type.id(), H5S_ALL, H5S_ALL, H5P_DEFAULT, copy.bytes.data()),
               "writing a dataset");
}

// A file in memory: if the library itself cannot write, it crashes when the program ends.
Hdf5Handle create_image() {
    constexpr std::size_t growth = 65536;
    const Hdf5Handle access(H5Pcreate(H5P_FILE_ACCESS), H5Pclose, "file properties");
    check_hdf5(H5Pset_fapl_core(access.id(), growth, false), "file properties");
    return {H5Fcreate("frame", H5F_ACC_TRUNC, H5P_DEFAULT, access.id()), H5Fclose, "creating a file"};
}

std::vector<char> image_of(const Hdf5Handle& file) {
    check_hdf5(H5Fflush(file.id(), H5F_SCOPE_LOCAL), "flushing");
    const ssize_t size = H5Fget_file_image(file.id(), nullptr, 0);
    std::vector<char> bytes(static_cast<std::size_t>(std::max<ssize_t>(size, 0)));
    if (size < 0 || H5Fget_file_image(file.id(), bytes.data(), bytes.size()) < 0) {
        throw Hdf5Error("making the file");
    }
    return bytes;
}

void write_step_count(const Hdf5Handle& file, std::int64_t steps) {
    const Hdf5Handle group(H5Gopen2(file.id(), "/VTKHDF/Steps", H5P_DEFAULT), H5Gclose, "opening a group");
    const Hdf5Handle space(H5Screate(H5S_SCALAR), H5Sclose, "scalar dataspace");
    const Hdf5Handle count(
        H5Acreate2(group.id(), "NSteps", H5T_STD_I64LE, space.id(), H5P_DEFAULT, H5P_DEFAULT),
        H5Aclose,
        "creating an attribute");
    check_hdf5(H5Awrite(count.id(), H5T_NATIVE_INT64, &steps), "counting the frames");
}

std::vector<char> make_image(const FrameCopy& copies, const VtkForm& form) {
    const Hdf5Handle file = create_image();
    for (const DatasetCopy& dataset : copies) write_copy(file.id(), dataset);
    const Hdf5Handle group(H5Gopen2(file.id(), "/VTKHDF", H5P_DEFAULT), H5Gclose, "opening a group");
    write_attribute(group.id(), "Version", std::array<std::int64_t, 2>{form.version, 0});
    write_fixed_attribute(group.id(), "Type", form.type);
    if (form.steps) write_step_count(file, *form.steps);
    return image_of(file);
}

template <class Number>
DatasetCopy copy_values(const std::string& path,
                        const std::string& description,
                        std::vector<hsize_t> size,
                        hid_t type,
                        const std::vector<Number>& values) {
    DatasetCopy copy;
    copy.path = path;
    copy.label = {path.substr(path.rfind('/') + 1), description, "none", "1"};
    copy.type = Hdf5Handle(H5Tcopy(type), H5Tclose, "type");
    copy.size = std::move(size);
    const auto bytes = std::as_bytes(std::span(values));
    copy.bytes.assign(bytes.begin(), bytes.end());
    return copy;
}

}  // namespace

DatasetCopy copy_rows(const Hdf5Reader& file, const std::string& path, hsize_t first, hsize_t count) {
    DatasetCopy copy;
    copy.path = path;
    copy.label = {path.substr(path.rfind('/') + 1),
                  file.text_attribute(path, "description"),
                  file.text_attribute(path, "frame"),
                  file.text_attribute(path, "dimension")};
    copy.size = file.size(path);
    if (first > copy.size.at(0) || count > copy.size[0] - first)
        throw std::runtime_error(path + " is too short");
    copy.size[0] = count;

    const Hdf5Handle dataset = open_dataset(file.id(), path);
    copy.type = Hdf5Handle(H5Dget_type(dataset.id()), H5Tclose, "type");
    const H5T_class_t kind = H5Tget_class(copy.type.id());
    if (kind != H5T_FLOAT && kind != H5T_INTEGER) throw std::runtime_error(path + " does not hold numbers");
    copy.bytes.resize(file.count_values(path, copy.size) * H5Tget_size(copy.type.id()));
    read_rows(dataset, first, copy);
    return copy;
}

DatasetCopy make_copy(const std::string& path,
                      const std::string& description,
                      std::vector<hsize_t> size,
                      const std::vector<std::int64_t>& values) {
    return copy_values(path, description, std::move(size), H5T_NATIVE_INT64, values);
}

DatasetCopy make_copy(const std::string& path,
                      const std::string& description,
                      std::vector<hsize_t> size,
                      const std::vector<float>& values) {
    return copy_values(path, description, std::move(size), H5T_NATIVE_FLOAT, values);
}

DatasetCopy make_copy(const std::string& path,
                      const std::string& description,
                      std::vector<hsize_t> size,
                      const std::vector<std::uint8_t>& values) {
    return copy_values(path, description, std::move(size), H5T_NATIVE_UINT8, values);
}

FrameCopy read_frame(const Hdf5Reader& results, hsize_t frame) {
    FrameCopy copy;
    for (const char* name :
         {"NumberOfPoints", "NumberOfCells", "NumberOfConnectivityIds", "Connectivity", "Offsets", "Types"}) {
        const std::string path = std::string("/VTKHDF/") + name;
        copy.push_back(copy_rows(results, path, 0, results.size(path).at(0)));
    }
    const auto points = static_cast<hsize_t>(results.count("/VTKHDF/NumberOfPoints"));
    const auto cells = static_cast<hsize_t>(results.count("/VTKHDF/NumberOfCells"));
    copy.push_back(copy_rows(results, "/VTKHDF/Points", frame * points, points));
    copy_data(results, "/VTKHDF/PointData", frame, points, copy);
    copy_data(results, "/VTKHDF/CellData", frame, cells, copy);
    return copy;
}

void write_copies(const FrameCopy& copies, const VtkForm& form, const std::filesystem::path& path) {
    std::vector<char> bytes;
    try {
        bytes = make_image(copies, form);
    } catch (const Hdf5Error& error) {  // if results were damaged: two fields of the same name, for example
        throw FileError(path, "cannot be made from the results", error.what());
    }
    std::ofstream out(path, std::ios::binary);
    out.write(bytes.data(), static_cast<std::streamsize>(bytes.size()));
    out.close();
    if (!out) throw FileError(path, "cannot be written", std::generic_category().message(errno));
}

}  // namespace gxrod
