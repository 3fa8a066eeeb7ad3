#include "cross_section/walls/wall_mesh.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>
#include <set>

#include "cross_section/walls/graded_line.hpp"
#include "cross_section/walls/quad_grid.hpp"
#include "cross_section/walls/wall_pieces.hpp"

namespace gxrod {
namespace {

// Interfaces closer than this, over the thickness, are one.
constexpr double same_interface = 1e-9;
// A wall has about this many rows, or elements would be too coarse at its corners; a ply has one at least.
constexpr double usual_rows = 8.0;
// Elements at corners and edges, and where an arc begins, over the thickness of the wall.
constexpr double sharp_size = 0.1;
constexpr double smooth_size = 1.0;
// Elements of an arc have this angle at most.
constexpr double largest_angle = std::numbers::pi / 8.0;
// Elements are this part of a piece at most.
constexpr double largest_part = 0.25;

// Returns where the plies of a layup meet, as fractions of its thickness, 0 and 1 included.
std::vector<double> list_interfaces(const Layup& layup) {
    std::vector<double> fractions{0.0};
    double sum = 0.0;
    for (const Ply& ply : layup.plies) fractions.push_back((sum += ply.thickness) / layup.thickness());
    fractions.back() = 1.0;
    return fractions;
}

// The rows of a mesh, between fractions of the thickness; plies of all layups end at rows.
std::vector<double> list_wall_rows(const std::set<std::size_t>& used,
                                   const std::vector<Layup>& layups,
                                   const WallMeshSettings& settings) {
    std::vector<double> all;
    for (const std::size_t layup : used) {
        const std::vector<double> some = list_interfaces(layups[layup]);
        all.insert(all.end(), some.begin(), some.end());
    }
    std::ranges::sort(all);
    std::vector<double> rows{0.0};
    for (const double fraction : all) {
        const double from = rows.back();
        if (fraction - from < same_interface) continue;
        const double wanted = (fraction - from) * usual_rows * settings.refinement;
        const int count = std::max(1, static_cast<int>(std::lround(wanted)));
        for (int i = 1; i <= count; ++i) rows.push_back(from + (fraction - from) * i / count);
    }
    rows.back() = 1.0;
    return rows;
}

std::size_t find_ply(const Layup& layup, double fraction) {
    const std::vector<double> interfaces = list_interfaces(layup);
    const auto above = std::ranges::upper_bound(interfaces, fraction);
    return static_cast<std::size_t>(above - interfaces.begin()) - 1;
}

std::vector<double> grade_piece(const WallPiece& piece, double thickness, double refinement) {
    const double length = piece.length();
    const auto size = [&](bool is_sharp) {
        return (is_sharp ? sharp_size : smooth_size) * thickness / refinement;
    };
    double largest = largest_part * length;
    if (piece.is_arc()) {
        largest = std::min(largest, largest_angle / std::abs(piece.turn) * length);
    }
    return grade_line(length,
                      {.at_start = size(piece.starts_sharply),
                       .at_end = size(piece.ends_sharply),
                       .growth = 0.7 / refinement,
                       .largest = largest / refinement});
}

class WallMesher {
  public:
    WallMesher(const WallOutline& outline, const std::vector<Layup>& layups, const WallMeshSettings& settings)
        : outline_(outline),
          layups_(layups),
          settings_(settings),
          pieces_(list_wall_pieces(outline, layups)) {
        for (const WallPiece& piece : pieces_) {
            const std::size_t layup = outline.layup_of(piece.side);
            used_.insert(layup);
            along_.push_back(grade_piece(piece, layups[layup].thickness(), settings.refinement));
            grid_.cells_along += static_cast<int>(along_.back().size()) - 1;
        }
        rows_ = list_wall_rows(used_, layups, settings);
        grid_.cells_across = static_cast<int>(rows_.size()) - 1;
    }

    SectionMesh mesh() {
        add_layers();
        const int nodes = grid_.columns() * grid_.rows();
        mesh_.nodes.resize(static_cast<std::size_t>(nodes));
        int first_cell = 0;
        for (std::size_t i = 0; i < pieces_.size(); ++i) {
            for (std::size_t k = 0; k + 1 < along_[i].size(); ++k) {
                add_stack(pieces_[i], {along_[i][k], along_[i][k + 1]}, first_cell++);
            }
        }
        return std::move(mesh_);
    }

  private:
    void add_layers() {
        for (const std::size_t layup : used_) {
            first_layer_[layup] = static_cast<int>(mesh_.layers.size());
            const auto& [name, plies] = layups_[layup];
            for (std::size_t i = 0; i < plies.size(); ++i) {
                mesh_.layers.push_back(
                    {fmt::format("{} ply {}", name, i), plies[i].material, plies[i].fibre_angle});
            }
        }
    }

    // Adds the cells across the wall between two fractions of a piece. Nodes that two stacks share are placed
    // twice, equally.
    void add_stack(const WallPiece& piece, std::pair<double, double> between, int along) {
        const int order = settings_.order;
        const std::size_t layup = outline_.layup_of(piece.side);
        const auto place = [&](int i) {
            return between.first + (between.second - between.first) * i / order;
        };
        for (int row = 0; row < grid_.cells_across; ++row) {
            const double low = rows_[static_cast<std::size_t>(row)];
            const double high = rows_[static_cast<std::size_t>(row) + 1];
            const std::size_t ply = find_ply(layups_[layup], 0.5 * (low + high));
            SectionCell cell = grid_.cell_at(along, row);
            cell.layer = first_layer_[layup] + static_cast<int>(ply);
            for (int j = 0; j <= order; ++j) {
                for (int i = 0; i <= order; ++i) {
                    const int at = j * (order + 1) + i;
                    const int node = cell.nodes[static_cast<std::size_t>(at)];
                    mesh_.nodes[static_cast<std::size_t>(node)] =
                        piece.at(place(i), low + (high - low) * j / order);
                    cell.walls.push_back(piece.wall(place(i)));
                }
            }
            mesh_.cells.push_back(std::move(cell));
        }
    }

    const WallOutline& outline_;
    const std::vector<Layup>& layups_;
    const WallMeshSettings& settings_;
    std::vector<WallPiece> pieces_;
    std::set<std::size_t> used_;              // layups
    std::vector<std::vector<double>> along_;  // where elements of each piece meet
    std::vector<double> rows_;
    QuadGrid grid_{.order = settings_.order, .cells_along = 0, .is_ring = outline_.is_closed};
    std::map<std::size_t, int> first_layer_;
    SectionMesh mesh_;
};

}  // namespace

SectionMesh mesh_walls(const WallOutline& outline,
                       const std::vector<Layup>& layups,
                       const WallMeshSettings& settings) {
    return WallMesher(outline, layups, settings).mesh();
}

}  // namespace gxrod
