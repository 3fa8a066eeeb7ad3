#include "batch/slurm/slurm_batch.hpp"

#include "tools/catch.hpp"

namespace gxrod::test {
namespace {

CaseRow make_row(long number, CaseStatus status) {
    CaseRow row;
    row.number = number;
    row.status = status;
    return row;
}

using Numbers = std::vector<long>;

}  // namespace

TEST_CASE("Cases that are not done are sorted by their holders and status", "[batch]") {
    const std::vector<CaseRow> rows{make_row(1, CaseStatus::done),
                                    make_row(3, CaseStatus::failed),
                                    make_row(4, CaseStatus::crashed),
                                    make_row(6, CaseStatus::time_limit),
                                    make_row(7, CaseStatus::done)};
    SlurmJob job;
    job.retried = {{4, 5}};
    const Remainder free = find_remainder(rows, 8, {}, {job});
    CHECK(free.missing == Numbers{2, 5, 8});
    CHECK(free.failed == Numbers{3, 6});
    CHECK(free.failed_again == Numbers{4});
    CHECK(free.taken == 0);
    const Remainder taken = find_remainder(rows, 8, {{1, 3}, {6, 8}}, {});
    CHECK(taken.missing == Numbers{5});
    CHECK(taken.failed == Numbers{4});
    CHECK(taken.failed_again.empty());
    CHECK(taken.taken == 4);
    CHECK_FALSE(taken.is_empty());
}

TEST_CASE("Nothing remains of a batch that is done", "[batch]") {
    CHECK(find_remainder({make_row(1, CaseStatus::done)}, 1, {{1, 1}}, {}).is_empty());
    CHECK_FALSE(find_remainder({}, 1, {{1, 1}}, {}).is_empty());
}

}  // namespace gxrod::test
