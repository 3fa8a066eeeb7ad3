#include "report/case_pages.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <system_error>

#include "batch/batch_folder.hpp"
#include "machine/file_error.hpp"
#include "report/report.hpp"

namespace gxrod {

namespace fs = std::filesystem;

namespace {

struct CaseFiles {
    long number;
    bool has_failed;
    fs::path results, page;
};

// Of the cases whose results, or a page of them, are there.
std::vector<CaseFiles> list_kept(const fs::path& folder,
                                 const BatchRecord& record,
                                 const std::vector<CaseRow>& rows,
                                 CasePages& pages) {
    std::vector<CaseFiles> kept;
    for (const CaseRow& row : rows) {
        if (row.results.empty()) continue;
        CaseFiles files{row.number,
                        row.status != CaseStatus::done,
                        folder / row.results,
                        folder / "reports" / case_page_name(row.number, record.cases)};
        if (fs::exists(files.results) || fs::exists(files.page)) {
            kept.push_back(std::move(files));
        } else {
            ++pages.lost;
        }
    }
    return kept;
}

// Whether the page shows the results as they are; results that were removed since cannot change any more.
bool is_current(const CaseFiles& files) {
    std::error_code no_page, no_results;
    const fs::file_time_type page = fs::last_write_time(files.page, no_page);
    const fs::file_time_type results = fs::last_write_time(files.results, no_results);
    return !no_page && (no_results || page >= results);
}

// Those of the choice whose pages are missing or old, failed ones first if there are too many.
std::vector<CaseFiles> choose(const std::vector<CaseFiles>& kept,
                              const CaseChoice& choice,
                              CasePages& pages) {
    std::vector<CaseFiles> chosen;
    std::copy_if(kept.begin(), kept.end(), std::back_inserter(chosen), [&](const CaseFiles& files) {
        return choice.range.contains(files.number);
    });
    if (chosen.size() > choice.most) {
        pages.passed_over = chosen.size() - choice.most;
        std::stable_partition(
            chosen.begin(), chosen.end(), [](const CaseFiles& files) { return files.has_failed; });
        chosen.resize(choice.most);
    }
    const std::size_t all = chosen.size();
    std::erase_if(chosen, [](const CaseFiles& files) { return is_current(files); });
    pages.kept = all - chosen.size();
    return chosen;
}

}  // namespace

std::string case_page_name(long number, long cases) {
    const std::size_t width = std::max<std::size_t>(4, std::to_string(cases).size());
    return fmt::format("{:0{}}.html", number, width);
}

CasePages write_case_pages(const fs::path& folder,
                           const BatchRecord& record,
                           const std::vector<CaseRow>& rows,
                           const CaseChoice& choice,
                           std::size_t most_bytes,
                           const PageProgress& progress) {
    CasePages pages;
    const std::vector<CaseFiles> kept = list_kept(folder, record, rows, pages);
    const std::vector<CaseFiles> chosen = choose(kept, choice, pages);
    if (!chosen.empty()) make_folder(folder / "reports");
    for (const CaseFiles& files : chosen) {
        try {
            write_report({files.results, files.page, most_bytes, Existing::replace});
            ++pages.written;
        } catch (const FileError& error) {
            pages.faults.emplace_back(error.what());
        }
        progress(pages.written + pages.faults.size(), chosen.size());
    }
    for (const CaseFiles& files : kept) {
        if (is_current(files)) pages.numbers.push_back(files.number);
    }
    return pages;
}

}  // namespace gxrod
