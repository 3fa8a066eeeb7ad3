#pragma once

#include <optional>
#include <vector>

#include "model/model.hpp"

// Estimates for a rod in water before anything is solved.
namespace gxrod {

// The tension of a rod at rest at places along it, from its start to its end.
struct LineAtRest {
    enum class Source {
        hung,    // starts under stress as a line that hangs by its weight in water
        pulled,  // pulled by the weight and the loads beyond each place, up to an end that can move along the
                 // rod
        unloaded  // straight between its supports, without tension
    };
    Source source = Source::unloaded;
    std::vector<double> arc_length;
    std::vector<double> tension;
    // The hanging part: from the place where it leaves the ground, or the start, to the end or the place
    // where it touches down again, and indices around it.
    double from = 0.0, to = 0.0;
    std::size_t first = 0, last = 0;
};

// Finds the tension. Returns nullopt for a rod that is not one line, that shares its ends with other rods,
// joints or springs, or whose tension has none of these sources, as with loads that change with time. In
// static analyses loads are those at t = 1.
std::optional<LineAtRest> find_line_at_rest(const Model& model, const Rod& rod);

// Computes √(EI/T) with the smaller EI: the length over which a support bends a rod in tension. Returns
// nullopt without tension.
std::optional<double> find_boundary_layer(const Model& model,
                                          const Rod& rod,
                                          const LineAtRest& line,
                                          std::size_t place);

// Returns the section at an entry of Rod::arc_length.
const Section& section_at_entry(const Model& model, const Rod& rod, std::size_t entry);

// Returns the support of a node; nullptr if it has none.
const Support* find_support_of(const Model& model, int node);

// Whether a support, or the plane of the model, stops a displacement of a node along a direction.
bool is_held_along(const Model& model, int node, const Vec3& direction);

}  // namespace gxrod
