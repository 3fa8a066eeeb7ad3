#pragma once

#include <optional>
#include <vector>

#include "model/model.hpp"

// What can be known of a rod in water before anything is solved.
namespace gxrod {

// The tension of a rod at rest at places along it, from its start to its end.
struct LineAtRest {
    enum class Source {
        hung,     // starts under stress as a line that hangs by its weight in water
        pulled,   // by the weight and the loads beyond each place, up to an end that can move along the rod
        unloaded  // straight between its supports: none
    };
    Source source = Source::unloaded;
    std::vector<double> arc_length;
    std::vector<double> tension;
    // What hangs: from where it leaves the ground, or the start, to the end or where it comes down again, and
    // indices around it.
    double from = 0.0, to = 0.0;
    std::size_t first = 0, last = 0;
};

// nullopt of a rod that is not one line, that shares its ends with other rods, joints or springs, or whose
// tension does not follow from one of these, as by loads that change with time. Of static analyses loads are
// those at t = 1.
std::optional<LineAtRest> find_line_at_rest(const Model& model, const Rod& rod);

// √(EI/T) with the smaller EI: the length over which a support bends a rod that is in tension. nullopt
// without tension.
std::optional<double> find_boundary_layer(const Model& model,
                                          const Rod& rod,
                                          const LineAtRest& line,
                                          std::size_t place);

// The section at an entry of Rod::arc_length.
const Section& section_at_entry(const Model& model, const Rod& rod, std::size_t entry);

// nullptr of a node without one.
const Support* find_support_of(const Model& model, int node);

// Whether a support, or the plane of the model, stops a displacement of a node along a direction.
bool is_held_along(const Model& model, int node, const Vec3& direction);

}  // namespace gxrod
