#include "deck/loads/column_table.hpp"

#include <fmt/format.h>

#include <array>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <sstream>

#include "deck/text/table_files.hpp"
#include "machine/file_error.hpp"
#include "machine/printable.hpp"

namespace gxrod {
namespace {

constexpr const char* broken_output = "is no whole binary output of OpenFAST";

// The numbers of a binary file, one after the other, little-endian as all machines that write it.
class BinaryOutput {
  public:
    BinaryOutput(std::string_view bytes, const std::string& file) : bytes_(bytes), file_(file) {}

    template <class Number>
    Number next() {
        Number number{};
        std::memcpy(&number, take(sizeof number).data(), sizeof number);
        return number;
    }
    // A text of so many letters without the blanks behind it.
    std::string next_text(std::size_t letters) {
        const std::string text(take(letters));
        return text.substr(0, text.find_last_not_of(std::string(" \0", 2)) + 1);
    }
    template <class Number>
    std::vector<double> next_numbers(std::size_t count) {
        if (count > bytes_.size()) throw FileError(file_, broken_output);
        std::vector<double> numbers(count);
        for (double& number : numbers) number = static_cast<double>(next<Number>());
        return numbers;
    }

  private:
    std::string_view take(std::size_t count) {
        if (count > bytes_.size() - at_) throw FileError(file_, broken_output);
        at_ += count;
        return bytes_.substr(at_ - count, count);
    }

    std::string_view bytes_;
    const std::string& file_;
    std::size_t at_ = 0;
};

// The formats of binary output; 2 is packed and without times.
struct OutputFormat {
    static constexpr std::int16_t with_times = 1, not_packed = 3, with_long_names = 4;
};

bool is_binary_output(std::string_view bytes) {
    return bytes.size() > 10 && bytes[0] >= OutputFormat::with_times &&
           bytes[0] <= OutputFormat::with_long_names && bytes[1] == '\0';
}

// Every number is packed as (number · scale + offset) in 16 bits, times in 32 bits.
ColumnTable read_binary_output(std::string_view bytes, const std::string& file) {
    BinaryOutput input(bytes, file);
    const auto format = input.next<std::int16_t>();
    const std::size_t letters =
        format == OutputFormat::with_long_names ? static_cast<std::uint16_t>(input.next<std::int16_t>()) : 10;
    const std::size_t channels = static_cast<std::uint32_t>(input.next<std::int32_t>());
    const std::size_t rows = static_cast<std::uint32_t>(input.next<std::int32_t>());
    const auto first = input.next<double>();
    const auto second = input.next<double>();
    std::vector<double> scales(channels, 1.0), offsets(channels, 0.0);
    if (format != OutputFormat::not_packed) {
        scales = input.next_numbers<float>(channels);
        offsets = input.next_numbers<float>(channels);
    }
    input.next_text(static_cast<std::uint32_t>(input.next<std::int32_t>()));  // what wrote it
    ColumnTable table;
    if (channels > bytes.size() || rows > bytes.size()) throw FileError(file, broken_output);
    for (std::size_t i = 0; i <= channels; ++i) table.names.push_back(input.next_text(letters));
    for (std::size_t i = 0; i <= channels; ++i) input.next_text(letters);  // units
    std::vector<double> times(rows);
    if (format == OutputFormat::with_times) times = input.next_numbers<std::int32_t>(rows);
    for (std::size_t row = 0; row < rows; ++row) {
        table.values.push_back(format == OutputFormat::with_times
                                   ? (times[row] - second) / first
                                   : first + second * static_cast<double>(row));
        for (std::size_t i = 0; i < channels; ++i) {
            const double number =
                format == OutputFormat::not_packed ? input.next<double>() : input.next<std::int16_t>();
            table.values.push_back((number - offsets[i]) / scales[i]);
            if (!std::isfinite(table.values.back()))
                throw FileError(
                    file,
                    fmt::format("row {} of column {} is not a finite number", row + 1, table.names[i + 1]));
        }
    }
    return table;
}

std::vector<std::string> split_columns(const std::string& line) {
    std::istringstream words(line);
    std::vector<std::string> found;
    for (std::string word; words >> word;) found.push_back(word);
    return found;
}

void add_output_row(const std::vector<std::string>& fields,
                    int line,
                    const std::string& file,
                    ColumnTable& table) {
    const std::string place = fmt::format("{}:{}", file, line);
    if (fields.size() != table.columns())
        throw FileError(place, fmt::format("expected {} columns, found {}", table.columns(), fields.size()));
    for (const std::string& field : fields) {
        const std::optional<double> number = read_finite(field);
        if (!number)
            throw FileError(place, fmt::format("expected a finite number, found \"{}\"", shorten(field)));
        table.values.push_back(*number);
    }
    table.lines.push_back(line);
}

// Text output: some lines, one with names, of which the first is Time, one with units, rows of numbers.
ColumnTable read_text_output(std::string_view bytes, const std::string& file) {
    std::istringstream lines{std::string(bytes)};
    ColumnTable table;
    int line = 0;
    for (std::string text; std::getline(lines, text);) {
        ++line;
        const std::vector<std::string> words = split_columns(text);
        if (words.empty()) continue;
        if (table.names.empty()) {
            if (words.front() == "Time") table.names = words;
        } else if (!words.front().starts_with('(')) {
            add_output_row(words, line, file, table);
        }
    }
    return table;
}

// Whether a line begins with the word Time and no comma parts its words.
bool is_text_output(std::string_view bytes) {
    std::size_t at = 0;
    for (int line = 0; line < 100 && at < bytes.size(); ++line) {
        const std::size_t end = std::min(bytes.find('\n', at), bytes.size());
        const std::string text(bytes.substr(at, end - at));
        const std::vector<std::string> words = split_columns(text);
        if (words.size() > 1 && words.front() == "Time" && text.find(',') == std::string::npos) return true;
        at = end + 1;
    }
    return false;
}

}  // namespace

std::string ColumnTable::place_of(std::size_t row, const std::string& file) const {
    return lines.empty() ? fmt::format("{}: row {}", file, row + 1) : fmt::format("{}:{}", file, lines[row]);
}

ColumnTable read_column_table(std::string_view bytes, const std::string& file) {
    if (is_binary_output(bytes)) return read_binary_output(bytes, file);
    if (is_text_output(bytes)) return read_text_output(bytes, file);
    const FileTable read = read_file_table(bytes, file);
    if (read.header.empty())
        throw FileError(fmt::format("{}:{}", file, read.header_line),
                        "expected a header with the names of the columns");
    ColumnTable table{.names = read.header, .values = {}, .lines = {}};
    for (const CsvRow& row : read.rows) add_output_row(row.fields, row.line, file, table);
    return table;
}

}  // namespace gxrod
