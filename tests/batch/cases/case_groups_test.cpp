#include "batch/cases/case_groups.hpp"

#include "tools/catch.hpp"

namespace gxrod::test {
namespace {

CaseRow failed(long number, const std::string& reason, CaseStatus status = CaseStatus::failed) {
    CaseRow row;
    row.number = number;
    row.status = status;
    row.reason = reason;
    return row;
}

}  // namespace

TEST_CASE("Failures that differ in numbers only are one group, the largest first", "[batch]") {
    CaseRow warned;
    warned.number = 9;
    warned.warning = "careful: 3";
    const std::vector<CaseRow> rows{failed(1, "lost at t = 0.25"),
                                    failed(2, "did not converge at t = 1.5e-3, node 12"),
                                    failed(3, "did not converge at t = 2, node 7"),
                                    failed(4, "did not converge at t = -0.5, node 7"),
                                    failed(5, "lost at t = 4", CaseStatus::time_limit),
                                    warned};
    const std::vector<CaseGroup> groups = group_failures(rows);
    REQUIRE(groups.size() == 3);
    CHECK(groups[0].numbers == std::vector<long>{2, 3, 4});
    CHECK(groups[0].text == "did not converge at t = 1.5e-3, node 12");
    CHECK(groups[1].numbers == std::vector<long>{1});
    CHECK(groups[2].status == CaseStatus::time_limit);
    const std::vector<CaseGroup> warnings = group_warnings(rows);
    REQUIRE(warnings.size() == 1);
    CHECK(warnings[0].numbers == std::vector<long>{9});
    CHECK(group_failures({}).empty());
}

}  // namespace gxrod::test
