#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "batch/cases/case_list.hpp"
#include "batch/cases/case_row.hpp"
#include "model/problem.hpp"
#include "watch/history_watch.hpp"
#include "watch/members.hpp"

// Forces at the ends of members in combinations of load cases: of each case a file, of a batch two tables.
namespace gxrod {

// Returns whether the cases of a plan are combinations.
bool varies_combinations(const Plan& plan);

// Records the forces at the ends of all members; the last ones count.
class MemberForces {
  public:
    // Adds a history of each end to the problem, which must outlive the record.
    explicit MemberForces(Problem& problem);

    void add(const Snapshot& snapshot);
    // Writes a row for each end, with its place and N, Vy, Vz, T, My, Mz. Throws FileError.
    void write(const std::filesystem::path& file) const;

  private:
    struct End {
        HistoryWatch watch;
        HistoryRow force{}, moment{};
    };

    const Problem* problem_;
    std::vector<Member> members_;
    std::vector<End> ends_;  // two of each member
};

// Returns the path of a case's file, relative to the folder: "cases/0017.members.csv".
std::string member_path(long number, long cases);

// The largest and the least value of a force over combinations.
struct MemberExtreme {
    double value = 0.0;
    std::string combination, member, end;
};
struct MemberRange {
    std::string force;  // "N"
    MemberExtreme largest, least;
};

// Writes members.csv, a row for each end and combination, and envelope.csv, a row for each end and force.
// Returns the ranges over all members; empty if no case has its file. Throws FileError.
std::vector<MemberRange> write_member_tables(const std::filesystem::path& folder,
                                             const CaseList& cases,
                                             const std::vector<CaseRow>& rows);

}  // namespace gxrod
