#include "results/file/output_file.hpp"

#include <sys/wait.h>
#include <unistd.h>

#include <fstream>

#include "machine/file_error.hpp"
#include "results/sample.hpp"
#include "tools/catch.hpp"

using namespace gxrod;
using Catch::Contains;
namespace fs = std::filesystem;

namespace {

void create(const fs::path& path, Existing existing) { ::close(create_output_file(path, existing)); }

std::string content(const fs::path& path) {
    std::ifstream stream(path);
    return {std::istreambuf_iterator<char>(stream), {}};
}

}  // namespace

TEST_CASE("A file that exists is refused or replaced", "[results]") {
    const sample::ScratchFolder folder;
    const fs::path path = folder / "a.vtkhdf";
    std::ofstream(path) << "old";
    CHECK_THROWS_AS(create(path, Existing::refuse), FileError);
    CHECK_THROWS_WITH(create(path, Existing::refuse),
                      Contains(path.string()) && Contains("exists already") && Contains("--force"));
    CHECK(content(path) == "old");
    create(path, Existing::replace);
    CHECK(content(path).empty());
}

TEST_CASE("Replacing a link replaces what it points to", "[results]") {
    const sample::ScratchFolder folder;
    std::ofstream(folder / "target") << "old";
    fs::create_symlink("target", folder / "link");
    create(folder / "link", Existing::replace);
    CHECK(fs::is_symlink(folder / "link"));
    CHECK(content(folder / "target").empty());
}

TEST_CASE("A file that could not be started is removed, and a link to it stays", "[results]") {
    const sample::ScratchFolder folder;
    std::ofstream(folder / "target") << "old";
    fs::create_symlink("target", folder / "link");
    create(folder / "link", Existing::replace);
    REQUIRE(fs::exists(folder / "target"));
    remove_output_file(folder / "link");
    CHECK(fs::is_symlink(folder / "link"));
    CHECK(!fs::exists(folder / "target"));
}

TEST_CASE("A folder or a device is not a results file", "[results]") {
    const sample::ScratchFolder folder;
    for (const Existing existing : {Existing::refuse, Existing::replace}) {
        CHECK_THROWS_WITH(create(folder.path(), existing), Contains("it is a directory"));
        CHECK_THROWS_AS(create(folder.path(), existing), FileError);
        CHECK_THROWS_WITH(create("/dev/full", existing), Contains("not a regular file"));
    }
    CHECK(fs::exists("/dev/full"));
}

TEST_CASE("A missing folder is named", "[results]") {
    const sample::ScratchFolder folder;
    CHECK_THROWS_WITH(create(folder / "none" / "a.vtkhdf", Existing::refuse),
                      Contains("the folder " + (folder / "none").string() + " does not exist"));
}

TEST_CASE("The message names a folder that is not writable", "[results]") {
    const sample::ScratchFolder folder;
    fs::permissions(folder.path(), fs::perms::owner_read | fs::perms::owner_exec | fs::perms::others_exec);
    // Root may write everywhere: try as nobody.
    const pid_t child = ::fork();
    if (child == 0) {
        if (::geteuid() == 0 && ::seteuid(65534) != 0) ::_exit(2);
        try {
            create(folder / "a.vtkhdf", Existing::refuse);
        } catch (const FileError& error) {
            ::_exit(std::string(error.what()).find("is not writable") != std::string::npos ? 0 : 3);
        }
        ::_exit(4);
    }
    int status = 0;
    ::waitpid(child, &status, 0);
    fs::permissions(folder.path(), fs::perms::owner_all);
    REQUIRE(WIFEXITED(status));
    CHECK(WEXITSTATUS(status) == 0);
}
