#include "batch/cases/case_table.hpp"

#include <chrono>
#include <fstream>

#include "batch/batch.hpp"
#include "batch/batch_folder.hpp"
#include "batch/gathering.hpp"
#include "batch/plans.hpp"
#include "machine/file_error.hpp"
#include "tools/catch.hpp"

namespace gxrod::test {
namespace {

BatchRecord of_cases(long cases) {
    BatchRecord record;
    record.cases = cases;
    record.parameters = {"k"};
    return record;
}

CaseRow row_of(long number, const std::string& reason = "") {
    CaseRow row;
    row.number = number;
    row.parameters = {std::to_string(10 * number)};
    row.reason = reason;
    if (!reason.empty()) row.status = CaseStatus::failed;
    return row;
}

std::string numbers_and_reasons(const std::vector<CaseRow>& rows) {
    std::string text;
    for (const CaseRow& row : rows) text += std::to_string(row.number) + row.reason + " ";
    return text;
}

void append_text(const std::filesystem::path& path, const std::string& text) {
    std::ofstream(path, std::ios::binary | std::ios::app) << text;
}

}  // namespace

TEST_CASE("Rows that are appended are read by case, the last of each", "[batch]") {
    const ScratchFolder folder;
    const BatchRecord record = of_cases(9);
    CHECK(read_case_rows(folder.path(), record).empty());
    {
        TableAppender table(table_path(folder.path()), record);
        for (const long number : {5, 2, 7}) table.append(row_of(number, number == 2 ? "a" : ""));
    }
    {
        TableAppender table(table_path(folder.path()), record);
        table.append(row_of(2, "b"));
    }
    CHECK(numbers_and_reasons(read_case_rows(folder.path(), record)) == "2b 5 7 ");
}

TEST_CASE("A row that was cut short is left out, and does not spoil the next", "[batch]") {
    const ScratchFolder folder;
    const BatchRecord record = of_cases(9);
    const std::filesystem::path path = table_path(folder.path());
    { TableAppender(path, record).append(row_of(1)); }
    append_text(path, "2,20,done,,0,0");
    CHECK(numbers_and_reasons(read_case_rows(folder.path(), record)) == "1 ");
    { TableAppender(path, record).append(row_of(3)); }
    CHECK(numbers_and_reasons(read_case_rows(folder.path(), record)) == "1 3 ");
    // Not even the header was whole.
    std::ofstream(path, std::ios::binary | std::ios::trunc) << "case,k,sta";
    CHECK(read_case_rows(folder.path(), record).empty());
    { TableAppender(path, record).append(row_of(4)); }
    CHECK(numbers_and_reasons(read_case_rows(folder.path(), record)) == "4 ");
}

TEST_CASE("Parts of slices go into the table", "[batch]") {
    const ScratchFolder folder;
    const BatchRecord record = of_cases(9);
    for (const char* name : {"parts", "cases"}) std::filesystem::create_directory(folder.path() / name);
    write_case_table(folder.path(), record, {row_of(1), row_of(4, "old")});
    const std::filesystem::path part = part_path(folder.path(), {4, 6});
    CHECK(range_of_part(part) == CaseRange{4, 6});
    for (const char* other : {"x.csv", "4.csv", "4-.csv", "4-x.csv", "6-4.csv", "0-4.csv"})
        CHECK_FALSE(range_of_part(other));
    { TableAppender(part, record).append(row_of(4, "new")); }
    CHECK(numbers_and_reasons(read_case_rows(folder.path(), record)) == "1 4new ");
    {
        // Writing continues.
        const BatchLock writer = BatchLock::of_cases(folder.path(), {4, 6});
        CHECK(numbers_and_reasons(gather_rows(folder.path(), record)) == "1 4new ");
        CHECK(std::filesystem::exists(part));
        CHECK(std::filesystem::exists(folder.path() / "cases"));
        CHECK(has_idle_parts(folder.path(), writer));
    }
    CHECK(numbers_and_reasons(gather_rows(folder.path(), record)) == "1 4new ");
    for (const char* name : {"parts", "cases"}) CHECK_FALSE(std::filesystem::exists(folder.path() / name));
    CHECK(numbers_and_reasons(read_case_rows(folder.path(), record)) == "1 4new ");
}

TEST_CASE("A row counts before those that slices left earlier", "[batch]") {
    const PlanFiles files("deck = \"deck.toml\"\n[vary]\n\"parameters.EI\" = [100.0, 200.0, 300.0]\n");
    const PreparedBatch batch(files.read());
    BatchRequest request;
    request.folder = files.folder() / "out";
    request.only = CaseRange{3, 3};
    run_batch(batch, request);
    std::filesystem::create_directory(request.folder / "parts");
    const std::filesystem::path left = part_path(request.folder, {1, 2});
    {
        TableAppender part(left, batch.record());
        for (const long number : {1, 2}) part.append(row_of(number, "killed"));
    }
    const auto later = std::filesystem::last_write_time(left) + std::chrono::hours(1);
    std::filesystem::last_write_time(left, later);
    request.only = CaseRange{2, 3};
    request.retry_failed = true;
    run_batch(batch, request);
    CHECK(numbers_and_reasons(batch.read_rows(request.folder)) == "1killed 2 3 ");
    std::filesystem::create_directory(request.folder / "parts");
    { TableAppender(left, batch.record()).append(row_of(1, "killed again")); }
    request.only.reset();
    run_batch(batch, request);
    CHECK(numbers_and_reasons(batch.read_rows(request.folder)) == "1 2 3 ");
}

TEST_CASE("The table of another batch is not read", "[batch]") {
    const ScratchFolder folder;
    write_case_table(folder.path(), of_cases(9), {row_of(1)});
    BatchRecord other = of_cases(9);
    other.parameters = {"q"};
    const std::string path = table_path(folder.path()).string();
    CHECK_THROWS_WITH(read_case_rows(folder.path(), other),
                      path + ": is the table of another batch: its columns differ from those of batch.json");
}

TEST_CASE("A table that cannot be written is reported", "[batch]") {
    CHECK_THROWS_WITH(TableAppender("/nowhere/index.csv", of_cases(1)),
                      "/nowhere/index.csv: cannot be written (No such file or directory)");
    CHECK_THROWS_WITH(replace_file("/nowhere/index.csv", "x"),
                      "/nowhere/index.csv: cannot be written (No such file or directory)");
}

}  // namespace gxrod::test
