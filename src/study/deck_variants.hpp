#pragma once

#include <string>
#include <vector>

#include "deck/problem.hpp"

namespace gxrod {

enum class VariantKind {
    as_it_is,
    finer_steps,  // half, a quarter of the step; a 16th, a 256th of the tolerance; in statics more load steps
    finer_mesh,   // twice, four times the elements
    higher_order,  // elements of the next order
    turned,        // the whole model rotated rigidly
    turned_more,   // turned a little more: only round-off differs
    simo,          // `simo` elements instead of `objective`
    resumed,       // stopped midway and resumed
    two_threads
};

// One of the runs that examine a user's deck.
struct DeckVariant {
    VariantKind kind;
    int level = 0;                            // level of refinement: 1, 2
    std::string title;                        // "half the step"
    std::vector<std::string> overrides = {};  // after the user's own
    double cost = 1.0;                        // in runs of the unchanged deck, about
};

// Lists the variants that make sense for this problem, whose last stage is studied, the unchanged deck first.
// `levels`: 1 or 2 refinements.
std::vector<DeckVariant> list_variants(const Problem& problem, int levels);

// Lists the rods that no variant refines: the rods of meshes.
std::vector<std::string> list_unrefined_rods(const Problem& problem);

double total_cost(const std::vector<DeckVariant>& variants);

}  // namespace gxrod
