#include "batch/slurm/slurm_jobs.hpp"

#include <filesystem>

#include "batch/plans.hpp"
#include "machine/file_error.hpp"
#include "tools/catch.hpp"

namespace gxrod::test {
namespace {

const SlurmJob first{"17", "", "sweep-1.sbatch", "2024-05-17 09:30:00", {}, {{1, 10}, {11, 20}}, {}};
const SlurmJob second{"99",
                      "north",
                      "sweep-2.sbatch",
                      "2024-05-18 09:30:00",
                      {"-c", "8", "--comment=it's \"ü\"\n"},
                      {{3, 3}},
                      {{3, 3}, {5, 9}}};

}  // namespace

TEST_CASE("Jobs of a folder are as they were written", "[batch]") {
    const ScratchFolder folder;
    CHECK(read_slurm_jobs(folder.path()).empty());
    std::filesystem::create_directory(slurm_folder(folder.path()));
    write_slurm_jobs({}, folder.path());
    CHECK(read_slurm_jobs(folder.path()).empty());
    write_slurm_jobs({first, second}, folder.path());
    CHECK(read_slurm_jobs(folder.path()) == std::vector<SlurmJob>{first, second});
}

TEST_CASE("An invalid list of jobs is reported", "[batch]") {
    const ScratchFolder folder;
    std::filesystem::create_directory(slurm_folder(folder.path()));
    const std::filesystem::path file = folder.write("slurm/jobs.json", "{\"jobs\": [{\"id\": 17}]}");
    CHECK_THROWS_AS(read_slurm_jobs(folder.path()), FileError);
    CHECK_THROWS_WITH(read_slurm_jobs(folder.path()),
                      Catch::StartsWith(file.string() + ": is not a list of Slurm jobs: "));
}

TEST_CASE("The number of a job is read from what sbatch prints", "[batch]") {
    CHECK(read_submission("17\n").id == "17");
    CHECK(read_submission("17\n").cluster.empty());
    CHECK(read_submission("Welcome to the north\n17;north\n").id == "17");
    CHECK(read_submission("17;north\n").cluster == "north");
    CHECK(read_submission("").id.empty());
    CHECK(read_submission("Submitted batch job 17\n").id.empty());
}

TEST_CASE("Tasks are read from what squeue prints", "[batch]") {
    const std::vector<SlurmTask> tasks = read_squeue(
        "CLUSTER: north\n17|2|PENDING|Resources\n17|1|RUNNING|None\n18|1|RUNNING|None\n"
        "17|3|RUNNING|None\n17|N/A|RUNNING|None\n99|1|COMPLETING|\n",
        {first, second});
    REQUIRE(tasks.size() == 3);
    CHECK(tasks[0] == SlurmTask{"17", "PENDING", "Resources", {11, 20}});
    CHECK(tasks[1] == SlurmTask{"17", "RUNNING", "None", {1, 10}});
    CHECK(tasks[2] == SlurmTask{"99", "COMPLETING", "", {3, 3}});
}

}  // namespace gxrod::test
