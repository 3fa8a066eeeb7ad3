#include "batch/cases/case_run.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <chrono>
#include <limits>
#include <new>

#include "batch/collector.hpp"
#include "batch/members/member_forces.hpp"
#include "batch/seconds_since.hpp"
#include "check/model_examination.hpp"
#include "machine/file_error.hpp"
#include "run/run_to_end.hpp"

namespace gxrod {
namespace {

using Clock = std::chrono::steady_clock;

// Rows begin with a number.
const std::string obstacle_mark = "obstacle: ";

class CaseRun {
  public:
    CaseRun(const CaseContext& context, long number) : context_(context) {
        row_.number = number;
        row_.parameters = context.cases.parameters(number);
        row_.collected.assign(context.plan.collections.size(), std::numeric_limits<double>::quiet_NaN());
    }

    CaseOutcome run() {
        std::string obstacle;
        try {
            try_to_run();
        } catch (const DeckError& error) {
            // It was right when the batch began.
            obstacle = std::string("its files have changed: ") + error.what();
        } catch (const FileError& error) {
            obstacle = error.what();
        } catch (const std::bad_alloc&) {
            end(CaseStatus::out_of_memory, explain_memory(context_.plan));
        } catch (const std::exception& error) {
            end(CaseStatus::failed, error.what());
        }
        keep_or_remove();
        row_.seconds = seconds_since(begin_);
        return {std::move(row_), obstacle};
    }

  private:
    void end(CaseStatus status, const std::string& reason) {
        row_.status = status;
        row_.reason = reason;
    }

    void try_to_run() {
        Problem problem = context_.build(row_.number);
        check_meshes(problem);
        const std::vector<Finding> findings = examine_stages(problem.model, problem.stages);
        for (const Finding& finding : findings) {
            if (finding.severity == Severity::error) return end(CaseStatus::deck_fault, finding.message);
        }
        Collector collector(context_.plan.collections, problem);
        const RunSummary summary =
            run(problem, findings, [&](const Snapshot& snapshot, const LedgerRow& ledger) {
                collector.add(snapshot, ledger);
            });
        collector.add(summary);
        take(summary);
        row_.collected = collector.values();
    }

    void check_meshes(const Problem& problem) const {
        if (problem.record.meshes.empty()) return;
        const std::size_t deck = context_.cases.deck(row_.number);
        const MeshDigests& before = context_.meshes[deck];
        for (const auto& [file, digest] : digest_meshes(problem.record.meshes)) {
            const auto earlier = before.find(file);
            if (earlier == before.end() || earlier->second != digest)
                throw FileError(context_.decks[deck].file(),
                                "its mesh " + file + " has changed since the batch began");
        }
    }

    RunSummary run(const Problem& problem,
                   const std::vector<Finding>& findings,
                   const std::function<void(const Snapshot&, const LedgerRow&)>& observe) {
        RunRequest request{problem};
        if (context_.plan.keeping != Keeping::none) {
            const std::string path = results_path(row_.number, context_.cases.count());
            request.results = ResultsFileOptions{context_.folder / path, Existing::replace};
            row_.results = path;
        }
        request.examined = findings;
        request.observe = observe;
        request.is_interrupted = [&] { return seconds_since(begin_) > context_.plan.time_limit; };
        if (!varies_combinations(context_.plan)) return run_analysis(request);
        return run_to_end(request, [&](const SteppedRun& ended) {
            if (ended.summary().status != RunStatus::complete) return;
            write_member_forces(ended, context_.folder / member_path(row_.number, context_.cases.count()));
        });
    }

    void take(const RunSummary& summary) {
        row_.steps = summary.totals.steps;
        row_.newton_iterations = summary.totals.newton_iterations;
        row_.rejected_steps = summary.totals.rejected_steps;
        row_.time = summary.time;
        row_.warning = fmt::format("{}", fmt::join(summary.warnings, "; "));
        if (summary.status == RunStatus::interrupted) {
            end(CaseStatus::time_limit,
                fmt::format("the time limit of {} s was over at t = {:.10g}",
                            context_.plan.time_limit,
                            summary.time));
        } else if (summary.status == RunStatus::failed) {
            if (summary.out_of_memory) return end(CaseStatus::out_of_memory, explain_memory(context_.plan));
            end(summary.deck_fault ? CaseStatus::deck_fault : CaseStatus::failed, summary.reason);
        }
    }

    void keep_or_remove() {
        const std::filesystem::path path =
            context_.folder / results_path(row_.number, context_.cases.count());
        const Keeping keeping = context_.plan.keeping;
        const bool is_kept =
            keeping == Keeping::all || (keeping == Keeping::failed && row_.status != CaseStatus::done);
        std::error_code ignored;
        if (!is_kept) std::filesystem::remove(path, ignored);
        if (!is_kept || !std::filesystem::exists(path, ignored)) row_.results.clear();
    }

    const CaseContext& context_;
    CaseRow row_;
    Clock::time_point begin_ = Clock::now();
};

}  // namespace

std::string explain_memory(const Plan& plan) {
    constexpr double bytes_in_gigabyte = 1e9;
    if (plan.memory_limit)
        return fmt::format("more than memory_limit, {:.4g} GB", *plan.memory_limit / bytes_in_gigabyte);
    return "more than its share of the machine; a smaller -j, or memory_limit, gives it more";
}

Problem CaseContext::build(long number) const {
    return decks[cases.deck(number)].build(cases.overrides(number));
}

std::string results_path(long number, long cases) {
    constexpr std::size_t fewest_digits = 4;
    const std::size_t digits = std::max(fewest_digits, fmt::format("{}", cases).size());
    return fmt::format("cases/{:0{}}.vtkhdf", number, digits);
}

CaseOutcome run_case(const CaseContext& context, long number) { return CaseRun(context, number).run(); }

std::string write_outcome(const CaseOutcome& outcome) {
    return outcome.obstacle.empty() ? write_case_row(outcome.row) : obstacle_mark + outcome.obstacle;
}

CaseOutcome read_outcome(const std::string& text, const BatchRecord& record) {
    if (text.starts_with(obstacle_mark)) return {{}, text.substr(obstacle_mark.size())};
    const std::vector<CsvRow> lines = read_csv(text + "\n", "reply of a worker");
    return {read_case_row(lines.at(0), record, "reply of a worker"), ""};
}

}  // namespace gxrod
