#include "batch/program_output.hpp"

#include "tools/catch.hpp"

namespace gxrod::test {

TEST_CASE("What a program prints is kept, and how it ends", "[batch]") {
    const ProgramOutput done = run_program({"sh", "-c", "echo out; echo wrong >&2; exit 7"});
    CHECK(done.was_found);
    CHECK(done.exit_code == 7);
    CHECK(done.output == "out\n");
    CHECK(done.errors == "wrong\n");
    CHECK(run_program({"sh", "-c", "kill -9 $$"}).exit_code == 128 + 9);
}

TEST_CASE("No shell reads the words of a program", "[batch]") {
    CHECK(run_program({"printf", "%s|", "a b", "$HOME", "'`id`"}).output == "a b|$HOME|'`id`|");
}

TEST_CASE("A program that prints much does not wait for a reader", "[batch]") {
    CHECK(
        run_program({"sh", "-c", "head -c 1000000 /dev/zero; head -c 500000 /dev/zero >&2"}).output.size() ==
        1'000'000);
}

TEST_CASE("A program that reads finds nothing", "[batch]") { CHECK(run_program({"cat"}).output.empty()); }

TEST_CASE("A missing program is reported", "[batch]") {
    CHECK_FALSE(run_program({"gxrod-has-no-such-program"}).was_found);
}

}  // namespace gxrod::test
