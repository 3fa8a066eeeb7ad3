#pragma once

#include <vector>

#include "laws/layered_law.hpp"

namespace gxrod {

// A part of a section's area at the coordinates y and z.
struct Fibre {
    double y = 0.0, z = 0.0;
    double area = 0.0;
};

// Fibres of one material; one that stays elastic has an infinite yield stress.
struct FibreGroup {
    std::vector<Fibre> fibres;
    double E = 1.0, yield_stress = 1.0;
};

// The law of elastic, perfectly plastic fibres, each by its own strain, so that axial force and both bending
// moments interact; what is left, torsion and shear, answers by itself. docs/theory/laws.md, (L30). It
// remembers what `rest` does, then the plastic strain of each fibre.
class FibreLaw final : public SmallMotionLaw, public KinkedLaw {
  public:
    // `rest` has no stiffness in tension and bending.
    FibreLaw(LayeredLaw rest, const std::vector<FibreGroup>& groups);
    FibreLaw(LayeredLaw rest, std::vector<Fibre> fibres, double E, double yield_stress);

    int memory_size() const override { return rest_.memory_size() + fibre_count_; }
    std::string describe() const override { return "yields, fibres: " + std::to_string(fibre_count_); }
    SectionResponse respond(const Vec6& strain,
                            std::span<const double> memory,
                            double elapsed,
                            std::span<double> after) const override;
    Mat6 elastic_tangent(const Vec6& strain, std::span<const double> memory) const override;
    bool is_at_limit(const Vec6& strain, std::span<const double> memory) const override;
    int piece_count() const override { return rest_.piece_count() + fibre_count_; }
    void find_pieces(const Vec6& strain,
                     std::span<const double> memory,
                     std::span<int> pieces) const override;
    SectionResponse respond_on(std::span<const int> pieces,
                               const Vec6& strain,
                               std::span<const double> memory,
                               double elapsed,
                               std::span<double> after) const override;

    int fibre_count() const { return fibre_count_; }

  private:
    // Fibres that are computed together, of one material; those that fill up a block have no area.
    static constexpr int block_size = 8;
    using Lanes = Eigen::Array<double, block_size, 1>;
    struct Block {
        Lanes y = Lanes::Zero(), z = Lanes::Zero(), area = Lanes::Zero();
        double modulus, limit;
        int first, count;  // fibres
    };

    struct Held {
        Lanes stress;
        Lanes elastic;  // 1, or 0 where a fibre yields
    };

    static Lanes find_trial(const Block& block, const Vec6& strain, const double* plastic);
    // Adds the fibres to a response. hold(block, trial stresses) returns what they are held to.
    template <class Hold>
    void add_fibres(const Vec6& strain,
                    std::span<const double> memory,
                    std::span<double> after,
                    SectionResponse& response,
                    Hold&& hold) const;

    LayeredLaw rest_;
    int fibre_count_ = 0;
    std::vector<Block> blocks_;
};

}  // namespace gxrod
