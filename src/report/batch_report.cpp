#include "report/batch_report.hpp"

#include <fmt/format.h>

#include <nlohmann/json.hpp>
#include <stdexcept>
#include <string_view>

#include "batch/batch_record.hpp"
#include "batch/cases/case_table.hpp"
#include "machine/file_error.hpp"
#include "report/batch_json.hpp"
#include "report/page_file.hpp"
#include "report/page_template.hpp"
#include "report/script_json.hpp"
#include "results/file/output_file.hpp"

namespace gxrod {

namespace fs = std::filesystem;

namespace {

// A page may not take the place of what the batch is made of.
void check_place(const BatchReportOptions& options) {
    const fs::path folder = fs::absolute(options.folder / "").lexically_normal();
    const fs::path inside = fs::absolute(options.page).lexically_normal().lexically_relative(folder);
    const bool is_inside = !inside.empty() && *inside.begin() != "..";
    if (is_inside && options.page.extension() != ".html") {
        throw FileError(options.page,
                        "is in the folder of the batch and not named .html",
                        "so that no table or results are overwritten; give another name");
    }
    check_export_file(options.page, options.existing);
}

std::string name_of(const fs::path& folder) {
    const fs::path whole = fs::absolute(folder).lexically_normal();
    return (whole.has_filename() ? whole : whole.parent_path()).filename().string();
}

BatchContent plan(const BatchStory& story, std::size_t shell_bytes, const fs::path& page) {
    constexpr std::size_t element_bytes = 100;  // around the JSON
    const std::size_t fixed = shell_bytes + element_bytes;
    try {
        if (fixed >= story.most_bytes) throw std::length_error("no room for data");
        return plan_batch(story, story.most_bytes - fixed);
    } catch (const std::length_error&) {
        throw FileError(page,
                        fmt::format("the batch does not fit into {:g} MB even without its cases",
                                    static_cast<double>(story.most_bytes) / 1e6),
                        "give a larger --budget");
    }
}

}  // namespace

std::string relative_address(const fs::path& folder, const fs::path& page) {
    const fs::path from = fs::absolute(page).lexically_normal().parent_path();
    const std::string path =
        fs::absolute(folder).lexically_normal().lexically_relative(from).generic_string();
    constexpr std::string_view plain = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789-._~/";
    std::string address;
    for (const char c : path) {
        if (plain.find(c) != std::string_view::npos) {
            address += c;
        } else {
            address += fmt::format("%{:02X}", static_cast<unsigned char>(c));
        }
    }
    return address.ends_with('/') ? address : address + "/";
}

BatchReportSummary write_batch_report(const BatchReportOptions& options) {
    if (!is_batch_folder(options.folder)) {
        throw FileError(options.folder,
                        "is a folder without batch.json, so not the folder of a batch",
                        "give a results file of gxrod run, or the folder that gxrod batch wrote");
    }
    const BatchRecord record = read_batch_record(options.folder);
    const std::vector<CaseRow> rows = read_case_rows(options.folder, record);
    check_place(options);
    BatchReportSummary summary;
    summary.finished = rows.size();
    summary.cases = record.cases;
    PageFile page(options.page);
    summary.pages = write_case_pages(
        options.folder, record, rows, options.cases, options.most_case_bytes, options.progress);
    const BatchStory story{&record,
                           &rows,
                           name_of(options.folder),
                           relative_address(options.folder / "reports", options.page),
                           summary.pages.numbers,
                           options.most_bytes};
    const PageShell shell(batch_template());
    const BatchContent content = plan(story, shell.size(), options.page);
    summary.left_out = list_left_out(story, content);
    page.out() << shell.before;
    write_description(page.out(), describe_batch(story, content));
    page.out() << shell.after;
    summary.bytes = static_cast<std::size_t>(page.out().tellp());
    page.finish();
    return summary;
}

}  // namespace gxrod
