#pragma once

#include <Eigen/Core>
#include <complex>
#include <vector>

#include "linear/sparse_pattern.hpp"

namespace gxrod {

// A stiffness R that relaxes: motions x e^(λt) add the force λτ/(1 + λτ) R x.
struct RelaxingMatrix {
    double time = 1.0;  // τ
    std::vector<double> values;

    // Return λτ/(1 + λτ), and its divided difference for two λ, which is its derivative if these are equal.
    template <class Number>
    Number factor(Number lambda) const {
        return lambda * time / (1.0 + lambda * time);
    }
    std::complex<double> slope(std::complex<double> first, std::complex<double> second) const {
        return time / ((1.0 + first * time) * (1.0 + second * time));
    }
};

// The problem T(λ) x = (λ² M + λ D + K) x = 0, real matrices of any symmetry by their values on one pattern;
// with relaxing stiffness, T(λ) = λ² M + λ D + K + Σ λτ/(1 + λτ) R. The pattern must outlive it.
struct QuadraticProblem {
    const SparsePattern* pattern;
    std::vector<double> K, D, M;
    std::vector<RelaxingMatrix> relaxing{};

    std::int64_t size() const { return pattern->size(); }
    // Return T(λ).
    std::vector<double> at(double lambda) const;
    std::vector<std::complex<double>> at(std::complex<double> lambda) const;
    // Returns the problem with transposed matrices: its right vectors are left vectors y of this one, yᵀ T(λ)
    // = 0.
    QuadraticProblem transposed() const;
};

// Motions with a larger damping ratio creep.
inline constexpr double most_damping = 0.99;

// Whether a motion decays so fast for its frequency that it hardly oscillates. With relaxing stiffness there
// are as many of these as unknowns, near −1/τ and where all branches of a section creep.
inline bool creeps(std::complex<double> lambda) { return lambda.real() < -most_damping * std::abs(lambda); }

}  // namespace gxrod
