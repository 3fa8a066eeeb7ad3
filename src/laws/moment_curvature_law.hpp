#pragma once

#include <memory>
#include <optional>
#include <vector>

#include "laws/piecewise_line.hpp"
#include "laws/strain_part.hpp"
#include "model/sections/kinked_law.hpp"

namespace gxrod {

// A curve of a moment over a curvature, or of the size of both moments over the size of both curvatures.
struct MomentCurve {
    StrainPart on = StrainPart::bending;  // or about y or z alone
    PiecewiseLine curve;                  // from (0, 0), not falling
};

// A section with elastic curves for bending and C for all other strains; docs/theory/laws.md, (L7) and (L8).
class MomentCurvatureLaw final : public SectionLaw, public KinkedLaw {
  public:
    // C couples no entry that has a curve with another one.
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
    // Computes the response to all strains without curves.
    SectionResponse respond_without_curves(const Vec6& strain) const;

    Mat6 others_;  // C without the entries that curves replace
    std::vector<MomentCurve> curves_;
};

// Makes a law with the same curves for first loading, which yields at each kink and hardens kinematically:
// layers, by (L9). Slopes must not rise from piece to piece.
std::shared_ptr<const SectionLaw> make_kinematic_law(const Mat6& C, const std::vector<MomentCurve>& curves);

// Finds the first piece with a larger slope than the piece before it.
std::optional<std::size_t> find_rising_slope(const PiecewiseLine& curve);

}  // namespace gxrod
