#include "cross_section/failure_criteria.hpp"

#include <algorithm>
#include <cmath>

#include "cross_section/stress_measures.hpp"

namespace gxrod {
namespace {

bool has_strength(const ElasticMaterial& material) { return material.strength.has_value(); }
bool has_yield_stress(const ElasticMaterial& material) { return material.yield_stress.has_value(); }

constexpr double square(double value) { return value * value; }

FailureModes find_yield(const Vec6& stress, const ElasticMaterial& material) {
    FailureModes modes;
    modes.add({.word = "yield", .linear = compute_von_mises(stress) / *material.yield_stress});
    return modes;
}

// Tsai and Wu 1971, transversely isotropic in strength. It has one mode; its word is that of the stresses
// which contribute most at failure.
FailureModes find_tsai_wu(const Vec6& stress, const ElasticMaterial& material) {
    const PlyStrength& s = *material.strength;
    const auto [s1, s2, s3, t23, t13, t12] =
        std::array{stress[0], stress[1], stress[2], stress[3], stress[4], stress[5]};
    const double F11 = 1.0 / (s.Xt * s.Xc), F22 = 1.0 / (s.Yt * s.Yc), F44 = 1.0 / square(s.S23);
    const double F12 = s.f12 * std::sqrt(F11 * F22), F23 = F22 - 0.5 * F44;
    const double between = F12 * s1 * (s2 + s3);  // half of the mixed term belongs to each of the two
    const std::array<FailureMode, 3> parts{{
        {"fibre", (1.0 / s.Xt - 1.0 / s.Xc) * s1, F11 * s1 * s1 + between},
        {"matrix",
         (1.0 / s.Yt - 1.0 / s.Yc) * (s2 + s3),
         F22 * (s2 * s2 + s3 * s3) + 2.0 * F23 * s2 * s3 + F44 * t23 * t23 + between},
        {"shear", 0.0, (t12 * t12 + t13 * t13) / square(s.S12)},
    }};
    FailureMode all;
    for (const FailureMode& part : parts) {
        all.linear += part.linear;
        all.quadratic += part.quadratic;
    }
    const double exposure = all.exposure();
    all.word = std::ranges::max_element(parts, {}, [&](const FailureMode& part) {
                   return part.linear * exposure + part.quadratic;
               })->word;
    FailureModes modes;
    modes.add(all);
    return modes;
}

// Hashin 1980, his four modes.
FailureModes find_hashin(const Vec6& stress, const ElasticMaterial& material) {
    const PlyStrength& s = *material.strength;
    const double s1 = stress[0], p = stress[1] + stress[2];
    const double along = (square(stress[4]) + square(stress[5])) / square(s.S12);
    const double shear = (square(stress[3]) - stress[1] * stress[2]) / square(s.S23) + along;
    FailureModes modes;
    if (s1 >= 0.0) {
        modes.add({.word = "fibre tension", .quadratic = square(s1 / s.Xt) + along});
    } else {
        modes.add({.word = "fibre compression", .quadratic = square(s1 / s.Xc)});
    }
    if (p >= 0.0) {
        modes.add({.word = "matrix tension", .quadratic = square(p / s.Yt) + shear});
    } else {
        modes.add({.word = "matrix compression",
                   .linear = (square(0.5 * s.Yc / s.S23) - 1.0) * p / s.Yc,
                   .quadratic = square(0.5 * p / s.S23) + shear});
    }
    return modes;
}

FailureModes find_maximum_stress(const Vec6& stress, const ElasticMaterial& material) {
    const PlyStrength& s = *material.strength;
    FailureModes modes;
    const auto add_normal =
        [&](std::string_view tension, std::string_view compression, double value, double t, double c) {
            const bool is_tension = value >= 0.0;
            modes.add(
                {.word = is_tension ? tension : compression, .linear = is_tension ? value / t : -value / c});
        };
    add_normal("fibre tension", "fibre compression", stress[0], s.Xt, s.Xc);
    add_normal("matrix tension 2", "matrix compression 2", stress[1], s.Yt, s.Yc);
    add_normal("matrix tension 3", "matrix compression 3", stress[2], s.Yt, s.Yc);
    modes.add({.word = "shear 23", .linear = std::abs(stress[3]) / s.S23});
    modes.add({.word = "shear 13", .linear = std::abs(stress[4]) / s.S12});
    modes.add({.word = "shear 12", .linear = std::abs(stress[5]) / s.S12});
    return modes;
}

constexpr std::array<FailureCriterion, 4> cards{{
    {"von-mises", "von Mises", "yield_stress", has_yield_stress, find_yield},
    {"tsai-wu", "Tsai–Wu", "strength", has_strength, find_tsai_wu},
    {"hashin", "Hashin", "strength", has_strength, find_hashin},
    {"max-stress", "maximum stress", "strength", has_strength, find_maximum_stress},
}};

}  // namespace

double FailureMode::exposure() const {
    const double discriminant = linear * linear + 4.0 * quadratic;
    return discriminant < 0.0 ? 0.0 : std::max(0.0, 0.5 * (linear + std::sqrt(discriminant)));
}

const FailureMode& FailureModes::governing() const {
    return *std::ranges::max_element(values(), {}, &FailureMode::exposure);
}

std::span<const FailureCriterion> failure_criteria() { return cards; }

const FailureCriterion* find_failure_criterion(std::string_view word) {
    const auto found = std::ranges::find(cards, word, &FailureCriterion::word);
    return found == cards.end() ? nullptr : &*found;
}

const FailureCriterion* choose_failure_criterion(const FailureCriterion* wanted,
                                                 const ElasticMaterial& material) {
    if (wanted != nullptr && wanted->applies_to(material)) return wanted;
    return has_yield_stress(material) ? &cards.front() : nullptr;
}

}  // namespace gxrod
