#include "batch/members/member_forces.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>

#include "batch/batch_folder.hpp"
#include "batch/cases/case_run.hpp"
#include "batch/members/member_stations.hpp"
#include "deck/text/csv_reading.hpp"
#include "deck/text/text_file.hpp"
#include "machine/file_error.hpp"

namespace gxrod {
namespace {

constexpr std::array force_names{"N", "Vy", "Vz", "T", "My", "Mz"};
// Before the forces: member, station, s, x, y, z.
constexpr std::size_t place_columns = 6;
constexpr double most_file_bytes = 1e9;

const char* const case_header = "member,station,s,x,y,z,N,Vy,Vz,T,My,Mz\n";

}  // namespace

bool varies_combinations(const Plan& plan) {
    return std::ranges::find(plan.variations, "apply", &Variation::key) != plan.variations.end();
}

void write_member_forces(const SteppedRun& run, const std::filesystem::path& file) {
    std::string text = case_header;
    for (const Member& member : list_members(run.problem().model)) {
        for (const StationForces& one : find_station_forces(member, run)) {
            text += fmt::format("{},{},{}", write_csv_field(member.name), one.station, one.s);
            for (const double x : one.position) text += fmt::format(",{}", x);
            for (const double force : one.forces) text += fmt::format(",{}", force);
            text += "\n";
        }
    }
    replace_file(file, text);
}

std::string member_path(long number, long cases) {
    return std::filesystem::path(results_path(number, cases)).replace_extension(".members.csv").string();
}

namespace {

// The ranges of the forces at one station of a member.
struct StationRanges {
    std::vector<std::string> place;  // as columns have it
    std::vector<MemberRange> ranges;
};

void widen_range(MemberRange& range, const MemberExtreme& extreme, bool is_first) {
    if (is_first || extreme.value > range.largest.value) range.largest = extreme;
    if (is_first || extreme.value < range.least.value) range.least = extreme;
}

class MemberTables {
  public:
    MemberTables() : all_("combination," + std::string(case_header)) {}

    void add(const std::string& combination, const std::filesystem::path& file) {
        const std::vector<CsvRow> rows =
            read_csv(read_text_file(file, "a table of members", most_file_bytes), file);
        for (std::size_t i = 1; i < rows.size(); ++i) {
            const std::vector<std::string>& fields = rows[i].fields;
            if (fields.size() != place_columns + force_names.size())
                throw FileError(file, fmt::format("line {} is not a row of members", rows[i].line));
            all_ += write_csv_field(combination);
            for (const std::string& field : fields) all_ += "," + write_csv_field(field);
            all_ += "\n";
            take(combination, fields);
        }
    }

    void write(const std::filesystem::path& folder) const {
        replace_file(folder / "members.csv", all_);
        std::string text = "member,station,s,x,y,z,force,max,max_combination,min,min_combination\n";
        for (const StationRanges& station : stations_) {
            for (const MemberRange& range : station.ranges) {
                for (const std::string& field : station.place) text += write_csv_field(field) + ",";
                text += fmt::format("{},{},{},{},{}\n",
                                    range.force,
                                    range.largest.value,
                                    write_csv_field(range.largest.combination),
                                    range.least.value,
                                    write_csv_field(range.least.combination));
            }
        }
        replace_file(folder / "envelope.csv", text);
    }

    const std::vector<MemberRange>& whole() const { return whole_; }

  private:
    void take(const std::string& combination, const std::vector<std::string>& fields) {
        std::vector<double> forces;
        for (std::size_t k = 0; k < force_names.size(); ++k)
            forces.push_back(std::stod(fields[place_columns + k]));
        const auto widen =
            [&](std::vector<MemberRange>& ranges, std::size_t k, const char* name, double value) {
                const bool is_first = ranges.size() <= k;
                if (is_first) ranges.push_back({name, {}, {}});
                widen_range(ranges[k], {value, combination, fields[0], fields[1]}, is_first);
            };
        for (std::size_t k = 0; k < force_names.size(); ++k) widen(whole_, k, force_names[k], forces[k]);
        const auto [found, is_new] = numbers_.emplace(fields[0] + " " + fields[1], stations_.size());
        if (is_new) stations_.push_back({{fields.begin(), fields.begin() + place_columns}, {}});
        StationRanges& station = stations_[found->second];
        if (fields[1] != station_words.back()) {
            for (std::size_t k = 0; k < force_names.size(); ++k)
                widen(station.ranges, k, force_names[k], forces[k]);
            return;
        }
        widen(station.ranges, 0, "|M|", std::hypot(forces[4], forces[5]));
        // Its place differs from one combination to the other.
        if (station.ranges[0].largest.combination == combination)
            station.place.assign(fields.begin(), fields.begin() + place_columns);
    }

    std::string all_;
    std::vector<StationRanges> stations_;
    std::map<std::string, std::size_t> numbers_;  // of stations
    std::vector<MemberRange> whole_;              // over all stations
};

}  // namespace

std::vector<MemberRange> write_member_tables(const std::filesystem::path& folder,
                                             const CaseList& cases,
                                             const std::vector<CaseRow>& rows) {
    MemberTables tables;
    for (const CaseRow& row : rows) {
        const std::filesystem::path file = folder / member_path(row.number, cases.count());
        if (row.status != CaseStatus::done || !std::filesystem::exists(file)) continue;
        tables.add(fmt::format("{}", fmt::join(row.parameters, " ")), file);
    }
    if (!tables.whole().empty()) tables.write(folder);
    return tables.whole();
}

}  // namespace gxrod
