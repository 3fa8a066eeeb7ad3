#include "results/file/ordered_driver.hpp"

#include <fcntl.h>

#include <array>
#include <cstdint>
#include <cstring>
#include <memory>
#include <string>
#include <vector>

#include "deck/text/text_file.hpp"
#include "results/file/append_dataset.hpp"
#include "results/file/hdf5_objects.hpp"
#include "results/sample.hpp"
#include "tools/catch.hpp"

using namespace gxrod;

namespace {

struct NewFile {
    explicit NewFile(const std::string& path)
        : file(std::make_shared<OrderedFile>(::open(path.c_str(), O_RDWR | O_CREAT, 0600))),
          hdf5(create_hdf5(*file)),
          root(H5Gopen2(hdf5.id(), "/", H5P_DEFAULT), H5Gclose, "opening the root") {}
    void commit() const {
        REQUIRE(H5Fflush(hdf5.id(), H5F_SCOPE_LOCAL) >= 0);
        file->commit();
    }

    std::shared_ptr<OrderedFile> file;
    Hdf5Handle hdf5, root;
};

}  // namespace

TEST_CASE("The file driver stays when its last file is closed", "[results]") {
    // Closing a file, HDF5 reads the driver after it has let go of it.
    silence_hdf5();
    const sample::ScratchFolder folder;
    hid_t driver = H5I_INVALID_HID;
    for (const char* name : {"a", "b"}) {
        const auto file =
            std::make_shared<OrderedFile>(::open((folder / name).c_str(), O_RDWR | O_CREAT, 0600));
        Hdf5Handle access = make_ordered_access(*file);
        driver = H5Pget_driver(access.id());
        Hdf5Handle hdf5 = create_hdf5(*file);
        access.reset();
        CHECK(hdf5.reset() >= 0);
        CHECK(H5Iis_valid(driver) > 0);
    }
}

TEST_CASE("Many chunks leave no gaps to keep account of, and no B-tree node across two pages", "[results]") {
    silence_hdf5();
    const sample::ScratchFolder folder;
    const std::string path = folder / "a";
    {
        const NewFile file(path);
        AppendDataset<double> vectors(file.root, {"vectors", "", "", ""}, RowShape{3, true}, 0);
        AppendDataset<double> numbers(file.root, {"numbers", "", "", ""}, RowShape{1, false}, 0);
        for (int row = 0; row < 200'000; ++row) {
            const double value = row;
            vectors.append(std::array{value, -value, 0.0});
            numbers.append(std::array{value});
        }
        vectors.flush();
        numbers.flush();
        CHECK(H5Fget_free_sections(file.hdf5.id(), H5FD_MEM_DEFAULT, 0, nullptr) < 10);
        file.commit();
    }

    const std::string bytes = read_text_file(path);
    const std::string node_of_chunks = "TREE\x01";
    constexpr std::size_t page = 4096;
    constexpr std::size_t least_node = 2096;  // 64 places of chunks: HDF5's file format, III.A.1
    int nodes = 0;
    for (std::size_t at = bytes.find(node_of_chunks); at != std::string::npos;
         at = bytes.find(node_of_chunks, at + 1), ++nodes) {
        INFO("byte " << at);
        CHECK(at % page <= page - least_node);
    }
    CHECK(nodes > 20);
}

TEST_CASE("A heap of texts keeps to one page, and is not made longer", "[results]") {
    silence_hdf5();
    const sample::ScratchFolder folder;
    const std::string path = folder / "a";
    {
        const NewFile file(path);
        const std::vector<std::uint8_t> odd(1001);
        for (int i = 0; i < 20; ++i) {
            write_dataset(file.root, {"bytes" + std::to_string(i), "", "", ""}, odd);
            write_attribute(file.root.id(), "text" + std::to_string(i), std::string(700, 'a'));
            file.commit();
        }
    }

    const std::string bytes = read_text_file(path);
    constexpr std::size_t page = 4096;
    int heaps = 0;
    for (std::size_t at = bytes.find("GCOL"); at != std::string::npos;
         at = bytes.find("GCOL", at + 1), ++heaps) {
        std::uint64_t size = 0;  // HDF5's file format, III.E
        std::memcpy(&size, bytes.data() + at + 8, sizeof size);
        INFO("byte " << at);
        CHECK(at % page == 0);
        CHECK(size == page);
    }
    CHECK(heaps >= 4);
}
