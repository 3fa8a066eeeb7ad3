#include "mesh/sections/boundary_division.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <numbers>
#include <span>

#include "cross_section/outlines/wall_thickness.hpp"
#include "mesh/grading.hpp"
#include "mesh/line_mesh.hpp"

namespace gxrod {
namespace {

// PieceSizes of elements at places of one piece, by the fraction of its length.
struct SizeAt {
    double fraction;
    PlanePoint at;
    double size;
};
using PieceSizes = std::map<const OutlinePiece*, std::vector<SizeAt>>;

PlanePoint find_extents(const Outline& outline) {
    PlanePoint least = outline.outer.front().from, greatest = least;
    for (const OutlinePiece& piece : outline.outer) {
        least = least.cwiseMin(piece.from);
        greatest = greatest.cwiseMax(piece.from);
    }
    return greatest - least;
}

// Whether the area has an angle of more than 195 degrees, and no arc, at the start of a piece. Stresses at
// less blunt corners, as of curves by many points, have next to no singularity.
bool is_sharp(const OutlinePiece& before, const OutlinePiece& piece) {
    constexpr double most_turn = std::numbers::pi / 12.0;
    const PlanePoint in = before.direction(1.0), out = piece.direction(0.0);
    return std::atan2(cross(in, out), in.dot(out)) < -most_turn;
}

class SizeField {
  public:
    SizeField(const Outline& outline, const SectionMeshSize& size)
        : outline_(outline), size_(size), most_(size.per_extent * find_extents(outline).minCoeff()) {
        for (const OutlineLoop* loop : outline.loops()) {
            for (const OutlinePiece& piece : *loop) measure(piece);
        }
        for (const OutlineLoop* loop : outline.loops()) refine_corners(*loop);
        smooth();
    }

    const std::vector<SizeAt>& of(const OutlinePiece& piece) const { return sizes_.at(&piece); }
    const std::vector<SharpCorner>& sharp_corners() const { return sharp_corners_; }

  private:
    // A wall may become thinner than this part of `most_` at the edge of a wedge.
    static constexpr double least_part = 1e-2;

    void measure(const OutlinePiece& piece) {
        // Dense at the ends, where sizes change.
        constexpr std::array all{0.0,
                                 1.0 / 64,
                                 1.0 / 32,
                                 1.0 / 16,
                                 0.125,
                                 0.25,
                                 0.375,
                                 0.5,
                                 0.625,
                                 0.75,
                                 0.875,
                                 15.0 / 16,
                                 31.0 / 32,
                                 63.0 / 64,
                                 1.0};
        constexpr std::array few{0.0, 0.5, 1.0};
        const bool is_short = piece.length() < 0.2 * most_;
        for (const double fraction : is_short ? std::span<const double>(few) : std::span<const double>(all)) {
            double size = most_;
            if (const auto opposite = find_opposite_wall(outline_, piece, fraction)) {
                size = std::clamp(size_.per_thickness * opposite->thickness, least_part * most_, most_);
                add(*opposite->piece, opposite->fraction, size);
            }
            add(piece, fraction, size);
        }
    }

    void add(const OutlinePiece& piece, double fraction, double size) {
        sizes_[&piece].push_back({fraction, piece.at(fraction), size});
    }

    // The size at the start of a piece, of both pieces there.
    double size_at_start(const OutlinePiece& before, const OutlinePiece& piece) const {
        double least = most_;
        for (const SizeAt& one : sizes_.at(&before))
            if (one.fraction == 1.0) least = std::min(least, one.size);
        for (const SizeAt& one : sizes_.at(&piece))
            if (one.fraction == 0.0) least = std::min(least, one.size);
        return least;
    }

    void refine_corners(const OutlineLoop& loop) {
        for (std::size_t i = 0; i < loop.size(); ++i) {
            const OutlinePiece& before = loop[(i + loop.size() - 1) % loop.size()];
            if (!is_sharp(before, loop[i])) continue;
            const double size = size_at_start(before, loop[i]);
            sharp_corners_.push_back({loop[i].from, size});
            add(loop[i], 0.0, size * size_.per_thickness_at_corners / size_.per_thickness);
        }
    }

    // Lets no size grow faster than by `growth` of the distance.
    void smooth() {
        std::vector<SizeAt> all;
        for (const auto& [piece, sizes] : sizes_) all.insert(all.end(), sizes.begin(), sizes.end());
        for (auto& [piece, sizes] : sizes_) {
            for (SizeAt& one : sizes) {
                for (const SizeAt& other : all)
                    one.size = std::min(one.size, other.size + size_.growth * (one.at - other.at).norm());
            }
            std::ranges::stable_sort(sizes, {}, &SizeAt::fraction);
        }
    }

    const Outline& outline_;
    const SectionMeshSize size_;
    double most_;
    PieceSizes sizes_;
    std::vector<SharpCorner> sharp_corners_;
};

// At most 18 degrees of an arc for one edge.
double count_edges(const OutlinePiece& piece, const Grading& grading) {
    constexpr double round_off = 1e-3, of_arc = std::numbers::pi / 10.0;
    const double by_size = std::ceil(grading.count_steps() - round_off);
    const double by_turn = std::ceil(std::abs(piece.turn) / of_arc - round_off);
    return std::max({1.0, by_size, by_turn});
}

Grading grade(const OutlinePiece& piece, const std::vector<SizeAt>& sizes) {
    std::vector<std::pair<double, double>> steps;
    for (const SizeAt& one : sizes) steps.emplace_back(one.fraction, one.size / piece.length());
    return Grading(steps);
}

// Sections with as many edges have some 30,000 triangles, which take a minute.
constexpr int most_edges = 6000;

// Says that an outline has too many edges, by its thinnest wall.
std::string explain_too_many(const Outline& outline) {
    double thinnest = find_extents(outline).minCoeff();
    for (const OutlineLoop* loop : outline.loops()) {
        for (const OutlinePiece& piece : *loop) {
            if (const auto opposite = find_opposite_wall(outline, piece, 0.5))
                thinnest = std::min(thinnest, opposite->thickness);
        }
    }
    return fmt::format(
        "has more than {} edges of triangles around it: it is {:.3g} thick somewhere, and {:.3g} across; "
        "draw thin parts as a "
        "rectangle, walls or a mesh, whose cells are long",
        most_edges,
        thinnest,
        find_extents(outline).maxCoeff());
}

void check_count(const Outline& outline, const SizeField& field) {
    double count = 0.0;
    for (const OutlineLoop* loop : outline.loops()) {
        for (const OutlinePiece& piece : *loop) count += count_edges(piece, grade(piece, field.of(piece)));
    }
    if (!(count <= most_edges)) throw MeshError(explain_too_many(outline));
}

void divide(const OutlinePiece& piece, const std::vector<SizeAt>& sizes, BoundaryEdges& edges) {
    const Grading grading = grade(piece, sizes);
    const int count = static_cast<int>(count_edges(piece, grading));
    double from = 0.0;
    for (int i = 0; i < count; ++i) {
        const double to = i + 1 == count ? 1.0 : grading.fraction_at((i + 1.0) / count);
        edges.push_back({&piece, from, to, (to - from) * piece.length()});
        from = to;
    }
}

}  // namespace

BoundaryDivision divide_boundary(const Outline& outline, const SectionMeshSize& size) {
    const SizeField field(outline, size);
    check_count(outline, field);
    BoundaryDivision division{.loops = {}, .sharp_corners = field.sharp_corners()};
    for (const OutlineLoop* loop : outline.loops()) {
        BoundaryEdges& edges = division.loops.emplace_back();
        for (const OutlinePiece& piece : *loop) divide(piece, field.of(piece), edges);
    }
    return division;
}

}  // namespace gxrod
