#include "results/row_sums.hpp"

#include <limits>

#include "machine/checksum.hpp"
#include "results/append_dataset.hpp"
#include "results/sample.hpp"
#include "tools/catch.hpp"

using namespace gxrod;

namespace {

// A file of its own in memory.
struct MemoryFile {
    Hdf5Handle access{H5Pcreate(H5P_FILE_ACCESS), H5Pclose, "properties"};
    Hdf5Handle file;
    Hdf5Handle root;

    MemoryFile() {
        H5Pset_fapl_core(access.id(), 1 << 16, false);
        file = Hdf5Handle(H5Fcreate("memory", H5F_ACC_TRUNC, H5P_DEFAULT, access.id()), H5Fclose, "creating");
        root = Hdf5Handle(H5Gopen2(file.id(), "/", H5P_DEFAULT), H5Gclose, "opening");
    }
};

std::uint32_t sum_of(const std::vector<double>& values) { return checksum(std::span<const double>(values)); }

std::vector<double> count_up(std::size_t count) {
    std::vector<double> values;
    for (std::size_t i = 0; i < count; ++i) values.push_back(0.5 * static_cast<double>(i));
    return values;
}

}  // namespace

TEST_CASE("Rows have the checksum of their numbers, in memory, on disk and when they are gone on from",
          "[results]") {
    const MemoryFile memory;
    const DatasetLabel label{"rows", "rows", "none", "1"};
    // More than the pieces that are read at once.
    const std::vector<double> values = count_up(600000);
    const std::span<const double> all(values);
    {
        AppendDataset<double> rows(memory.root, label, vector_row, 0);
        rows.append(all.first(3));
        CHECK(rows.sum().sum == checksum(all.first(3)));
        rows.append(all.subspan(3, 30));
        CHECK(rows.sum().sum == checksum(all.first(33)));
        rows.flush();
        CHECK(rows.sum().sum == checksum(all.first(33)));
        rows.append(all.subspan(33));
        rows.flush();
        CHECK(rows.sum().sum == sum_of(values));
        CHECK(sum_rows(rows.id(), {0, 200000}) == sum_of(values));
        CHECK(sum_rows(rows.id(), {0, 11}) == checksum(all.first(33)));
        CHECK(sum_rows(rows.id(), {0, 0}) == 0);
        CHECK_THROWS_WITH(sum_rows(rows.id(), {0, 200001}), "a dataset lacks rows");
        CHECK(rows.sum().address == address_of(rows.id()));
    }
    AppendDataset<double> rows(memory.root, label, vector_row, 11);
    rows.append(all.first(3));
    CHECK(rows.sum().sum == checksum(all.first(3), checksum(all.first(33))));
}

TEST_CASE("Rows that a dataset begins without count as what stands in for them", "[results]") {
    const MemoryFile memory;
    AppendDataset<double> numbers(memory.root, {"numbers", "", "none", "1"}, scalar_row, 3);
    CHECK(numbers.sum().sum == sum_of(std::vector(3, std::numeric_limits<double>::quiet_NaN())));
    AppendDataset<std::int64_t> counts(memory.root, {"counts", "", "none", "1"}, scalar_row, 3);
    CHECK(counts.sum().sum == sum_of(std::vector(3, 0.0)));
}

TEST_CASE("The checksum of several datasets tells each, and which is which", "[results]") {
    const std::uint32_t all = combine({{100, 7}, {200, 8}});
    CHECK(combine({{200, 8}, {100, 7}}) == all);
    CHECK(combine({{100, 8}, {200, 7}}) != all);
    CHECK(combine({{100, 7}}) != all);
    CHECK(combine({{100, 7}, {201, 8}}) != all);
    CHECK(combine({}) == 0);
}

TEST_CASE("What no file can hold is not read for its checksum", "[results]") {
    const MemoryFile memory;
    const auto create = [&](const char* name, std::vector<hsize_t> size, hid_t type) {
        const Hdf5Handle properties(H5Pcreate(H5P_DATASET_CREATE), H5Pclose, "properties");
        H5Pset_chunk(
            properties.id(), static_cast<int>(size.size()), std::vector<hsize_t>(size.size(), 8).data());
        const Hdf5Handle space(
            H5Screate_simple(static_cast<int>(size.size()), size.data(), nullptr), H5Sclose, "space");
        return Hdf5Handle(
            H5Dcreate2(memory.file.id(), name, type, space.id(), H5P_DEFAULT, properties.id(), H5P_DEFAULT),
            H5Dclose,
            "creating");
    };
    const Hdf5Handle many = create("many", {hsize_t{1} << 40}, H5T_IEEE_F64LE);
    CHECK_THROWS_WITH(sum_rows(many.id(), {0, hsize_t{1} << 40}),
                      "a dataset has 1099511627776 rows of 8 bytes, more than its file can hold");
    CHECK(sum_rows(many.id(), {0, 1}) == sum_of({0.0}));
    const Hdf5Handle wide = create("wide", {10, hsize_t{1} << 40}, H5T_IEEE_F64LE);
    CHECK_THROWS_WITH(sum_rows(wide.id(), {0, 1}), Catch::Contains("rows of 8.8e+12 bytes"));
}
