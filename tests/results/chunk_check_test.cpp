#include "results/chunk_check.hpp"

#include <array>
#include <fstream>
#include <numeric>
#include <string>
#include <vector>

#include "deck/reading/text_file.hpp"
#include "results/hdf5_objects.hpp"
#include "results/sample.hpp"
#include "tools/catch.hpp"

using namespace gxrod;

namespace {

constexpr hsize_t rows = 10, rows_in_chunk = 4;  // in three chunks, the last one partly filled
constexpr std::size_t chunk_bytes = rows_in_chunk * 3 * sizeof(double);

enum class Entry { length, skipped_filters };  // of a chunk in the index
enum class Form { contiguous, chunked, deflated, nbit };

// A dataset of rows of three numbers in a file of its own.
struct Rows {
    sample::ScratchFolder folder;
    Hdf5Handle file, dataset;

    explicit Rows(Form form, hsize_t count = rows, hsize_t chunk_rows = rows_in_chunk) {
        silence_hdf5();
        file = Hdf5Handle(H5Fcreate((folder / "a").c_str(), H5F_ACC_TRUNC, H5P_DEFAULT, H5P_DEFAULT),
                          H5Fclose,
                          "creating the file");
        const std::array<hsize_t, 2> size{count, 3}, limit{H5S_UNLIMITED, 3}, chunk{chunk_rows, 3};
        const bool grows = form != Form::contiguous;
        const Hdf5Handle space(
            H5Screate_simple(2, size.data(), grows ? limit.data() : nullptr), H5Sclose, "space");
        const Hdf5Handle properties(H5Pcreate(H5P_DATASET_CREATE), H5Pclose, "properties");
        if (grows) check_hdf5(H5Pset_chunk(properties.id(), 2, chunk.data()), "chunks");
        if (form == Form::deflated) {
            check_hdf5(H5Pset_shuffle(properties.id()), "shuffle");
            check_hdf5(H5Pset_deflate(properties.id(), 1), "deflate");
        }
        if (form == Form::nbit) check_hdf5(H5Pset_nbit(properties.id()), "nbit");
        dataset = Hdf5Handle(
            H5Dcreate2(
                file.id(), "rows", H5T_IEEE_F64LE, space.id(), H5P_DEFAULT, properties.id(), H5P_DEFAULT),
            H5Dclose,
            "creating a dataset");
        std::vector<double> values(count * 3);
        std::iota(values.begin(), values.end(), 0.0);
        if (count > 0)
            check_hdf5(
                H5Dwrite(dataset.id(), H5T_NATIVE_DOUBLE, H5S_ALL, H5S_ALL, H5P_DEFAULT, values.data()),
                "writing");
        check_hdf5(H5Fflush(file.id(), H5F_SCOPE_LOCAL), "flushing");
    }
    // As it is in the file, in place of a chunk.
    void write_chunk(hsize_t first, const std::vector<std::uint8_t>& bytes) const {
        const std::array<hsize_t, 2> place{first, 0};
        check_hdf5(H5Dwrite_chunk(dataset.id(), H5P_DEFAULT, 0, place.data(), bytes.size(), bytes.data()),
                   "writing a chunk");
    }
    // In the only leaf of the index: HDF5's file format, III.A.1.
    void change_index(std::size_t chunk, Entry entry, std::uint32_t number) {
        dataset.reset();
        file.reset();
        std::string bytes = read_text_file(folder / "a");
        constexpr std::size_t head_bytes = 24, key_bytes = 8 + 3 * 8, child_bytes = 8;
        const std::size_t at = bytes.find("TREE\x01") + head_bytes + chunk * (key_bytes + child_bytes) +
                               (entry == Entry::length ? 0 : 4);
        REQUIRE(at < bytes.size());
        bytes.replace(at, sizeof number, reinterpret_cast<const char*>(&number), sizeof number);
        std::ofstream(folder / "a", std::ios::binary) << bytes;
        file = Hdf5Handle(H5Fopen((folder / "a").c_str(), H5F_ACC_RDONLY, H5P_DEFAULT), H5Fclose, "opening");
        dataset = Hdf5Handle(H5Dopen2(file.id(), "rows", H5P_DEFAULT), H5Dclose, "opening");
    }
    std::vector<std::uint8_t> read_chunk(hsize_t first) const {
        const std::array<hsize_t, 2> place{first, 0};
        hsize_t size = 0;
        check_hdf5(H5Dget_chunk_storage_size(dataset.id(), place.data(), &size), "size");
        std::vector<std::uint8_t> bytes(size);
        std::uint32_t skipped = 0;
        check_hdf5(H5Dread_chunk(dataset.id(), H5P_DEFAULT, place.data(), &skipped, bytes.data()), "reading");
        return bytes;
    }
    void grow(hsize_t count) const {
        const std::array<hsize_t, 2> size{count, 3};
        check_hdf5(H5Dset_extent(dataset.id(), size.data()), "growing");
    }
    bool are_sound() const {
        return has_sound_chunks(dataset.id(), [] {});
    }
};

}  // namespace

TEST_CASE("Rows as they were written have sound chunks", "[results]") {
    for (const Form form : {Form::contiguous, Form::chunked, Form::deflated}) {
        CHECK(Rows(form).are_sound());
        CHECK(Rows(form, 0).are_sound());
    }
    for (const Form form : {Form::chunked, Form::deflated}) {
        Rows with_gap(form);
        with_gap.grow(9 * rows_in_chunk);
        CHECK(with_gap.are_sound());
        const std::vector<std::uint8_t> chunk = with_gap.read_chunk(0);
        with_gap.write_chunk(8 * rows_in_chunk, chunk);
        CHECK(with_gap.are_sound());
    }
}

TEST_CASE("A chunk of another length is told", "[results]") {
    for (std::size_t chunk = 0; chunk < 3; ++chunk) {
        for (const std::size_t bytes : {std::size_t{1}, chunk_bytes - 1, chunk_bytes + 1}) {
            Rows changed(Form::chunked);
            changed.change_index(chunk, Entry::length, static_cast<std::uint32_t>(bytes));
            CHECK_FALSE(changed.are_sound());
            changed.change_index(chunk, Entry::length, chunk_bytes);
            CHECK(changed.are_sound());
        }
    }
}

TEST_CASE("A chunk that inflates to another length is told", "[results]") {
    const auto deflated_of = [](hsize_t count) { return Rows(Form::deflated, count, count).read_chunk(0); };
    for (const hsize_t first : {0, 4, 8}) {
        Rows changed(Form::deflated);
        changed.write_chunk(first, deflated_of(rows_in_chunk));
        CHECK(changed.are_sound());
        for (const hsize_t count : {rows_in_chunk - 1, rows_in_chunk + 1}) {
            changed.write_chunk(first, deflated_of(count));
            CHECK_FALSE(changed.are_sound());
        }
    }
}

TEST_CASE("A compressed chunk that is said not to be is told", "[results]") {
    for (std::size_t chunk = 0; chunk < 3; ++chunk) {
        for (const std::uint32_t skipped : {1U, 2U, 3U, 1U << 31U}) {
            Rows changed(Form::deflated);
            changed.change_index(chunk, Entry::skipped_filters, skipped);
            CHECK_FALSE(changed.are_sound());
            changed.change_index(chunk, Entry::skipped_filters, 0);
            CHECK(changed.are_sound());
        }
    }
}

TEST_CASE("Chunks that are compressed in another way than gxrod does are told", "[results]") {
    CHECK(Rows(Form::nbit, 0).are_sound());  // without any chunk
    CHECK_FALSE(Rows(Form::nbit).are_sound());
}
