#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "batch/cases/case_list.hpp"
#include "batch/cases/case_row.hpp"
#include "run/stepped_run.hpp"

// Forces at stations of members in combinations of load cases: of each case a file, of a batch two tables.
namespace gxrod {

// Returns whether the cases of a plan are combinations.
bool varies_combinations(const Plan& plan);

// Writes a row for each station of each member, with its place and N, Vy, Vz, T, My, Mz, at the last accepted
// state of a run. Throws FileError.
void write_member_forces(const SteppedRun& run, const std::filesystem::path& file);

// Returns the path of a case's file, relative to the folder: "cases/0017.members.csv".
std::string member_path(long number, long cases);

// The largest and the least value of a force over combinations.
struct MemberExtreme {
    double value = 0.0;
    std::string combination, member, station;
};
struct MemberRange {
    std::string force;  // "N"
    MemberExtreme largest, least;
};

// Writes members.csv, a row for each station and combination, and envelope.csv, a row for each station and
// force; of the largest moment of each member a row with its place in the combination that governs.
// Returns the ranges over all members; empty if no case has its file. Throws FileError.
std::vector<MemberRange> write_member_tables(const std::filesystem::path& folder,
                                             const CaseList& cases,
                                             const std::vector<CaseRow>& rows);

}  // namespace gxrod
