#include "results/file/ordered_file.hpp"

#include <fcntl.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <csignal>
#include <fstream>
#include <string_view>
#include <system_error>

#include "results/file/file_seal.hpp"
#include "results/sample.hpp"
#include "tools/catch.hpp"

using namespace gxrod;
using Part = OrderedFile::Part;

namespace {

int create(const std::filesystem::path& path) { return ::open(path.c_str(), O_RDWR | O_CREAT, 0600); }

// Places are counted from the end of the seal.
constexpr std::size_t begin = seal_block_bytes;

std::span<const std::byte> bytes(std::string_view text) { return std::as_bytes(std::span(text)); }

std::string read_part(const OrderedFile& file, std::uint64_t offset, std::size_t size) {
    std::string text(size, '?');
    file.read(begin + offset, std::as_writable_bytes(std::span(text)));
    return text;
}

std::string content(const std::filesystem::path& path) {
    std::ifstream stream(path, std::ios::binary);
    const std::string all{std::istreambuf_iterator<char>(stream), {}};
    return all.substr(std::min(begin, all.size()));
}

}  // namespace

TEST_CASE("An ordered file shows its writes at once and stores them at the commit", "[results]") {
    const sample::ScratchFolder folder;
    OrderedFile file(create(folder / "a"));
    file.write(Part::header, begin + 2, bytes("abcdef"));
    file.write(Part::data, begin + 4, bytes("XY"));
    file.set_size(begin + 10);
    CHECK(file.end() == begin + 8);
    CHECK(read_part(file, 0, 12) == std::string("\0\0abXYef\0\0\0\0", 12));
    CHECK(read_part(file, 5, 2) == "Ye");
    CHECK(content(folder / "a").empty());
    file.commit();
    CHECK(content(folder / "a") == std::string("\0\0abXYef\0\0", 10));
    CHECK(read_part(file, 0, 9) == std::string("\0\0abXYef\0", 9));
    file.write(Part::header, begin + 2, bytes("ABCDEF"));
    file.write(Part::header, begin + 2, bytes("ghijkl"));
    CHECK(read_part(file, 2, 6) == "ghijkl");
    file.set_size(begin + 6);
    file.commit();
    CHECK(content(folder / "a") == std::string("\0\0ghij", 6));
}

TEST_CASE("Data past what is committed are on disk at once, unless something is to be there", "[results]") {
    const sample::ScratchFolder folder;
    OrderedFile file(create(folder / "a"));
    file.write(Part::header, begin + 0, bytes("head"));
    file.set_size(begin + 6);
    file.commit();
    file.write(Part::data, begin + 4, bytes("ab"));
    CHECK(content(folder / "a") == std::string("head\0\0", 6));
    file.write(Part::data, begin + 6, bytes("cdef"));
    CHECK(content(folder / "a") == std::string("head\0\0cdef", 10));
    file.write(Part::header, begin + 12, bytes("ol"));
    file.write(Part::data, begin + 10, bytes("ghij"));
    CHECK(content(folder / "a").size() == 10);
    CHECK(read_part(file, 0, 14) == "headabcdefghij");
    CHECK(file.end() == begin + 14);
    file.set_size(begin + 14);
    file.commit();
    CHECK(content(folder / "a") == "headabcdefghij");
}

TEST_CASE("A commit that fails leaves what was there and can be tried again", "[results]") {
    const sample::ScratchFolder folder;
    OrderedFile file(create(folder / "a"));
    file.write(Part::superblock, begin + 0, bytes("S1"));
    file.write(Part::header, begin + 2, bytes("H1"));
    file.set_size(begin + 4);
    file.commit();
    file.write(Part::superblock, begin + 0, bytes("S2"));
    file.write(Part::header, begin + 2, bytes("H2"));
    file.set_size(begin + 10004);

    const pid_t child = ::fork();
    if (child == 0) {
        std::signal(SIGXFSZ, SIG_IGN);
        const rlimit limit{5000, RLIM_INFINITY};
        ::setrlimit(RLIMIT_FSIZE, &limit);
        file.write(Part::data, begin + 4, bytes(std::string(10000, 'd')));
        try {
            file.commit();
        } catch (const std::system_error& error) {
            if (error.code() != std::errc::file_too_large || content(folder / "a").substr(0, 4) != "S1H1")
                ::_exit(1);
            const rlimit none{RLIM_INFINITY, RLIM_INFINITY};
            ::setrlimit(RLIMIT_FSIZE, &none);
            file.commit();
            ::_exit(content(folder / "a") == "S2H2" + std::string(10000, 'd') ? 0 : 2);
        }
        ::_exit(3);
    }
    int status = 0;
    ::waitpid(child, &status, 0);
    REQUIRE(WIFEXITED(status));
    CHECK(WEXITSTATUS(status) == 0);
}
