#pragma once

#include <string>
#include <vector>

#include "assembly/system.hpp"
#include "state/records/shapes_record.hpp"

// What a stage has found about small motions, in sentences.
namespace gxrod {

// A heading, then a line for each shape, at most so many.
std::vector<std::string> list_shapes(const ShapesRecord& record, std::size_t most);

// What is to be known before they are trusted, a sentence each.
std::vector<std::string> warn_of_shapes(const ShapesRecord& record);

// Why nothing was found; "" if something was, or if there is nothing.
std::string find_failure(const ShapesRecord& record);

// Of a deck whose first stage finds modes: which of its loads do not act there; "" if it has none.
std::string describe_left_out_loads(const Model& model);

// How shapes about a state take the laws of its sections, a sentence each; none where no section relaxes or
// is about to slip or to yield.
std::vector<std::string> note_sections(const System& system, const State& state, const ShapesRecord& record);

}  // namespace gxrod
