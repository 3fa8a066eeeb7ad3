#pragma once

#include <deque>
#include <filesystem>
#include <vector>

#include "batch/cases/case_list.hpp"
#include "batch/cases/case_row.hpp"
#include "deck/problem.hpp"

namespace gxrod {

// The data that all cases of a batch share; the objects that it refers to must outlive it.
struct CaseContext {
    const Plan& plan;
    const CaseList& cases;
    const std::deque<DeckTemplate>& decks;
    const std::vector<MeshDigests>& meshes;  // meshes of each deck when the batch began
    std::filesystem::path folder;

    Problem build(long number) const;
};

// Returns the path of a case's results, relative to the folder: "cases/0017.vtkhdf".
std::string results_path(long number, long cases);

// Explains why a case is out of memory.
std::string explain_memory(const Plan& plan);

// The row of a case, or the obstacle if it could not be run or its results not be written: that is not the
// fault of the case, which then has no row.
struct CaseOutcome {
    CaseRow row;
    std::string obstacle;  // "" if there is none
};

// Runs one case and returns its outcome, unless it crashes. Results are kept as the plan says.
CaseOutcome run_case(const CaseContext& context, long number);

// Convert an outcome to a line of text and back. Reading throws FileError if the line is not an outcome.
std::string write_outcome(const CaseOutcome& outcome);
CaseOutcome read_outcome(const std::string& text, const BatchRecord& record);

}  // namespace gxrod
