#include "results/export/contacts_export.hpp"

#include <algorithm>
#include <numeric>
#include <stdexcept>
#include <string>

#include "machine/file_error.hpp"
#include "results/export/frame_copy.hpp"
#include "results/file/results_access.hpp"

namespace gxrod {

namespace {

using Integers = std::vector<std::int64_t>;

constexpr hsize_t cell_kinds = 4;

Integers count_from(std::int64_t first, std::size_t count) {
    Integers numbers(count);
    std::iota(numbers.begin(), numbers.end(), first);
    return numbers;
}

// Numbers of what stands before each frame.
Integers add_up(const Integers& counts) {
    Integers before{0};
    for (const std::int64_t count : counts) before.push_back(before.back() + count);
    before.pop_back();
    return before;
}

// A vertex for each point. A frame without points has a vertex without points: VTK 9.7 takes frames that
// start at the same cell for one.
Integers count_vertices(const Integers& points) {
    Integers counts = points;
    for (std::int64_t& count : counts) count = std::max<std::int64_t>(count, 1);
    return counts;
}

// A frame is a part: its cells number its own points.
void add_cells(const Integers& points, FrameCopy& copies) {
    const auto add =
        [&](const char* kind, const char* name, const char* description, const Integers& values) {
            copies.push_back(
                make_copy(std::string("/VTKHDF/") + kind + "/" + name, description, {values.size()}, values));
        };
    Integers connectivity, offsets;
    for (const std::int64_t count : points) {
        const auto ends = count_from(0, static_cast<std::size_t>(count) + 1);
        connectivity.insert(connectivity.end(), ends.begin(), ends.end() - 1);
        offsets.insert(offsets.end(), ends.begin(), ends.end());
        if (count == 0) offsets.push_back(0);
    }
    const Integers none(points.size(), 0);
    for (const char* kind : {"Vertices", "Lines", "Polygons", "Strips"}) {
        const bool has_cells = kind == std::string("Vertices");
        add(kind, "NumberOfCells", "cells of each frame", has_cells ? count_vertices(points) : none);
        add(kind, "NumberOfConnectivityIds", "points of these cells", has_cells ? points : none);
        add(kind, "Connectivity", "point of each cell, in its frame", has_cells ? connectivity : Integers());
        add(kind, "Offsets", "where each cell begins in Connectivity", has_cells ? offsets : none);
    }
}

// Of a table with a row for each frame and a column for each kind of cells; contacts have vertices alone.
Integers in_first_column(const Integers& values) {
    Integers table;
    for (const std::int64_t value : values) {
        for (hsize_t kind = 0; kind < cell_kinds; ++kind) table.push_back(kind == 0 ? value : 0);
    }
    return table;
}

void add_steps(const Hdf5Reader& file, const Integers& points, FrameCopy& copies) {
    const hsize_t frames = points.size();
    const auto add =
        [&](const std::string& name, const char* description, const Integers& values, hsize_t columns) {
            std::vector<hsize_t> size{frames};
            if (columns > 1) size.push_back(columns);
            copies.push_back(make_copy("/VTKHDF/Steps/" + name, description, std::move(size), values));
        };
    copies.push_back(copy_rows(file, "/VTKHDF/Steps/Values", 0, frames));
    add("PartOffsets", "the part of each frame", count_from(0, frames), 1);
    add("NumberOfParts", "parts of each frame: 1", Integers(frames, 1), 1);
    add("PointOffsets", "first point of each frame", add_up(points), 1);
    add("CellOffsets",
        "first cell of each frame",
        in_first_column(add_up(count_vertices(points))),
        cell_kinds);
    add("ConnectivityIdOffsets",
        "where each frame begins in Connectivity",
        in_first_column(add_up(points)),
        cell_kinds);
}

FrameCopy read_contacts(const Hdf5Reader& file, hsize_t frames) {
    Integers offsets;
    for (const double one : file.rows("/contacts/offsets", 0, frames + 1, 1))
        offsets.push_back(static_cast<std::int64_t>(one));
    Integers counts(frames);
    for (std::size_t f = 0; f < frames; ++f) counts[f] = offsets[f + 1] - offsets[f];
    if (offsets[0] != 0 || std::ranges::any_of(counts, [](std::int64_t count) { return count < 0; }))
        throw std::runtime_error("/contacts/offsets do not rise from 0");
    const auto touches = static_cast<hsize_t>(offsets.back());

    FrameCopy copies;
    copies.push_back(make_copy("/VTKHDF/NumberOfPoints", "points of each frame", {frames}, counts));
    add_cells(counts, copies);
    add_steps(file, counts, copies);
    copies.push_back(copy_rows(file, "/contacts/point", 0, touches));
    copies.back().path = "/VTKHDF/Points";
    for (const std::string name : {"normal_force", "friction_force", "gap", "slides", "rods", "places"}) {
        copies.push_back(copy_rows(file, "/contacts/" + name, 0, touches));
        copies.back().path = "/VTKHDF/PointData/" + name;
        copies.push_back(make_copy(
            "/VTKHDF/Steps/PointDataOffsets/" + name, "first point of each frame", {frames}, add_up(counts)));
    }
    return copies;
}

}  // namespace

std::filesystem::path export_contacts(const std::filesystem::path& results,
                                      const std::filesystem::path& folder,
                                      Existing existing) {
    FrameCopy copies;
    std::int64_t frames = 0;
    read_results(results, [&](const Hdf5Reader& file) {
        frames = static_cast<std::int64_t>(file.numbers("/VTKHDF/Steps/Values").size());
        if (frames == 0) throw FileError(results, "has no frame yet");
        if (!file.has("/contacts/offsets"))
            throw FileError(results, "has no contacts", "its deck has neither [contact] nor [obstacle.NAME]");
        copies = read_contacts(file, static_cast<hsize_t>(frames));
    });
    std::filesystem::path path = folder / "contacts.vtkhdf";
    prepare_export(folder, {path}, existing);
    write_copies(copies, {"PolyData", 2, frames}, path);
    return path;
}

}  // namespace gxrod
