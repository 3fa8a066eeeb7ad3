#pragma once

#include <filesystem>
#include <functional>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "batch/prepared_batch.hpp"

// Runs a batch: worker processes run the cases of a plan and write into a folder.
namespace gxrod {

// Lists the cases of a range that have no row, or, if failed ones are wanted, a row that is not done.
std::vector<long> list_wanted_cases(const std::map<long, CaseRow>& rows,
                                    const CaseRange& range,
                                    bool retry_failed);

// A user's request to a batch that runs.
enum class Interruption {
    none,
    finish_cases,  // start no more cases
    stop           // abandon running cases
};

struct BatchProgress {
    long cases = 0;  // cases that this run has to do
    long done = 0;
    long failed = 0;  // cases of this run that failed
    int running = 0;
    double seconds = 0.0;
};

struct BatchRequest {
    std::filesystem::path folder;
    int workers = 1;
    std::optional<CaseRange> only;  // a slice of the cases, which is written into a separate part
    bool retry_failed = false;
    bool begin_anew = false;  // discard another batch in the folder
    std::function<void(const BatchProgress&)> report_progress = [](const BatchProgress&) {};
    std::function<void(const CaseRow&)> report_failure = [](const CaseRow&) {};
    std::function<Interruption()> interruption = [] { return Interruption::none; };
};

struct BatchSummary {
    CaseRange range;            // cases of this run
    std::vector<CaseRow> rows;  // rows of the range, by case
    long run_now = 0;           // cases that this run has done
    long left = 0;              // cases that this run has not done
    bool is_interrupted = false;
    double seconds = 0.0;

    long count(CaseStatus status) const;
    bool is_complete() const { return count(CaseStatus::done) == range.count(); }
};

// Runs the cases that have no row in the folder yet, and leaves its table complete and sorted. A failed case
// has a row, too. Throws FileError if the folder cannot be used or written, or another process runs these
// cases; rows written before stay.
BatchSummary run_batch(const PreparedBatch& batch, const BatchRequest& request);

// Makes the folder of a batch that other processes will run, unless it exists. Throws DeckError and FileError
// if it holds something else, unless `begin_anew` discards that.
void begin_batch(const PreparedBatch& batch, const std::filesystem::path& folder, bool begin_anew);

// Makes index.csv of all rows in a folder, after waiting for a process that writes the table. Throws
// FileError.
std::vector<CaseRow> gather_rows(const std::filesystem::path& folder, const BatchRecord& record);

}  // namespace gxrod
