#include "batch/slurm/slurm_script.hpp"

#include "batch/program_output.hpp"
#include "machine/file_error.hpp"
#include "tools/catch.hpp"

namespace gxrod::test {
namespace {

SlurmScript make_script() {
    return {.name = "sweep",
            .program = "/opt/gxrod/bin/gxrod",
            .directory = "/shared/my work",
            .files = {"sweep.toml"},
            .folder = "/shared/my work/it's 5%",
            .slices = {{1, 10}, {11, 11}},
            .retry_failed = false};
}

}  // namespace

TEST_CASE("The script of an array job", "[batch]") {
    const std::string expected = R"script(#!/bin/bash
# Each task runs a slice of a batch; gxrod batch --slurm wrote this.
#SBATCH --job-name=sweep
#SBATCH --array=1-2
#SBATCH --output="/shared/my work/it's 5%%/slurm/%A_%a.out"
#SBATCH --open-mode=append

slices=(
  [1]=1..10
  [2]=11
)
slice=${slices[SLURM_ARRAY_TASK_ID]:?there is no such task}
echo "cases $slice on ${SLURMD_NODENAME:-$(hostname)}, $(date '+%F %T')"
cd '/shared/my work' || exit
exec /opt/gxrod/bin/gxrod batch sweep.toml \
  --output '/shared/my work/it'\''s 5%' \
  --only "$slice" --jobs "${SLURM_CPUS_PER_TASK:-1}"
)script";
    CHECK(write_slurm_script(make_script()) == expected);
}

TEST_CASE("The script of cases that failed runs these too", "[batch]") {
    SlurmScript script = make_script();
    script.retry_failed = true;
    CHECK_THAT(write_slurm_script(script), Catch::Contains("--only \"$slice\" --retry-failed --jobs"));
}

TEST_CASE("bash runs a task as it is meant", "[batch]") {
    SlurmScript script = make_script();
    script.program = "/bin/echo";
    script.directory = "/";
    script.files = {"a b.toml", "$HOME 'and' \"`id`\".toml"};
    const std::string text = write_slurm_script(script);
    const auto run = [&](const std::string& setting) {
        return run_program({"bash", "-c", "unset SLURM_CPUS_PER_TASK; " + setting + "\n" + text});
    };
    const std::string arguments =
        "batch a b.toml $HOME 'and' \"`id`\".toml --output /shared/my work/it's 5% --only ";
    CHECK_THAT(run("SLURM_ARRAY_TASK_ID=1").output, Catch::EndsWith(arguments + "1..10 --jobs 1\n"));
    CHECK_THAT(run("SLURM_ARRAY_TASK_ID=2; SLURM_CPUS_PER_TASK=8").output,
               Catch::EndsWith(arguments + "11 --jobs 8\n"));
    // Of an --array that the user set there may be tasks without a slice.
    const ProgramOutput none = run("SLURM_ARRAY_TASK_ID=3");
    CHECK(none.exit_code != 0);
    CHECK(none.output.empty());
    CHECK_THAT(none.errors, Catch::Contains("there is no such task"));
}

TEST_CASE("A folder that sbatch cannot name is refused", "[batch]") {
    SlurmScript script = make_script();
    script.folder = "/shared/a\\b";
    CHECK_THROWS_WITH(
        write_slurm_script(script),
        "/shared/a\\b: sbatch cannot write into a folder whose name has a line end, a \" or a \\ "
        "(-o takes another folder)");
    script.folder = "/shared/a\nb";
    CHECK_THROWS_AS(write_slurm_script(script), FileError);
}

TEST_CASE("Words for the shell", "[batch]") {
    CHECK(quote_for_shell("/usr/bin/gxrod-1.0_a") == "/usr/bin/gxrod-1.0_a");
    CHECK(quote_for_shell("--time=1:00:00") == "--time=1:00:00");
    CHECK(quote_for_shell("") == "''");
    CHECK(quote_for_shell("a b") == "'a b'");
    CHECK(quote_for_shell("it's") == "'it'\\''s'");
    CHECK(make_job_name("my sweep (2).v1-a_b") == "my_sweep__2_.v1-a_b");
}

TEST_CASE("The number of tasks suits cases and cores", "[batch]") {
    CHECK(choose_task_count(1, {}) == 1);
    CHECK(choose_task_count(40, {}) == 10);
    CHECK(choose_task_count(100'000, {}) == 100);
    for (const std::vector<std::string>& options : {std::vector<std::string>{"-c", "5"},
                                                    {"-p", "all", "-c5"},
                                                    {"--cpus-per-task=5"},
                                                    {"--cpus-per-task", "5", "--mem=4G"}}) {
        CAPTURE(options);
        CHECK(choose_task_count(40, options) == 2);
        CHECK(choose_task_count(3, options) == 1);
    }
    CHECK(choose_task_count(40, {"--cpus-per-task"}) == 10);
}

}  // namespace gxrod::test
