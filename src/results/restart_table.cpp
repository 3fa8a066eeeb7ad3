#include "results/restart_table.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <span>
#include <stdexcept>
#include <type_traits>
#include <vector>

namespace gxrod {
namespace {

constexpr std::int64_t no_slot = -1;
constexpr std::int64_t form_version = 1;  // of what is in a slot; raise it with every change
std::string slot_name(std::int64_t slot) { return slot == 0 ? "a" : "b"; }

// Calls visit(vector) for each vector of a row, const or not.
template <class Row, class Visitor>
void visit_vectors(Row& row, Visitor&& visit) {
    using Kind = std::remove_const_t<Row>;
    if constexpr (std::is_same_v<Kind, NodeMotion>) {
        visit(row.r);
        visit(row.Lambda.coeffs());
        visit(row.v);
        visit(row.omega);
        visit(row.a);
        visit(row.alpha);
    } else if constexpr (std::is_same_v<Kind, SectionHistory>) {
        visit(row.Lambda.coeffs());
        visit(row.K);
    } else if constexpr (std::is_same_v<Kind, AlgorithmicAcceleration>) {
        visit(row.a);
        visit(row.alpha);
    } else {
        static_assert(std::is_same_v<Kind, Vec6>);
        visit(row);
    }
}

template <class Row>
hsize_t count_columns() {
    hsize_t columns = 0;
    Row row;
    visit_vectors(row, [&](const auto& vector) { columns += static_cast<hsize_t>(vector.size()); });
    return columns;
}

// Rows of numbers with so many columns.
struct Table {
    hsize_t columns;
    std::vector<double> values = {};
};

template <class Row>
Table table_of(std::span<const Row> rows) {
    Table table{count_columns<Row>()};
    table.values.reserve(rows.size() * table.columns);
    for (const Row& row : rows) {
        visit_vectors(row, [&](const auto& vector) {
            table.values.insert(table.values.end(), vector.data(), vector.data() + vector.size());
        });
    }
    return table;
}

template <class Row>
std::vector<Row> rows_of(const Table& table) {
    std::vector<Row> rows(table.values.size() / table.columns);
    const double* next = table.values.data();
    for (Row& row : rows) {
        visit_vectors(row, [&](auto&& vector) {
            std::copy_n(next, vector.size(), vector.data());
            next += vector.size();
        });
    }
    return rows;
}

// Calls visit(name, member) for each single number of a place.
template <class Place, class Visitor>
void visit_numbers(Place& place, Visitor&& visit) {
    auto& [record, steps, frames] = place;
    visit("steps", steps);
    visit("frames", frames);
    visit("time", record.steps.time);
    visit("has_failed", record.steps.has_failed);
    visit("next_step", record.steps.step);
    visit("error_before", record.steps.error_before);
    visit("just_rejected", record.steps.just_rejected);
    visit("steps_by_error", record.steps.accepted);
    visit("initial_energy", record.ledger.initial_energy);
    visit("initial_potential", record.ledger.initial_potential);
    visit("driving_work", record.ledger.driving_work);
    visit("dissipated", record.ledger.dissipated);
    visit("driving_power", record.ledger.driving_power);
    visit("damping_power", record.ledger.damping_power);
    visit("is_framed", record.is_framed);
    visit("accepted_steps", record.totals.steps);
    visit("rejected_steps", record.totals.rejected_steps);
    visit("newton_iterations", record.totals.newton_iterations);
    visit("largest_energy", record.totals.largest_energy);
    visit("largest_energy_error", record.totals.largest_energy_error);
}

// A number as it was before it was written as a double.
template <class Number>
Number restore(double number) {
    constexpr double exactly_whole = 9007199254740992.0;  // 2^53
    if constexpr (std::is_same_v<Number, double>) {
        return number;
    } else if constexpr (std::is_same_v<Number, bool>) {
        return number != 0.0;
    } else {
        if (!(std::abs(number) <= exactly_whole && (std::is_signed_v<Number> || number >= 0.0))) {
            throw std::runtime_error("its state has a count that is none");
        }
        return static_cast<Number>(number);
    }
}

DatasetLabel numbers_label() {
    std::string names;
    const RestartPlace none;
    visit_numbers(none, [&](const char* name, const auto&) { names += std::string(" ") + name; });
    return {"numbers", "single numbers, in order:" + names, "none", ""};
}

// The dataset of that name, with so many rows; a new one if there is none.
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

void write_rows(const Hdf5Handle& dataset, hsize_t first, const Table& table) {
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

// Piece by piece: of large models, all rows once more as numbers would be much.
template <class Row>
void put(const Hdf5Handle& group, const DatasetLabel& label, std::span<const Row> rows) {
    constexpr std::size_t piece = 4096;
    const Hdf5Handle dataset = require_dataset(group, label, rows.size(), count_columns<Row>());
    for (std::size_t first = 0; first < rows.size(); first += piece)
        write_rows(dataset, first, table_of(rows.subspan(first, std::min(piece, rows.size() - first))));
}

const DatasetLabel nodes_label{"nodes",
                               "of each node: position, rotation as quaternion x y z w, velocity, angular "
                               "velocity, acceleration, angular acceleration",
                               "spatial",
                               ""};
const DatasetLabel sections_label{"sections",
                                  "of each force point that remembers: section axes as quaternion x y z w, "
                                  "material curvature",
                                  "none",
                                  ""};
const DatasetLabel algorithmic_label{
    "algorithmic", "of each node: algorithmic acceleration and angular acceleration", "spatial", ""};
const DatasetLabel driving_label{"driving", "force and moment that does work on each node", "spatial", ""};
const DatasetLabel damping_label{"damping", "force and moment of damping on each node", "spatial", ""};

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
    check_hdf5(H5Awrite(slot_attribute_.id(), H5T_NATIVE_INT64, &no_slot), "writing an attribute");
    write_attribute(group_.id(), "version", std::array{form_version});
}

void RestartTable::write(const RestartPlace& place) {
    const Hdf5Handle slot = require_group(group_, slot_name(slot_ == 0 ? 1 : 0));
    const RestartRecord& record = place.record;
    Table single{1};
    visit_numbers(
        place, [&](const char*, const auto& value) { single.values.push_back(static_cast<double>(value)); });
    write_rows(require_dataset(slot, numbers_label(), single.values.size(), 1), 0, single);
    put<NodeMotion>(slot, nodes_label, record.nodes);
    put<SectionHistory>(slot, sections_label, record.sections);
    put<AlgorithmicAcceleration>(slot, algorithmic_label, record.algorithmic);
    put<Vec6>(slot, driving_label, record.ledger.driving);
    put<Vec6>(slot, damping_label, record.ledger.damping);
    is_written_ = true;
}

void RestartTable::switch_slot() {
    if (!is_written_) return;
    slot_ = slot_ == 0 ? 1 : 0;
    is_written_ = false;
    check_hdf5(H5Awrite(slot_attribute_.id(), H5T_NATIVE_INT64, &slot_), "writing an attribute");
}

std::optional<RestartPlace> read_restart(const Hdf5Reader& file) {
    if (!file.has("/restart") || file.integer_attribute("/restart", "slot") == no_slot) return std::nullopt;
    if (file.integer_attribute("/restart", "version") != form_version) {
        throw std::runtime_error("its state was written in another form, by another version of gxrod");
    }
    const std::string slot = "/restart/" + slot_name(file.integer_attribute("/restart", "slot")) + "/";
    const auto read = [&](const DatasetLabel& label, hsize_t columns) {
        const std::vector<hsize_t> size = file.size(slot + label.name);
        if (size.size() != 2 || size[1] != columns)
            throw std::runtime_error(slot + label.name + " is damaged");
        return Table{columns, file.numbers(slot + label.name)};
    };
    RestartPlace place;
    const Table single = read(numbers_label(), 1);
    std::size_t count = 0;
    visit_numbers(place, [&](const char*, auto& value) {
        if (count >= single.values.size()) throw std::runtime_error(slot + "numbers is damaged");
        value = restore<std::remove_reference_t<decltype(value)>>(single.values[count++]);
    });
    RestartRecord& record = place.record;
    const auto read_rows = [&](const DatasetLabel& label, auto& rows) {
        using Row = typename std::remove_reference_t<decltype(rows)>::value_type;
        rows = rows_of<Row>(read(label, count_columns<Row>()));
    };
    read_rows(nodes_label, record.nodes);
    read_rows(sections_label, record.sections);
    read_rows(algorithmic_label, record.algorithmic);
    read_rows(driving_label, record.ledger.driving);
    read_rows(damping_label, record.ledger.damping);
    return place;
}

}  // namespace gxrod
