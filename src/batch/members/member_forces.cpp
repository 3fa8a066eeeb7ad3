#include "batch/members/member_forces.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <map>

#include "batch/batch_folder.hpp"
#include "batch/cases/case_run.hpp"
#include "deck/text/csv_reading.hpp"
#include "deck/text/text_file.hpp"
#include "machine/file_error.hpp"

namespace gxrod {
namespace {

constexpr std::array force_names{"N", "Vy", "Vz", "T", "My", "Mz"};
// Before the forces: member, end, x, y, z.
constexpr std::size_t place_columns = 5;
constexpr double most_file_bytes = 1e9;

const char* const case_header = "member,end,x,y,z,N,Vy,Vz,T,My,Mz\n";

}  // namespace

bool varies_combinations(const Plan& plan) {
    return std::ranges::find(plan.variations, "apply", &Variation::key) != plan.variations.end();
}

MemberForces::MemberForces(Problem& problem) : problem_(&problem), members_(list_members(problem.model)) {
    std::vector<HistoryRequest>& histories = problem.output.histories;
    const std::size_t first = histories.size();
    for (std::size_t i = 0; i < members_.size(); ++i) {
        for (std::size_t end = 0; end < 2; ++end) {
            // Histories of a deck have no dot in their names.
            const std::string name = fmt::format("member.{}.{}", i + 1, member_end_names[end]);
            histories.push_back({.name = name,
                                 .at = members_[i].name + " " + member_end_names[end],
                                 .target = WatchedPoint{members_[i].ends[end]},
                                 .quantities = {member_quantities.begin(), member_quantities.end()}});
        }
    }
    for (std::size_t i = first; i < histories.size(); ++i)
        ends_.push_back({HistoryWatch(problem.model, histories, i), {}, {}});
}

void MemberForces::add(const Snapshot& snapshot) {
    for (End& end : ends_) {
        end.force = end.watch.compute(member_quantities[0], snapshot);
        end.moment = end.watch.compute(member_quantities[1], snapshot);
    }
}

void MemberForces::write(const std::filesystem::path& file) const {
    std::string text = case_header;
    for (std::size_t i = 0; i < ends_.size(); ++i) {
        const Member& member = members_[i / 2];
        const Vec3& place = problem_->model.nodes[static_cast<std::size_t>(member.nodes[i % 2])].position;
        text += fmt::format("{},{},{},{},{}",
                            write_csv_field(member.name),
                            member_end_names[i % 2],
                            place[0],
                            place[1],
                            place[2]);
        for (std::size_t k = 0; k < 3; ++k) text += fmt::format(",{}", ends_[i].force[k]);
        for (std::size_t k = 0; k < 3; ++k) text += fmt::format(",{}", ends_[i].moment[k]);
        text += "\n";
    }
    replace_file(file, text);
}

std::string member_path(long number, long cases) {
    return std::filesystem::path(results_path(number, cases)).replace_extension(".members.csv").string();
}

namespace {

// The ranges of the forces at one end of a member.
struct EndRanges {
    std::vector<std::string> place;  // member, end, x, y, z
    std::array<MemberRange, force_names.size()> ranges;
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
        std::string text = "member,end,x,y,z,force,max,max_combination,min,min_combination\n";
        for (const EndRanges& end : ends_) {
            for (const MemberRange& range : end.ranges) {
                for (const std::string& field : end.place) text += write_csv_field(field) + ",";
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

    std::vector<MemberRange> find_whole() const {
        std::vector<MemberRange> whole;
        for (std::size_t k = 0; k < force_names.size() && !ends_.empty(); ++k) {
            whole.push_back(ends_.front().ranges[k]);
            for (const EndRanges& end : ends_) {
                widen_range(whole.back(), end.ranges[k].largest, false);
                widen_range(whole.back(), end.ranges[k].least, false);
            }
        }
        return whole;
    }

  private:
    void take(const std::string& combination, const std::vector<std::string>& fields) {
        const auto [found, is_new] = numbers_.emplace(fields[0] + " " + fields[1], ends_.size());
        if (is_new) ends_.push_back({{fields.begin(), fields.begin() + place_columns}, {}});
        EndRanges& end = ends_[found->second];
        for (std::size_t k = 0; k < force_names.size(); ++k) {
            end.ranges[k].force = force_names[k];
            widen_range(end.ranges[k],
                        {std::stod(fields[place_columns + k]), combination, fields[0], fields[1]},
                        is_new);
        }
    }

    std::string all_;
    std::vector<EndRanges> ends_;
    std::map<std::string, std::size_t> numbers_;  // of ends
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
    std::vector<MemberRange> whole = tables.find_whole();
    if (!whole.empty()) tables.write(folder);
    return whole;
}

}  // namespace gxrod
