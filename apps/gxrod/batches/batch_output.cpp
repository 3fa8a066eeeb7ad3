#include "batch_output.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <nlohmann/json.hpp>

#include "model/version.hpp"
#include "say.hpp"
#include "summary.hpp"

namespace gxrod {

namespace {

constexpr std::size_t most_numbers = 8;
constexpr std::size_t most_groups = 10;

// "3, 17, 18 and 40 more"
std::string list_numbers(const std::vector<long>& numbers) {
    std::string text;
    for (std::size_t i = 0; i < std::min(numbers.size(), most_numbers); ++i)
        text += fmt::format("{}{}", i == 0 ? "" : ", ", numbers[i]);
    if (numbers.size() > most_numbers) text += fmt::format(" and {} more", numbers.size() - most_numbers);
    return text;
}

void print_groups(std::FILE* out, const std::vector<CaseGroup>& groups, bool has_status) {
    for (std::size_t i = 0; i < std::min(groups.size(), most_groups); ++i) {
        const CaseGroup& group = groups[i];
        say(out,
            "  {}{} ({}): {}\n",
            has_status ? std::string(name_of(group.status)) + ", " : "",
            count_cases(group.numbers.size()),
            list_numbers(group.numbers),
            group.text);
    }
    if (groups.size() > most_groups) say(out, "  and {} other reasons\n", groups.size() - most_groups);
}

std::string describe(const BatchProgress& progress) {
    std::string text = fmt::format("{}/{} cases", progress.done, progress.cases);
    if (progress.failed > 0) text += fmt::format(", {} not done", progress.failed);
    text += fmt::format(", {} running", progress.running);
    if (progress.done == 0 || progress.seconds <= 0.0) return text;
    const double rate = static_cast<double>(progress.done) / progress.seconds;
    const double left = static_cast<double>(progress.cases - progress.done) / rate;
    const std::string speed = rate >= 1.0 ? fmt::format("{:.3g} a second", rate)
                                          : fmt::format("{} each", describe_duration(1.0 / rate));
    return text + fmt::format("  {}  {} left", speed, describe_duration(left));
}

}  // namespace

std::string count_cases(std::size_t count) { return fmt::format("{} case{}", count, count == 1 ? "" : "s"); }

void print_failures(const std::vector<CaseGroup>& failures) {
    if (failures.empty()) return;
    say(stderr, "Not done:\n");
    print_groups(stderr, failures, true);
}

void BatchOutput::show_examined(long examined, long cases) {
    if (is_quiet_) return;
    line_.show([&] { return fmt::format("examining the cases: {}/{}", examined, cases); });
}

void BatchOutput::show_progress(const BatchProgress& progress, bool is_ending) {
    if (is_quiet_) return;
    if (is_ending && !has_shown_ending_) {
        line_.finish();
        say(stderr,
            "gxrod: ends after the running {}; Ctrl-C again leaves them\n",
            count_cases(static_cast<std::size_t>(progress.running)));
        has_shown_ending_ = true;
    }
    if (progress.cases > 0) line_.show([&] { return describe(progress); });
}

void BatchOutput::show_failure(const CaseRow& row, const CaseList& cases) {
    if (is_quiet_) return;
    // Once for failures that will be in one group.
    if (shown_.size() == most_groups) return;
    shown_.push_back(row);
    if (group_failures(shown_).size() < shown_.size()) {
        shown_.pop_back();
        return;
    }
    line_.finish();
    say(stderr,
        "case {} ({}): {}: {}\n",
        row.number,
        cases.describe(row.number),
        name_of(row.status),
        row.reason);
}

bool BatchOutput::was_shown(long number) const {
    return std::any_of(
        shown_.begin(), shown_.end(), [&](const CaseRow& row) { return row.number == number; });
}

namespace {

std::string describe_room(const std::filesystem::path& folder, double bytes) {
    std::error_code error;
    const std::filesystem::path parent = folder.parent_path();
    const auto room = std::filesystem::space(parent.empty() ? "." : parent, error);
    if (error || bytes <= static_cast<double>(room.available)) return "";
    return fmt::format(
        ", more than the {:.3g} GB that are free: a larger output.every or output.interval makes fewer "
        "frames, and [keep] "
        "results = \"failed\" or \"none\" keeps fewer files",
        static_cast<double>(room.available) / 1e9);
}

// "" if results of cases that are done are not kept.
std::string describe_kept(const PreparedBatch& batch, const BatchRequest& request) {
    constexpr double gigabyte = 1e9;
    if (batch.plan().keeping != Keeping::all) return "";
    const KeptResults& kept = batch.kept_results();
    std::string text = "results to keep: ";
    const bool is_large = kept.bytes >= 0.1 * gigabyte;
    if (kept.bytes > 0.0) {
        text += fmt::format("at least {:.3g} {}, {:.6g} frames",
                            kept.bytes / (is_large ? gigabyte : 1e6),
                            is_large ? "GB" : "MB",
                            kept.frames);
    }
    if (kept.unknown > 0) {
        text += fmt::format("{}{} of adaptive steps, of unknown size",
                            kept.bytes > 0.0 ? ", and those of " : "those of ",
                            count_cases(static_cast<std::size_t>(kept.unknown)));
    }
    return text + describe_room(request.folder, kept.bytes) + "\n";
}

}  // namespace

void BatchOutput::show_plan(const PreparedBatch& batch, const BatchRequest& request) const {
    constexpr long most_lines = 20;
    const CaseRange range = request.only.value_or(batch.all());
    std::map<long, CaseRow> rows;
    if (!request.begin_anew) {
        for (CaseRow& row : batch.read_rows(request.folder))
            rows.insert_or_assign(row.number, std::move(row));
    }
    const std::vector<long> wanted = list_wanted_cases(rows, range, request.retry_failed);
    for (long number = range.first; number <= range.last; ++number) {
        const auto row = rows.find(number);
        const bool is_shown = number - range.first < most_lines || number == range.last;
        if (number - range.first == most_lines && !is_shown) say(stdout, "…\n");
        if (!is_shown) continue;
        const std::string state = row == rows.end() ? "" : fmt::format("  [{}]", name_of(row->second.status));
        say(stdout, "{}: {}{}\n", number, batch.cases().describe(number), state);
    }
    say(stdout,
        "{} read and checked, {} to run into {}, {} at a time\n",
        count_cases(static_cast<std::size_t>(range.count())),
        wanted.size(),
        request.folder.string(),
        request.workers);
    say(stdout, "{}", describe_kept(batch, request));
}

void BatchOutput::show_size(const PreparedBatch& batch, const BatchRequest& request) const {
    if (!is_quiet_ && prints_) say(stdout, "{}", describe_kept(batch, request));
}

void BatchOutput::show_summary(const BatchSummary& summary, const BatchRequest& request) const {
    const long cases = summary.range.count();
    const long done = summary.count(CaseStatus::done);
    const std::vector<CaseGroup> failures = group_failures(summary.rows);
    // Reasons of single cases were printed when they failed.
    std::vector<CaseGroup> unshown = failures;
    std::erase_if(unshown, [&](const CaseGroup& group) {
        return group.numbers.size() == 1 && was_shown(group.numbers[0]);
    });
    print_failures(unshown);
    const std::vector<CaseGroup> warnings = group_warnings(summary.rows);
    if (!warnings.empty()) {
        say(stderr, "Warnings:\n");
        print_groups(stderr, warnings, false);
    }
    if (summary.is_interrupted) {
        say(stderr,
            "gxrod: interrupted; {} left to run. The same command resumes the batch.\n",
            count_cases(static_cast<std::size_t>(summary.left)));
    }
    if (!prints_) return;
    say(stdout,
        "{} of {} done{}; {} run now in {}\nTable: {}\n",
        done,
        count_cases(static_cast<std::size_t>(cases)),
        failures.empty() ? "" : fmt::format(", {} not", static_cast<long>(summary.rows.size()) - done),
        summary.run_now,
        describe_duration(summary.seconds),
        table_path(request.folder).string());
    // What did not converge will not the next time.
    const bool is_worth_a_try = std::any_of(failures.begin(), failures.end(), [](const CaseGroup& group) {
        return group.status != CaseStatus::failed && group.status != CaseStatus::deck_fault;
    });
    if (is_worth_a_try && !summary.is_interrupted)
        say(stdout, "--retry-failed runs the cases that are not done again.\n");
}

void BatchOutput::show_members(const std::vector<MemberRange>& ranges, const BatchRequest& request) const {
    if (!prints_ || ranges.empty()) return;
    constexpr double round_off = 1e-9;  // of the largest
    double largest = 0.0;
    for (const MemberRange& range : ranges)
        largest = std::max({largest, std::abs(range.largest.value), std::abs(range.least.value)});
    const auto describe_extreme = [&](const MemberExtreme& one) {
        if (std::abs(one.value) < round_off * largest) return fmt::format("{:>12} {:<24}", 0, "");
        return fmt::format("{:>12.6g} {:<24}",
                           one.value,
                           fmt::format("{} {}, {}", one.member, one.station, one.combination));
    };
    say(stdout,
        "Forces along members: {}, {}\n",
        (request.folder / "members.csv").string(),
        (request.folder / "envelope.csv").string());
    for (const MemberRange& range : ranges) {
        say(stdout,
            "  {:<2} max {} min {}\n",
            range.force,
            describe_extreme(range.largest),
            describe_extreme(range.least));
    }
}

void write_batch_summary(const std::string& target,
                         const BatchSummary& summary,
                         const BatchRequest& request) {
    nlohmann::ordered_json json{{"folder", request.folder.string()},
                                {"table", table_path(request.folder).string()},
                                {"cases", summary.range.count()}};
    for (const CaseStatus status : case_statuses) {
        std::string key = name_of(status);
        std::replace(key.begin(), key.end(), ' ', '_');
        json[key] = summary.count(status);
    }
    json["missing"] = summary.range.count() - static_cast<long>(summary.rows.size());
    json["run_now"] = summary.run_now;
    json["interrupted"] = summary.is_interrupted;
    json["workers"] = request.workers;
    json["seconds"] = summary.seconds;
    json["version"] = version;
    write_json(target, json);
}

}  // namespace gxrod
