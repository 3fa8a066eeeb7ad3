#pragma once

#include <string>

#include "batch/batch.hpp"
#include "batch/cases/case_groups.hpp"
#include "batch/members/member_forces.hpp"
#include "progress_line.hpp"

namespace gxrod {

// "17 cases"
std::string count_cases(std::size_t count);

// Cases that are not done, to standard error.
void print_failures(const std::vector<CaseGroup>& failures);

// What a batch prints: progress and failures on standard error, the rest on standard output.
class BatchOutput {
  public:
    BatchOutput(bool is_quiet, bool prints) : is_quiet_(is_quiet), prints_(prints) {}

    void show_examined(long examined, long cases);
    void show_progress(const BatchProgress& progress, bool is_ending);
    // The first failure, and those of other kinds.
    void show_failure(const CaseRow& row, const CaseList& cases);
    void finish_line() { line_.finish(); }

    // How large the kept results will be.
    void show_size(const PreparedBatch& batch, const BatchRequest& request) const;
    // The cases that would be run.
    void show_plan(const PreparedBatch& batch, const BatchRequest& request) const;
    void show_summary(const BatchSummary& summary, const BatchRequest& request) const;
    // The largest and least forces along members; nothing without members.
    void show_members(const std::vector<MemberRange>& ranges, const BatchRequest& request) const;

  private:
    bool was_shown(long number) const;

    bool is_quiet_;
    bool prints_;
    bool has_shown_ending_ = false;
    std::vector<CaseRow> shown_;  // failures, the first of each kind
    ProgressLine line_;
};

// Writes the summary of a batch as one JSON object to a file, or to standard output for "-". Throws
// FileError.
void write_batch_summary(const std::string& target, const BatchSummary& summary, const BatchRequest& request);

}  // namespace gxrod
