#pragma once

#include <deque>
#include <filesystem>
#include <vector>

#include "batch/case_list.hpp"
#include "batch/case_row.hpp"
#include "deck/problem.hpp"

namespace gxrod {

// All that the cases of a batch have in common; what it refers to must outlive it.
struct CaseContext {
    const Plan& plan;
    const CaseList& cases;
    const std::deque<DeckTemplate>& decks;
    std::filesystem::path folder;

    Problem build(long number) const;
};

// Where a case's results are, relative to the folder: "cases/0017.vtkhdf".
std::string results_path(long number, long cases);

// Runs one case and says what became of it, whatever that is: only a crash ends otherwise. Results stay as
// the plan says.
CaseRow run_case(const CaseContext& context, long number);

}  // namespace gxrod
