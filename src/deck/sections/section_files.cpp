#include "deck/sections/section_files.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <memory>
#include <optional>

#include "deck/rods/rod_table.hpp"
#include "deck/schema/suggestion.hpp"
#include "deck/sections/build_sections.hpp"
#include "deck/sections/section_matrices.hpp"
#include "laws/trapeze_law.hpp"
#include "machine/file_error.hpp"
#include "machine/printable.hpp"

namespace gxrod {
namespace {

std::string name_entry(char matrix, int row, int column) {
    return fmt::format("{}{}{}", matrix, row + 1, column + 1);
}

std::vector<std::string> list_columns() {
    std::vector<std::string> names{"fraction", "twist"};
    for (const char matrix : {'K', 'M'}) {
        for (int i = 0; i < 6; ++i) {
            for (int j = i; j < 6; ++j) names.push_back(name_entry(matrix, i, j));
        }
    }
    return names;
}

class SectionFileReader {
  public:
    SectionFileReader(const FileTable& table, const std::string& file) : table_(table), file_(file) {}

    SectionFile read() {
        find_columns();
        has_mass_ =
            std::ranges::any_of(table_.header, [](const auto& name) { return name.starts_with('M'); });
        for (const char matrix : {'K', 'M'}) {
            if (matrix == 'M' && !has_mass_) break;
            for (int i = 0; i < 6; ++i) require(name_entry(matrix, i, i));
        }
        require("fraction");
        for (const CsvRow& row : table_.rows) add(row);
        check_ends();
        return std::move(result_);
    }

  private:
    [[noreturn]] void refuse(int line, std::size_t column, const std::string& message) const {
        throw FileError(fmt::format("{}:{}:{}", file_, line, column + 1), message);
    }
    // In the line of names, which is the first that is no comment.
    [[noreturn]] void refuse_header(std::size_t column, const std::string& message) const {
        refuse(table_.header_line, column, message);
    }

    void find_columns() {
        if (table_.header.empty()) {
            refuse_header(0, "expected a line with the names of the columns: fraction, K11, K12, …");
        }
        const std::vector<std::string> known = list_columns();
        for (std::size_t i = 0; i < table_.header.size(); ++i) {
            const std::string& name = table_.header[i];
            if (std::ranges::find(known, name) == known.end()) refuse_header(i, explain_column(name, known));
            if (!columns_.emplace(name, i).second)
                refuse_header(i, fmt::format("a column {} is there already", name));
        }
    }

    static std::string explain_column(const std::string& name, const std::vector<std::string>& known) {
        const std::string text = fmt::format("unknown column \"{}\"", shorten(name));
        if (name.size() == 3 && name[1] > name[2]) {
            const std::string upper{name[0], name[2], name[1]};
            if (std::ranges::find(known, upper) != known.end())
                return text + "; entries stand on and above the diagonal: " + upper;
        }
        const std::string hint = did_you_mean(name, known);
        return text + (hint.empty() ? "; known here: fraction, twist, K11 … K66, M11 … M66" : hint);
    }

    void require(const std::string& name) const {
        if (columns_.contains(name)) return;
        refuse_header(0, fmt::format("there is no column {}", name));
    }

    // Of a field that its column has; 0 without the column.
    double value(const CsvRow& row, const std::string& name) const {
        const auto column = columns_.find(name);
        if (column == columns_.end()) return 0.0;
        const std::string& field = row.fields[column->second];
        if (const std::optional<double> number = read_finite(field)) return *number;
        refuse(
            row.line, column->second, fmt::format("expected a finite number, found \"{}\"", shorten(field)));
    }

    using MatrixCheck = std::optional<MatrixFault>(Mat6&);

    Mat6 matrix(const CsvRow& row, char name, MatrixCheck& check) const {
        Mat6 matrix;
        for (int i = 0; i < 6; ++i) {
            for (int j = i; j < 6; ++j) matrix(i, j) = matrix(j, i) = value(row, name_entry(name, i, j));
        }
        const std::optional<MatrixFault> fault = check(matrix);
        if (!fault) return matrix;
        // "[3][4]", or nothing of the whole matrix.
        const std::string entry = fault->entry.empty()
                                      ? name_entry(name, 0, 0)
                                      : name_entry(name, fault->entry[1] - '0', fault->entry[4] - '0');
        const auto column = columns_.find(entry);
        const bool is_whole = fault->entry.empty();
        refuse(row.line,
               column == columns_.end() ? 0 : column->second,
               fmt::format("{}: {}", is_whole ? std::string(1, name) : entry, fault->message));
    }

    void add(const CsvRow& row) {
        if (row.fields.size() != table_.header.size()) {
            refuse(row.line,
                   std::min(row.fields.size(), table_.header.size()),
                   fmt::format("expected {} fields, one for each column, found {}",
                               table_.header.size(),
                               row.fields.size()));
        }
        const double fraction = value(row, "fraction");
        check_fraction(row, fraction);
        SectionRow station{fraction, {.name = file_}};
        station.section.stiffness = matrix(row, 'K', check_stiffness_matrix);
        if (has_mass_) station.section.mass = matrix(row, 'M', check_mass_matrix);
        if (columns_.contains("twist")) add_twist(row, fraction);
        result_.rows.push_back(std::move(station));
    }

    void check_fraction(const CsvRow& row, double fraction) const {
        const std::size_t column = columns_.at("fraction");
        if (result_.rows.empty() && fraction != 0.0)
            refuse(row.line, column, fmt::format("expected the fraction 0 here, found {}", fraction));
        if (fraction > 1.0) refuse(row.line, column, fmt::format("expected at most 1, found {}", fraction));
        if (!result_.rows.empty() && fraction < result_.rows.back().fraction) {
            refuse(row.line,
                   column,
                   fmt::format("fractions must not fall from row to row: {} follows {}",
                               fraction,
                               result_.rows.back().fraction));
        }
    }

    // A section can jump, its axes cannot.
    void add_twist(const CsvRow& row, double fraction) {
        const double twist = value(row, "twist");
        if (!result_.twist.empty() && result_.twist.back().first == fraction) {
            if (result_.twist.back().second == twist) return;
            refuse(
                row.line,
                columns_.at("twist"),
                fmt::format("expected the twist {} of the row before, which has this fraction too, found {}",
                            result_.twist.back().second,
                            twist));
        }
        result_.twist.emplace_back(fraction, twist);
    }

    void check_ends() const {
        const int last = table_.rows.empty() ? table_.header_line : table_.rows.back().line;
        if (result_.rows.size() < 2) {
            refuse(last,
                   0,
                   fmt::format("expected rows from the fraction 0 to 1, two at least, found {}",
                               result_.rows.size()));
        }
        if (result_.rows.back().fraction == 1.0) return;
        refuse(
            last,
            columns_.at("fraction"),
            fmt::format("expected the fraction 1 in the last row, found {}", result_.rows.back().fraction));
    }

    const FileTable& table_;
    const std::string& file_;
    std::map<std::string, std::size_t> columns_;
    bool has_mass_ = false;
    SectionFile result_;
};

}  // namespace

SectionFile read_section_file(std::string_view bytes, const std::string& file) {
    const FileTable table = read_file_table(bytes, file);
    return SectionFileReader(table, file).read();
}

SectionFiles read_section_files(const CheckedTable& deck,
                                const TableFiles& files,
                                FaultList& faults,
                                std::vector<MeshRecord>& records) {
    SectionFiles all;
    const auto rods = rods_of(deck);
    for (std::size_t i = 0; i < rods.size(); ++i) {
        const SectionFileTable* table = rods[i].get().find_section_file();
        if (table == nullptr) continue;
        try {
            const std::string bytes = files.read(table->file);
            SectionFile file = read_section_file(bytes, table->file);
            if (table->damping) {
                for (SectionRow& row : file.rows) set_damping(*table->damping, row.section);
            }
            if (table->trapeze.value_or(false)) {
                for (SectionRow& row : file.rows)
                    row.section.law = std::make_shared<const TrapezeLaw>(row.section.stiffness);
            }
            keep_file(table->file, bytes, records);
            all.emplace(static_cast<int>(i), std::move(file));
        } catch (const FileError& error) {
            faults.add(table->place_of(&table->file), table->path_of(&table->file), error.what());
        }
    }
    return all;
}

}  // namespace gxrod
