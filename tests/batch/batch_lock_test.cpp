#include "batch/batch_lock.hpp"

#include "batch/plans.hpp"
#include "machine/file_error.hpp"
#include "tools/catch.hpp"

namespace gxrod::test {

TEST_CASE("Cases are locked one by one", "[batch]") {
    const ScratchFolder folder;
    const BatchLock first = BatchLock::of_cases(folder.path(), {1, 10});
    {
        const BatchLock second = BatchLock::of_cases(folder.path(), {11, 20});
        const std::string busy =
            folder.path().string() +
            ": another gxrod batch is running in it (-o takes another folder, --only other cases)";
        CHECK_THROWS_WITH(BatchLock::of_cases(folder.path(), {10, 10}), busy);
        CHECK_THROWS_WITH(BatchLock::of_cases(folder.path(), {1, 30}), busy);
    }
    const BatchLock third = BatchLock::of_cases(folder.path(), {11, 11});
    // The table is another matter.
    const BatchLock table = BatchLock::of_table(folder.path());
}

TEST_CASE("Cases that others run are listed", "[batch]") {
    const ScratchFolder folder;
    CHECK(BatchLock::list_running(folder.path(), {1, 100}).empty());
    const BatchLock late = BatchLock::of_cases(folder.path(), {90, 120});
    const BatchLock early = BatchLock::of_cases(folder.path(), {3, 3});
    const BatchLock middle = BatchLock::of_cases(folder.path(), {11, 20});
    const BatchLock table = BatchLock::of_table(folder.path());
    using Ranges = std::vector<CaseRange>;
    CHECK(BatchLock::list_running(folder.path(), {1, 100}) == Ranges{{3, 3}, {11, 20}, {90, 100}});
    CHECK(BatchLock::list_running(folder.path(), {15, 40}) == Ranges{{15, 20}});
    CHECK(BatchLock::list_running(folder.path(), {21, 89}).empty());
    CHECK(middle.list_running({1, 100}) == Ranges{{3, 3}, {90, 100}});
}

TEST_CASE("Only one submits cases at a time", "[batch]") {
    const ScratchFolder folder;
    {
        const BatchLock first = BatchLock::of_submission(folder.path());
        CHECK_THROWS_WITH(BatchLock::of_submission(folder.path()),
                          folder.path().string() +
                              ": another gxrod batch is submitting its cases (wait until it has ended)");
        // Tasks begin meanwhile.
        const BatchLock cases = BatchLock::of_cases(folder.path(), {1, 1'000'000});
        const BatchLock table = BatchLock::of_table(folder.path());
    }
    const BatchLock second = BatchLock::of_submission(folder.path());
}

TEST_CASE("A folder that cannot be locked is reported", "[batch]") {
    CHECK_THROWS_WITH(BatchLock::of_cases("/nowhere", {1, 2}),
                      "/nowhere/lock: cannot be written (No such file or directory)");
}

}  // namespace gxrod::test
