#include "results/restart_table.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <span>
#include <stdexcept>
#include <type_traits>
#include <vector>

#include "results/checksum.hpp"

namespace gxrod {
namespace {

constexpr std::int64_t no_slot = -1;
constexpr std::uint32_t no_sum = 0;
constexpr std::int64_t form_version = 2;  // of what is in a slot; raise it with every change
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
    auto& [record, steps, frames, sums] = place;
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
    visit("checksum_of_steps", sums.steps);
    visit("checksum_of_frames", sums.frames);
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
    return {"numbers", "single numbers, in order:" + names + " checksum_of_state", "none", ""};
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

std::uint32_t sum_of(const Table& table, std::uint32_t before) {
    return checksum(std::span<const double>(table.values), before);
}

// Piece by piece: of large models, all rows once more as numbers would be much. The checksum of what went
// before becomes that with these rows.
template <class Row>
void put(const Hdf5Handle& group, const DatasetLabel& label, std::span<const Row> rows, std::uint32_t& sum) {
    constexpr std::size_t piece = 4096;
    const Hdf5Handle dataset = require_dataset(group, label, rows.size(), count_columns<Row>());
    for (std::size_t first = 0; first < rows.size(); first += piece) {
        const Table table = table_of(rows.subspan(first, std::min(piece, rows.size() - first)));
        write_rows(dataset, first, table);
        sum = sum_of(table, sum);
    }
}

Hdf5Handle open_attribute(const Hdf5Handle& group, const char* name) {
    return {H5Aopen(group.id(), name, H5P_DEFAULT), H5Aclose, "opening an attribute"};
}

void write_number(const Hdf5Handle& attribute, std::int64_t number) {
    check_hdf5(H5Awrite(attribute.id(), H5T_NATIVE_INT64, &number), "writing an attribute");
}

Hdf5Handle create_number(const Hdf5Handle& group, const char* name, std::int64_t number) {
    const Hdf5Handle space(H5Screate(H5S_SCALAR), H5Sclose, "scalar dataspace");
    Hdf5Handle attribute(H5Acreate2(group.id(), name, H5T_STD_I64LE, space.id(), H5P_DEFAULT, H5P_DEFAULT),
                         H5Aclose,
                         "creating an attribute");
    write_number(attribute, number);
    return attribute;
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
        slot_attribute_ = open_attribute(group_, "slot");
        structure_attribute_ = open_attribute(group_, "structure");
        end_attribute_ = open_attribute(group_, "end");
        check_hdf5(H5Aread(slot_attribute_.id(), H5T_NATIVE_INT64, &slot_), "reading an attribute");
        return;
    }
    slot_attribute_ = create_number(group_, "slot", no_slot);
    structure_attribute_ = create_number(group_, "structure", no_sum);
    end_attribute_ = create_number(group_, "end", no_sum);
    write_attribute(group_.id(), "version", std::array{form_version});
}

void RestartTable::write_structure_sum(std::uint32_t sum) {
    write_number(structure_attribute_, sum);
    has_structure_sum_ = true;
}

void RestartTable::write_end_sum(std::uint32_t sum) { write_number(end_attribute_, sum); }

void RestartTable::write(const RestartPlace& place) {
    const Hdf5Handle slot = require_group(group_, slot_name(slot_ == 0 ? 1 : 0));
    const RestartRecord& record = place.record;
    std::uint32_t sum = 0;
    put<NodeMotion>(slot, nodes_label, record.nodes, sum);
    put<SectionHistory>(slot, sections_label, record.sections, sum);
    put<AlgorithmicAcceleration>(slot, algorithmic_label, record.algorithmic, sum);
    put<Vec6>(slot, driving_label, record.ledger.driving, sum);
    put<Vec6>(slot, damping_label, record.ledger.damping, sum);
    Table single{1};
    visit_numbers(
        place, [&](const char*, const auto& value) { single.values.push_back(static_cast<double>(value)); });
    single.values.push_back(static_cast<double>(sum_of(single, sum)));
    write_rows(require_dataset(slot, numbers_label(), single.values.size(), 1), 0, single);
    is_written_ = true;
}

void RestartTable::switch_slot() {
    if (!is_written_) return;
    slot_ = slot_ == 0 ? 1 : 0;
    is_written_ = false;
    is_switched_ = true;
    write_number(slot_attribute_, slot_);
}

namespace {

// With their checksum at the end.
Table read_numbers(const Hdf5Reader& file, const std::string& slot) {
    std::size_t count = 1;
    const RestartPlace none;
    visit_numbers(none, [&](const char*, const auto&) { ++count; });
    return {1, file.rows(slot + numbers_label().name, 0, count, 1)};
}

}  // namespace

std::optional<RestartPlace> read_restart(const Hdf5Reader& file) {
    if (!file.has("/restart") || file.integer_attribute("/restart", "slot") == no_slot) return std::nullopt;
    if (file.integer_attribute("/restart", "version") != form_version) {
        throw std::runtime_error("its state was written in another form, by another version of gxrod");
    }
    const std::string slot = "/restart/" + slot_name(file.integer_attribute("/restart", "slot")) + "/";
    std::uint32_t sum = 0;
    const auto read = [&](const DatasetLabel& label, hsize_t columns) {
        const std::vector<hsize_t> size = file.size(slot + label.name);
        if (size.size() != 2 || size[1] != columns)
            throw std::runtime_error(slot + label.name + " is damaged");
        Table table{columns, file.numbers(slot + label.name)};
        sum = sum_of(table, sum);
        return table;
    };
    RestartPlace place;
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
    Table single = read_numbers(file, slot);
    const double written = single.values.back();
    single.values.pop_back();
    if (static_cast<double>(sum_of(single, sum)) != written)
        throw std::runtime_error("its state is not the one that was written");
    std::size_t count = 0;
    visit_numbers(place, [&](const char*, auto& value) {
        value = restore<std::remove_reference_t<decltype(value)>>(single.values[count++]);
    });
    return place;
}

void clear_file_sums(const Hdf5Handle& root) {
    const Hdf5Handle group = require_group(root, "restart");
    write_number(open_attribute(group, "structure"), no_sum);
    write_number(open_attribute(group, "end"), no_sum);
}

FileSums read_file_sums(const Hdf5Reader& file) {
    const auto read = [&](const char* name) {
        const long long sum = file.integer_attribute("/restart", name);
        if (sum < 0 || sum > std::numeric_limits<std::uint32_t>::max())
            throw std::runtime_error(std::string("/restart@") + name + " is damaged");
        return static_cast<std::uint32_t>(sum);
    };
    return {read("structure"), read("end")};
}

}  // namespace gxrod
