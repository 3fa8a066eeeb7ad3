#pragma once

#include <array>
#include <cstddef>
#include <span>
#include <string_view>

#include "cross_section/elastic_material.hpp"
#include "rotation/types.hpp"

// When a material fails. Each criterion is a card; whoever lists, names or computes criteria reads the cards.
namespace gxrod {

// A way to fail, at linear × R + quadratic × R² = 1, when all stresses are multiplied by R.
struct FailureMode {
    std::string_view word;  // "fibre tension"
    double linear = 0.0, quadratic = 0.0;

    // The left side for the stress as it is: the failure index of handbooks, not linear in the load.
    double index() const { return linear + quadratic; }
    // Returns 1/R with the least positive R; 0 without a positive R. Linear in the load.
    double exposure() const;
};

// The modes of a criterion that a stress can reach; six at most.
struct FailureModes {
    std::array<FailureMode, 6> modes = {};
    std::size_t count = 0;

    void add(const FailureMode& mode) { modes[count++] = mode; }
    std::span<const FailureMode> values() const { return {modes.data(), count}; }
    // The mode with the largest exposure.
    const FailureMode& governing() const;
};

struct FailureCriterion {
    std::string_view word;   // in decks
    std::string_view title;  // in text
    std::string_view needs;  // the key of [material.NAME] without which it cannot be computed
    bool (*applies_to)(const ElasticMaterial& material);
    // The stress is in the axes 1 2 3 of the material.
    FailureModes (*find_modes)(const Vec6& stress, const ElasticMaterial& material);
};

// Returns the cards: von Mises (with yield_stress), Tsai–Wu, Hashin 1980 and maximum stress (with strength).
std::span<const FailureCriterion> failure_criteria();

// Returns the criterion of a word, or nothing.
const FailureCriterion* find_failure_criterion(std::string_view word);

// Returns the criterion for a material: the wanted one if the material has what it needs, else von Mises if
// it has a yield stress, else nothing.
const FailureCriterion* choose_failure_criterion(const FailureCriterion* wanted,
                                                 const ElasticMaterial& material);

}  // namespace gxrod
