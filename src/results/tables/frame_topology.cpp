#include "results/tables/frame_topology.hpp"

#include <array>

namespace gxrod {

void write_frame_topology(const Hdf5Handle& vtkhdf, const FrameMesh& mesh, std::size_t points) {
    write_attribute(vtkhdf.id(), "Version", std::array<std::int64_t, 2>{2, 0});
    write_fixed_attribute(vtkhdf.id(), "Type", "UnstructuredGrid");
    const auto write_count = [&](const char* name, const char* description, std::size_t count) {
        const std::array<std::int64_t, 1> value{static_cast<std::int64_t>(count)};
        write_dataset(vtkhdf, {name, description, "none", "1"}, value);
    };
    write_count("NumberOfPoints", "points of a frame", points);
    write_count("NumberOfCells", "cells of a frame", mesh.cell_count());
    write_count("NumberOfConnectivityIds", "length of Connectivity", mesh.connectivity.size());
    write_dataset(
        vtkhdf, {"Connectivity", "points of each cell, the two ends first", "none", "1"}, mesh.connectivity);
    write_dataset(vtkhdf, {"Offsets", "where each cell begins in Connectivity", "none", "1"}, mesh.offsets);
    write_dataset(
        vtkhdf,
        {"Types", "VTK cell types: 3, 21, 68, 68 rod elements of order 1 to 4, 1 bodies", "none", "1"},
        mesh.types);
}

}  // namespace gxrod
