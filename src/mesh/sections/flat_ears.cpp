#include "mesh/sections/flat_ears.hpp"

#include <map>
#include <optional>
#include <utility>

namespace gxrod {
namespace {

using Triangle = std::array<int, 3>;
// Triangles by their sides, as they walk them, with the number of the side.
using TrianglesBySide = std::map<std::pair<int, int>, std::pair<std::size_t, std::size_t>>;

class EarDivider {
  public:
    explicit EarDivider(PlaneTriangles& mesh) : mesh_(mesh) {
        for (std::size_t i = 0; i < mesh.triangles.size(); ++i) list_sides(i);
    }

    void divide_all() {
        const std::size_t count = mesh_.triangles.size();
        for (std::size_t i = 0; i < count; ++i) {
            if (const auto tip = find_flat_tip(mesh_.triangles[i])) divide(i, *tip);
        }
    }

  private:
    void list_sides(std::size_t i) {
        const Triangle& triangle = mesh_.triangles[i];
        for (std::size_t k = 0; k < 3; ++k) sides_[{triangle[k], triangle[(k + 1) % 3]}] = {i, k};
    }

    bool is_inner(int from, int to) const { return sides_.contains({to, from}); }

    const PlanePoint& point(int i) const { return mesh_.points[static_cast<std::size_t>(i)]; }

    // The corner between two sides on the boundary, if the angle there is more than 120 degrees.
    std::optional<std::size_t> find_flat_tip(const Triangle& triangle) const {
        constexpr double cosine = -0.5;
        for (std::size_t k = 0; k < 3; ++k) {
            const int before = triangle[(k + 2) % 3], tip = triangle[k], after = triangle[(k + 1) % 3];
            if (is_inner(before, tip) || is_inner(tip, after) || !is_inner(after, before)) continue;
            const PlanePoint in = point(before) - point(tip), out = point(after) - point(tip);
            if (in.dot(out) < cosine * in.norm() * out.norm()) return k;
        }
        return std::nullopt;
    }

    void divide(std::size_t i, std::size_t k) {
        // From the third side to the corner opposite to it: the median lies in the neighbour.
        constexpr double part_of_median = 0.35;
        const Triangle ear = mesh_.triangles[i];
        const int before = ear[(k + 2) % 3], tip = ear[k], after = ear[(k + 1) % 3];
        const auto [neighbour, side] = sides_.at({before, after});
        const int opposite = mesh_.triangles[neighbour][(side + 2) % 3];
        const PlanePoint middle = 0.5 * (point(before) + point(after));
        const auto added = static_cast<int>(mesh_.points.size());
        mesh_.points.push_back(middle + part_of_median * (point(opposite) - middle));
        sides_.erase({before, after});
        sides_.erase({after, before});
        mesh_.triangles[i] = {before, tip, added};
        mesh_.triangles[neighbour] = {tip, after, added};
        mesh_.triangles.push_back({after, opposite, added});
        mesh_.triangles.push_back({opposite, before, added});
        for (const std::size_t one : {i, neighbour, mesh_.triangles.size() - 2, mesh_.triangles.size() - 1})
            list_sides(one);
    }

    PlaneTriangles& mesh_;
    TrianglesBySide sides_;
};

}  // namespace

void divide_flat_ears(PlaneTriangles& mesh) { EarDivider(mesh).divide_all(); }

}  // namespace gxrod
