#include "mesh/sections/wall_directions.hpp"

#include <algorithm>
#include <array>
#include <limits>

#include "mesh/chains.hpp"

namespace gxrod {
namespace {

// Lines that turn more than this (30°) meet at a corner.
constexpr double corner_cosine = 0.866;

// Returns the nodes of a curve's element from end to end; the file has the ends first.
std::vector<int> nodes_along(const SurfaceElement& element) {
    std::vector<int> nodes{element.nodes[0]};
    nodes.insert(nodes.end(), element.nodes.begin() + 2, element.nodes.end());
    nodes.push_back(element.nodes[1]);
    return nodes;
}

double signed_area(const std::vector<PlanePoint>& points) {
    double area = 0.0;
    for (std::size_t i = 0; i < points.size(); ++i) {
        const PlanePoint &a = points[i], &b = points[(i + 1) % points.size()];
        area += 0.5 * (a.x() * b.y() - a.y() * b.x());
    }
    return area;
}

}  // namespace

WallDirections::WallDirections(const SurfaceMesh& mesh, int group, const std::vector<PlanePoint>& nodes) {
    std::vector<const SurfaceElement*> elements;
    std::vector<std::array<std::size_t, 2>> ends;
    for (const SurfaceElement& element : mesh.curves) {
        if (element.group != group) continue;
        elements.push_back(&element);
        ends.push_back(
            {static_cast<std::size_t>(element.nodes[0]), static_cast<std::size_t>(element.nodes[1])});
    }
    for (const Chain& chain : find_chains(ends)) {
        std::vector<PlanePoint> points;
        for (const ChainLink& link : chain.links) {
            std::vector<int> along = nodes_along(*elements[link.element]);
            if (link.is_reversed) std::ranges::reverse(along);
            if (!points.empty()) points.pop_back();
            for (const int node : along) points.push_back(nodes[static_cast<std::size_t>(node)]);
        }
        add_chain(std::move(points), chain.is_closed);
    }
}

void WallDirections::add_chain(std::vector<PlanePoint> points, bool is_closed) {
    if (is_closed && signed_area(points) < 0.0) std::ranges::reverse(points);
    const std::size_t first = lines_.size(), count = points.size() - 1;
    for (std::size_t i = 0; i < count; ++i) {
        const PlanePoint direction = (points[i + 1] - points[i]).normalized();
        lines_.push_back({points[i], points[i + 1], direction, direction});
    }
    for (std::size_t i = 0; i < (is_closed ? count : count - 1); ++i) {
        Line &before = lines_[first + i], &after = lines_[first + (i + 1) % count];
        const PlanePoint a = (before.to - before.from).normalized(), b = (after.to - after.from).normalized();
        if (a.dot(b) < corner_cosine) continue;
        // The tangent of the circle through three points: a line twice as long counts half as much.
        const double length_a = (before.to - before.from).norm(), length_b = (after.to - after.from).norm();
        before.end_direction = after.start_direction = (length_b * a + length_a * b).normalized();
    }
}

PlanePoint WallDirections::at(const PlanePoint& point) const {
    double nearest = std::numeric_limits<double>::infinity();
    PlanePoint direction(1.0, 0.0);
    for (const Line& line : lines_) {
        const double place = find_place(line, point);
        const double distance = (line.at(place) - point).squaredNorm();
        if (distance >= nearest) continue;
        nearest = distance;
        direction = line.direction(place);
    }
    return direction.normalized();
}

// The point is on the normal of the direction there, which turns along the line. So the direction is
// continuous away from the curve too, where the normal of the line itself jumps from line to line.
double WallDirections::find_place(const Line& line, const PlanePoint& point) {
    const PlanePoint along = line.to - line.from, turn = line.end_direction - line.start_direction;
    double place = (point - line.from).dot(along) / along.squaredNorm();
    for (int i = 0; i < 4; ++i) {
        place = std::clamp(place, 0.0, 1.0);
        const PlanePoint between = point - line.at(place);
        const double slope = between.dot(turn) - along.dot(line.direction(place));
        if (slope < 0.0) place -= between.dot(line.direction(place)) / slope;
    }
    return std::clamp(place, 0.0, 1.0);
}

}  // namespace gxrod
