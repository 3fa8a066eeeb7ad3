#include "mesh/triangles/rounded_triangles.hpp"

#include <algorithm>
#include <cmath>

#include "mesh/triangles/triangle_edges.hpp"
#include "numerics/disjoint_sets.hpp"

namespace gxrod {
namespace {

using Edge = std::pair<int, int>;

// The curve over an edge from its first corner: x(t) = x₀ + t d + t (1 − t) bow.
struct EdgeCurve {
    Vec3 bow = Vec3::Zero();
    bool is_smooth = false;  // of two triangles that are one surface
    double turn = 0.0;       // of the surface from one end of the edge to the other
};

// A bow along the mean of the normals at both ends of an edge, so that the curve has the slopes of both as
// far as they agree.
struct Bow {
    Vec3 along = Vec3::Zero();
    double size = 0.0;
    double turn = 0.0;
};

Bow find_bow(const Vec3& edge, const Vec3& n0, const Vec3& n1) {
    constexpr double least = 0.5;  // of a sum of two normals
    const Vec3 sum = n0 + n1;
    const double length = sum.norm();
    if (length < least) return {};
    return {sum / length, (n1 - n0).dot(edge) / length, std::atan2(n0.cross(n1).norm(), n0.dot(n1))};
}

class Rounder {
  public:
    explicit Rounder(const TriangleMesh& mesh)
        : mesh_(mesh),
          sides_(list_sides(mesh)),
          orientation_(orient_triangles(mesh, sides_)),
          corners_(3 * mesh.triangles.size()),
          regions_(mesh.triangles.size()) {
        join_smooth_edges();
        find_normals();
        find_curves();
        choose_pieces();
    }

    RoundedTriangles run() {
        RoundedTriangles result;
        result.mesh = mesh_;
        if (std::ranges::all_of(pieces_, [](int pieces) { return pieces == 1; })) return result;
        result.mesh.triangles.clear();
        result.mesh.numbers.clear();
        for (int t = 0; t < count(); ++t) cut(t, result);
        result.mesh.open_edges = 0;
        for (const auto& [edge, own] : sides_)
            if (own.size() == 1)
                result.mesh.open_edges += static_cast<std::size_t>(pieces_of(own[0].triangle));
        return result;
    }

  private:
    int count() const { return static_cast<int>(mesh_.triangles.size()); }
    const std::array<int, 3>& triangle(int t) const { return mesh_.triangles[static_cast<std::size_t>(t)]; }
    // A corner of a triangle, in corners_.
    int corner_of(int t, int corner) const {
        const auto& own = triangle(t);
        return 3 * t + static_cast<int>(std::ranges::find(own, corner) - own.begin());
    }
    int pieces_of(int t) { return pieces_[static_cast<std::size_t>(regions_.find(t))]; }
    const Vec3& normal_of(int t, int corner) {
        return normals_[static_cast<std::size_t>(corners_.find(corner_of(t, corner)))];
    }
    bool is_turned(int t) const { return orientation_.is_turned[static_cast<std::size_t>(t)] != 0; }

    bool is_smooth(const std::vector<EdgeSide>& sides) const {
        if (sides.size() != 2 || find_turn(mesh_, sides) > mesh_.feature_angle) return false;
        // Of a surface with one side only, some neighbours are never the same way around.
        const bool is_opposite = sides[0].goes_up == sides[1].goes_up;
        return (is_turned(sides[0].triangle) != is_turned(sides[1].triangle)) == is_opposite;
    }

    void join_smooth_edges() {
        for (const auto& [edge, sides] : sides_) {
            if (!is_smooth(sides)) continue;
            curves_[edge].is_smooth = true;
            regions_.join(sides[0].triangle, sides[1].triangle);
            for (const int corner : {edge.first, edge.second})
                corners_.join(corner_of(sides[0].triangle, corner), corner_of(sides[1].triangle, corner));
        }
    }

    // The mean of the normals around a corner, by the angles there.
    void find_normals() {
        normals_.assign(3 * mesh_.triangles.size(), Vec3::Zero());
        for (int t = 0; t < count(); ++t) {
            const Vec3 normal = (is_turned(t) ? -1.0 : 1.0) * find_area_vector(mesh_, t).stableNormalized();
            for (std::size_t i = 0; i < 3; ++i) {
                const Vec3& here = corner_at(mesh_, triangle(t)[i]);
                const Vec3 a = corner_at(mesh_, triangle(t)[(i + 1) % 3]) - here;
                const Vec3 b = corner_at(mesh_, triangle(t)[(i + 2) % 3]) - here;
                const double angle = std::atan2(a.cross(b).norm(), a.dot(b));
                normals_[static_cast<std::size_t>(corners_.find(3 * t + static_cast<int>(i)))] +=
                    angle * normal;
            }
        }
        for (Vec3& normal : normals_) normal = normal.stableNormalized();
    }

    Bow bow_of(const Edge& edge, const EdgeSide& side) {
        const Vec3 along = corner_at(mesh_, edge.second) - corner_at(mesh_, edge.first);
        return find_bow(along, normal_of(side.triangle, edge.first), normal_of(side.triangle, edge.second));
    }

    // A sharp edge bows with both of its surfaces.
    void find_curve(const Edge& edge, const std::vector<EdgeSide>& sides, EdgeCurve& curve) {
        if (sides.size() > 2) return;
        const Bow first = bow_of(edge, sides.front());
        curve.turn = first.turn;
        curve.bow = first.size * first.along;
        if (sides.size() == 2 && !curve.is_smooth) {
            const Bow second = bow_of(edge, sides.back());
            curve.turn = std::max(curve.turn, second.turn);
            constexpr double nearly = 0.95;  // the cosine of an angle of 18°
            const double cosine = first.along.dot(second.along);
            if (cosine > nearly) {
                curve.bow = 0.5 * (curve.bow + second.size * second.along);
            } else if (cosine < -nearly) {
                curve.bow.setZero();
            } else {
                const double whole = 1.0 - cosine * cosine;
                curve.bow = (first.size - cosine * second.size) / whole * first.along +
                            (second.size - cosine * first.size) / whole * second.along;
            }
        }
        constexpr double most = 0.5, least = 1e-9;  // of the edge
        const double length = (corner_at(mesh_, edge.second) - corner_at(mesh_, edge.first)).norm();
        const double size = curve.bow.norm();
        if (size > most * length || size < least * length) curve.bow.setZero();
    }

    void find_curves() {
        for (const auto& [edge, sides] : sides_) {
            EdgeCurve& curve = curves_[edge];
            find_curve(edge, sides, curve);
            // What meets along a curve is cut alike.
            if (sides.size() == 2 && !curve.bow.isZero(0.0))
                regions_.join(sides[0].triangle, sides[1].triangle);
        }
    }

    void choose_pieces() {
        constexpr double least_turn = 0.1;
        constexpr int most_pieces = 16;
        constexpr double most_triangles = 4e5;
        std::vector<double> turns(mesh_.triangles.size(), 0.0);
        for (const auto& [edge, sides] : sides_) {
            const EdgeCurve& curve = curves_[edge];
            if (curve.bow.isZero(0.0)) continue;
            for (const EdgeSide& side : sides) {
                double& turn = turns[static_cast<std::size_t>(regions_.find(side.triangle))];
                turn = std::max(turn, curve.turn);
            }
        }
        const auto pieces_for = [&](double turn, double share) {
            const int wanted = std::clamp(static_cast<int>(turn / least_turn), 1, most_pieces);
            return std::max(1, static_cast<int>(share * wanted));
        };
        double total = 0.0;
        for (int t = 0; t < count(); ++t) {
            const int pieces = pieces_for(turns[static_cast<std::size_t>(regions_.find(t))], 1.0);
            total += static_cast<double>(pieces) * pieces;
        }
        const double share = std::min(1.0, std::sqrt(most_triangles / total));
        for (const double turn : turns) pieces_.push_back(pieces_for(turn, share));
    }

    // The corners of the pieces along an edge, from its end `from`.
    std::vector<int> list_points(int from, int to, int pieces, RoundedTriangles& result) {
        const Edge edge = std::minmax(from, to);
        std::vector<int>& points = points_[{edge, pieces}];
        if (points.empty()) {
            points.push_back(edge.first);
            const Vec3 &a = corner_at(mesh_, edge.first), &b = corner_at(mesh_, edge.second);
            for (int i = 1; i < pieces; ++i) {
                const double t = static_cast<double>(i) / pieces;
                points.push_back(add(a + t * (b - a), t * (1.0 - t) * curves_[edge].bow, result));
            }
            points.push_back(edge.second);
        }
        std::vector<int> own = points;
        if (from != edge.first) std::ranges::reverse(own);
        return own;
    }

    static int add(const Vec3& flat, const Vec3& lift, RoundedTriangles& result) {
        result.depth = std::max(result.depth, lift.norm());
        result.mesh.positions.push_back(flat + lift);
        return static_cast<int>(result.mesh.positions.size()) - 1;
    }

    // Rows of points from the side between the first two corners to the third one.
    void cut(int t, RoundedTriangles& result) {
        const int pieces = pieces_of(t);
        const auto [a, b, c] = triangle(t);
        const std::vector<int> left = list_points(a, c, pieces, result);
        const std::vector<int> right = list_points(b, c, pieces, result);
        std::vector<int> row = list_points(a, b, pieces, result);
        for (int j = 1; j <= pieces; ++j) {
            std::vector<int> next{left[static_cast<std::size_t>(j)]};
            for (int i = 1; i < pieces - j; ++i) next.push_back(add_inner(t, i, j, pieces, result));
            if (j < pieces) next.push_back(right[static_cast<std::size_t>(j)]);
            for (std::size_t i = 0; i + 1 < row.size(); ++i) {
                add_triangle(t, {row[i], row[i + 1], next[i]}, result);
                if (i + 1 < next.size()) add_triangle(t, {row[i + 1], next[i + 1], next[i]}, result);
            }
            row = std::move(next);
        }
    }

    int add_inner(int t, int i, int j, int pieces, RoundedTriangles& result) {
        const auto [a, b, c] = triangle(t);
        const double at_b = static_cast<double>(i) / pieces, at_c = static_cast<double>(j) / pieces;
        const double at_a = static_cast<double>(pieces - i - j) / pieces;
        const auto bow = [&](int from, int to) -> const Vec3& { return curves_[std::minmax(from, to)].bow; };
        return add(at_a * corner_at(mesh_, a) + at_b * corner_at(mesh_, b) + at_c * corner_at(mesh_, c),
                   at_a * at_b * bow(a, b) + at_b * at_c * bow(b, c) + at_c * at_a * bow(c, a),
                   result);
    }

    void add_triangle(int t, const std::array<int, 3>& corners, RoundedTriangles& result) const {
        result.mesh.triangles.push_back(corners);
        result.mesh.numbers.push_back(mesh_.numbers[static_cast<std::size_t>(t)]);
    }

    const TriangleMesh& mesh_;
    SidesOfEdges sides_;
    Orientation orientation_;
    DisjointSets corners_;  // of triangles, 3 t + i; those of one surface around a corner together
    DisjointSets regions_;  // of triangles that are cut alike
    std::vector<Vec3> normals_;
    std::map<Edge, EdgeCurve> curves_;
    std::vector<int> pieces_;                                  // at each region
    std::map<std::pair<Edge, int>, std::vector<int>> points_;  // along edges, by their pieces
};

}  // namespace

RoundedTriangles round_triangles(const TriangleMesh& mesh) { return Rounder(mesh).run(); }

}  // namespace gxrod
