#include "cross_section/outlines/wall_thickness.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace gxrod {
namespace {

struct Ray {
    PlanePoint from, along;
};

struct RayHit {
    double distance = std::numeric_limits<double>::infinity();
    double fraction = 0.0;
};

// Keeps a hit if it is nearer, in front of the ray's start and on the piece.
void keep_nearer(double distance, double fraction, double least, RayHit& hit) {
    const bool is_on_piece = fraction >= 0.0 && fraction <= 1.0;
    if (is_on_piece && distance > least && distance < hit.distance) hit = {distance, fraction};
}

void meet_straight(const Ray& ray, const OutlinePiece& piece, double least, RayHit& hit) {
    const PlanePoint side = piece.to - piece.from, to = piece.from - ray.from;
    const double product = cross(ray.along, side);
    if (product == 0.0) return;
    keep_nearer(cross(to, side) / product, cross(to, ray.along) / product, least, hit);
}

void meet_arc(const Ray& ray, const OutlinePiece& piece, double least, RayHit& hit) {
    const PlanePoint start = piece.from - piece.centre;
    const double along = ray.along.dot(piece.centre - ray.from);
    const double square = (ray.from + along * ray.along - piece.centre).squaredNorm();
    if (square > start.squaredNorm()) return;
    const double half = std::sqrt(start.squaredNorm() - square);
    for (const double distance : {along - half, along + half}) {
        const PlanePoint radius = ray.from + distance * ray.along - piece.centre;
        const double angle = std::atan2(cross(start, radius), start.dot(radius));
        keep_nearer(distance, angle / piece.turn, least, hit);
    }
}

}  // namespace

std::optional<OppositeWall> find_opposite_wall(const Outline& outline,
                                               const OutlinePiece& piece,
                                               double fraction) {
    // Of the cosine between the two inward normals: 120 degrees.
    constexpr double about_parallel = -0.5;
    const PlanePoint walk = piece.direction(fraction);
    const Ray ray{piece.at(fraction), {-walk.y(), walk.x()}};
    const double least = 1e-9 * piece.length();
    OppositeWall found;
    RayHit nearest;
    for (const OutlineLoop* loop : outline.loops()) {
        for (const OutlinePiece& other : *loop) {
            RayHit hit = nearest;
            (other.is_arc() ? meet_arc : meet_straight)(ray, other, least, hit);
            if (hit.distance < nearest.distance) {
                nearest = hit;
                found = {&other, hit.fraction, hit.distance};
            }
        }
    }
    if (found.piece == nullptr) return std::nullopt;
    if (walk.dot(found.piece->direction(found.fraction)) > about_parallel) return std::nullopt;
    return found;
}

}  // namespace gxrod
