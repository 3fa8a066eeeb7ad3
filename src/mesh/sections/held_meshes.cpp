#include "mesh/sections/held_meshes.hpp"

#include <Eigen/SparseCholesky>
#include <algorithm>
#include <deque>
#include <limits>
#include <memory>
#include <mutex>

namespace gxrod {
namespace {

thread_local int held = 0;

constexpr double most_change = 5e-3;  // of points of the outline, over its size
constexpr std::size_t most_remembered = 64;

// Its division refers to its own outline.
struct Remembered {
    Outline outline;
    OutlineTriangles mesh;
};

std::mutex remembered_mutex;
std::deque<std::shared_ptr<const Remembered>> remembered;

// For each edge of the boundary, the same part of the same piece of another outline with as many pieces.
std::vector<BoundaryEdges> transfer(const std::vector<BoundaryEdges>& edges,
                                    const Outline& from,
                                    const Outline& to) {
    std::vector<BoundaryEdges> transferred = edges;
    const auto old_loops = from.loops(), new_loops = to.loops();
    for (std::size_t l = 0; l < edges.size(); ++l) {
        for (BoundaryEdge& edge : transferred[l])
            edge.piece = new_loops[l]->data() + (edge.piece - old_loops[l]->data());
    }
    return transferred;
}

// How far points of two outlines are apart, over the size; infinite if their pieces differ.
double compare(const Outline& one, const Outline& other) {
    constexpr double apart = std::numeric_limits<double>::infinity();
    const auto loops = one.loops(), others = other.loops();
    if (loops.size() != others.size()) return apart;
    double distance = 0.0, size = 0.0;
    for (std::size_t l = 0; l < loops.size(); ++l) {
        if (loops[l]->size() != others[l]->size()) return apart;
        for (std::size_t i = 0; i < loops[l]->size(); ++i) {
            const OutlinePiece &piece = (*loops[l])[i], &with = (*others[l])[i];
            if (piece.is_arc() != with.is_arc()) return apart;
            for (const double part : {0.0, 0.5})
                distance = std::max(distance, (piece.at(part) - with.at(part)).norm());
            size = std::max(size, (piece.from - loops[l]->front().from).norm());
        }
    }
    return distance / size;
}

// Moves points inside by the mean of how their neighbours move.
void move_inside(const std::vector<PlanePoint>& boundary, PlaneTriangles& mesh) {
    const auto fixed = static_cast<int>(boundary.size());
    const auto free = static_cast<int>(mesh.points.size()) - fixed;
    std::vector<PlanePoint> shift(boundary.size());
    for (std::size_t i = 0; i < boundary.size(); ++i) shift[i] = boundary[i] - mesh.points[i];
    Eigen::MatrixX2d pull = Eigen::MatrixX2d::Zero(free, 2);
    std::vector<Eigen::Triplet<double>> entries;
    const auto add = [&](int a, int b) {
        if (a < fixed) return;
        entries.emplace_back(a - fixed, a - fixed, 1.0);
        if (b < fixed)
            pull.row(a - fixed) += shift[static_cast<std::size_t>(b)].transpose();
        else
            entries.emplace_back(a - fixed, b - fixed, -1.0);
    };
    for (const auto& triangle : mesh.triangles) {
        for (std::size_t k = 0; k < 3; ++k) {
            add(triangle[k], triangle[(k + 1) % 3]);
            add(triangle[(k + 1) % 3], triangle[k]);
        }
    }
    std::ranges::copy(boundary, mesh.points.begin());
    if (free == 0) return;
    Eigen::SparseMatrix<double> matrix(free, free);
    matrix.setFromTriplets(entries.begin(), entries.end());
    const Eigen::MatrixX2d moved = Eigen::SimplicialLDLT<Eigen::SparseMatrix<double>>(matrix).solve(pull);
    const auto first_inside = mesh.points.begin() + fixed;
    for (int i = 0; i < free; ++i) first_inside[i] += moved.row(i).transpose();
}

}  // namespace

HeldMeshes::HeldMeshes() { ++held; }
HeldMeshes::~HeldMeshes() { --held; }
bool HeldMeshes::are_on() { return held > 0; }

void remember_triangles(const Outline& outline, const OutlineTriangles& mesh) {
    auto kept = std::make_shared<Remembered>(Remembered{outline, mesh});
    kept->mesh.boundary.loops = transfer(mesh.boundary.loops, outline, kept->outline);
    const std::scoped_lock lock(remembered_mutex);
    if (remembered.size() >= most_remembered) remembered.pop_front();
    remembered.push_back(std::move(kept));
}

std::optional<OutlineTriangles> move_remembered(const Outline& outline, const SectionMeshSize& size) {
    std::shared_ptr<const Remembered> nearest;
    double least = most_change;
    {
        const std::scoped_lock lock(remembered_mutex);
        for (const auto& one : remembered) {
            const double distance = compare(one->outline, outline);
            if (distance < least) nearest = one;
            least = std::min(least, distance);
        }
    }
    if (!nearest) return std::nullopt;
    OutlineTriangles moved{divide_boundary(outline, size), nearest->mesh.triangles};
    moved.boundary.loops = transfer(nearest->mesh.boundary.loops, nearest->outline, outline);
    std::vector<PlanePoint> boundary;
    for (const BoundaryEdges& loop : moved.boundary.loops) {
        for (const BoundaryEdge& edge : loop) boundary.push_back(edge.start());
    }
    move_inside(boundary, moved.triangles);
    return moved;
}

}  // namespace gxrod
