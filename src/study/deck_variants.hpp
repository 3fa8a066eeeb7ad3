#pragma once

#include <string>
#include <vector>

#include "deck/problem.hpp"

namespace gxrod {

enum class VariantKind {
    as_it_is,
    finer_steps,  // half, a quarter of the step; of the tolerance a 16th, a 256th; of statics more load steps
    finer_mesh,   // twice, four times the elements
    higher_order,  // elements of the next order
    turned,        // all of it rotated rigidly
    turned_more,   // and a little more: all that differs then is round-off
    simo,          // elements simo instead of objective
    resumed,       // stopped midway and resumed
    two_threads
};

// One of the runs that examine a user's deck.
struct DeckVariant {
    VariantKind kind;
    int level = 0;                            // of refinement: 1, 2
    std::string title;                        // "half the step"
    std::vector<std::string> overrides = {};  // after the user's own
    double cost = 1.0;                        // in runs of the deck as it is, about
};

// All that make sense for this problem, the deck as it is first. `levels`: 1 or 2 refinements.
std::vector<DeckVariant> list_variants(const Problem& problem, int levels);

// The rods that no variant refines: those of meshes.
std::vector<std::string> list_unrefined_rods(const Problem& problem);

double total_cost(const std::vector<DeckVariant>& variants);

}  // namespace gxrod
