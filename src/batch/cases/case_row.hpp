#pragma once

#include <array>
#include <string>
#include <string_view>
#include <vector>

#include "batch/batch_record.hpp"
#include "deck/text/csv_reading.hpp"

namespace gxrod {

enum class CaseStatus { done, failed, time_limit, out_of_memory, crashed, deck_fault };
inline constexpr std::array case_statuses{CaseStatus::done,
                                          CaseStatus::failed,
                                          CaseStatus::time_limit,
                                          CaseStatus::out_of_memory,
                                          CaseStatus::crashed,
                                          CaseStatus::deck_fault};

// Returns the word of tables, for example "done" or "time limit".
const char* name_of(CaseStatus status);

// The outcome of one case.
struct CaseRow {
    long number = 0;
    std::vector<std::string> parameters;  // values of BatchRecord::parameters
    CaseStatus status = CaseStatus::done;
    std::string reason;             // "" if it is done
    std::vector<double> collected;  // values of BatchRecord::columns; NaN for none
    long steps = 0;
    long newton_iterations = 0;
    long rejected_steps = 0;
    double time = 0.0;     // reached
    double seconds = 0.0;  // wall time
    std::string results;   // relative to the folder; "" if they were not kept
    std::string warning;
};

// Returns the first line of the table, without its line end.
std::string write_case_header(const BatchRecord& record);
// Returns a row of the table, without its line end. Numbers have all of their digits.
std::string write_case_row(const CaseRow& row);
// Reads a row. Throws FileError, which names the file and the line, if the row does not belong to this batch.
CaseRow read_case_row(const CsvRow& row, const BatchRecord& record, const std::filesystem::path& file);

}  // namespace gxrod
