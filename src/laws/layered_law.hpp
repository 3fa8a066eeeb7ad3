#pragma once

#include <vector>

#include "laws/strain_part.hpp"
#include "model/sections/kinked_law.hpp"
#include "model/sections/small_motion_law.hpp"

namespace gxrod {

// A spring that slips, in parallel with the rest of a section, as in the model of Besseling and Iwan.
struct Layer {
    StrainPart on = StrainPart::bending;
    double stiffness = 0.0;          // resultant per strain of each entry, before it slips
    double limit = 0.0;              // largest size of its resultants
    double limit_per_tension = 0.0;  // growth of the limit per positive axial resultant
};

// The law S = C E + Σ S_i, each layer's S_i elastic up to its limit, at which it slips; docs/theory/laws.md,
// (L1)–(L6). It remembers the slip of each layer, a strain for each of its entries.
class LayeredLaw final : public SmallMotionLaw, public KinkedLaw {
  public:
    // `C` acts in parallel with all layers; it can be semidefinite. Layers on tension have no
    // limit_per_tension.
    LayeredLaw(const Mat6& C, std::vector<Layer> layers);

    int memory_size() const override { return memory_size_; }
    std::string describe() const override {
        return layers_.empty() ? "linear" : "slips, layers: " + std::to_string(layers_.size());
    }
    SectionResponse respond(const Vec6& strain,
                            std::span<const double> memory,
                            double elapsed,
                            std::span<double> after) const override;
    Mat6 elastic_tangent(const Vec6& strain, std::span<const double> memory) const override;
    bool is_at_limit(const Vec6& strain, std::span<const double> memory) const override;
    int piece_count() const override { return static_cast<int>(layers_.size()); }
    void find_pieces(const Vec6& strain,
                     std::span<const double> memory,
                     std::span<int> pieces) const override;
    SectionResponse respond_on(std::span<const int> pieces,
                               const Vec6& strain,
                               std::span<const double> memory,
                               double elapsed,
                               std::span<double> after) const override;

    const Mat6& stiffness() const { return stiffness_; }
    const std::vector<Layer>& layers() const { return layers_; }

  private:
    // Whether a layer slips, and whether tension raises its limit.
    enum Piece : unsigned { slips = 1, is_pulled = 2 };

    // Calls choose(index, piece found, part of its limit that a layer takes) for the piece of each layer.
    template <class Choose>
    SectionResponse respond_by(const Vec6& strain,
                               std::span<const double> memory,
                               std::span<double> after,
                               Choose&& choose) const;
    template <class Choose>
    void add(const Layer& layer,
             const Vec6& strain,
             const double* slip,
             double* slip_after,
             SectionResponse& response,
             Choose&& choose) const;

    Mat6 stiffness_;
    std::vector<Layer> layers_;  // layers on tension first
    int memory_size_ = 0;
};

}  // namespace gxrod
