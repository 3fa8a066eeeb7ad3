#include "report/batch_report.hpp"

#include <fmt/format.h>

#include <filesystem>
#include <fstream>
#include <limits>
#include <nlohmann/json.hpp>
#include <sstream>

#include "batch/cases/case_table.hpp"
#include "machine/file_error.hpp"
#include "report/batch_json.hpp"
#include "report/page_template.hpp"
#include "report/script_json.hpp"
#include "results/results_file.hpp"
#include "results/sample.hpp"
#include "tools/catch.hpp"

using namespace gxrod;
using Json = nlohmann::json;
namespace fs = std::filesystem;

namespace {

constexpr const char* evil = "</script><script>document.title='run'</script><!-- <script>";

BatchRecord make_record(long cases) {
    BatchRecord record;
    record.version = "0.1.0";
    record.plan = "sweep.toml";
    record.plan_text = "deck = \"rod.toml\"\n";
    record.title = "A rod";
    record.combine = "grid";
    record.cases = cases;
    record.decks = {{"rod.toml", "title = \"A rod\"\n", {}}};
    record.parameters = {"parameters.EI"};
    record.columns = {{"tip", "largest z of position of tip"}};
    return record;
}

CaseRow make_row(long number) {
    CaseRow row;
    row.number = number;
    row.parameters = {fmt::format("{}", 10 * number)};
    row.collected = {0.5 * static_cast<double>(number)};
    row.steps = 100;
    row.seconds = 0.25;
    row.time = 2.0;
    return row;
}

std::vector<CaseRow> make_rows(long count) {
    std::vector<CaseRow> rows;
    for (long number = 1; number <= count; ++number) rows.push_back(make_row(number));
    return rows;
}

fs::path write_batch(const fs::path& folder, const BatchRecord& record, const std::vector<CaseRow>& rows) {
    fs::create_directories(folder);
    write_batch_record(record, folder);
    write_case_table(folder, record, rows);
    return folder;
}

// Results of two steps.
void write_results(const fs::path& path) {
    fs::create_directories(path.parent_path());
    const Model model = sample::make_model();
    ResultsFile file({path}, sample::make_deck(), model, sample::make_output());
    for (const double time : {0.0, 0.1}) {
        const sample::Motion motion(time);
        file.record_step(motion.snapshot(), sample::make_ledger(time), sample::make_solver(time));
        file.write_frame(motion.snapshot());
    }
    file.close(RunStatus::complete, "");
}

std::string read(const fs::path& path) {
    std::ostringstream text;
    text << std::ifstream(path, std::ios::binary).rdbuf();
    return text.str();
}

Json describe(const std::string& page) {
    const std::string start = "<script type=\"application/json\" id=\"report\">";
    const std::size_t first = page.find(start) + start.size();
    return Json::parse(page.substr(first, page.find("</script>", first) - first));
}

std::size_t count(const std::string& text, const std::string& part) {
    std::size_t number = 0;
    for (std::size_t at = text.find(part); at != std::string::npos; at = text.find(part, at + 1)) ++number;
    return number;
}

std::size_t size_of(const BatchStory& story, const BatchContent& content) {
    return write_script_json(describe_batch(story, content)).size();
}

}  // namespace

TEST_CASE("The page of a batch holds its cases, column by column", "[report]") {
    const BatchRecord record = make_record(5);
    std::vector<CaseRow> rows = make_rows(3);
    rows[1].status = CaseStatus::time_limit;
    rows[1].reason = "took longer than 1 s";
    rows[1].collected = {std::numeric_limits<double>::quiet_NaN()};
    rows[2].status = CaseStatus::deck_fault;
    rows[2].reason = rows[1].reason;
    rows[2].collected = {-std::numeric_limits<double>::infinity()};
    rows[2].warning = "mind";
    const BatchStory story{&record, &rows, "sweep", "reports/", {1, 3}, 20'000'000};
    const Json json = Json::parse(write_script_json(describe_batch(story, {3, 1})));
    CHECK(json["cases"] == 5);
    CHECK(json["finished"] == 3);
    CHECK(json["counts"] == Json{1, 0, 1, 0, 0, 1});
    CHECK(json["statuses"][2] == "time limit");
    CHECK(json["seconds"] == 0.75);
    CHECK(json["warned"] == 1);
    CHECK(json["rows"]["case"] == Json{1, 2, 3});
    CHECK(json["rows"]["status"] == Json{0, 2, 5});
    CHECK(json["rows"]["parameters"] == Json::array({{"10", "20", "30"}}));
    CHECK(json["rows"]["collected"] == Json::array({{0.5, nullptr, nullptr}}));
    CHECK(json["texts"] == Json{"", "took longer than 1 s", "mind"});
    CHECK(json["rows"]["reason"] == Json{0, 1, 1});
    CHECK(json["rows"]["warning"] == Json{0, 0, 2});
    CHECK(json["pages"] == Json{{"folder", "reports/"}, {"width", 4}, {"cases", {1, 3}}});
    CHECK(json["decks"][0]["text"] == record.decks[0].text);
    CHECK(json["left_out"].empty());
}

TEST_CASE("As many cases and decks go into a page as fit", "[report]") {
    BatchRecord record = make_record(5000);
    std::vector<CaseRow> rows = make_rows(5000);
    for (CaseRow& row : rows) row.reason = fmt::format("a reason of its own, {}", row.number);
    const BatchStory story{&record, &rows, "sweep", "reports/", {}, 0};
    const std::size_t all = size_of(story, {5000, 1});
    CHECK(plan_batch(story, all).rows == 5000);
    for (const std::size_t bytes : {all - 100, all / 2, all / 9}) {
        const BatchContent content = plan_batch(story, bytes);
        CHECK(content.decks == 1);
        CHECK(content.rows < 5000);
        CHECK(size_of(story, content) <= bytes);
        CHECK(size_of(story, {content.rows + 1, 1}) > bytes);
        REQUIRE(list_left_out(story, content).size() == 1);
        CHECK(list_left_out(story, content)[0] ==
              fmt::format("Of 5000 cases that have ended, the page has the first {}.", content.rows));
    }
    record.decks.assign(100, {"rod.toml", std::string(10'000, 'x'), {}});
    const BatchContent content = plan_batch(story, 400'000);
    CHECK(content.decks > 15);
    CHECK(content.decks < 20);
    CHECK(content.rows > 1000);
    CHECK(size_of(story, content) <= 400'000);
    CHECK(list_left_out(story, content).size() == 2);
    CHECK_THROWS_AS(plan_batch(story, 300), std::length_error);
}

TEST_CASE("No text of a batch can end the script that holds it", "[report]") {
    const sample::ScratchFolder scratch;
    BatchRecord record = make_record(1);
    record.plan = record.plan_text = record.title = record.combine = evil;
    record.decks = {{evil, evil, {}}};
    record.parameters = {evil};
    record.columns = {{evil, evil}};
    CaseRow row = make_row(1);
    row.parameters = {evil};
    row.status = CaseStatus::crashed;
    row.reason = row.warning = evil;
    const fs::path folder = write_batch(scratch / "batch", record, {row});
    write_batch_report({folder, folder / "report.html"});
    const std::string page = read(folder / "report.html");
    const PageShell shell(batch_template());
    CHECK(count(page, "<script") == count(shell.before + shell.after, "<script") + 1);
    CHECK(count(page, "</script") == count(shell.before + shell.after, "</script") + 1);
    const Json json = describe(page);
    CHECK(json["title"] == evil);
    CHECK(json["plan_text"] == evil);
    CHECK(json["rows"]["parameters"][0][0] == evil);
    CHECK(json["texts"] == Json{evil});
}

TEST_CASE("The page of a batch stays within its budget", "[report]") {
    const sample::ScratchFolder scratch;
    const fs::path folder = write_batch(scratch / "batch", make_record(5000), make_rows(5000));
    const fs::path page = folder / "report.html";
    const BatchReportSummary whole = write_batch_report({folder, page});
    CHECK(whole.left_out.empty());
    CHECK(whole.finished == 5000);
    CHECK(whole.bytes == fs::file_size(page));

    BatchReportOptions options{folder, page, whole.bytes - 50'000, 3'000'000, Existing::replace};
    const BatchReportSummary thin = write_batch_report(options);
    CHECK(fs::file_size(page) <= options.most_bytes);
    CHECK(fs::file_size(page) > options.most_bytes - 1000);
    CHECK(describe(read(page))["left_out"] == Json(thin.left_out));
    CHECK(describe(read(page))["finished"] == 5000);

    options.most_bytes = 50'000;
    options.page = folder / "small.html";
    CHECK_THROWS_WITH(write_batch_report(options),
                      Catch::Contains("does not fit into 0.05 MB") && Catch::Contains("--budget"));
    CHECK_FALSE(fs::exists(folder / "small.html"));
    CHECK_FALSE(fs::exists(folder / "small.html.part"));
}

TEST_CASE("A page does not take the place of what a batch is made of", "[report]") {
    const sample::ScratchFolder scratch;
    const fs::path folder = write_batch(scratch / "batch", make_record(1), make_rows(1));
    for (const char* name : {"index.csv", "batch.json", "cases/0001.vtkhdf", "../batch/index.csv", "page"}) {
        BatchReportOptions options{folder, folder / name};
        options.existing = Existing::replace;
        CHECK_THROWS_WITH(write_batch_report(options), Catch::Contains("not named .html"));
    }
    BatchReportOptions outside{folder, folder / "../page"};
    CHECK(write_batch_report(outside).bytes > 0);
    CHECK_THROWS_WITH(write_batch_report(outside), Catch::Contains("exists already"));
    CHECK_THROWS_WITH(write_batch_report({scratch / "none", scratch / "page.html"}),
                      Catch::Contains("none: ") && Catch::Contains("batch.json"));
}

TEST_CASE("If cases are too many, failed ones get their page first", "[report]") {
    const sample::ScratchFolder scratch;
    std::vector<CaseRow> rows = make_rows(5);
    for (CaseRow& row : rows) {
        if (row.number == 2) continue;  // whose results were not kept
        row.results = fmt::format("cases/{:04}.vtkhdf", row.number);
        write_results(scratch / "batch" / row.results);
    }
    rows[3].status = CaseStatus::failed;
    const BatchRecord record = make_record(5);
    const fs::path folder = write_batch(scratch / "batch", record, rows);
    std::size_t told = 0;
    const auto write = [&](const CaseChoice& choice) {
        return write_case_pages(
            folder, record, rows, choice, 3'000'000, [&](std::size_t, std::size_t) { ++told; });
    };
    const CasePages two = write({{1, 5}, 2});
    CHECK(two.written == 2);
    CHECK(two.passed_over == 2);
    CHECK(two.numbers == std::vector<long>{1, 4});
    CHECK(told == 2);
    const CasePages more = write({{2, 4}, 10});
    CHECK(more.written == 1);
    CHECK(more.kept == 1);
    CHECK(more.numbers == std::vector<long>{1, 3, 4});
    CHECK(fs::exists(folder / "reports/0003.html"));
    // Results that are gone keep the page that they had, and are reported if they had none.
    fs::remove(folder / rows[0].results);
    fs::remove(folder / rows[4].results);
    const CasePages last = write({});
    CHECK(last.numbers == std::vector<long>{1, 3, 4});
    CHECK(last.lost == 1);
}

TEST_CASE("Links to the pages of cases are relative and encoded", "[report]") {
    CHECK(case_page_name(17, 20) == "0017.html");
    CHECK(case_page_name(17, 123456) == "000017.html");
    CHECK(relative_address("/a/batch/reports", "/a/batch/report.html") == "reports/");
    CHECK(relative_address("/a/batch/reports", "/a/b/c/page.html") == "../../batch/reports/");
    CHECK(relative_address("batch/reports", "page.html") == "batch/reports/");
    CHECK(relative_address("/a/b c#1?/ä:%/reports", "/a/page.html") == "b%20c%231%3F/%C3%A4%3A%25/reports/");
    CHECK(relative_address("/a/../b/./reports/", "/b/page.html") == "reports/");
}
