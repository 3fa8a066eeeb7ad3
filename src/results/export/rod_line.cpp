#include "results/export/rod_line.hpp"

#include <array>
#include <cmath>
#include <stdexcept>

namespace gxrod {
namespace {

constexpr std::size_t least_nodes = 2;
constexpr std::size_t most_nodes = 5;

// An integer from 0 to below `end`.
std::size_t index_of(double number, std::size_t end) {
    if (!(number >= 0.0 && number < static_cast<double>(end)) || number != std::floor(number))
        throw std::runtime_error("the table of its rods does not fit its frames");
    return static_cast<std::size_t>(number);
}

// The columns of /VTKHDF and /rods that locate cells.
struct Columns {
    std::vector<double> connectivity, offsets, entry_arc_length;
    std::size_t points = 0;
    std::size_t cells = 0;

    explicit Columns(const Hdf5Reader& file)
        : connectivity(file.numbers("/VTKHDF/Connectivity")),
          offsets(file.numbers("/VTKHDF/Offsets")),
          entry_arc_length(file.numbers("/rods/arc_length")),
          points(static_cast<std::size_t>(file.count("/VTKHDF/NumberOfPoints"))),
          cells(static_cast<std::size_t>(file.count("/VTKHDF/NumberOfCells"))) {
        if (entry_arc_length.size() != connectivity.size() || offsets.size() != cells + 1)
            throw std::runtime_error("the table of its rods does not fit its frames");
    }
};

void add_node(RodLine& line, std::size_t point, double arc_length) {
    const std::size_t element = line.elements.size();
    const bool is_end_of_last =
        !line.nodes.empty() && line.nodes.back().point == point && line.nodes.back().element + 1 == element;
    if (!is_end_of_last) line.nodes.push_back({point, element, arc_length});
}

void add_element(const Columns& columns, std::size_t cell, double middle, RodLine& line) {
    const std::size_t first = index_of(columns.offsets[cell], columns.connectivity.size());
    const std::size_t end = index_of(columns.offsets[cell + 1], columns.connectivity.size() + 1);
    if (end < first + least_nodes || end > first + most_nodes)
        throw std::runtime_error("a cell of a rod is not an element");
    RodLine::Element element{cell, middle, {}};
    for (std::size_t i = first; i < end; ++i)
        element.points.push_back(index_of(columns.connectivity[i], columns.points));
    add_node(line, element.points[0], columns.entry_arc_length[first]);
    for (std::size_t i = 2; i < element.points.size(); ++i)
        add_node(line, element.points[i], columns.entry_arc_length[first + i]);
    add_node(line, element.points[1], columns.entry_arc_length[first + 1]);
    line.elements.push_back(std::move(element));
}

}  // namespace

std::vector<std::string> read_rod_names(const Hdf5Reader& file) {
    return file.has("/rods/name") ? file.texts("/rods/name") : std::vector<std::string>{};
}

RodLine read_rod_line(const Hdf5Reader& file, std::size_t rod) {
    const Columns columns(file);
    const std::size_t first = index_of(file.rows("/rods/first_cell", rod, 1, 1).at(0), columns.cells);
    const std::size_t count = index_of(file.rows("/rods/elements", rod, 1, 1).at(0), columns.cells + 1);
    if (count > columns.cells - first) throw std::runtime_error("a rod has more elements than there are");
    const std::vector<double> middles = file.rows("/VTKHDF/CellData/arc_length", first, count, 1);
    RodLine line;
    for (std::size_t i = 0; i < count; ++i) add_element(columns, first + i, middles[i], line);
    return line;
}

const std::vector<double>& middle_weights(std::size_t nodes) {
    // Of order 3, whose inner nodes are at ±1/√5, −1/8 and 5/8.
    static const std::array<std::vector<double>, 4> weights{
        {{0.5, 0.5}, {0.0, 0.0, 1.0}, {-0.125, -0.125, 0.625, 0.625}, {0.0, 0.0, 0.0, 1.0, 0.0}}};
    return weights.at(nodes - least_nodes);
}

}  // namespace gxrod
