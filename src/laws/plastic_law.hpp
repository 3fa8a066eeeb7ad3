#pragma once

#include <optional>
#include <utility>
#include <vector>

#include "laws/piecewise_line.hpp"
#include "model/sections/kinked_law.hpp"
#include "model/sections/small_motion_law.hpp"

namespace gxrod {

enum class YieldInteraction {
    ellipsoid,  // the sum of the squares of resultants over their limits is at most 1
    none        // each resultant has its own limit
};

// The limits of resultants and their hardening.
struct YieldLimits {
    std::vector<std::pair<int, double>> limits;  // entry of S, its positive limit
    YieldInteraction interaction = YieldInteraction::ellipsoid;
    // The factor of all limits over the accumulated plastic strain, in strains at yield; from (0, 1) on, not
    // falling. Without it limits are constant.
    std::optional<PiecewiseLine> isotropic;
    double kinematic = 0.0;  // stiffness of yielded entries relative to their elastic one
};

// Elastic by C up to a yield surface; beyond it S returns to its closest point in the energy norm;
// docs/theory/laws.md, (L18)–(L26). It remembers for each surface plastic strains and accumulated yield.
class PlasticLaw final : public SmallMotionLaw, public KinkedLaw {
  public:
    // With `interaction` none, C couples no two yielding entries.
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
    int piece_count() const override { return static_cast<int>(surfaces_.size()); }
    void find_pieces(const Vec6& strain,
                     std::span<const double> memory,
                     std::span<int> pieces) const override;
    SectionResponse respond_on(std::span<const int> pieces,
                               const Vec6& strain,
                               std::span<const double> memory,
                               double elapsed,
                               std::span<double> after) const override;

    const YieldLimits& yield() const { return yield_; }

    // The entries of one surface: up to 6, without allocation.
    using Entries = Eigen::Matrix<double, Eigen::Dynamic, 1, 0, 6, 1>;
    using Square = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, 0, 6, 6>;

  private:
    // A yield surface: resultants over their limits, in axes in which a return scales each entry separately.
    struct Surface {
        std::vector<int> index;  // entries of E
        Entries limits;
        Entries hardening;    // kinematic: back stress per plastic strain
        Entries rate;         // λ_j of (L21), 1/energy
        Square axes;          // V, columns
        double energy = 1.0;  // w of (L19): the energy of a yield strain
    };

    struct Return;

    static Surface make_surface(const Mat6& C,
                                const std::vector<std::pair<int, double>>& limits,
                                double kinematic);
    // Pieces: −1 if a surface does not yield; else the final piece of the isotropic hardening.
    static constexpr int elastic_piece = -1;

    double factor(double gone) const;
    Entries scale_resultants(const Surface& surface, const Vec6& elastic, const double* memory) const;
    // Returns strains without the plastic strains of all surfaces.
    Vec6 subtract_plastic(const Vec6& strain, std::span<const double> memory) const;
    // The factor of all limits by isotropic hardening, on its own piece or on a given one.
    struct Hardening {
        double factor, slope, integral;
    };
    Hardening harden(double gone, const int* piece) const;
    Return find_return(const Surface& surface, const Entries& trial, double gone, const int* piece) const;
    // Calls choose(index, part of its limits that a surface uses) for each surface; it returns a pointer to
    // the piece, or nullptr if the piece is to be found.
    template <class Choose>
    SectionResponse respond_by(const Vec6& strain,
                               std::span<const double> memory,
                               std::span<double> after,
                               Choose&& choose) const;
    template <class Choose>
    void add(const Surface& surface,
             const Vec6& elastic_trial,
             const double* memory,
             double* after,
             Vec6& elastic,
             SectionResponse& response,
             Choose&& choose) const;

    Mat6 stiffness_;
    YieldLimits yield_;
    std::vector<Surface> surfaces_;
    int memory_size_ = 0;
};

}  // namespace gxrod
