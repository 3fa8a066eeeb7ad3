#include <cmath>
#include <stdexcept>

#include "results/restart/restart_form.hpp"
#include "results/restart/restart_table.hpp"

namespace gxrod {

namespace {

// Converts a number back from the double that it was written as.
template <class Number>
Number restore(double number) {
    constexpr double exactly_whole = 9007199254740992.0;  // 2^53
    if constexpr (std::is_same_v<Number, double>) {
        return number;
    } else if constexpr (std::is_same_v<Number, bool>) {
        return number != 0.0;
    } else {
        if (!(std::abs(number) <= exactly_whole && (std::is_signed_v<Number> || number >= 0.0))) {
            throw std::runtime_error("its state has an invalid count");
        }
        return static_cast<Number>(number);
    }
}

// With their checksum at the end.
RestartNumbers read_numbers(const Hdf5Reader& file, const std::string& slot) {
    std::size_t count = 1;
    const RestartPlace none;
    visit_numbers(none, [&](const char*, const auto&) { ++count; });
    visit_lists(none.record, [&](const DatasetLabel&, const auto&) { ++count; });
    return {1, file.rows(slot + numbers_label().name, 0, count, 1)};
}

}  // namespace

std::optional<RestartPlace> read_restart(const Hdf5Reader& file) {
    if (!file.has("/restart")) return std::nullopt;
    const std::int64_t number = file.integer_attribute("/restart", "slot");
    if (number == no_slot) return std::nullopt;
    if (file.integer_attribute("/restart", "version") != form_version) {
        throw std::runtime_error("its state was written by another version of gxrod, in another form");
    }
    if (number != 0 && number != 1) throw std::runtime_error("/restart@slot is damaged");
    const std::string slot = "/restart/" + slot_name(number) + "/";
    std::uint32_t sum = 0;
    const auto read = [&](const DatasetLabel& label, double rows, hsize_t columns) {
        const std::vector<hsize_t> size = file.size(slot + label.name);
        if (size.size() != 2 || static_cast<double>(size[0]) != rows || size[1] != columns)
            throw std::runtime_error(slot + label.name + " is damaged");
        RestartNumbers table{columns, file.numbers(slot + label.name)};
        sum = sum_of(table, sum);
        return table;
    };
    RestartPlace place;
    RestartNumbers single = read_numbers(file, slot);
    const double written = single.values.back();
    single.values.pop_back();
    std::size_t next = 0;
    visit_numbers(place, [&](const char*, const auto&) { ++next; });
    visit_lists(place.record, [&](const DatasetLabel& label, auto& rows) {
        using Row = typename std::remove_reference_t<decltype(rows)>::value_type;
        const double count = single.values[next++];
        if (count != 0.0)
            rows = rows_of<Row>(
                read(with_rows(label, static_cast<std::size_t>(count)), count, count_columns<Row>()));
    });
    if (static_cast<double>(sum_of(single, sum)) != written)
        throw std::runtime_error("its state does not have the checksum that was written with it");
    std::size_t count = 0;
    visit_numbers(place, [&](const char*, auto& value) {
        value = restore<std::remove_reference_t<decltype(value)>>(single.values[count++]);
    });
    return place;
}

}  // namespace gxrod
