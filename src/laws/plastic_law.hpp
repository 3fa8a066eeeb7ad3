#pragma once

#include <optional>
#include <utility>
#include <vector>

#include "laws/piecewise_line.hpp"
#include "model/small_motion_law.hpp"

namespace gxrod {

enum class YieldInteraction {
    ellipsoid,  // the squares of resultants over their limits add up to 1
    none        // each resultant by itself
};

// Where resultants yield and how they harden.
struct YieldLimits {
    std::vector<std::pair<int, double>> limits;  // entry of S, its limit, positive
    YieldInteraction interaction = YieldInteraction::ellipsoid;
    // What all limits are multiplied with, over the plastic strain gone through, in strains at yield; from
    // (0, 1) on, not falling. None: they stay.
    std::optional<PiecewiseLine> isotropic;
    double kinematic = 0.0;  // stiffness by which yielded entries still resist, over their elastic one
};

// Elastic by C up to a yield surface, then S returns to its closest point in the energy norm;
// docs/theory/laws.md, (L18)–(L26). It remembers, of each surface, plastic strains and how much it has
// yielded.
class PlasticLaw final : public SmallMotionLaw {
  public:
    // `interaction` none: C couples no two yielding entries.
    PlasticLaw(const Mat6& C, const YieldLimits& yield);

    int memory_size() const override { return memory_size_; }
    std::string describe() const override {
        return "yields, limits: " + std::to_string(yield_.limits.size());
    }
    SectionResponse respond(const Vec6& strain,
                            std::span<const double> memory,
                            double elapsed,
                            std::span<double> after) const override;
    Mat6 elastic_tangent(const Vec6& /*strain*/, std::span<const double> /*memory*/) const override {
        return stiffness_;
    }
    bool is_at_limit(const Vec6& strain, std::span<const double> memory) const override;

    const YieldLimits& yield() const { return yield_; }

    // Those of one surface: of up to 6 entries, without allocation.
    using Entries = Eigen::Matrix<double, Eigen::Dynamic, 1, 0, 6, 1>;
    using Square = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, 0, 6, 6>;

  private:
    // Resultants over their limits, in axes in which a return scales each entry by itself.
    struct Surface {
        std::vector<int> index;  // of E
        Entries limits;
        Entries hardening;    // kinematic: back stress per plastic strain
        Entries rate;         // λ_j of (L21), 1/energy
        Square axes;          // V, columns
        double energy = 1.0;  // w of (L19): a yield strain is worth that much
    };

    struct Return;

    static Surface make_surface(const Mat6& C,
                                const std::vector<std::pair<int, double>>& limits,
                                double kinematic);
    double factor(double gone) const;
    Entries scale_resultants(const Surface& surface, const Vec6& elastic, const double* memory) const;
    // Strains without the plastic ones of all surfaces.
    Vec6 subtract_plastic(const Vec6& strain, std::span<const double> memory) const;
    Return find_return(const Surface& surface, const Entries& trial, double gone) const;
    void add(const Surface& surface,
             const Vec6& elastic_trial,
             const double* memory,
             double* after,
             Vec6& elastic,
             SectionResponse& response) const;

    Mat6 stiffness_;
    YieldLimits yield_;
    std::vector<Surface> surfaces_;
    int memory_size_ = 0;
};

}  // namespace gxrod
