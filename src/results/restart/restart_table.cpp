#include "results/restart/restart_table.hpp"

#include <algorithm>
#include <array>
#include <span>
#include <stdexcept>

#include "results/restart/restart_form.hpp"

namespace gxrod {
namespace {

// Opens the dataset of that name, or creates it, with so many rows.
Hdf5Handle require_dataset(const Hdf5Handle& group,
                           const DatasetLabel& label,
                           hsize_t rows,
                           hsize_t columns) {
    if (!has_link(group, label.name)) return create_dataset(group, label, rows, columns);
    Hdf5Handle dataset(H5Dopen2(group.id(), label.name.c_str(), H5P_DEFAULT), H5Dclose, "opening a dataset");
    const Hdf5Handle space(H5Dget_space(dataset.id()), H5Sclose, "dataspace");
    if (H5Sget_simple_extent_npoints(space.id()) != static_cast<hssize_t>(rows * columns)) {
        throw std::runtime_error("/restart holds another number of " + label.name);
    }
    return dataset;
}

void write_rows(const Hdf5Handle& dataset, hsize_t first, const RestartNumbers& table) {
    const std::array<hsize_t, 2> start{first, 0};
    const std::array<hsize_t, 2> count{table.values.size() / table.columns, table.columns};
    const Hdf5Handle on_disk(H5Dget_space(dataset.id()), H5Sclose, "dataspace");
    check_hdf5(
        H5Sselect_hyperslab(on_disk.id(), H5S_SELECT_SET, start.data(), nullptr, count.data(), nullptr),
        "selecting rows");
    const Hdf5Handle in_memory(H5Screate_simple(2, count.data(), nullptr), H5Sclose, "dataspace");
    check_hdf5(
        H5Dwrite(
            dataset.id(), H5T_NATIVE_DOUBLE, in_memory.id(), on_disk.id(), H5P_DEFAULT, table.values.data()),
        "writing a dataset");
}

// Piece by piece: for large models, a copy of all rows as numbers would be large. `sum`, the checksum so far,
// is extended by these rows.
template <class Row>
void put(const Hdf5Handle& group, const DatasetLabel& label, std::span<const Row> rows, std::uint32_t& sum) {
    // What an earlier stage wrote stays: it does not count.
    if (rows.empty()) return;
    constexpr std::size_t piece = 4096;
    const Hdf5Handle dataset =
        require_dataset(group, with_rows(label, rows.size()), rows.size(), count_columns<Row>());
    for (std::size_t first = 0; first < rows.size(); first += piece) {
        const RestartNumbers table = table_of(rows.subspan(first, std::min(piece, rows.size() - first)));
        write_rows(dataset, first, table);
        sum = sum_of(table, sum);
    }
}

void write_number(const Hdf5Handle& attribute, std::int64_t number) {
    check_hdf5(H5Awrite(attribute.id(), H5T_NATIVE_INT64, &number), "writing an attribute");
}

}  // namespace

RestartTable::RestartTable(const Hdf5Handle& root) : group_(require_group(root, "restart")) {
    if (H5Aexists(group_.id(), "slot") > 0) {
        slot_attribute_ =
            Hdf5Handle(H5Aopen(group_.id(), "slot", H5P_DEFAULT), H5Aclose, "opening an attribute");
        check_hdf5(H5Aread(slot_attribute_.id(), H5T_NATIVE_INT64, &slot_), "reading an attribute");
        return;
    }
    const Hdf5Handle space(H5Screate(H5S_SCALAR), H5Sclose, "scalar dataspace");
    slot_attribute_ =
        Hdf5Handle(H5Acreate2(group_.id(), "slot", H5T_STD_I64LE, space.id(), H5P_DEFAULT, H5P_DEFAULT),
                   H5Aclose,
                   "creating an attribute");
    write_number(slot_attribute_, no_slot);
    write_attribute(group_.id(), "version", std::array{form_version});
}

void RestartTable::write(const RestartPlace& place) {
    const Hdf5Handle slot = require_group(group_, slot_name(slot_ == 0 ? 1 : 0));
    RestartNumbers single{1};
    visit_numbers(
        place, [&](const char*, const auto& value) { single.values.push_back(static_cast<double>(value)); });
    std::uint32_t sum = 0;
    visit_lists(place.record, [&](const DatasetLabel& label, const auto& rows) {
        using Row = typename std::remove_cvref_t<decltype(rows)>::value_type;
        put<Row>(slot, label, rows, sum);
        single.values.push_back(static_cast<double>(rows.size()));
    });
    single.values.push_back(static_cast<double>(sum_of(single, sum)));
    write_rows(require_dataset(slot, numbers_label(), single.values.size(), 1), 0, single);
    is_written_ = true;
}

void RestartTable::switch_slot() {
    if (!is_written_) return;
    slot_ = slot_ == 0 ? 1 : 0;
    is_written_ = false;
    write_number(slot_attribute_, slot_);
}

}  // namespace gxrod
