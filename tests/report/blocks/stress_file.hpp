#pragma once

#include <filesystem>
#include <numeric>
#include <string>
#include <vector>

#include "results/file/hdf5_objects.hpp"

// A file with /sections and /envelopes alone, as a run with stresses writes them.
namespace gxrod::stress_file {

inline void write_rows(const Hdf5Handle& group,
                       const std::string& name,
                       hsize_t width,
                       const std::vector<double>& values) {
    const std::vector<hsize_t> size{values.size() / width, width};
    write_dataset(group,
                  {name, name, "none", "1"},
                  std::span<const hsize_t>(size).first(width > 1 ? 2 : 1),
                  std::span<const double>(values));
}

// A square of two triangles whose points, in order, are a corner, the middle of an edge, and three corners;
// its operator at point i is i + (0, …, 35)/36. The last point is singular.
inline void write_section(const Hdf5Handle& group, double last_corner) {
    write_attribute(group.id(), "source", "a square");
    const std::vector<std::string> layers{"steel"};
    write_dataset(group, {"layers", "layers", "none", "1"}, std::span<const std::string>(layers));
    write_rows(group, "cell_points", 3, {0, 2, 3, 0, 3, last_corner});
    write_rows(group, "points", 2, {0, 0, 0.5, 0, 1, 0, 1, 1, 0, 1});
    write_rows(group, "point_layer", 1, {0, 0, 0, 0, 0});
    write_rows(group, "is_singular", 1, {0, 0, 0, 0, 1});
    std::vector<double> operators;
    for (int point = 0; point < 5; ++point) {
        for (int i = 0; i < 36; ++i) operators.push_back(point + i / 36.0);
    }
    write_rows(group, "stress_operator", 36, operators);
}

// So many places on each of two rods. The von Mises stress grows along them and the exposure falls.
inline void write_envelopes(const Hdf5Handle& group, int places) {
    write_attribute(group.id(), "criterion", "von-mises");
    std::vector<double> rods, lengths, elements, growing, falling, points, forces;
    const int count = 2 * places;
    for (int i = 0; i < count; ++i) {
        rods.push_back(i < places ? 0 : 1);
        elements.push_back(i / 3);
        lengths.push_back(i % places);
        growing.push_back(i);
        falling.push_back(count - i);
        points.insert(points.end(), {0.1 * i, -0.1 * i});
        for (int j = 0; j < 6; ++j) forces.push_back(10 * i + j);
    }
    write_rows(group, "rod", 1, rods);
    write_rows(group, "element", 1, elements);
    write_rows(group, "arc_length", 1, lengths);
    write_rows(group, "section", 1, std::vector<double>(rods.size(), 0.0));
    for (const char* name : {"von_mises", "exposure"}) {
        const Hdf5Handle measure = require_group(group, name);
        write_rows(measure, "value", 1, name[0] == 'v' ? growing : falling);
        write_rows(measure, "time", 1, lengths);
        write_rows(measure, "point", 2, points);
        write_rows(measure, "layer", 1, std::vector<double>(rods.size(), 0.0));
        write_rows(measure, "resultants", 6, forces);
    }
}

inline void write(const std::filesystem::path& path, int sections, int places, double last_corner = 4) {
    const Hdf5Handle file(
        H5Fcreate(path.c_str(), H5F_ACC_TRUNC, H5P_DEFAULT, H5P_DEFAULT), H5Fclose, "creating a file");
    const Hdf5Handle list = require_group(file, "sections");
    std::vector<std::string> names;
    for (int i = 0; i < sections; ++i) {
        names.push_back("s" + std::to_string(i));
        write_section(require_group(list, std::to_string(i)), last_corner);
    }
    write_dataset(list, {"name", "names", "none", "1"}, std::span<const std::string>(names));
    write_envelopes(require_group(file, "envelopes"), places);
}

}  // namespace gxrod::stress_file
