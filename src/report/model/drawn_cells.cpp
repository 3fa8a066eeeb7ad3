#include "report/model/drawn_cells.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <stdexcept>

namespace gxrod {

namespace {

constexpr int vtk_vertex = 1;
constexpr std::size_t most_cell_nodes = 5;

Quat read_axes(const std::array<std::vector<double>, 3>& axes, std::size_t node) {
    Mat3 matrix;
    for (int i = 0; i < 3; ++i) matrix.col(i) = Vec3(axes[i].data() + 3 * node);
    return Quat(matrix).normalized();
}

// Of an index in a list, or its end.
std::size_t index_of(double number, std::size_t size) {
    if (!(number >= 0.0 && number <= static_cast<double>(size)))
        throw std::runtime_error("a cell has points that are not there");
    return static_cast<std::size_t>(number);
}

double semi_axis(double bending, double axial, double otherwise) {
    const double radius = 2.0 * std::sqrt(bending / axial);
    return std::isfinite(radius) ? radius : otherwise;
}

// By the section there; bending about z strains along y, and the reverse.
std::array<double, 2> find_radii(const Section& section, const std::array<double, 2>& otherwise) {
    const Mat6& C = section.stiffness;
    return {semi_axis(C(5, 5), C(0, 0), otherwise[0]), semi_axis(C(4, 4), C(0, 0), otherwise[1])};
}

// Sections are computed from both sides of a node.
bool are_alike(const std::array<double, 2>& a, const std::array<double, 2>& b) {
    const auto is_alike = [](double x, double y) { return std::abs(x - y) <= 1e-9 * std::abs(x); };
    return is_alike(a[0], b[0]) && is_alike(a[1], b[1]);
}

// Whether the line continues from one cell to the next as if they were one.
bool continues(const DrawnCell& cell, const DrawnCell& next) {
    return cell.nodes[1] == next.nodes[0] && cell.rod == next.rod &&
           are_alike(cell.radii[1], next.radii[0]) && cell.axes[1].angularDistance(next.axes[0]) < 1e-3;
}

// Whether the frames have as many nodes and bodies as the model, and elements of its orders.
bool has_cells_of(const Model& model, const FrameTopology& topology) {
    std::vector<std::size_t> of_model, of_frames;
    for (const Rod& rod : model.rods) {
        of_model.insert(of_model.end(), rod.element_count(), static_cast<std::size_t>(rod.order) + 1);
    }
    for (const DrawnCell& cell : topology.rod_cells) of_frames.push_back(cell.nodes.size());
    return model.nodes.size() == static_cast<std::size_t>(topology.nodes) && of_model == of_frames &&
           model.bodies.size() == topology.body_nodes.size();
}

}  // namespace

FrameTopology read_topology(const Hdf5Reader& file) {
    FrameTopology topology;
    topology.nodes = file.count("/VTKHDF/NumberOfPoints");
    topology.cells = file.count("/VTKHDF/NumberOfCells");
    const std::vector<double> connectivity = file.numbers("/VTKHDF/Connectivity");
    const std::vector<double> offsets = file.numbers("/VTKHDF/Offsets");
    const std::vector<double> types = file.numbers("/VTKHDF/Types");
    const std::vector<double> radius =
        file.rows("/VTKHDF/CellData/radius", 0, static_cast<hsize_t>(topology.cells), 1);
    const auto nodes = static_cast<hsize_t>(topology.nodes);
    const std::array<std::vector<double>, 3> axes{file.rows("/VTKHDF/PointData/axis_x", 0, nodes, 3),
                                                  file.rows("/VTKHDF/PointData/axis_y", 0, nodes, 3),
                                                  file.rows("/VTKHDF/PointData/axis_z", 0, nodes, 3)};
    for (std::size_t cell = 0; cell < types.size(); ++cell) {
        DrawnCell drawn;
        for (std::size_t i = index_of(offsets.at(cell), connectivity.size());
             i < index_of(offsets.at(cell + 1), connectivity.size());
             ++i) {
            if (!(connectivity[i] >= 0.0 && connectivity[i] < topology.nodes))
                throw std::runtime_error("a cell has a point that is not there");
            const int node = static_cast<int>(connectivity[i]);
            drawn.nodes.push_back(node);
            drawn.axes.push_back(read_axes(axes, static_cast<std::size_t>(node)));
        }
        const bool is_body = types[cell] == vtk_vertex;
        if (is_body ? drawn.nodes.size() != 1
                    : drawn.nodes.size() < 2 || drawn.nodes.size() > most_cell_nodes) {
            throw std::runtime_error("a cell is neither a rod's element nor a body");
        }
        drawn.radii.assign(drawn.nodes.size(), {radius.at(cell), radius.at(cell)});
        drawn.source = static_cast<int>(cell);
        if (is_body) {
            topology.body_nodes.push_back(drawn.nodes.at(0));
        } else {
            topology.rod_cells.push_back(std::move(drawn));
        }
    }
    return topology;
}

bool refine_cells(const Model& model, FrameTopology& topology) {
    if (!has_cells_of(model, topology)) return false;
    auto cell = topology.rod_cells.begin();
    int number = 0;
    for (const Rod& rod : model.rods) {
        const auto section_at = [&](std::size_t entry) -> const Section& {
            return rod.has_varying_sections() ? rod.varying.at_nodes[entry] : model.sections[rod.section];
        };
        const auto order = static_cast<std::size_t>(rod.order);
        // What touches is round.
        const std::vector<double>& touching = model.contact.radii;
        const double radius = touching.empty() ? 0.0 : touching[static_cast<std::size_t>(number)];
        for (std::size_t first = 0; first < rod.triads.size(); first += order + 1, ++cell) {
            const std::array<double, 2> of_file = cell->radii.front();
            cell->axes.clear();
            cell->arc_length.clear();
            cell->radii.clear();
            for (std::size_t i = 0; i <= order; ++i) {
                // The ends first.
                const std::size_t entry = first + (i == 0 ? 0 : i == 1 ? order : i - 1);
                cell->axes.push_back(rod.triads[entry]);
                cell->arc_length.push_back(rod.arc_length[entry]);
                cell->radii.push_back(radius > 0.0 ? std::array{radius, radius}
                                                   : find_radii(section_at(entry), of_file));
            }
            cell->rod = number;
            cell->middle = 0.5 * (rod.arc_length[first] + rod.arc_length[first + order]);
        }
        ++number;
    }
    return true;
}

std::vector<DrawnCell> join_cells(const std::vector<DrawnCell>& cells,
                                  std::size_t run,
                                  const std::vector<bool>& kept) {
    if (run < 2) return cells;
    std::vector<int> ends(kept.size(), 0);
    for (const DrawnCell& cell : cells) {
        ++ends[cell.nodes[0]];
        ++ends[cell.nodes[1]];
    }
    std::vector<DrawnCell> joined;
    for (std::size_t first = 0; first < cells.size();) {
        std::size_t last = first;
        while (last + 1 < cells.size() && last + 1 < first + run && continues(cells[last], cells[last + 1]) &&
               ends[cells[last].nodes[1]] == 2 && !kept[cells[last].nodes[1]]) {
            ++last;
        }
        DrawnCell cell = cells[first];
        if (last > first) {
            cell.nodes = {cells[first].nodes[0], cells[last].nodes[1]};
            cell.axes = {cells[first].axes[0], cells[last].axes[1]};
            cell.radii = {cells[first].radii[0], cells[last].radii[1]};
            cell.source = cells[(first + last) / 2].source;
            cell.middle = cells[(first + last) / 2].middle;
            if (cell.rod >= 0)
                cell.arc_length = {cells[first].arc_length.at(0), cells[last].arc_length.at(1)};
        }
        joined.push_back(std::move(cell));
        first = last + 1;
    }
    return joined;
}

std::vector<DrawnCell> sample_cells(const std::vector<DrawnCell>& cells, std::size_t most) {
    if (cells.size() <= most) return cells;
    std::vector<DrawnCell> chosen;
    for (std::size_t i = 0; i < most; ++i) chosen.push_back(cells[i * cells.size() / most]);
    return chosen;
}

}  // namespace gxrod
