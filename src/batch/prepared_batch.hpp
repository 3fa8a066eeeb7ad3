#pragma once

#include <deque>
#include <filesystem>
#include <functional>
#include <optional>
#include <vector>

#include "batch/cases/case_check.hpp"
#include "batch/cases/case_row.hpp"
#include "batch/cases/case_run.hpp"
#include "batch/cases/case_table.hpp"
#include "batch/plan/plan.hpp"

namespace gxrod {

// A plan whose cases were all read and found to be right.
class PreparedBatch {
  public:
    // Examines the cases, or only those in `only` if it is given. Calls `report` with the number examined so
    // far. Throws DeckError and FileError, as check_cases.
    explicit PreparedBatch(Plan plan,
                           const std::optional<CaseRange>& only = {},
                           const std::function<void(long examined, long cases)>& report = {});
    PreparedBatch(const PreparedBatch&) = delete;
    PreparedBatch& operator=(const PreparedBatch&) = delete;

    const Plan& plan() const { return plan_; }
    const CaseList& cases() const { return cases_; }
    const BatchRecord& record() const { return record_; }
    // Returns the size of the results of the examined cases if all are kept.
    const KeptResults& kept_results() const { return kept_; }
    CaseRange all() const { return {1, cases_.count()}; }
    CaseContext context(const std::filesystem::path& folder) const {
        return {plan_, cases_, decks_, meshes_, folder};
    }

    // Returns the rows of this batch in a folder; none if the folder does not exist or is empty. Throws
    // DeckError and FileError if it holds something else.
    std::vector<CaseRow> read_rows(const std::filesystem::path& folder) const;
    // Makes the folder one of this batch, unless it is, and returns its rows. Its table must be locked, and
    // all of its cases if `begin_anew` discards its content. Throws as read_rows.
    std::vector<CaseRow> open_folder(const std::filesystem::path& folder, bool begin_anew) const;

  private:
    Plan plan_;
    CaseList cases_;
    std::deque<DeckTemplate> decks_;
    std::vector<MeshDigests> meshes_;  // meshes of each deck
    KeptResults kept_;
    BatchRecord record_;
};

}  // namespace gxrod
