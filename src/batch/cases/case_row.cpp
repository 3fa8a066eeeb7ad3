#include "batch/cases/case_row.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <limits>

#include "machine/file_error.hpp"

namespace gxrod {
namespace {

constexpr std::size_t fixed_columns = 10;  // without parameters and collected numbers

// Takes the fields of a row one after the other.
class RowReader {
  public:
    RowReader(const CsvRow& row, const std::filesystem::path& file) : row_(row), file_(file) {}

    const std::string& text() { return row_.fields[next_++]; }

    template <class Number>
    Number number() {
        const std::string& field = text();
        if (field == "nan") return std::numeric_limits<Number>::quiet_NaN();
        Number value{};
        const char* end = field.data() + field.size();
        const auto [stop, error] = std::from_chars(field.data(), end, value);
        if (error != std::errc() || stop != end) refuse(fmt::format("\"{}\" is not a number", field));
        return value;
    }

    CaseStatus status() {
        const std::string& word = text();
        const auto found = std::find_if(case_statuses.begin(), case_statuses.end(), [&](CaseStatus status) {
            return word == name_of(status);
        });
        if (found == case_statuses.end()) refuse(fmt::format("\"{}\" is no status of a case", word));
        return *found;
    }

    [[noreturn]] void refuse(const std::string& failure) const {
        throw FileError(fmt::format("{}:{}", file_.string(), row_.line),
                        "no row of the batch: " + failure,
                        "take the line out, and the case is run again");
    }

  private:
    const CsvRow& row_;
    const std::filesystem::path& file_;
    std::size_t next_ = 0;
};

// A field without line ends, so that every row is one line.
std::string write_field(std::string text) {
    std::replace(text.begin(), text.end(), '\n', ' ');
    std::replace(text.begin(), text.end(), '\r', ' ');
    return write_csv_field(text);
}

}  // namespace

const char* name_of(CaseStatus status) {
    switch (status) {
        case CaseStatus::done:
            return "done";
        case CaseStatus::failed:
            return "failed";
        case CaseStatus::time_limit:
            return "time limit";
        case CaseStatus::out_of_memory:
            return "out of memory";
        case CaseStatus::crashed:
            return "crashed";
        case CaseStatus::deck_fault:
            break;
    }
    return "deck fault";
}

std::string write_case_header(const BatchRecord& record) {
    std::string line = "case";
    for (const std::string& name : record.parameters) line += "," + write_csv_field(name);
    line += ",status,reason";
    for (const BatchColumn& column : record.columns) line += "," + write_csv_field(column.name);
    return line + ",steps,newton_iterations,rejected_steps,time,seconds,results,warning";
}

std::string write_case_row(const CaseRow& row) {
    std::string line = fmt::format("{}", row.number);
    for (const std::string& value : row.parameters) line += "," + write_field(value);
    line += fmt::format(",{},{}", name_of(row.status), write_field(row.reason));
    for (const double value : row.collected) line += fmt::format(",{}", value);
    return line + fmt::format(",{},{},{},{},{:.4g},{},{}",
                              row.steps,
                              row.newton_iterations,
                              row.rejected_steps,
                              row.time,
                              row.seconds,
                              write_field(row.results),
                              write_field(row.warning));
}

CaseRow read_case_row(const CsvRow& csv, const BatchRecord& record, const std::filesystem::path& file) {
    RowReader reader(csv, file);
    const std::size_t columns = fixed_columns + record.parameters.size() + record.columns.size();
    if (csv.fields.size() != columns)
        reader.refuse(fmt::format("it has {} fields, expected {}", csv.fields.size(), columns));
    CaseRow row;
    row.number = reader.number<long>();
    if (row.number < 1 || row.number > record.cases)
        reader.refuse(fmt::format("there is no case {}; the batch has {}", row.number, record.cases));
    for (std::size_t i = 0; i < record.parameters.size(); ++i) row.parameters.push_back(reader.text());
    row.status = reader.status();
    row.reason = reader.text();
    for (std::size_t i = 0; i < record.columns.size(); ++i) row.collected.push_back(reader.number<double>());
    row.steps = reader.number<long>();
    row.newton_iterations = reader.number<long>();
    row.rejected_steps = reader.number<long>();
    row.time = reader.number<double>();
    row.seconds = reader.number<double>();
    row.results = reader.text();
    row.warning = reader.text();
    return row;
}

}  // namespace gxrod
