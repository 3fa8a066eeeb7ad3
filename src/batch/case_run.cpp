#include "batch/case_run.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <limits>
#include <new>

#include "analyses/model_examination.hpp"
#include "analyses/run.hpp"
#include "batch/collector.hpp"
#include "model/file_error.hpp"
#include "results/energy_warning.hpp"

namespace gxrod {
namespace {

using Clock = std::chrono::steady_clock;

double seconds_since(Clock::time_point begin) {
    return std::chrono::duration<double>(Clock::now() - begin).count();
}

void add_warning(CaseRow& row, const std::string& warning) {
    if (warning.empty()) return;
    row.warning += (row.warning.empty() ? "" : "; ") + warning;
}

class CaseRun {
  public:
    CaseRun(const CaseContext& context, long number) : context_(context) {
        row_.number = number;
        row_.parameters = context.cases.parameters(number);
        row_.collected.assign(context.plan.collections.size(), std::numeric_limits<double>::quiet_NaN());
    }

    CaseRow run() {
        try {
            try_to_run();
        } catch (const DeckError& error) {
            end(CaseStatus::deck_fault, error.what());
        } catch (const std::bad_alloc&) {
            end(CaseStatus::out_of_memory, explain_memory());
        } catch (const std::exception& error) {
            end(CaseStatus::failed, error.what());
        }
        keep_or_remove();
        row_.seconds = seconds_since(begin_);
        return std::move(row_);
    }

  private:
    void end(CaseStatus status, const std::string& reason) {
        row_.status = status;
        row_.reason = reason;
    }

    std::string explain_memory() const {
        constexpr double bytes_in_gigabyte = 1e9;
        const std::optional<double>& limit = context_.plan.memory_limit;
        if (limit) return fmt::format("more than memory_limit, {:.4g} GB", *limit / bytes_in_gigabyte);
        return "more than its share of the machine; a smaller -j, or memory_limit, gives it more";
    }

    void try_to_run() {
        const Problem problem = context_.build(row_.number);
        const std::vector<Finding> findings = examine_model(problem.model, problem.analysis);
        for (const Finding& finding : findings) {
            if (finding.severity == Severity::error) return end(CaseStatus::deck_fault, finding.message);
            if (finding.severity == Severity::warning) add_warning(row_, finding.message);
        }
        Collector collector(context_.plan.collections, problem);
        take(run(problem, collector));
        row_.collected = collector.values();
    }

    RunSummary run(const Problem& problem, Collector& collector) {
        RunRequest request{problem.model, problem.analysis, problem.output, problem.record, {}};
        if (context_.plan.keeping != Keeping::none) {
            const std::string path = results_path(row_.number, context_.cases.count());
            request.results = ResultsFileOptions{context_.folder / path, Existing::replace};
            row_.results = path;
        }
        request.observe = [&](const Snapshot& snapshot, const LedgerRow& ledger) {
            collector.add(snapshot, ledger);
        };
        request.is_interrupted = [&] { return seconds_since(begin_) > context_.plan.time_limit; };
        return run_analysis(request);
    }

    void take(const RunSummary& summary) {
        row_.steps = summary.totals.steps;
        row_.newton_iterations = summary.totals.newton_iterations;
        row_.rejected_steps = summary.totals.rejected_steps;
        row_.time = summary.time;
        add_warning(row_,
                    describe_imbalance(summary.totals.largest_energy, summary.totals.largest_energy_error));
        if (summary.status == RunStatus::interrupted) {
            end(CaseStatus::time_limit,
                fmt::format("the time limit of {} s was over at t = {:.10g}",
                            context_.plan.time_limit,
                            summary.time));
        } else if (summary.status == RunStatus::failed) {
            if (summary.out_of_memory) return end(CaseStatus::out_of_memory, explain_memory());
            end(summary.deck_fault ? CaseStatus::deck_fault : CaseStatus::failed, summary.reason);
        }
    }

    void keep_or_remove() {
        std::error_code ignored;
        const std::filesystem::path path =
            context_.folder / results_path(row_.number, context_.cases.count());
        const bool is_wanted = context_.plan.keeping == Keeping::all || row_.status != CaseStatus::done;
        if (!row_.results.empty() && !is_wanted) std::filesystem::remove(path, ignored);
        if (!row_.results.empty() && (!is_wanted || !std::filesystem::exists(path, ignored)))
            row_.results.clear();
    }

    const CaseContext& context_;
    CaseRow row_;
    Clock::time_point begin_ = Clock::now();
};

}  // namespace

Problem CaseContext::build(long number) const {
    return decks[cases.deck(number)].build(cases.overrides(number));
}

std::string results_path(long number, long cases) {
    constexpr std::size_t fewest_digits = 4;
    const std::size_t digits = std::max(fewest_digits, fmt::format("{}", cases).size());
    return fmt::format("cases/{:0{}}.vtkhdf", number, digits);
}

CaseRow run_case(const CaseContext& context, long number) { return CaseRun(context, number).run(); }

}  // namespace gxrod
