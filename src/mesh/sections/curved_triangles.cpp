#include "mesh/sections/curved_triangles.hpp"

#include <map>
#include <utility>

namespace gxrod {
namespace {

using TriangleSide = std::pair<int, int>;  // points, in the order of the walk around a triangle

class TriangleBender {
  public:
    TriangleBender(const PlaneTriangles& mesh, const std::vector<BoundaryEdges>& boundary, int order)
        : mesh_(mesh), order_(order) {
        bent_.nodes = mesh.points;
        int first = 0;
        for (const BoundaryEdges& loop : boundary) {
            const auto count = static_cast<int>(loop.size());
            for (int i = 0; i < count; ++i) edges_[{first + i, first + (i + 1) % count}] = &loop[i];
            first += count;
        }
        for (const auto& triangle : mesh.triangles) bent_.cells.push_back(bend(triangle));
    }

    SectionMesh take() { return std::move(bent_); }

  private:
    SectionCell bend(const std::array<int, 3>& triangle) {
        SectionCell cell;
        cell.order = order_;
        for (int j = 0; j <= order_; ++j) {
            for (int i = 0; i <= order_ - j; ++i) cell.nodes.push_back(find_node(triangle, i, j));
        }
        return cell;
    }

    // The node (i, j) of the lattice of a triangle.
    int find_node(const std::array<int, 3>& triangle, int i, int j) {
        const auto& [a, b, c] = triangle;
        const int k = order_ - i - j;
        if (k == order_) return a;
        if (i == order_) return b;
        if (j == order_) return c;
        if (j == 0) return find_node_of_side({a, b}, i);
        if (k == 0) return find_node_of_side({b, c}, j);
        if (i == 0) return find_node_of_side({c, a}, k);
        const double n = order_;
        return add(locate(triangle, {k / n, i / n, j / n}));
    }

    // The node at a step along a side, which two triangles walk in opposite directions.
    int find_node_of_side(const TriangleSide& side, int step) {
        const auto other = sides_.find({side.second, side.first});
        if (other != sides_.end()) return other->second + order_ - 1 - step;
        const auto [own, is_new] = sides_.try_emplace(side, static_cast<int>(bent_.nodes.size()));
        for (int i = 1; is_new && i < order_; ++i) {
            const double s = static_cast<double>(i) / order_;
            add((1.0 - s) * point(side.first) + s * point(side.second) + deviate(side, s));
        }
        return own->second + step - 1;
    }

    // A point inside: what a side deviates from its chord fades away from it, as λa λb does.
    PlanePoint locate(const std::array<int, 3>& triangle, const std::array<double, 3>& part) const {
        PlanePoint at = PlanePoint::Zero();
        for (std::size_t k = 0; k < 3; ++k) {
            const std::size_t next = (k + 1) % 3;
            const double s = 0.5 * (1.0 + part[next] - part[k]);
            at += part[k] * point(triangle[k]) +
                  part[k] * part[next] / (s * (1.0 - s)) * deviate({triangle[k], triangle[next]}, s);
        }
        return at;
    }

    // How far a side's point at a fraction is from its chord.
    PlanePoint deviate(const TriangleSide& side, double s) const {
        const auto edge = edges_.find(side);
        if (edge == edges_.end() || !edge->second->piece->is_arc()) return PlanePoint::Zero();
        return edge->second->at(s) - ((1.0 - s) * point(side.first) + s * point(side.second));
    }

    const PlanePoint& point(int i) const { return mesh_.points[static_cast<std::size_t>(i)]; }

    int add(const PlanePoint& at) {
        bent_.nodes.push_back(at);
        return static_cast<int>(bent_.nodes.size()) - 1;
    }

    const PlaneTriangles& mesh_;
    int order_;
    std::map<TriangleSide, const BoundaryEdge*> edges_;
    std::map<TriangleSide, int> sides_;  // the first of the nodes on a side
    SectionMesh bent_;
};

}  // namespace

SectionMesh bend_triangles(const PlaneTriangles& mesh,
                           const std::vector<BoundaryEdges>& boundary,
                           int order) {
    return TriangleBender(mesh, boundary, order).take();
}

}  // namespace gxrod
