#pragma once

#include <string>
#include <vector>

#include "deck/places/build_context.hpp"
#include "deck/text/table_files.hpp"
#include "model/problem.hpp"
#include "model/settings/mode_kind.hpp"

// [[imperfection]]: a stress-free start that is not the perfect one.
namespace gxrod {

// Finds the displacements and spins of all nodes in a mode, from 1, of a problem. Throws std::runtime_error
// with the reason if it has no such mode.
using ModeFinder = std::vector<Vec6> (*)(const Problem& perfect, ModeKind kind, int mode);

// Sets what finds modes. The deck knows no analysis; programs that run decks have one that finds them.
// Returns true.
bool set_mode_finder(ModeFinder finder);

// Files of shapes that were found are kept with results under names that begin so.
inline constexpr const char* found_shape_prefix = "imperfection[";

// Lists the cases of load combinations that imperfections name.
std::vector<std::string> list_imperfection_cases(const CheckedTable& deck);

// Displaces the start of a problem that has no faults, and adds what it needs again to its record. A deck
// that only varies another one takes shapes from files alone.
void apply_imperfections(
    const CheckedTable& deck, const TableFiles& files, bool is_varied, Problem& problem, FaultList& faults);

}  // namespace gxrod
