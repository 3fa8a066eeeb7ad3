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

Integers count_from(std::int64_t first, std::size_t count) {
    Integers numbers(count);
    std::iota(numbers.begin(), numbers.end(), first);
    return numbers;
}

// Every frame has as many of the vertices 0, 1 … as it has points.
void add_cells(const Integers& counts, FrameCopy& copies) {
    const std::int64_t most = *std::ranges::max_element(counts);
    const hsize_t frames = counts.size();
    for (const char* kind : {"Vertices", "Lines", "Polygons", "Strips"}) {
        const bool has_points = kind == std::string("Vertices");
        const Integers numbers = has_points ? counts : Integers(frames, 0);
        const auto cells = static_cast<std::size_t>(has_points ? most : 0);
        const auto add = [&](const char* name, const char* description, const Integers& values) {
            copies.push_back(
                make_copy(std::string("/VTKHDF/") + kind + "/" + name, description, {values.size()}, values));
        };
        add("NumberOfCells", "cells of each frame", numbers);
        add("NumberOfConnectivityIds", "points of these cells", numbers);
        add("Connectivity", "point of each cell, in all frames", count_from(0, cells));
        add("Offsets", "where each cell begins in Connectivity", count_from(0, cells + 1));
    }
}

void add_steps(const Hdf5Reader& file, const Integers& offsets, FrameCopy& copies) {
    const hsize_t frames = offsets.size() - 1;
    const Integers first(offsets.begin(), offsets.end() - 1);
    const auto add =
        [&](const std::string& name, const char* description, const Integers& values, hsize_t columns) {
            std::vector<hsize_t> size{frames};
            if (columns > 1) size.push_back(columns);
            copies.push_back(make_copy("/VTKHDF/Steps/" + name, description, std::move(size), values));
        };
    copies.push_back(copy_rows(file, "/VTKHDF/Steps/Values", 0, frames));
    add("PartOffsets", "the part of each frame", count_from(0, frames), 1);
    add("NumberOfParts", "parts of each frame: 1", Integers(frames, 1), 1);
    add("PointOffsets", "first point of each frame", first, 1);
    constexpr hsize_t kinds = 4;
    const Integers none(frames * kinds, 0);
    add("CellOffsets", "one topology serves all frames: 0", none, kinds);
    add("ConnectivityIdOffsets", "one topology serves all frames: 0", none, kinds);
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
    add_steps(file, offsets, copies);
    const Integers first(offsets.begin(), offsets.end() - 1);
    copies.push_back(copy_rows(file, "/contacts/point", 0, touches));
    copies.back().path = "/VTKHDF/Points";
    for (const std::string name : {"normal_force", "friction_force", "gap", "slides", "rods", "places"}) {
        copies.push_back(copy_rows(file, "/contacts/" + name, 0, touches));
        copies.back().path = "/VTKHDF/PointData/" + name;
        copies.push_back(make_copy(
            "/VTKHDF/Steps/PointDataOffsets/" + name, "first point of each frame", {frames}, first));
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
