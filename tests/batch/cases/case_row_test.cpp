#include "batch/cases/case_row.hpp"

#include <cmath>
#include <limits>

#include "machine/file_error.hpp"
#include "tools/catch.hpp"

namespace gxrod::test {
namespace {

BatchRecord two_by_two() {
    BatchRecord record;
    record.cases = 20;
    record.parameters = {"parameters.EI", "load[0].force"};
    record.columns = {{"peak", ""}, {"energy", ""}};
    return record;
}

CaseRow sample() {
    CaseRow row;
    row.number = 17;
    row.parameters = {"0.1", "[0, 0, 1]"};
    row.status = CaseStatus::time_limit;
    row.reason = "said \"no\", twice";
    row.collected = {1.0 / 3.0, std::numeric_limits<double>::quiet_NaN()};
    row.steps = 3;
    row.newton_iterations = 12;
    row.rejected_steps = 1;
    row.time = 0.25;
    row.seconds = 1.5;
    row.results = "cases/0017.vtkhdf";
    row.warning = "careful";
    return row;
}

CaseRow read_back(const std::string& line) {
    return read_case_row(read_csv(line + "\n", "i.csv").at(0), two_by_two(), "i.csv");
}

}  // namespace

TEST_CASE("A row of the table comes back to the last bit", "[batch]") {
    const CaseRow row = sample();
    const CaseRow back = read_back(write_case_row(row));
    CHECK(back.number == 17);
    CHECK(back.parameters == row.parameters);
    CHECK(back.status == row.status);
    CHECK(back.reason == row.reason);
    CHECK(back.collected[0] == row.collected[0]);
    CHECK(std::isnan(back.collected[1]));
    CHECK(back.steps == 3);
    CHECK(back.newton_iterations == 12);
    CHECK(back.rejected_steps == 1);
    CHECK(back.time == 0.25);
    CHECK(back.seconds == 1.5);
    CHECK(back.results == row.results);
    CHECK(back.warning == "careful");
    for (const CaseStatus status : case_statuses) {
        CaseRow other = row;
        other.status = status;
        CHECK(read_back(write_case_row(other)).status == status);
    }
}

TEST_CASE("Header and rows of the table have the same columns", "[batch]") {
    CHECK(write_case_header(two_by_two()) ==
          "case,parameters.EI,load[0].force,status,reason,peak,energy,steps,newton_iterations,rejected_steps,"
          "time,"
          "seconds,results,warning");
    CHECK(write_case_row(sample()) ==
          "17,0.1,\"[0, 0, 1]\",time limit,\"said \"\"no\"\", twice\",0.3333333333333333,nan,3,12,1,0.25,1.5,"
          "cases/0017.vtkhdf,careful");
}

TEST_CASE("A row is one line whatever its reason", "[batch]") {
    CaseRow row = sample();
    row.reason = "first\nsecond";
    CHECK(write_case_row(row).find('\n') == std::string::npos);
    CHECK(read_back(write_case_row(row)).reason == "first second");
}

TEST_CASE("A line that is not a row of the batch is an error with its place", "[batch]") {
    const std::string hint = " (take the line out, and the case is run again)";
    CHECK_THROWS_WITH(read_back("1,2"), "i.csv:1: no row of the batch: it has 2 fields, expected 14" + hint);
    CHECK_THROWS_WITH(read_back("21,a,b,done,,1,1,1,1,0,1,1,,"),
                      "i.csv:1: no row of the batch: there is no case 21; the batch has 20" + hint);
    CHECK_THROWS_WITH(read_back("2,a,b,dome,,1,1,1,1,0,1,1,,"),
                      "i.csv:1: no row of the batch: \"dome\" is no status of a case" + hint);
    CHECK_THROWS_WITH(read_back("2,a,b,done,,1,x,1,1,0,1,1,,"),
                      "i.csv:1: no row of the batch: \"x\" is not a number" + hint);
    CHECK_THROWS_WITH(read_back("2,a,b,done,,1,1,1.5,1,0,1,1,,"),
                      "i.csv:1: no row of the batch: \"1.5\" is not a number" + hint);
}

}  // namespace gxrod::test
