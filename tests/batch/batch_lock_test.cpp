#include "batch/batch_lock.hpp"

#include <catch2/catch.hpp>

#include "batch/plans.hpp"
#include "model/file_error.hpp"

namespace gxrod::test {

TEST_CASE("Cases are locked one by one", "[batch]") {
    const ScratchFolder folder;
    const BatchLock first = BatchLock::of_cases(folder.path(), {1, 10});
    {
        const BatchLock second = BatchLock::of_cases(folder.path(), {11, 20});
        CHECK(BatchLock::is_running(folder.path(), {15, 30}));
        const std::string busy =
            folder.path().string() +
            ": another gxrod batch is running in it (-o takes another folder, --only other cases)";
        CHECK_THROWS_WITH(BatchLock::of_cases(folder.path(), {10, 10}), busy);
        CHECK_THROWS_WITH(BatchLock::of_cases(folder.path(), {1, 30}), busy);
    }
    CHECK_FALSE(BatchLock::is_running(folder.path(), {11, 20}));
    CHECK(BatchLock::is_running(folder.path(), {1, 1}));
    // The table is another matter.
    const BatchLock table = BatchLock::of_table(folder.path());
}

TEST_CASE("A folder that cannot be locked is told", "[batch]") {
    CHECK_THROWS_WITH(BatchLock::of_cases("/nowhere", {1, 2}),
                      "/nowhere/lock: cannot be written (No such file or directory)");
}

}  // namespace gxrod::test
