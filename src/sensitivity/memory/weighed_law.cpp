#include "sensitivity/memory/weighed_law.hpp"

#include <algorithm>
#include <cmath>

namespace gxrod {

namespace {

constexpr double part = 1e-3;

// Where a section yields, resultants hardly follow what it remembers, or not all strains by far, and steps
// can be too large.
template <class Function>
double differentiate_with_care(const Function& f, double step) {
    constexpr int trials = 3;
    constexpr double curved = 1e-6;
    const auto difference = [&](double h) { return (f(h) - f(-h)) / (2.0 * h); };
    double near = difference(step), far = difference(2.0 * step);
    for (int trial = 1; trial < trials && std::abs(near - far) > curved * std::abs(near); ++trial) {
        step *= 0.1;
        near = difference(step);
        far = difference(2.0 * step);
    }
    return (4.0 * near - far) / 3.0;
}

bool are_zero(std::span<const double> numbers) {
    return std::ranges::all_of(numbers, [](double one) { return one == 0.0; });
}

}  // namespace

WeighedLaw::WeighedLaw(const RodSection& section,
                       const Vec6& strain,
                       std::span<const double> memory,
                       double elapsed)
    : law_(*section.law),
      stiffness_(section.stiffness.diagonal()),
      strain_(strain),
      memory_(memory.begin(), memory.end()),
      elapsed_(elapsed),
      after_(memory_.size()),
      moved_(memory_.size()),
      resultants_(law_.respond(strain_, memory_, elapsed_, after_).resultants),
      energy_(find_energy()) {}

// Twice the energy of resultants.
double WeighedLaw::measure(const Vec6& resultants) const {
    double energy = 0.0;
    for (Eigen::Index k = 0; k < 6; ++k) {
        if (stiffness_[k] > 0.0) energy += resultants[k] * resultants[k] / stiffness_[k];
    }
    return energy;
}

// The size of what is elastic, on whose scale laws are curved; strains give the scale of round-off.
double WeighedLaw::find_energy() const {
    constexpr double of_strain = 1e-4, least = 1e-12;
    return std::max({measure(resultants_),
                     of_strain * strain_.dot(stiffness_.cwiseProduct(strain_)),
                     least * stiffness_.maxCoeff()});
}

// But for a constant.
double WeighedLaw::weigh(const Vec6& strain,
                         std::span<const double> memory,
                         const Vec6& forces,
                         std::span<const double> after) const {
    const Vec6 resultants = law_.respond(strain, memory, elapsed_, moved_).resultants;
    double sum = -forces.dot(resultants - resultants_);
    for (std::size_t i = 0; i < after.size(); ++i) sum += after[i] * (moved_[i] - after_[i]);
    return sum;
}

Vec6 WeighedLaw::differentiate_by_strain(std::span<const double> after) const {
    Vec6 gradient = Vec6::Zero();
    if (are_zero(after)) return gradient;
    for (Eigen::Index k = 0; k < 6; ++k) {
        if (!(stiffness_[k] > 0.0)) continue;
        gradient[k] = differentiate_with_care(
            [&](double amount) {
                Vec6 strain = strain_;
                strain[k] += amount;
                return weigh(strain, memory_, Vec6::Zero(), after);
            },
            part * std::sqrt(energy_ / stiffness_[k]));
    }
    return gradient;
}

void WeighedLaw::add_by_memory(const Vec6& forces,
                               std::span<const double> after,
                               std::span<double> by_memory) const {
    if (forces.isZero(0.0) && are_zero(after)) return;
    std::vector<double> memory = memory_;
    for (std::size_t i = 0; i < memory.size(); ++i) {
        by_memory[i] += differentiate_with_care(
            [&](double amount) {
                memory[i] = memory_[i] + amount;
                return weigh(strain_, memory, forces, after);
            },
            find_step(i));
        memory[i] = memory_[i];
    }
}

// Between the sizes of elastic strains by the largest and the smallest stiffness. By a number on which
// nothing depends here the effect says nothing.
double WeighedLaw::find_step(std::size_t number) const {
    constexpr double round_off = 1e-6;
    double smallest = stiffness_.maxCoeff();
    for (Eigen::Index k = 0; k < 6; ++k) {
        if (stiffness_[k] > 0.0) smallest = std::min(smallest, stiffness_[k]);
    }
    const double least =
        std::max(part * std::sqrt(energy_ / stiffness_.maxCoeff()), round_off * std::abs(memory_[number]));
    const double most = std::max(least, part * std::sqrt(energy_ / smallest));
    std::vector<double> memory = memory_;
    memory[number] = memory_[number] + least;
    const Vec6 change = law_.respond(strain_, memory, elapsed_, {}).resultants - resultants_;
    const double effect = std::sqrt(measure(change) / energy_);
    return effect > 0.0 ? std::clamp(part / effect * least, least, most) : least;
}

}  // namespace gxrod
