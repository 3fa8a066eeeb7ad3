#include "deck/text/text_file.hpp"

#include <sys/stat.h>
#include <unistd.h>

#include <fstream>
#include <thread>

#include "machine/file_error.hpp"
#include "results/sample.hpp"
#include "tools/catch.hpp"

using namespace gxrod;
using Catch::EndsWith;
using Catch::StartsWith;

namespace {

// Ends the tests if what is done meanwhile does not come to an end.
struct TimeLimit {
    explicit TimeLimit(unsigned seconds) { ::alarm(seconds); }
    ~TimeLimit() { ::alarm(0); }
};

}  // namespace

TEST_CASE("What has no end is read up to a limit", "[deck]") {
    const TimeLimit limit(60);
    CHECK_THROWS_AS(read_text_file("/dev/zero"), FileError);
    CHECK_THROWS_WITH(read_text_file("/dev/zero"), "/dev/zero: has more than 100 MB, expected a file");
    CHECK_THROWS_WITH(read_text_file("/dev/zero", "a deck", 2'000'000),
                      "/dev/zero: has more than 2 MB, expected a deck");
    CHECK(read_text_file("/dev/null").empty());
}

TEST_CASE("A regular file can have as many bytes as the limit", "[deck]") {
    const sample::ScratchFolder folder;
    const std::string text(200'000, 'x');
    std::ofstream(folder / "file") << text;
    CHECK(read_text_file(folder / "file") == text);
    CHECK(read_text_file(folder / "file", "a deck", text.size()) == text);
    CHECK_THROWS_WITH(read_text_file(folder / "file", "a deck", text.size() - 1),
                      EndsWith("has more than 0 MB, expected a deck"));
}

TEST_CASE("A pipe is read as long as it has a writer", "[deck]") {
    const TimeLimit limit(60);
    const sample::ScratchFolder folder;
    const std::string path = (folder / "pipe").string();
    REQUIRE(::mkfifo(path.c_str(), 0600) == 0);
    CHECK_THROWS_WITH(read_text_file(path), path + ": is a pipe that nobody writes to");
    std::thread writer([&] {
        std::ofstream pipe(path);
        ::usleep(1'200'000);  // longer than a writer is waited for
        pipe << std::string(150'000, 'x') << std::flush;
        pipe << "end";
    });
    const std::string text = read_text_file(path);
    writer.join();
    CHECK(text.size() == 150'003);
    CHECK_THAT(text, StartsWith("xxx") && EndsWith("end"));
}
