#include "deck/text/csv_reading.hpp"

#include <csv.h>
#include <fmt/format.h>

#include <algorithm>
#include <new>
#include <utility>

#include "machine/file_error.hpp"

namespace gxrod {
namespace {

// What libcsv hands over, piece by piece.
struct Rows {
    std::vector<CsvRow> rows;
    CsvRow current;
};

extern "C" void add_csv_field(void* data, std::size_t size, void* target) {
    static_cast<Rows*>(target)->current.fields.emplace_back(static_cast<const char*>(data), size);
}

extern "C" void end_csv_row(int, void* target) {
    Rows& rows = *static_cast<Rows*>(target);
    rows.rows.push_back(std::move(rows.current));
    rows.current = {};
}

class Parser {
  public:
    Parser() {
        if (csv_init(&parser_, CSV_STRICT | CSV_STRICT_FINI) != 0) throw std::bad_alloc();
    }
    ~Parser() { csv_free(&parser_); }
    Parser(const Parser&) = delete;
    Parser& operator=(const Parser&) = delete;

    bool parse(std::string_view text, Rows& rows) {
        return csv_parse(&parser_, text.data(), text.size(), add_csv_field, end_csv_row, &rows) ==
               text.size();
    }
    bool finish(Rows& rows) { return csv_fini(&parser_, add_csv_field, end_csv_row, &rows) == 0; }

  private:
    csv_parser parser_{};
};

}  // namespace

std::vector<CsvRow> read_csv(std::string_view text, const std::filesystem::path& file) {
    constexpr std::string_view byte_order_mark = "\xEF\xBB\xBF";
    if (text.starts_with(byte_order_mark)) text.remove_prefix(byte_order_mark.size());
    Parser parser;
    Rows rows;
    int line = 1;
    const auto refuse = [&] {
        throw FileError(fmt::format("{}:{}", file.string(), line),
                        "no CSV: a quote that is out of place",
                        "a field with a quote is quoted itself, and the quote doubled");
    };
    // Line by line, so that each row knows where it begins; each line ends at most one.
    int begin = 0;
    const auto place_new_row = [&](std::size_t before) {
        if (rows.rows.size() > before) rows.rows.back().line = std::exchange(begin, 0);
    };
    while (!text.empty()) {
        const std::size_t size = std::min(text.find('\n'), text.size() - 1) + 1;
        const std::size_t before = rows.rows.size();
        const std::string_view piece = text.substr(0, size);
        if (begin == 0 && piece.find_first_not_of("\r\n") != std::string_view::npos) begin = line;
        if (!parser.parse(piece, rows)) refuse();
        place_new_row(before);
        text.remove_prefix(size);
        ++line;
    }
    const std::size_t before = rows.rows.size();
    if (!parser.finish(rows)) refuse();
    place_new_row(before);
    return std::move(rows.rows);
}

std::string write_csv_field(std::string_view field) {
    if (field.find_first_of(",\"\r\n") == std::string_view::npos &&
        (field.empty() || (field.front() != ' ' && field.back() != ' '))) {
        return std::string(field);
    }
    std::string quoted = "\"";
    for (const char letter : field) {
        if (letter == '"') quoted += '"';
        quoted += letter;
    }
    return quoted + '"';
}

}  // namespace gxrod
