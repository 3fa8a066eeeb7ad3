#pragma once

#include <memory>
#include <optional>
#include <vector>

#include "laws/piecewise_line.hpp"
#include "laws/strain_part.hpp"
#include "model/sections/kinked_law.hpp"

namespace gxrod {

// A moment over a curvature, or its size over the size of both.
struct MomentCurve {
    StrainPart on = StrainPart::bending;  // or about y or z alone
    PiecewiseLine curve;                  // from (0, 0), not falling
};

// Bends elastically along curves, and has what C says of all else; docs/theory/laws.md, (L7) and (L8).
class MomentCurvatureLaw final : public SectionLaw, public KinkedLaw {
  public:
    // C couples no entry that has a curve with any other one.
    MomentCurvatureLaw(const Mat6& C, std::vector<MomentCurve> curves);

    int memory_size() const override { return 0; }
    std::string describe() const override { return "moments by tables, without hysteresis"; }
    SectionResponse respond(const Vec6& strain,
                            std::span<const double> memory,
                            double elapsed,
                            std::span<double> after) const override;
    int piece_count() const override { return static_cast<int>(curves_.size()); }
    void find_pieces(const Vec6& strain,
                     std::span<const double> memory,
                     std::span<int> pieces) const override;
    SectionResponse respond_on(std::span<const int> pieces,
                               const Vec6& strain,
                               std::span<const double> memory,
                               double elapsed,
                               std::span<double> after) const override;

    const std::vector<MomentCurve>& curves() const { return curves_; }

  private:
    // The response to all strains that have no curves.
    SectionResponse respond_without_curves(const Vec6& strain) const;

    Mat6 others_;  // C without what curves replace
    std::vector<MomentCurve> curves_;
};

// The same curves as first loading of a section that yields at each kink and hardens kinematically: layers,
// by (L9). Slopes must not rise from piece to piece.
std::shared_ptr<const SectionLaw> make_kinematic_law(const Mat6& C, const std::vector<MomentCurve>& curves);

// The first piece whose slope is above that of the one before it.
std::optional<std::size_t> find_rising_slope(const PiecewiseLine& curve);

}  // namespace gxrod
