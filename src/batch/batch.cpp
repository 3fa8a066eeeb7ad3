#include "batch/batch.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <deque>
#include <limits>
#include <set>
#include <system_error>

#include "batch/batch_folder.hpp"
#include "batch/batch_lock.hpp"
#include "batch/gathering.hpp"
#include "batch/seconds_since.hpp"
#include "batch/worker_pool.hpp"
#include "machine/file_error.hpp"
#include "machine/machine_memory.hpp"

namespace gxrod {
namespace {

namespace fs = std::filesystem;
using Clock = std::chrono::steady_clock;

// Of a fully run batch, or a slice of it.
class BatchRun {
  public:
    BatchRun(const PreparedBatch& batch, const BatchRequest& request)
        : batch_(batch),
          request_(request),
          range_(request.only.value_or(batch.all())),
          lock_(lock_cases(request.folder, range_)),
          table_lock_(BatchLock::of_table(request.folder)) {
        begin();
    }

    BatchSummary run() {
        try {
            run_cases();
        } catch (const FileError&) {
            // The rows that exist can be sorted all the same.
            try {
                gather();
            } catch (const FileError&) {
            }
            throw;
        }
        return summarise(gather());
    }

  private:
    bool is_slice() const { return !(range_ == batch_.all()); }

    static BatchLock lock_cases(const fs::path& folder, const CaseRange& range) {
        check_batch_folder(folder);
        make_folder(folder);
        return BatchLock::of_cases(folder, range);
    }

    void begin() {
        const fs::path& folder = request_.folder;
        for (CaseRow& row : batch_.open_folder(folder, request_.begin_anew)) {
            if (range_.contains(row.number)) rows_.insert_or_assign(row.number, std::move(row));
        }
        if (has_idle_parts(folder, lock_)) gather_parts(folder, batch_.record(), lock_);
        for (const char* name : {"cases", "parts"}) make_folder(folder / name);
        const std::vector<long> wanted = list_wanted_cases(rows_, range_, request_.retry_failed);
        queue_.assign(wanted.begin(), wanted.end());
        progress_.cases = static_cast<long>(queue_.size());
        // A whole batch holds the table while it runs, a slice only its part.
        table_.emplace(is_slice() ? part_path(folder, range_) : table_path(folder), batch_.record());
        if (is_slice()) table_lock_.reset();
    }

    void run_cases() {
        if (queue_.empty()) return;
        WorkerPool pool(worker_options(), [context = batch_.context(request_.folder)](long number) {
            return write_outcome(run_case(context, number));
        });
        work(pool);
    }

    bool hand_out(WorkerPool& pool, long number) const {
        try {
            return pool.hand_out(number);
        } catch (const std::system_error& error) {
            throw FileError(request_.folder,
                            std::string("no process can be started for its cases: ") + error.what(),
                            "a smaller -j needs fewer");
        }
    }

    std::vector<CaseRow> gather() {
        table_.reset();
        if (!table_lock_) table_lock_.emplace(BatchLock::of_table(request_.folder));
        std::vector<CaseRow> rows = gather_parts(request_.folder, batch_.record(), lock_);
        std::erase_if(rows, [&](const CaseRow& row) { return !range_.contains(row.number); });
        return rows;
    }

    std::vector<CaseRow> list_rows() const {
        std::vector<CaseRow> rows;
        for (const auto& [number, row] : rows_) rows.push_back(row);
        return rows;
    }

    int count_workers() const {
        return static_cast<int>(std::min<std::size_t>(request_.workers, queue_.size()));
    }

    WorkerOptions worker_options() const {
        const Plan& plan = batch_.plan();
        // A case ends itself after a step; one that hangs within a step is ended.
        constexpr double least_grace = 5.0;
        constexpr double relative_grace = 0.2;
        const double limit = plan.time_limit;
        return {count_workers(),
                std::isfinite(limit) ? limit + std::max(least_grace, relative_grace * limit) : 0.0,
                plan.memory_limit.value_or(count_usable_bytes() / count_workers())};
    }

    void work(WorkerPool& pool) {
        constexpr double patience = 0.2;
        while (true) {
            const Interruption interruption = request_.interruption();
            if (interruption == Interruption::stop) {
                is_interrupted_ = pool.busy_workers() > 0 || !queue_.empty();
                return;
            }
            while (interruption == Interruption::none && !queue_.empty() && pool.has_idle_worker()) {
                if (hand_out(pool, queue_.front())) queue_.pop_front();
            }
            tell(pool);
            if (pool.busy_workers() == 0) {
                is_interrupted_ = !queue_.empty();
                return;
            }
            for (const WorkerReply& reply : pool.wait(patience)) take(reply);
        }
    }

    void tell(const WorkerPool& pool) {
        progress_.running = pool.busy_workers();
        progress_.seconds = seconds_since(begin_);
        request_.report_progress(progress_);
    }

    void take(const WorkerReply& reply) {
        if (reply.kind == WorkerReply::Kind::was_killed && killed_.insert(reply.number).second) {
            // By the system or a user, and perhaps not because of this case: try once more.
            queue_.push_back(reply.number);
            return;
        }
        if (reply.kind != WorkerReply::Kind::finished) return record(make_row(reply));
        CaseOutcome outcome = read_outcome(reply.text, batch_.record());
        if (!outcome.obstacle.empty()) {
            throw FileError(request_.folder,
                            fmt::format("the batch ends at case {}, which is left to be run: {}",
                                        reply.number,
                                        outcome.obstacle));
        }
        record(std::move(outcome.row));
    }

    // Of a case whose worker ended.
    CaseRow make_row(const WorkerReply& reply) const {
        CaseRow row;
        row.number = reply.number;
        row.parameters = batch_.cases().parameters(reply.number);
        row.collected.assign(batch_.plan().collections.size(), std::numeric_limits<double>::quiet_NaN());
        row.seconds = reply.seconds;
        row.status = CaseStatus::crashed;
        row.reason = reply.text;
        if (reply.kind == WorkerReply::Kind::overtime) {
            row.status = CaseStatus::time_limit;
            row.reason = fmt::format(
                "the time limit of {} s was over, and the current step or the setup took longer still; the "
                "process was ended",
                batch_.plan().time_limit);
        } else if (reply.kind == WorkerReply::Kind::overweight) {
            row.status = CaseStatus::out_of_memory;
            row.reason = explain_memory(batch_.plan());
        } else if (reply.kind == WorkerReply::Kind::was_killed) {
            row.reason = "the process was killed twice, perhaps for lack of memory";
        }
        std::error_code ignored;
        const std::string path = results_path(reply.number, batch_.cases().count());
        if (fs::exists(request_.folder / path, ignored)) row.results = path;
        return row;
    }

    void record(CaseRow row) {
        table_->append(row);
        ++progress_.done;
        if (row.status != CaseStatus::done) {
            ++progress_.failed;
            request_.report_failure(row);
        }
        rows_.insert_or_assign(row.number, std::move(row));
    }

    BatchSummary summarise(std::vector<CaseRow> rows) const {
        BatchSummary summary;
        summary.range = range_;
        summary.left = progress_.cases - progress_.done;
        summary.rows = std::move(rows);
        summary.run_now = progress_.done;
        summary.is_interrupted = is_interrupted_;
        summary.seconds = seconds_since(begin_);
        return summary;
    }

    const PreparedBatch& batch_;
    const BatchRequest& request_;
    CaseRange range_;
    BatchLock lock_;
    std::optional<BatchLock> table_lock_;
    std::optional<TableAppender> table_;
    std::map<long, CaseRow> rows_;
    std::deque<long> queue_;
    std::set<long> killed_;
    BatchProgress progress_;
    bool is_interrupted_ = false;
    Clock::time_point begin_ = Clock::now();
};

}  // namespace

std::vector<long> list_wanted_cases(const std::map<long, CaseRow>& rows,
                                    const CaseRange& range,
                                    bool retry_failed) {
    std::vector<long> wanted;
    for (long number = range.first; number <= range.last; ++number) {
        const auto row = rows.find(number);
        if (row == rows.end() || (retry_failed && row->second.status != CaseStatus::done))
            wanted.push_back(number);
    }
    return wanted;
}

long BatchSummary::count(CaseStatus status) const {
    return std::count_if(rows.begin(), rows.end(), [&](const CaseRow& row) { return row.status == status; });
}

BatchSummary run_batch(const PreparedBatch& batch, const BatchRequest& request) {
    return BatchRun(batch, request).run();
}

void begin_batch(const PreparedBatch& batch, const fs::path& folder, bool begin_anew) {
    check_batch_folder(folder);
    make_folder(folder);
    std::optional<BatchLock> cases_lock;
    if (begin_anew) cases_lock.emplace(BatchLock::of_cases(folder, batch.all()));
    const BatchLock table_lock = BatchLock::of_table(folder);
    batch.open_folder(folder, begin_anew);
}

std::vector<CaseRow> gather_rows(const fs::path& folder, const BatchRecord& record) {
    const BatchLock lock = BatchLock::of_table(folder);
    return gather_parts(folder, record, lock);
}

}  // namespace gxrod
