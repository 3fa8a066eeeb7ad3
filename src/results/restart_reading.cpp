#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <set>
#include <stdexcept>
#include <utility>

#include "results/file_seal.hpp"
#include "results/restart_form.hpp"
#include "results/restart_table.hpp"

namespace gxrod {

namespace {

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

// With their checksum at the end.
Table read_numbers(const Hdf5Reader& file, const std::string& slot) {
    std::size_t count = 1;
    const RestartPlace none;
    visit_numbers(none, [&](const char*, const auto&) { ++count; });
    return {1, file.rows(slot + numbers_label().name, 0, count, 1)};
}

bool has_label(const Hdf5Reader& file, const std::string& dataset, const DatasetLabel& label) {
    const bool has_dimension = file.has_attribute(dataset, "dimension");
    return file.text_attribute(dataset, "description") == label.description &&
           file.text_attribute(dataset, "frame") == label.frame &&
           label.dimension == (has_dimension ? file.text_attribute(dataset, "dimension") : "");
}

bool is_of_type(hid_t (*get_type)(hid_t), hid_t object, hid_t written) {
    const Hdf5Handle type(get_type(object), H5Tclose, "type");
    return H5Tequal(type.id(), written) > 0;
}

// What may change of /restart, apart from its rows.
bool has_known_attributes(const Hdf5Reader& file) {
    const std::array attributes{std::pair{"slot", H5S_SCALAR},
                                std::pair{"structure", H5S_SCALAR},
                                std::pair{"end", H5S_SCALAR},
                                std::pair{"version", H5S_SIMPLE}};
    return std::all_of(attributes.begin(), attributes.end(), [&](const auto& known) {
        const Hdf5Handle attribute(
            H5Aopen_by_name(file.id(), "/restart", known.first, H5P_DEFAULT, H5P_DEFAULT),
            H5Aclose,
            "opening an attribute");
        const Hdf5Handle space(H5Aget_space(attribute.id()), H5Sclose, "dataspace");
        return is_of_type(H5Aget_type, attribute.id(), H5T_STD_I64LE) &&
               H5Sget_simple_extent_type(space.id()) == known.second;
    });
}

bool has_type(const Hdf5Reader& file, const std::string& dataset, hid_t written) {
    const Hdf5Handle rows(H5Dopen2(file.id(), dataset.c_str(), H5P_DEFAULT), H5Dclose, "opening a dataset");
    return is_of_type(H5Dget_type, rows.id(), written);
}

bool has_known_seal(const Hdf5Reader& file) {
    const std::string path = "/restart/" + seal_label.name;
    return has_label(file, path, seal_label) && has_type(file, path, H5T_STD_I64LE) &&
           file.size(path) == std::vector<hsize_t>{1};
}

std::array<hsize_t, 3> header_form_of(const Hdf5Reader& file, const std::string& path) {
    return header_form(
        Hdf5Handle(H5Oopen(file.id(), path.c_str(), H5P_DEFAULT), H5Oclose, "opening an object").id());
}

}  // namespace

bool has_known_form(const Hdf5Reader& file) {
    return file.integer_attribute("/restart", "version") == form_version;
}

bool has_known_structure(const Hdf5Reader& file) {
    if (!has_known_attributes(file) || !has_known_seal(file)) return false;
    const std::array labels{nodes_label,
                            sections_label,
                            algorithmic_label,
                            forces_label,
                            force_change_label,
                            movement_label,
                            numbers_label()};
    // States are made alike, and so are all datasets of them.
    std::set<std::array<hsize_t, 3>> slot_headers, headers;
    for (const std::string& slot : file.members("/restart")) {
        if (slot == seal_label.name) continue;
        if (slot != slot_name(0) && slot != slot_name(1)) return false;
        const std::string path = "/restart/" + slot + "/";
        for (const std::string& name : file.members(path)) {
            const auto* const label = std::find_if(
                labels.begin(), labels.end(), [&](const DatasetLabel& one) { return one.name == name; });
            if (label == labels.end() || !has_label(file, path + name, *label) ||
                !has_type(file, path + name, H5T_IEEE_F64LE))
                return false;
            headers.insert(header_form_of(file, path + name));
        }
        slot_headers.insert(header_form_of(file, path));
    }
    return slot_headers.size() <= 1 && headers.size() <= 1;
}

std::optional<RestartPlace> read_restart(const Hdf5Reader& file) {
    if (!file.has("/restart")) return std::nullopt;
    const long long number = file.integer_attribute("/restart", "slot");
    if (number == no_slot) return std::nullopt;
    if (!has_known_form(file)) {
        throw std::runtime_error("its state was written in another form, by another version of gxrod");
    }
    if (number != 0 && number != 1) throw std::runtime_error("/restart@slot is damaged");
    const std::string slot = "/restart/" + slot_name(number) + "/";
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
    read_rows(forces_label, record.ledger.forces);
    read_rows(force_change_label, record.ledger.force_change);
    read_rows(movement_label, record.ledger.movement);
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

FileSums read_file_sums(const Hdf5Reader& file) {
    const auto read = [&](const char* name) {
        const long long sum = file.integer_attribute("/restart", name);
        if (sum == no_sum) return std::uint32_t{0};
        if (sum <= 0 || sum > std::numeric_limits<std::uint32_t>::max())
            throw std::runtime_error(std::string("/restart@") + name + " is damaged");
        return static_cast<std::uint32_t>(sum);
    };
    return {read("structure"), read("end")};
}

}  // namespace gxrod
