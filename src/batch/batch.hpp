#pragma once

#include <filesystem>
#include <functional>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "batch/prepared_batch.hpp"

// A batch: the cases of a plan, run by worker processes into a folder.
namespace gxrod {

// Cases of a range that have no row, or, if that is asked for, one that is not done.
std::vector<long> list_wanted_cases(const std::map<long, CaseRow>& rows,
                                    const CaseRange& range,
                                    bool retry_failed);

// What a user wants of a batch that runs.
enum class Interruption {
    none,
    finish_cases,  // hand out no more
    stop           // abandon running cases
};

struct BatchProgress {
    long cases = 0;  // that this run has to do
    long done = 0;
    long failed = 0;  // of them
    int running = 0;
    double seconds = 0.0;
};

struct BatchRequest {
    std::filesystem::path folder;
    int workers = 1;
    std::optional<CaseRange> only;  // a slice, which goes into a part of its own
    bool retry_failed = false;
    bool begin_anew = false;  // throw away what the folder holds of another batch
    std::function<void(const BatchProgress&)> report_progress = [](const BatchProgress&) {};
    std::function<void(const CaseRow&)> report_failure = [](const CaseRow&) {};
    std::function<Interruption()> interruption = [] { return Interruption::none; };
};

struct BatchSummary {
    CaseRange range;            // that this run was about
    std::vector<CaseRow> rows;  // of it, by case
    long run_now = 0;           // of them by this run
    long left = 0;              // that this run was to do, and did not
    bool is_interrupted = false;
    double seconds = 0.0;

    long count(CaseStatus status) const;
    bool is_complete() const { return count(CaseStatus::done) == range.count(); }
};

// Runs what the folder has no row of yet, and leaves its table complete and sorted. A case that fails is a
// row. Throws FileError if the folder cannot be used or written, or another process runs these cases; what
// was written before stays.
BatchSummary run_batch(const PreparedBatch& batch, const BatchRequest& request);

// Makes the folder of a batch that others will run, unless it is there. Throws DeckError and FileError if it
// holds something else, which `begin_anew` throws away.
void begin_batch(const PreparedBatch& batch, const std::filesystem::path& folder, bool begin_anew);

// Makes index.csv of all rows that a folder has, waiting for the process that writes the table. Throws
// FileError.
std::vector<CaseRow> gather_rows(const std::filesystem::path& folder, const BatchRecord& record);

}  // namespace gxrod
