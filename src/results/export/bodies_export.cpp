#include "results/export/bodies_export.hpp"

#include <numeric>
#include <stdexcept>
#include <string>

#include "machine/file_error.hpp"
#include "results/export/frame_copy.hpp"
#include "results/file/results_access.hpp"
#include "rotation/rotation_map.hpp"

namespace gxrod {
namespace {

using BodyNumbers = std::vector<std::int64_t>;

constexpr std::uint8_t vtk_line = 3, vtk_triangle = 5;

BodyNumbers read_body_numbers(const Hdf5Reader& file, const std::string& dataset) {
    BodyNumbers numbers;
    for (const double number : file.numbers("/bodies/" + dataset))
        numbers.push_back(static_cast<std::int64_t>(number));
    return numbers;
}

// Numbers from 0 to `rows`, or it is an error of the file.
void check_body_rows(const BodyNumbers& numbers, std::int64_t rows, const char* dataset) {
    for (const std::int64_t number : numbers) {
        if (number < 0 || number > rows)
            throw std::runtime_error(std::string("/bodies/") + dataset + " has numbers of no row");
    }
}

// The outlines of all bodies as they are in the file.
struct FileOutlines {
    BodyNumbers nodes, first_point, first_triangle, first_line, triangles, lines;
    std::vector<double> corners;

    explicit FileOutlines(const Hdf5Reader& file)
        : nodes(read_body_numbers(file, "point")),
          first_point(read_body_numbers(file, "outline_offsets")),
          first_triangle(read_body_numbers(file, "triangle_offsets")),
          first_line(read_body_numbers(file, "line_offsets")),
          triangles(read_body_numbers(file, "triangles")),
          lines(read_body_numbers(file, "lines")),
          corners(file.numbers("/bodies/outline")) {
        const std::int64_t last = count_points() - 1;
        check_body_rows(nodes, static_cast<std::int64_t>(file.count("/VTKHDF/NumberOfPoints")) - 1, "point");
        check_body_rows(triangles, last, "triangles");
        check_body_rows(lines, last, "lines");
        check_body_rows(first_point, last + 1, "outline_offsets");
        for (const BodyNumbers* first : {&first_point, &first_triangle, &first_line}) {
            if (first->size() != nodes.size() + 1) throw std::runtime_error("/bodies is incomplete");
        }
    }

    std::int64_t count_points() const { return static_cast<std::int64_t>(corners.size() / 3); }
};

// The cells of all frames: triangles, then lines.
void add_outline_cells(const FileOutlines& outlines, FrameCopy& copies) {
    BodyNumbers connectivity = outlines.triangles, offsets{0}, bodies;
    connectivity.insert(connectivity.end(), outlines.lines.begin(), outlines.lines.end());
    std::vector<std::uint8_t> types;
    const auto add = [&](const BodyNumbers& first, std::int64_t corners, std::uint8_t type) {
        for (std::size_t body = 0; body + 1 < first.size(); ++body) {
            for (std::int64_t cell = first[body]; cell < first[body + 1]; ++cell) {
                offsets.push_back(offsets.back() + corners);
                types.push_back(type);
                bodies.push_back(static_cast<std::int64_t>(body));
            }
        }
    };
    add(outlines.first_triangle, 3, vtk_triangle);
    add(outlines.first_line, 2, vtk_line);
    if (offsets.back() != static_cast<std::int64_t>(connectivity.size()))
        throw std::runtime_error("/bodies is incomplete");
    const auto count = [&](const char* name, std::size_t number) {
        copies.push_back(make_copy(std::string("/VTKHDF/") + name,
                                   "of a frame",
                                   {1},
                                   BodyNumbers{static_cast<std::int64_t>(number)}));
    };
    count("NumberOfPoints", static_cast<std::size_t>(outlines.count_points()));
    count("NumberOfCells", types.size());
    count("NumberOfConnectivityIds", connectivity.size());
    copies.push_back(
        make_copy("/VTKHDF/Connectivity", "points of each cell", {connectivity.size()}, connectivity));
    copies.push_back(
        make_copy("/VTKHDF/Offsets", "where each cell begins in Connectivity", {offsets.size()}, offsets));
    copies.push_back(make_copy("/VTKHDF/Types", "5 triangles, 3 lines", {types.size()}, types));
    copies.push_back(make_copy("/VTKHDF/CellData/body", "row of /bodies", {bodies.size()}, bodies));
}

std::vector<float> place_corners(const Hdf5Reader& file, const FileOutlines& outlines, hsize_t frames) {
    const auto nodes = static_cast<hsize_t>(file.count("/VTKHDF/NumberOfPoints"));
    std::vector<float> points;
    for (hsize_t frame = 0; frame < frames; ++frame) {
        for (std::size_t body = 0; body < outlines.nodes.size(); ++body) {
            const hsize_t row = frame * nodes + static_cast<hsize_t>(outlines.nodes[body]);
            const std::vector<double> place = file.rows("/VTKHDF/Points", row, 1, 3);
            const std::vector<double> turn = file.rows("/VTKHDF/PointData/rotation_vector", row, 1, 3);
            const Quat rotation = exp_quaternion(Vec3(turn.data()));
            for (auto i = static_cast<std::size_t>(outlines.first_point[body]);
                 i < static_cast<std::size_t>(outlines.first_point[body + 1]);
                 ++i) {
                const Vec3 point = Vec3(place.data()) + rotation * Vec3(outlines.corners.data() + 3 * i);
                for (const double x : point) points.push_back(static_cast<float>(x));
            }
        }
    }
    return points;
}

void add_outline_steps(const Hdf5Reader& file, std::int64_t points, hsize_t frames, FrameCopy& copies) {
    const auto add =
        [&](const char* name, const char* description, hsize_t columns, const BodyNumbers& values) {
            std::vector<hsize_t> size{frames};
            if (columns > 0) size.push_back(columns);
            copies.push_back(
                make_copy(std::string("/VTKHDF/Steps/") + name, description, std::move(size), values));
        };
    const BodyNumbers none(frames, 0);
    BodyNumbers first(frames, points);
    std::exclusive_scan(first.begin(), first.end(), first.begin(), std::int64_t{0});
    copies.push_back(copy_rows(file, "/VTKHDF/Steps/Values", 0, frames));
    add("PartOffsets", "the only part", 0, none);
    add("NumberOfParts", "parts of each frame: 1", 0, BodyNumbers(frames, 1));
    add("PointOffsets", "first point of each frame", 0, first);
    add("CellOffsets", "cells are those of all frames", 1, none);
    add("ConnectivityIdOffsets", "cells are those of all frames", 1, none);
    add("CellDataOffsets/body", "cells are those of all frames", 0, none);
}

FrameCopy read_bodies(const Hdf5Reader& file, hsize_t frames) {
    const FileOutlines outlines(file);
    FrameCopy copies;
    add_outline_cells(outlines, copies);
    const std::vector<float> points = place_corners(file, outlines, frames);
    copies.push_back(
        make_copy("/VTKHDF/Points", "corners, frame after frame", {points.size() / 3, 3}, points));
    copies.back().label.frame = "spatial";
    copies.back().label.dimension = "length";
    add_outline_steps(file, outlines.count_points(), frames, copies);
    return copies;
}

}  // namespace

std::filesystem::path export_bodies(const std::filesystem::path& results,
                                    const std::filesystem::path& folder,
                                    Existing existing) {
    FrameCopy copies;
    std::int64_t frames = 0;
    read_results(results, [&](const Hdf5Reader& file) {
        frames = static_cast<std::int64_t>(file.numbers("/VTKHDF/Steps/Values").size());
        if (frames == 0) throw FileError(results, "has no frame yet");
        if (!file.has("/bodies/outline"))
            throw FileError(results, "has no outlines of bodies", "its deck has no [body.NAME]");
        copies = read_bodies(file, static_cast<hsize_t>(frames));
    });
    std::filesystem::path path = folder / "bodies.vtkhdf";
    prepare_export(folder, {path}, existing);
    write_copies(copies, {"UnstructuredGrid", 2, frames}, path);
    return path;
}

}  // namespace gxrod
