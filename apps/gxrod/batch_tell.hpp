#pragma once

#include <string>

#include "batch/batch.hpp"
#include "batch/case_groups.hpp"
#include "progress_line.hpp"

namespace gxrod {

// "17 cases"
std::string count_cases(std::size_t count);

// Cases that are not done, to standard error.
void print_failures(const std::vector<CaseGroup>& failures);

// What a batch says while it runs: progress and failures on standard error, the rest on standard output.
class BatchTelling {
  public:
    BatchTelling(bool is_quiet, bool tells) : is_quiet_(is_quiet), tells_(tells) {}

    void show_examined(long examined, long cases);
    void show_progress(const BatchProgress& progress, bool is_ending);
    // The first failure, and those of other kinds.
    void show_failure(const CaseRow& row, const CaseList& cases);
    void finish_line() { line_.finish(); }

    // How large the results will be that are kept.
    void show_size(const PreparedBatch& batch, const BatchRequest& request) const;
    // The cases that would be run.
    void show_plan(const PreparedBatch& batch, const BatchRequest& request) const;
    void show_summary(const BatchSummary& summary, const BatchRequest& request) const;

  private:
    bool was_told(long number) const;

    bool is_quiet_;
    bool tells_;
    bool has_told_of_ending_ = false;
    std::vector<CaseRow> told_;  // failures, the first of each kind
    ProgressLine line_;
};

// Writes the summary of a batch as one JSON object to a file, or to standard output for "-". Throws
// FileError.
void write_batch_summary(const std::string& target, const BatchSummary& summary, const BatchRequest& request);

}  // namespace gxrod
