#pragma once

#include <string>
#include <vector>

#include "assembly/system.hpp"
#include "state/records/shapes_record.hpp"

// Sentences that report what a stage found about small motions.
namespace gxrod {

// Lists a heading and a line for each shape, at most `most`.
std::vector<std::string> list_shapes(const ShapesRecord& record, std::size_t most);

// Lists warnings to read before the shapes are trusted, a sentence each.
std::vector<std::string> warn_of_shapes(const ShapesRecord& record);

// Returns the reason why nothing was found; "" if shapes were found, or if there are none.
std::string find_failure(const ShapesRecord& record);

// Names the loads that do not act in a deck's first stage if that stage finds modes; "" if there are none.
std::string describe_left_out_loads(const Model& model);

// Notes how shapes about a state treat the laws of its sections, a sentence each; none if no section relaxes
// or is about to slip or to yield.
std::vector<std::string> note_sections(const System& system, const State& state, const ShapesRecord& record);

}  // namespace gxrod
