#pragma once

#include <cstdint>
#include <nlohmann/json_fwd.hpp>
#include <ostream>
#include <string>
#include <vector>

#include "results/file/hdf5_reader.hpp"

namespace gxrod {

// Sections on cells with the operators of their stresses, as /sections of a results file has them, as far as
// they fit into a page. A file without sections adds nothing to its page.
class SectionBlocks {
  public:
    // Reads what fits into `bytes`: all points of stresses, or the corners of cells alone, or these of the
    // first sections. Throws Hdf5Error, and std::runtime_error if a cell has points that are not there.
    SectionBlocks(const Hdf5Reader& file, std::size_t bytes);

    // Counts the blocks, with the text around them.
    std::size_t count_bytes() const;
    std::vector<std::string> left_out() const;
    // Adds "sections": name, source, layers, corners of a cell, and whether its blocks are in the page.
    void describe(nlohmann::ordered_json& json) const;
    // Writes for section I "section-cells-I" (points of each cell's corners), "section-points-I" (y, z),
    // "section-layers-I" (of points), "section-singular-I" (1 or 0 of points), and "section-operators-I", 36
    // numbers of each point. Throws Hdf5Error.
    void write(std::ostream& out) const;

  private:
    struct Cells {
        std::string name;
        std::vector<std::int32_t> corners;  // points of each cell's corners
        std::size_t width = 0;              // corners of a cell
        std::size_t all_points = 0;
        std::vector<std::int32_t> corner_points;  // all points that are a corner, in their order
    };

    Cells read_cells(std::size_t number) const;
    std::size_t count_bytes_of(const Cells& cells) const;
    std::size_t count_kept(std::size_t bytes) const;
    void write_section(std::size_t number, std::ostream& out) const;

    const Hdf5Reader& file_;
    std::vector<Cells> sections_;
    bool has_all_points_ = true;
    std::size_t kept_ = 0;
};

}  // namespace gxrod
