#include "results/file_seal.hpp"

#include <fcntl.h>
#include <sys/resource.h>

#include <fstream>
#include <random>
#include <system_error>

#include "deck/reading/text_file.hpp"
#include "machine/checksum.hpp"
#include "machine/file_error.hpp"
#include "results/traced_writer.hpp"
#include "results/written_file.hpp"
#include "tools/catch.hpp"
#include "tools/let_hdf5_leak.hpp"

using namespace gxrod;
using Part = OrderedFile::Part;

namespace {

constexpr std::size_t page = 4096;

// From all bytes at once: the checksum of the checksums of pages, after that of the size.
std::uint32_t sum_whole(std::string bytes, std::size_t left_out) {
    for (std::size_t at = left_out; at < std::min(left_out + 8, bytes.size()); ++at) bytes[at] = '\0';
    const std::uint64_t size = bytes.size();
    std::uint32_t sum = checksum(std::span<const std::uint64_t>(&size, 1));
    for (std::size_t at = 0; at < bytes.size(); at += page) {
        const std::string one = bytes.substr(at, page);
        const std::uint32_t of_page = checksum(std::span<const char>(one));
        sum = checksum(std::span<const std::uint32_t>(&of_page, 1), sum);
    }
    return sum;
}

void write_file(const std::filesystem::path& path, const std::string& bytes) {
    std::ofstream(path, std::ios::binary) << bytes;
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

std::int64_t number_at(const std::filesystem::path& path, std::size_t place) {
    std::int64_t number = 0;
    std::ifstream file(path, std::ios::binary);
    file.seekg(static_cast<std::streamoff>(place));
    file.read(reinterpret_cast<char*>(&number), sizeof(number));
    return number;
}

int create(const std::filesystem::path& path) { return ::open(path.c_str(), O_RDWR | O_CREAT, 0600); }

void write(OrderedFile& file, Part part, std::uint64_t at, const std::string& text) {
    file.write(part, at, std::as_bytes(std::span(text)));
}

SealState seal_of(const std::filesystem::path& path) { return look_at_seal(Hdf5Reader(path)); }

std::uint64_t find_seal_of(const std::filesystem::path& path) {
    const Hdf5Reader file(path);
    return find_seal(Hdf5Handle(H5Gopen2(file.id(), "restart", H5P_DEFAULT), H5Gclose, "opening"));
}

}  // namespace

TEST_CASE("The checksum of a file that changes is that of its bytes as they are", "[results]") {
    const sample::ScratchFolder folder;
    std::mt19937 random(1);
    for (const std::size_t left_out : {std::size_t{0}, page - 4, 3 * page + 17}) {
        PageSums sums(left_out);
        std::string bytes;
        for (int change = 0; change < 60; ++change) {
            if (change % 3 == 0) {
                // Longer or shorter, by parts of pages or many, up to more than are read at once.
                const std::size_t most = change == 30 ? 100 * page : 5 * page;
                bytes.resize(random() % most, 'x');
            } else if (!bytes.empty()) {
                const std::size_t at = random() % bytes.size();
                const std::size_t count = std::min(bytes.size() - at, random() % (2 * page));
                bytes.replace(at, count, random_bytes(count, random));
                sums.mark_changed(at, count);
            }
            write_file(folder / "a", bytes);
            const Descriptor file(folder / "a");
            REQUIRE(sums.compute(file.id, bytes.size()) == sum_whole(bytes, left_out));
        }
        const Descriptor file(folder / "a");
        CHECK_THROWS_AS(sums.compute(file.id, bytes.size() + 1), std::system_error);
    }
}

TEST_CASE("A commit breaks an ordered file's seal, and sealing it makes it whole", "[results]") {
    const sample::ScratchFolder folder;
    const auto path = folder / "a";
    OrderedFile file(create(path));
    const auto is_whole = [&] {
        return number_at(path, 16) == sum_whole(read_text_file(path), 16) && number_at(path, 16) != 0;
    };
    write(file, Part::data, 0, std::string(5000, 'a'));
    file.set_size(6000);
    file.commit();
    file.keep_seal(16);
    file.seal();
    CHECK(is_whole());
    write(file, Part::header, 4990, "header");
    CHECK(is_whole());  // nothing is on disk yet
    file.commit();
    CHECK(number_at(path, 16) == broken_seal);
    file.commit();
    file.seal();
    CHECK(is_whole());
    // Data beyond what is committed go to the disk at once.
    write(file, Part::data, 7000, std::string(9000, 'b'));
    CHECK(read_text_file(path).size() == 16000);
    CHECK(number_at(path, 16) == sum_whole(read_text_file(path).substr(0, 6000), 16));
    file.set_size(20000);
    file.commit();
    file.seal();
    CHECK(is_whole());
    file.set_size(9000);
    file.commit(OrderedFile::Order::shrinking);
    file.seal();
    CHECK(read_text_file(path).size() == 9000);
    CHECK(is_whole());
    file.abandon();
    CHECK_THROWS_AS(file.seal(), std::bad_alloc);
}

TEST_CASE("Bytes that were cut off and written anew between two seals count", "[results]") {
    const sample::ScratchFolder folder;
    const auto path = folder / "a";
    OrderedFile file(create(path));
    write(file, Part::data, 0, std::string(20000, 'a'));
    file.set_size(20000);
    file.commit();
    file.keep_seal(16);
    file.seal();
    file.set_size(5000);
    file.commit(OrderedFile::Order::shrinking);
    write(file, Part::data, 6000, std::string(9000, 'b'));
    file.set_size(20000);
    file.commit();
    file.seal();
    CHECK(number_at(path, 16) == sum_whole(read_text_file(path), 16));
}

TEST_CASE("What a commit that failed has written counts for the seal", "[results]") {
    const sample::ScratchFolder folder;
    const auto path = folder / "a";
    OrderedFile file(create(path));
    write(file, Part::data, 0, std::string(30000, 'a'));
    file.set_size(30000);
    file.commit();
    file.keep_seal(16);
    file.seal();
    const auto fails_first = [&] {
        std::signal(SIGXFSZ, SIG_IGN);
        const rlimit limit{20000, RLIM_INFINITY}, none{RLIM_INFINITY, RLIM_INFINITY};
        ::setrlimit(RLIMIT_FSIZE, &limit);
        write(file, Part::header, 100, std::string(9000, 'b'));
        write(file, Part::header, 19990, std::string(100, 'c'));
        try {
            file.commit();
            return false;
        } catch (const std::system_error&) {
            ::setrlimit(RLIMIT_FSIZE, &none);
        }
        const bool is_half_written = read_text_file(path)[9000] == 'b';
        write(file, Part::header, 100, "short");
        file.commit();
        file.seal();
        return is_half_written && number_at(path, 16) == sum_whole(read_text_file(path), 16);
    };
    const int status = test::wait_for(test::run_child([&] { return fails_first() ? 0 : 1; }));
    CHECK(WIFEXITED(status));
    CHECK(WEXITSTATUS(status) == 0);
}

TEST_CASE("A results file is sealed from its start to its end", "[results]") {
    const sample::ScratchFolder folder;
    const auto path = folder / "a.vtkhdf";
    const Model model = sample::make_model();
    {
        ResultsFile file({path}, sample::make_deck_with_mesh(), model, sample::make_output());
        CHECK(seal_of(path) == SealState::kept);
        for (int step = 0; step < 5; ++step) {
            sample::write_steps(file, step, 1);
            CHECK(seal_of(path) == SealState::kept);
        }
        file.close(RunStatus::interrupted, "Ctrl-C");
    }
    CHECK(seal_of(path) == SealState::kept);
    const std::uint64_t place = find_seal_of(path);
    CHECK(number_at(path, place) == sum_whole(read_text_file(path), place));
    {
        ResultsFile file(sample::make_deck_with_mesh(), model, sample::make_output(), ResumableFile(path));
        CHECK(seal_of(path) == SealState::kept);
        sample::write_steps(file, 5, 2);
        CHECK(seal_of(path) == SealState::kept);
    }
    CHECK(seal_of(path) == SealState::kept);
    CHECK(find_seal_of(path) == place);
}

TEST_CASE("A run goes on from a file whose seal is broken, and seals it", "[results][resume]") {
    const sample::WrittenFile written;
    CHECK(seal_of(written.path) == SealState::broken);
    CHECK(written.changes().empty());
    {
        ResultsFile file(
            sample::make_deck_with_mesh(), written.model, sample::make_output(), ResumableFile(written.path));
        CHECK(seal_of(written.path) == SealState::kept);
    }
    CHECK(seal_of(written.path) == SealState::kept);
}

TEST_CASE("Any changed bit of a sealed file is told, and no run goes on from it", "[results][resume]") {
    const test::LetHdf5Leak leaks;
    const sample::ScratchFolder folder;
    const auto path = folder / "a.vtkhdf";
    const Model model = sample::make_model();
    {
        ResultsFile file({path}, sample::make_deck_with_mesh(), model, sample::make_output());
        sample::write_steps(file, 0, 5);
        file.close(RunStatus::complete, "");
    }
    const std::string sound = read_text_file(path);
    const std::uint64_t seal = find_seal_of(path);
    std::vector<std::size_t> bits;
    for (std::size_t bit = 0; bit < 64; bit += 7) bits.push_back(8 * seal + bit);
    // Most are rooms between rows and in headers that nothing else looks at.
    std::mt19937 random(3);
    for (int i = 0; i < 70; ++i) bits.push_back(random() % (8 * sound.size()));
    const auto is_refused = [](const auto& action) {
        try {
            action();
            return false;
        } catch (const FileError&) {
            return true;
        }
    };
    int by_seal_alone = 0;
    for (const std::size_t bit : bits) {
        INFO("bit " << bit << " of " << 8 * sound.size());
        std::string changed = sound;
        changed[bit / 8] = static_cast<char>(changed[bit / 8] ^ (1 << bit % 8));
        write_file(path, changed);
        std::vector<std::string> changes;
        const bool is_unreadable = is_refused([&] { changes = list_changes(path); });
        CHECK((is_unreadable || changes.size() == 1));
        if (changes == std::vector{sample::seal_changed}) ++by_seal_alone;
        const bool is_resumed = !is_refused([&] { const ResumableFile file(path); });
        CHECK(!is_resumed);
        CHECK(read_text_file(path) == changed);
    }
    CHECK(by_seal_alone > 50);
    write_file(path, sound);
    CHECK(list_changes(path).empty());
    CHECK_NOTHROW(ResumableFile(path));
}
