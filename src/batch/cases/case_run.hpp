#pragma once

#include <deque>
#include <filesystem>
#include <vector>

#include "batch/cases/case_list.hpp"
#include "batch/cases/case_row.hpp"
#include "deck/problem.hpp"

namespace gxrod {

// What the cases of a batch have in common; what it refers to must outlive it.
struct CaseContext {
    const Plan& plan;
    const CaseList& cases;
    const std::deque<DeckTemplate>& decks;
    const std::vector<MeshDigests>& meshes;  // of each deck, as they were when the batch began
    std::filesystem::path folder;

    Problem build(long number) const;
};

// Where a case's results are, relative to the folder: "cases/0017.vtkhdf".
std::string results_path(long number, long cases);

// Why a case is out of memory.
std::string explain_memory(const Plan& plan);

// What became of a case; or why it could not be run or its results not be written, which is not its own
// fault, so that it has no row.
struct CaseOutcome {
    CaseRow row;
    std::string obstacle;  // "" if there is none
};

// Runs one case; returns whatever happens, except after a crash. Results are kept as the plan says.
CaseOutcome run_case(const CaseContext& context, long number);

// As a line of text, and back. Throws FileError if it is not one.
std::string write_outcome(const CaseOutcome& outcome);
CaseOutcome read_outcome(const std::string& text, const BatchRecord& record);

}  // namespace gxrod
