#pragma once

#include <span>
#include <vector>

#include "elements/rod/rod_section.hpp"

namespace gxrod {

// Derivatives of a law's response at a force point, weighed: of −forces · S + after · M, S its resultants and
// M its memory after the step. Steps of differences are a thousandth of what is elastic there.
class WeighedLaw {
  public:
    // Takes the strain of the law, its memory before the step and the time since then, as
    // SectionLaw::respond; the section must outlive this, and have a law.
    WeighedLaw(const RodSection& section, const Vec6& strain, std::span<const double> memory, double elapsed);

    // Computes ∂(after · M)/∂E.
    Vec6 differentiate_by_strain(std::span<const double> after) const;
    // Adds the derivatives of the whole by the numbers of the memory; `after` can be empty.
    void add_by_memory(const Vec6& forces, std::span<const double> after, std::span<double> by_memory) const;
    // Finds a step of a number of the memory that changes resultants by a small part.
    double find_step(std::size_t number) const;

  private:
    double measure(const Vec6& resultants) const;
    double find_energy() const;
    double weigh(const Vec6& strain,
                 std::span<const double> memory,
                 const Vec6& forces,
                 std::span<const double> after) const;

    const SectionLaw& law_;
    Vec6 stiffness_;  // of small strains, without coupling
    Vec6 strain_;
    std::vector<double> memory_;
    double elapsed_;
    std::vector<double> after_;          // M
    mutable std::vector<double> moved_;  // M where something is moved
    Vec6 resultants_;
    double energy_;
};

}  // namespace gxrod
