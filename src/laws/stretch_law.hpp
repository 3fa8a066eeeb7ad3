#pragma once

#include <optional>

#include "laws/piecewise_line.hpp"
#include "model/sections/kinked_law.hpp"
#include "model/sections/small_motion_law.hpp"

namespace gxrod {

// A curve of the axial force over the axial strain.
struct StretchCurve {
    PiecewiseLine pulled;  // tension over stretch, from (0, 0), not falling
    PiecewiseLine pushed;  // compression over shortening, likewise
    // The slope along which the tension falls below the largest stretch so far, and returns; not below any
    // slope of `pulled`. nullopt: back along the curve.
    std::optional<double> unloading = {};
};

// A section with a curve for its axial force and C for all other strains; docs/theory/laws.md, (L32) to
// (L34). With `unloading` it remembers the largest stretch, and a rope that is slack is longer by what it has
// yielded.
class StretchLaw final : public SmallMotionLaw, public KinkedLaw {
  public:
    // C does not couple the axial strain with another one.
    StretchLaw(const Mat6& C, StretchCurve curve);

    int memory_size() const override { return curve_.unloading ? 1 : 0; }
    std::string describe() const override;
    SectionResponse respond(const Vec6& strain,
                            std::span<const double> memory,
                            double elapsed,
                            std::span<double> after) const override;
    Mat6 elastic_tangent(const Vec6& strain, std::span<const double> memory) const override;
    bool is_at_limit(const Vec6& strain, std::span<const double> memory) const override;
    int piece_count() const override { return 1; }
    void find_pieces(const Vec6& strain,
                     std::span<const double> memory,
                     std::span<int> pieces) const override;
    SectionResponse respond_on(std::span<const int> pieces,
                               const Vec6& strain,
                               std::span<const double> memory,
                               double elapsed,
                               std::span<double> after) const override;

    const StretchCurve& curve() const { return curve_; }

  private:
    // Pieces of `pulled` are numbered from 0, the unloading line is behind them, pieces of `pushed` are -1,
    // -2 …
    int find_piece(double strain, double largest, double near) const;
    SectionResponse respond_by(int piece,
                               const Vec6& strain,
                               std::span<const double> memory,
                               std::span<double> after) const;
    int unloading_piece() const { return static_cast<int>(curve_.pulled.piece_count()); }
    // The strain at which a rope that was stretched so far is slack.
    double find_slack(double largest) const;

    Mat6 others_;  // C without the axial stiffness
    StretchCurve curve_;
};

}  // namespace gxrod
