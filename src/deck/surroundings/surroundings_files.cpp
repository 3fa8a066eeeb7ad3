#include "deck/surroundings/surroundings_files.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "deck/schema/schema_tables.hpp"
#include "deck/surroundings/surroundings_tables.hpp"
#include "deck/surroundings/vessel_table.hpp"
#include "machine/file_error.hpp"
#include "machine/printable.hpp"

namespace gxrod {
namespace {

// By how much times of a record may be off equal steps, relative to a step.
constexpr double uneven = 1e-3;

[[noreturn]] void refuse(const std::string& file, int line, const std::string& message) {
    throw FileError(fmt::format("{}:{}", file, line), message);
}

template <std::size_t Count>
struct NumberRow {
    int line;
    std::array<double, Count> values;
};

// Rows of so many numbers, behind a header or without one.
template <std::size_t Count>
std::vector<NumberRow<Count>> read_rows(std::string_view bytes, const std::string& file) {
    const FileTable table = read_file_table(bytes, file);
    std::vector<NumberRow<Count>> rows;
    rows.reserve(table.rows.size());
    for (const CsvRow& row : table.rows) {
        if (row.fields.size() != Count) {
            refuse(file, row.line, fmt::format("expected {} columns, found {}", Count, row.fields.size()));
        }
        NumberRow<Count> numbers{row.line, {}};
        for (std::size_t i = 0; i < Count; ++i) {
            const std::optional<double> value = read_finite(row.fields[i]);
            if (!value) {
                refuse(file,
                       row.line,
                       fmt::format("expected a finite number, found \"{}\"", shorten(row.fields[i])));
            }
            numbers.values[i] = *value;
        }
        rows.push_back(numbers);
    }
    return rows;
}

std::vector<double> sorted_values(const std::vector<NumberRow<3>>& rows, std::size_t column) {
    std::vector<double> values;
    values.reserve(rows.size());
    for (const auto& row : rows) values.push_back(row.values[column]);
    std::ranges::sort(values);
    values.erase(std::unique(values.begin(), values.end()), values.end());
    return values;
}

std::size_t index_of(const std::vector<double>& sorted, double value) {
    return static_cast<std::size_t>(std::ranges::lower_bound(sorted, value) - sorted.begin());
}

// That the first numbers, times, rise from row to row.
void check_rising(const std::vector<NumberRow<2>>& rows, const std::string& file) {
    for (std::size_t i = 1; i < rows.size(); ++i) {
        const double before = rows[i - 1].values[0];
        if (rows[i].values[0] > before) continue;
        refuse(file,
               rows[i].line,
               fmt::format(
                   "expected a time after {}, that of the row before, found {}", before, rows[i].values[0]));
    }
}

// Reads the file that a field of a table names; what is wrong goes to the faults.
class FileReader {
  public:
    FileReader(const TableFiles& files, FaultList& faults, std::vector<MeshRecord>& records)
        : files_(files), faults_(faults), records_(records) {}

    template <class Value>
    std::optional<Value> read(const TableHead& table,
                              const std::string& name,
                              Value (*parse)(std::string_view, const std::string&)) const {
        try {
            const std::string bytes = files_.read(name);
            Value value = parse(bytes, name);
            keep_file(name, bytes, records_);
            return value;
        } catch (const FileError& error) {
            faults_.add(table.place_of(&name), table.path_of(&name), error.what());
            return std::nullopt;
        }
    }

  private:
    const TableFiles& files_;
    FaultList& faults_;
    std::vector<MeshRecord>& records_;
};

}  // namespace

ElevationRecord read_elevations(std::string_view bytes, const std::string& file) {
    const auto rows = read_rows<2>(bytes, file);
    if (rows.size() < 2) {
        refuse(file,
               rows.empty() ? 1 : rows.front().line,
               "expected two rows of numbers or more, a time and a height");
    }
    check_rising(rows, file);
    const double start = rows.front().values[0];
    const double step = (rows.back().values[0] - start) / static_cast<double>(rows.size() - 1);
    ElevationRecord record{.start = start, .time_step = step, .elevations = {}};
    for (std::size_t i = 0; i < rows.size(); ++i) {
        const double time = rows[i].values[0];
        const double even = start + step * static_cast<double>(i);
        if (!(std::abs(time - even) <= uneven * step)) {
            refuse(file,
                   rows[i].line,
                   fmt::format("expected times in equal steps, here {:.9g}, found {}", even, time));
        }
        record.elevations.push_back(rows[i].values[1]);
    }
    return record;
}

GroundGrid read_ground_grid(std::string_view bytes, const std::string& file) {
    const auto rows = read_rows<3>(bytes, file);
    GroundGrid grid{.x = sorted_values(rows, 0), .y = sorted_values(rows, 1), .z = {}};
    if (grid.x.size() < 2 || grid.y.size() < 2) {
        refuse(
            file,
            rows.empty() ? 1 : rows.front().line,
            fmt::format("expected two x and two y or more, found {} and {}", grid.x.size(), grid.y.size()));
    }
    if (grid.x.size() * grid.y.size() > rows.size()) {
        refuse(file,
               rows.back().line,
               fmt::format("expected a row for each of {} x with each of {} y, found {} rows",
                           grid.x.size(),
                           grid.y.size(),
                           rows.size()));
    }
    constexpr double missing = std::numeric_limits<double>::quiet_NaN();
    grid.z.assign(grid.x.size() * grid.y.size(), missing);
    for (const auto& row : rows) {
        const auto& [x, y, z] = row.values;
        double& entry = grid.z[index_of(grid.x, x) + index_of(grid.y, y) * grid.x.size()];
        if (!std::isnan(entry)) refuse(file, row.line, fmt::format("x = {}, y = {} is there already", x, y));
        entry = z;
    }
    return grid;
}

SurroundingsFiles read_surroundings_files(const CheckedTable& deck,
                                          const TableFiles& files,
                                          FaultList& faults,
                                          std::vector<MeshRecord>& records) {
    const FileReader reader(files, faults, records);
    SurroundingsFiles all;
    std::size_t index = 0;
    for (const WaveTable& wave : tables_of<WaveTable>(deck, wave_table())) {
        if (wave.elevation) {
            auto record = reader.read(*wave.elevation, wave.elevation->file, read_elevations);
            if (record) all.waves.emplace(index, std::move(*record));
        }
        ++index;
    }
    for (const SeabedTable& seabed : tables_of<SeabedTable>(deck, seabed_table())) {
        if (seabed.grid) all.ground = reader.read(*seabed.grid, seabed.grid->file, read_ground_grid);
    }
    for (const VesselTable& vessel : tables_of<VesselTable>(deck, vessel_table())) {
        auto rows = reader.read(vessel, vessel.rao, read_raos);
        if (rows) all.vessels.emplace(vessel.name, std::move(*rows));
    }
    return all;
}

}  // namespace gxrod
