#include "report/blocks/envelope_blocks.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>
#include <numeric>

#include "report/blocks/data_blocks.hpp"

namespace gxrod {

namespace {

constexpr std::size_t numbers_of_place = 11;
constexpr std::size_t forces_of_place = 6;

template <class Number>
std::vector<Number> take_envelope(const std::vector<double>& column, const std::vector<std::size_t>& rows) {
    std::vector<Number> picked;
    for (const std::size_t row : rows) picked.push_back(static_cast<Number>(column[row]));
    return picked;
}

}  // namespace

EnvelopeBlocks::EnvelopeBlocks(const Hdf5Reader& file, std::size_t bytes) : file_(file) {
    if (!file.has("/envelopes/rod")) return;
    rods_ = file.numbers("/envelopes/rod");
    places_ = file.rows("/envelopes/arc_length", 0, rods_.size(), 1);
    sections_ = file.rows("/envelopes/section", 0, rods_.size(), 1);
    for (const char* name : {"von_mises", "exposure"}) {
        if (file.has(fmt::format("/envelopes/{}/value", name))) quantities_.push_back(read_quantity(name));
    }
    kept_.resize(rods_.size());
    std::iota(kept_.begin(), kept_.end(), std::size_t{0});
    for (std::size_t group = 2; count_bytes() > bytes && group <= rods_.size(); group *= 2)
        kept_ = list_largest(group);
}

EnvelopeBlocks::Quantity EnvelopeBlocks::read_quantity(const std::string& name) const {
    const std::string group = "/envelopes/" + name + "/";
    const std::size_t count = rods_.size();
    const std::vector<double> values = file_.rows(group + "value", 0, count, 1);
    const std::vector<double> times = file_.rows(group + "time", 0, count, 1);
    const std::vector<double> points = file_.rows(group + "point", 0, count, 2);
    const std::vector<double> layers = file_.rows(group + "layer", 0, count, 1);
    const std::vector<double> forces = file_.rows(group + "resultants", 0, count, forces_of_place);
    Quantity quantity{name, {}};
    quantity.rows.reserve(numbers_of_place * count);
    for (std::size_t i = 0; i < count; ++i) {
        for (const double number : {values[i], times[i], points[2 * i], points[2 * i + 1], layers[i]})
            quantity.rows.push_back(static_cast<float>(number));
        for (std::size_t j = 0; j < forces_of_place; ++j)
            quantity.rows.push_back(static_cast<float>(forces[forces_of_place * i + j]));
    }
    return quantity;
}

// Of each group of places that follow each other on a rod, those with the largest values of the quantities.
std::vector<std::size_t> EnvelopeBlocks::list_largest(std::size_t group) const {
    std::vector<std::size_t> rows;
    for (std::size_t first = 0; first < rods_.size();) {
        std::size_t end = first;
        while (end < rods_.size() && end < first + group && rods_[end] == rods_[first]) ++end;
        std::vector<std::size_t> largest;
        for (const Quantity& quantity : quantities_) {
            const auto value = [&](std::size_t row) { return quantity.rows[numbers_of_place * row]; };
            std::size_t found = first;
            for (std::size_t row = first; row < end; ++row) {
                if (value(row) > value(found) || std::isnan(value(found))) found = row;
            }
            largest.push_back(found);
        }
        std::sort(largest.begin(), largest.end());
        largest.erase(std::unique(largest.begin(), largest.end()), largest.end());
        rows.insert(rows.end(), largest.begin(), largest.end());
        first = end;
    }
    return rows;
}

std::size_t EnvelopeBlocks::count_bytes_of(std::size_t places) const {
    return (3 + quantities_.size()) * block_frame_bytes + 3 * base64_length(places * sizeof(float)) +
           quantities_.size() * base64_length(places * numbers_of_place * sizeof(float));
}

std::size_t EnvelopeBlocks::count_bytes() const {
    return quantities_.empty() ? 0 : count_bytes_of(kept_.size());
}

std::vector<std::string> EnvelopeBlocks::left_out() const {
    if (kept_.size() == rods_.size()) return {};
    return {fmt::format(
        "Of {} places of envelopes, {} are kept, with the largest values.", rods_.size(), kept_.size())};
}

void EnvelopeBlocks::describe(nlohmann::ordered_json& json) const {
    if (quantities_.empty()) return;
    nlohmann::ordered_json names = nlohmann::ordered_json::array();
    for (const Quantity& quantity : quantities_) names.push_back(quantity.name);
    json["envelopes"] = {{"criterion", file_.text_attribute("/envelopes", "criterion")},
                         {"quantities", names}};
}

void EnvelopeBlocks::write(std::ostream& out) const {
    if (quantities_.empty()) return;
    write_block(out, "envelope-rods", take_envelope<std::int32_t>(rods_, kept_));
    write_block(out, "envelope-places", take_envelope<float>(places_, kept_));
    write_block(out, "envelope-sections", take_envelope<std::int32_t>(sections_, kept_));
    for (const Quantity& quantity : quantities_) {
        std::vector<float> rows;
        for (const std::size_t row : kept_) {
            const auto first = quantity.rows.begin() + static_cast<std::ptrdiff_t>(numbers_of_place * row);
            rows.insert(rows.end(), first, first + numbers_of_place);
        }
        write_block(out, "envelope-" + quantity.name, rows);
    }
}

}  // namespace gxrod
