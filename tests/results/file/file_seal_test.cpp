#include "results/file/file_seal.hpp"

#include <fcntl.h>
#include <sys/resource.h>

#include <cstring>
#include <random>
#include <system_error>

#include "deck/text/text_file.hpp"
#include "machine/checksum.hpp"
#include "machine/file_error.hpp"
#include "results/file/guarded_reading.hpp"
#include "results/file/ordered_file.hpp"
#include "results/traced_writer.hpp"
#include "results/written_file.hpp"
#include "tools/catch.hpp"

using namespace gxrod;
using Part = OrderedFile::Part;

namespace {

constexpr std::size_t page = 4096;

// From all bytes at once: the checksum of the checksums of pages after the seal.
std::uint32_t sum_whole(const std::string& bytes) {
    std::uint32_t sum = 0;
    for (std::size_t at = seal_block_bytes; at < bytes.size(); at += page) {
        const std::string one = bytes.substr(at, page);
        const std::uint32_t of_page = checksum(std::span<const char>(one));
        sum = checksum(std::span<const std::uint32_t>(&of_page, 1), sum);
    }
    return sum;
}

std::string random_bytes(std::size_t count, std::mt19937& random) {
    std::string bytes(count, '\0');
    for (char& byte : bytes) byte = static_cast<char>(random());
    return bytes;
}

struct Descriptor {
    explicit Descriptor(const std::filesystem::path& path) : id(::open(path.c_str(), O_RDONLY)) {}
    ~Descriptor() { ::close(id); }
    Descriptor(const Descriptor&) = delete;
    Descriptor& operator=(const Descriptor&) = delete;
    int id;
};

FileSeal seal_in(const std::string& bytes) {
    SealBlock block{};
    std::memcpy(block.data(), bytes.data(), std::min(block.size(), bytes.size()));
    return read_seal(block).value_or(FileSeal{});
}

// Whether a file's seal is closed, and that of `count` bytes.
bool is_sealed(const std::filesystem::path& path, std::size_t count) {
    const std::string bytes = read_text_file(path);
    const FileSeal seal = seal_in(bytes);
    return !seal.is_open && seal.bytes == count && seal.sum == sum_whole(bytes.substr(0, count)) &&
           look_at_seal(path) == SealState::kept;
}

int create(const std::filesystem::path& path) { return ::open(path.c_str(), O_RDWR | O_CREAT, 0600); }

void write(OrderedFile& file, Part part, std::uint64_t at, const std::string& text) {
    file.write(part, at, std::as_bytes(std::span(text)));
}

// Whether it is refused, with FileError.
template <class Action>
bool is_refused(Action&& action) {
    try {
        action();
        return false;
    } catch (const FileError&) {
        return true;
    }
}

}  // namespace

TEST_CASE("A seal is read as it was written, and is invalid with any other bit", "[results]") {
    for (const FileSeal& seal : {FileSeal{}, FileSeal{false, 123456789012, 0xdeadbeef}}) {
        const SealBlock block = write_seal(seal);
        const std::optional<FileSeal> read = read_seal(block);
        REQUIRE(read);
        CHECK(read->is_open == seal.is_open);
        CHECK(read->bytes == seal.bytes);
        CHECK(read->sum == seal.sum);
        int unread = 0;
        for (std::size_t bit = 0; bit < 8 * block.size(); ++bit) {
            SealBlock changed = block;
            changed[bit / 8] ^= std::byte{1} << bit % 8;
            const std::optional<FileSeal> other = read_seal(changed);
            if (!other) ++unread;
            CHECK((!other || (other->is_open == seal.is_open &&
                              (other->bytes != seal.bytes || other->sum != seal.sum))));
        }
        CHECK(unread == 8 * static_cast<int>(block.size()) - 96);
    }
    CHECK(!read_seal(SealBlock{}));
}

TEST_CASE("The checksum of a file that changes is that of its bytes as they are", "[results]") {
    const sample::ScratchFolder folder;
    std::mt19937 random(1);
    PageSums sums;
    std::string bytes;
    for (int change = 0; change < 180; ++change) {
        if (change % 3 == 0) {
            // Longer or shorter, by parts of pages or many, up to more than are read at once.
            const std::size_t most = change == 30 ? 100 * page : 5 * page;
            bytes.resize(seal_block_bytes + random() % most, 'x');
        } else {
            const std::size_t at = random() % bytes.size();
            const std::size_t count = std::min(bytes.size() - at, random() % (2 * page));
            bytes.replace(at, count, random_bytes(count, random));
            sums.mark_changed(at, count);
        }
        sample::write_bytes(folder / "a", bytes);
        const Descriptor file(folder / "a");
        REQUIRE(sums.compute(file.id, bytes.size()) == sum_whole(bytes));
    }
    const Descriptor file(folder / "a");
    CHECK_THROWS_AS(sums.compute(file.id, bytes.size() + 1), std::system_error);
}

TEST_CASE("A commit opens an ordered file's seal, and sealing closes it", "[results]") {
    const sample::ScratchFolder folder;
    const auto path = folder / "a";
    OrderedFile file(create(path));
    write(file, Part::data, 600, std::string(5000, 'a'));
    CHECK(look_at_seal(path) == SealState::missing);
    file.set_size(6000);
    file.commit();
    CHECK(look_at_seal(path) == SealState::open);
    file.seal();
    CHECK(is_sealed(path, 6000));
    write(file, Part::header, 4990, "header");
    CHECK(is_sealed(path, 6000));  // nothing is on disk yet
    file.commit();
    CHECK(look_at_seal(path) == SealState::open);
    file.commit();
    file.seal();
    CHECK(is_sealed(path, 6000));
    // Data beyond what is committed go to the disk at once.
    write(file, Part::data, 7000, std::string(9000, 'b'));
    CHECK(read_text_file(path).size() == 16000);
    CHECK(is_sealed(path, 6000));
    file.set_size(20000);
    file.commit();
    file.seal();
    CHECK(is_sealed(path, 20000));
    file.set_size(9000);
    file.commit(OrderedFile::Order::shrinking);
    file.seal();
    CHECK(read_text_file(path).size() == 9000);
    CHECK(is_sealed(path, 9000));
    std::filesystem::resize_file(path, 8999);
    CHECK(look_at_seal(path) == SealState::violated);
    file.abandon();
    CHECK_THROWS_AS(file.seal(), std::bad_alloc);
}

TEST_CASE("Bytes that were cut off and rewritten between two seals count", "[results]") {
    const sample::ScratchFolder folder;
    const auto path = folder / "a";
    OrderedFile file(create(path));
    write(file, Part::data, seal_block_bytes, std::string(20000, 'a'));
    file.set_size(20000);
    file.commit();
    file.seal();
    file.set_size(5000);
    file.commit(OrderedFile::Order::shrinking);
    write(file, Part::data, 6000, std::string(9000, 'b'));
    file.set_size(20000);
    file.commit();
    file.seal();
    CHECK(is_sealed(path, 20000));
}

TEST_CASE("What a commit that failed has written counts for the seal", "[results]") {
    const sample::ScratchFolder folder;
    const auto path = folder / "a";
    OrderedFile file(create(path));
    write(file, Part::data, seal_block_bytes, std::string(30000, 'a'));
    file.set_size(30000);
    file.commit();
    file.seal();
    const auto fails_first = [&] {
        std::signal(SIGXFSZ, SIG_IGN);
        const rlimit limit{20000, RLIM_INFINITY}, none{RLIM_INFINITY, RLIM_INFINITY};
        ::setrlimit(RLIMIT_FSIZE, &limit);
        write(file, Part::header, 1000, std::string(9000, 'b'));
        write(file, Part::header, 19990, std::string(100, 'c'));
        try {
            file.commit();
            return false;
        } catch (const std::system_error&) {
            ::setrlimit(RLIMIT_FSIZE, &none);
        }
        const bool is_half_written = read_text_file(path)[9000] == 'b';
        write(file, Part::header, 1000, "short");
        file.commit();
        file.seal();
        return is_half_written && is_sealed(path, 30000);
    };
    const int status = test::wait_for(test::run_child([&] { return fails_first() ? 0 : 1; }));
    CHECK(WIFEXITED(status));
    CHECK(WEXITSTATUS(status) == 0);
}

TEST_CASE("A results file is sealed from its start to its end", "[results]") {
    const sample::ScratchFolder folder;
    const auto path = folder / "a.vtkhdf";
    const Model model = sample::make_model();
    const auto is_whole = [&] { return is_sealed(path, seal_in(read_text_file(path)).bytes); };
    {
        ResultsFile file({path}, sample::make_deck_with_mesh(), model, sample::make_output());
        CHECK(is_whole());
        for (int step = 0; step < 5; ++step) {
            sample::write_steps(file, step, 1);
            CHECK(is_whole());
        }
        file.close(RunStatus::interrupted, "Ctrl-C");
    }
    CHECK(is_sealed(path, std::filesystem::file_size(path)));
    {
        ResultsFile file(sample::make_deck_with_mesh(), model, sample::make_output(), ResumableFile(path));
        CHECK(is_whole());
        sample::write_steps(file, 5, 2);
        CHECK(is_whole());
    }
    CHECK(is_sealed(path, std::filesystem::file_size(path)));
}

TEST_CASE("A run resumes from a file whose seal is open, and closes it", "[results][resume]") {
    const sample::ScratchFolder folder;
    const auto path = folder / "a.vtkhdf";
    const Model model = sample::make_model();
    {
        ResultsFile file({path}, sample::make_deck(), model, sample::make_output());
        sample::write_steps(file, 0, 5);
    }
    sample::open_seal(path);
    CHECK(GuardedReading(path).doubt() ==
          "its run was stopped while it wrote, so that changes to it would not be noticed");
    {
        ResultsFile file(sample::make_deck(), model, sample::make_output(), ResumableFile(path));
        CHECK(look_at_seal(path) == SealState::kept);
        CHECK(GuardedReading(path).doubt().empty());
    }
    CHECK(look_at_seal(path) == SealState::kept);
    CHECK(GuardedReading(path).doubt().empty());
}

TEST_CASE("Any changed bit of a sealed file is reported, and no run resumes from it", "[results][resume]") {
    const sample::ScratchFolder folder;
    const auto path = folder / "a.vtkhdf";
    const Model model = sample::make_model();
    {
        ResultsFile file({path}, sample::make_deck_with_mesh(), model, sample::make_output());
        sample::write_steps(file, 0, 5);
        file.close(RunStatus::complete, "");
    }
    const std::string sound = read_text_file(path);
    std::vector<std::size_t> bits;
    for (std::size_t bit = 0; bit < 8 * 32; bit += 3) bits.push_back(bit);  // of the seal
    std::mt19937 random(3);
    for (int i = 0; i < 200; ++i) bits.push_back(random() % (8 * sound.size()));
    for (const std::size_t bit : bits) {
        INFO("bit " << bit << " of " << 8 * sound.size());
        std::string changed = sound;
        changed[bit / 8] = static_cast<char>(changed[bit / 8] ^ (1 << bit % 8));
        sample::write_bytes(path, changed);
        CHECK(!GuardedReading(path).doubt().empty());
        CHECK(is_refused([&] { const ResumableFile file(path); }));
        CHECK(read_text_file(path) == changed);
    }
    sample::write_bytes(path, sound);
    CHECK(GuardedReading(path).doubt().empty());
    CHECK_NOTHROW(ResumableFile(path));
}

TEST_CASE("What breaks down over a file that is not trusted ends that alone", "[results]") {
    const sample::ScratchFolder folder;
    const auto path = folder / "a";
    sample::write_bytes(path, "of another program");
    const GuardedReading reading(path);
    CHECK(reading.doubt() == "it has no seal of gxrod, so that changes to it would not be noticed");
    CHECK(reading.read([] { return std::string("done"); }) == "done");
    CHECK_THROWS_WITH(reading.read([]() -> std::string { throw FileError("b", "cannot be written"); }),
                      "b: cannot be written");
    CHECK_THROWS_WITH(reading.read([]() -> std::string { throw std::bad_alloc(); }),
                      Catch::Contains("cannot be read: there is not enough memory"));
    const auto break_down = []() -> std::string {
        std::signal(SIGSEGV, SIG_DFL);
        std::raise(SIGSEGV);
        return "";
    };
    CHECK_THROWS_WITH(reading.read(break_down),
                      Catch::Contains("is damaged: where HDF5's library reads it, it breaks down"));
}
