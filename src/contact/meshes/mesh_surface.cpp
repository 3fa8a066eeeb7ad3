#include "contact/meshes/mesh_surface.hpp"

#include <cmath>

#include "contact/contact_law.hpp"
#include "contact/meshes/triangle_energy.hpp"
#include "contact/pairs/advancement.hpp"

namespace gxrod {
namespace {

Triangle triangle_of(const TriangleMesh& mesh, int index) {
    const std::array<int, 3>& corners = mesh.triangles[static_cast<std::size_t>(index)];
    const auto at = [&](std::size_t i) { return mesh.positions[static_cast<std::size_t>(corners[i])]; };
    return make_triangle(at(0), at(1), at(2));
}

std::vector<Triangle> triangles_of(const TriangleMesh& mesh, const std::vector<int>& indices) {
    std::vector<Triangle> triangles;
    triangles.reserve(indices.size());
    for (const int index : indices) triangles.push_back(triangle_of(mesh, index));
    return triangles;
}

std::vector<Box> boxes_of(const std::vector<Triangle>& triangles) {
    std::vector<Box> boxes(triangles.size());
    for (std::size_t i = 0; i < triangles.size(); ++i)
        for (const Vec3& corner : triangles[i].corners) boxes[i].include(corner);
    return boxes;
}

Box box_of(const Vec3& from, const Vec3& to, double margin) {
    Box box;
    box.include(from);
    box.include(to);
    box.low.array() -= margin;
    box.high.array() += margin;
    return box;
}

ObstacleDistance distance_from_point(const Vec3& x,
                                     const Triangle& triangle,
                                     const ClosestOnTriangle& point) {
    ObstacleDistance result;
    result.position = point.position;
    result.distance = point.distance;
    if (point.distance == 0.0) return result;
    const Vec3 n = (x - point.position) / point.distance;
    result.normal = n;
    if (point.is_corner)
        result.curvature = (Mat3::Identity() - n * n.transpose()) / point.distance;
    else if (point.edge >= 0) {
        const Vec3& t = triangle.along[static_cast<std::size_t>(point.edge)];
        result.curvature = (Mat3::Identity() - n * n.transpose() - t * t.transpose()) / point.distance;
    }
    return result;
}

// Within the skin.
void set_gap(const Nearness& gap, double radius, ObstacleDistance& result) {
    const Vec3 gradient(gap.slopes[0], gap.slopes[1], gap.slopes[2]);
    result.distance = radius + gap.value;
    result.slope = gradient.norm();
    if (result.slope > 0.0) result.normal = gradient / result.slope;
    const auto& c = gap.curvatures;
    result.curvature << c[0], c[1], c[2], c[1], c[3], c[4], c[2], c[4], c[5];
}

}  // namespace

MeshSurface::MeshSurface(const TriangleMesh& mesh, std::vector<int> indices)
    : indices_(std::move(indices)),
      triangles_(triangles_of(mesh, indices_)),
      boxes_(boxes_of(triangles_)),
      tree_(boxes_) {
    for (const Box& box : boxes_)
        extent_ = std::max({extent_, box.low.cwiseAbs().maxCoeff(), box.high.cwiseAbs().maxCoeff()});
}

MeshSurface::Closest MeshSurface::search(const Vec3& x, double within) const {
    Closest closest;
    const double limit = within;
    closest.own = tree_.find_nearest(
        x, rounding_at(x), within, [&](int triangle) { return find_on(triangle, x).distance; });
    closest.point.distance = limit;
    if (closest.own < 0) return closest;
    closest.point = find_on(closest.own, x);
    closest.triangle = indices_[static_cast<std::size_t>(closest.own)];
    return closest;
}

// The nearest of the triangles nearby; −1 if another one could be nearer.
int MeshSurface::find_nearby(const Vec3& x, const MeshMemory& memory) const {
    if (!memory.nearby) return -1;
    const double reach = memory.nearby->reach_from(x) - rounding_at(x);
    if (!(reach > 0.0)) return -1;
    int nearest = -1;
    double within = std::numeric_limits<double>::infinity();
    for (const int triangle : memory.nearby->triangles) {
        const double limit = within + rounding_at(x);
        if (boxes_[static_cast<std::size_t>(triangle)].squared_distance(x) > limit * limit) continue;
        BoxTree::take_if_nearer(
            triangle, [&](int own) { return find_on(own, x).distance; }, nearest, within);
    }
    return within < reach ? nearest : -1;
}

MeshSurface::Closest MeshSurface::search_with(const Vec3& x, MeshMemory& memory) const {
    Closest closest;
    closest.own = find_nearby(x, memory);
    const bool is_nearby = closest.own >= 0;
    if (is_nearby) {
        closest.point = find_on(closest.own, x);
        closest.triangle = indices_[static_cast<std::size_t>(closest.own)];
    } else {
        const double rounding = rounding_at(x);
        if (memory.distance >= 0.0)
            closest = search(x, memory.distance + (x - memory.at).norm() + 2.0 * rounding);
        if (closest.own < 0) closest = search(x, std::numeric_limits<double>::infinity());
        if (closest.own < 0) return closest;
    }
    memory.at = x;
    memory.distance = closest.point.distance;
    if (!is_nearby && memory.distance < 2.0 * memory.range) {
        if (!memory.nearby) memory.nearby = std::make_unique<MeshMemory::Nearby>();
        MeshMemory::Nearby& nearby = *memory.nearby;
        nearby.box = box_of(x, x, std::max(memory.distance, memory.range) + 0.5 * memory.range);
        nearby.triangles.clear();
        visit_meeting(nearby.box, nullptr, [&](int triangle) { nearby.triangles.push_back(triangle); });
    }
    return closest;
}

MeshSurface::Closest MeshSurface::find_closest(const Vec3& x, double within, MeshMemory* memory) const {
    if (memory == nullptr) return search(x, within);
    Closest none;
    none.point.distance = within;
    if (memory->distance - (x - memory->at).norm() - rounding_at(x) >= within) return none;
    const Closest closest = search_with(x, *memory);
    return closest.own >= 0 && closest.point.distance < within ? closest : none;
}

double MeshSurface::find_least(const Vec3& x, double within, MeshMemory* memory) const {
    if (memory != nullptr && memory->distance >= 0.0 && memory->at == x)
        return std::min(within, memory->distance);
    return find_closest(x, within, memory).point.distance;
}

bool MeshSurface::is_nearer(const Vec3& x, double distance, MeshMemory* memory) const {
    if (memory != nullptr && memory->distance >= 0.0) {
        const double way = (x - memory->at).norm() + rounding_at(x);
        if (memory->distance - way >= distance) return false;
        if (memory->distance + way < distance) return true;
    }
    return find_least(x, distance, memory) < distance;
}

template <class Visit>
void MeshSurface::visit_meeting(const Box& box, const MeshMemory* memory, const Visit& visit) const {
    const auto visit_if_it_meets = [&](int triangle) {
        if (boxes_[static_cast<std::size_t>(triangle)].meets(box)) visit(triangle);
    };
    if (memory != nullptr && memory->nearby && memory->nearby->box.contains(box)) {
        for (const int triangle : memory->nearby->triangles) visit_if_it_meets(triangle);
    } else {
        tree_.visit_meeting(box, visit_if_it_meets);
    }
}

ObstacleDistance MeshSurface::find_distance(const Vec3& x,
                                            double radius,
                                            double skin,
                                            MeshMemory* memory) const {
    if (memory != nullptr && memory->nearby)
        for (const MeshMemory::Nearby::Found& found : memory->nearby->found)
            if (found.at == x) return found.distance;
    const Closest closest = find_closest(x, std::numeric_limits<double>::infinity(), memory);
    if (closest.own < 0) return {};
    ObstacleDistance result = find_distance_from(closest, x, radius, skin, memory);
    if (memory != nullptr && memory->nearby) {
        MeshMemory::Nearby& nearby = *memory->nearby;
        nearby.found[nearby.oldest] = {x, result};
        nearby.oldest = (nearby.oldest + 1) % nearby.found.size();
    }
    return result;
}

ObstacleDistance MeshSurface::find_distance_from(
    const Closest& closest, const Vec3& x, double radius, double skin, const MeshMemory* memory) const {
    const ClosestOnTriangle& point = closest.point;
    ObstacleDistance result =
        distance_from_point(x, triangles_[static_cast<std::size_t>(closest.own)], point);
    // Nearer than that, what is near is lost in round-off.
    constexpr double least = 1e-6;
    if (point.distance <= radius + least * skin || point.distance >= radius + skin) return result;
    Nearness sum;
    visit_meeting(box_of(x, x, radius + skin), memory, [&](int triangle) {
        sum += compute_nearness(triangles_[static_cast<std::size_t>(triangle)], x, radius, skin);
    });
    if (const std::optional<Nearness> gap = find_gap(sum, radius, skin)) {
        set_gap(*gap, radius, result);
    } else {
        result.distance = radius + skin;
    }
    return result;
}

// Each triangle is convex: its distance is never below its tangent plane's.
FreeMotion MeshSurface::find_free_motion(
    double radius, const Vec3& from, const Vec3& to, double skin, MeshMemory* memory) const {
    const Vec3 motion = to - from;
    const double length = motion.norm();
    // Nothing nearer can be met.
    const double clear = 1.001 * std::max(length / 0.9, length + 0.5 * skin) + radius;
    const double distance = find_least(from, clear, memory);
    FreeMotion free{1.0, distance - radius};
    if (distance >= clear) {
        free.gap = std::numeric_limits<double>::infinity();
        return free;
    }
    if (!(free.gap > 0.0)) return {0.0, free.gap};
    const double kept = skin > 0.0 ? find_predicted_share(skin, free.gap) : 0.1;
    if ((1.0 - kept) * free.gap >= length) return free;
    visit_meeting(box_of(from, to, radius + 2.0 * kept * free.gap), memory, [&](int index) {
        const Triangle& triangle = triangles_[static_cast<std::size_t>(index)];
        const Vec3 rest = free.fraction * motion;
        const auto measure = [&](double t) {
            const Vec3 x = from + t * rest;
            const ClosestOnTriangle point = find_on_triangle(triangle, x);
            return GapAndSpeed{
                point.distance - radius,
                point.distance > 0.0 ? (point.position - x).dot(rest) / point.distance : length};
        };
        AdvancementLimits limits;
        limits.kept_share = kept * free.gap / measure(0.0).gap;
        free.fraction *= advance(measure, limits).fraction;
    });
    return free;
}

int MeshSurface::find_crossed(const Vec3& from, const Vec3& to) const {
    int crossed = -1;
    visit_meeting(box_of(from, to, 0.0), nullptr, [&](int triangle) {
        if (crossed < 0 && crosses(triangles_[static_cast<std::size_t>(triangle)], from, to))
            crossed = indices_[static_cast<std::size_t>(triangle)];
    });
    return crossed;
}

}  // namespace gxrod
