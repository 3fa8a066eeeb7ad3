#include "cross_section/walls/wall_overlap.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "cross_section/examination/segment_crossing.hpp"

namespace gxrod {
namespace {

// Pieces of a polygon that stands for an arc, a radian: it is 3e-5 of the radius off.
constexpr double chords_a_radian = 64.0;

int count_chords(const WallPiece& piece) {
    return piece.is_arc() ? static_cast<int>(std::ceil(chords_a_radian * std::abs(piece.turn))) : 1;
}

}  // namespace

std::optional<WallFault> find_wall_overlap(const std::vector<WallPiece>& pieces) {
    std::vector<PlaneSegment> segments;
    for (const WallPiece& piece : pieces) {
        const int chords = count_chords(piece);
        for (const double across : {0.0, 0.5, 1.0}) {
            for (int i = 0; i < chords; ++i) {
                segments.push_back({piece.at(static_cast<double>(i) / chords, across),
                                    piece.at(static_cast<double>(i + 1) / chords, across),
                                    static_cast<int>(piece.side)});
            }
        }
    }
    // The ends of an open wall are surfaces too; of a closed one they are cuts within it, which cross
    // nothing.
    const WallCut &start = pieces.front().start, &end = pieces.back().end;
    segments.push_back({start.right, start.left, static_cast<int>(pieces.front().side)});
    segments.push_back({end.right, end.left, static_cast<int>(pieces.back().side)});
    const std::optional<SegmentCrossing> found = find_crossing(std::move(segments));
    if (!found) return std::nullopt;
    const auto [first, second] = std::minmax({found->a.owner, found->b.owner});
    return WallFault{"corners",
                     fmt::format("the walls of sides {} and {} overlap near ({:.4g}, {:.4g})",
                                 first,
                                 second,
                                 found->at.x(),
                                 found->at.y())};
}

}  // namespace gxrod
