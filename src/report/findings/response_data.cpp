#include "report/findings/response_data.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>
#include <set>

#include "report/blocks/data_blocks.hpp"

namespace gxrod {

namespace {

constexpr double least_part = 1e-9;  // of the largest amplitude: smaller components are left out

// Quantities of a response, with the names of histories that ask for them.
struct AnsweredQuantity {
    const char* name;
    std::vector<const char*> asked_as;
};
const std::vector<AnsweredQuantity>& list_quantities() {
    static const std::vector<AnsweredQuantity> quantities{
        {"displacement", {"displacement", "position"}},
        {"rotation_vector", {"rotation_vector", "quaternion", "orientation"}},
        {"reaction_force", {"reaction_force"}},
        {"reaction_moment", {"reaction_moment"}}};
    return quantities;
}

bool is_asked_for(const Hdf5Reader& file, const std::string& history, const AnsweredQuantity& quantity) {
    const std::string group = "/histories/" + history;
    return std::any_of(quantity.asked_as.begin(), quantity.asked_as.end(), [&](const char* name) {
        return file.has(group + "/" + name);
    });
}

}  // namespace

bool ResponseData::has_any(const Hdf5Reader& file, const FoundStage& stage) {
    return stage.has(file, "histories") && stage.has(file, "omega");
}

ResponseData::ResponseData(const Hdf5Reader& file, const FoundStage& stage, std::size_t bytes)
    : stage_(stage), omegas_(file.numbers(stage.group() + "/omega")) {
    for (const std::string& history : file.members(stage.group() + "/histories")) {
        for (const AnsweredQuantity& quantity : list_quantities()) {
            if (is_asked_for(file, history, quantity)) add_curves(file, history, quantity.name);
        }
    }
    choose_rows(bytes);
}

void ResponseData::add_curves(const Hdf5Reader& file,
                              const std::string& history,
                              const std::string& quantity) {
    const std::string dataset = fmt::format("{}/histories/{}/{}", stage_.group(), history, quantity);
    const std::vector<double> values = file.rows(dataset, 0, omegas_.size(), 6);
    std::vector<Curve> curves;
    double largest = 0.0;
    std::array<double, 3> sizes{};
    for (std::size_t component = 0; component < 3; ++component) {
        Curve curve{history, quantity, file.text_attribute(dataset, "dimension"), component, {}, {}};
        for (std::size_t row = 0; row < omegas_.size(); ++row) {
            curve.real.push_back(values[6 * row + 2 * component]);
            curve.imaginary.push_back(values[6 * row + 2 * component + 1]);
            const double size = std::hypot(curve.real.back(), curve.imaginary.back());
            if (std::isfinite(size)) sizes[component] = std::max(sizes[component], size);
        }
        largest = std::max(largest, sizes[component]);
        curves.push_back(std::move(curve));
    }
    for (std::size_t component = 0; component < 3; ++component) {
        if (sizes[component] > least_part * largest) curves_.push_back(std::move(curves[component]));
    }
}

std::size_t ResponseData::bytes_of_row() const {
    return base64_length(sizeof(double) + 2 * curves_.size() * sizeof(float));
}

// Of each group of frequencies the first and, of each curve, that with the largest amplitude.
void ResponseData::choose_rows(std::size_t bytes) {
    const std::size_t count = omegas_.size();
    const std::size_t most = std::max<std::size_t>(bytes / bytes_of_row(), 20);
    const std::size_t group = count <= most ? 1 : (count * (curves_.size() + 1)) / most + 1;
    std::set<std::size_t> kept;
    for (std::size_t first = 0; first < count; first += group) {
        kept.insert(first);
        for (const Curve& curve : curves_) {
            std::size_t peak = first;
            double largest = 0.0;
            for (std::size_t row = first; row < std::min(first + group, count); ++row) {
                const double size = std::hypot(curve.real[row], curve.imaginary[row]);
                if (size > largest) {
                    largest = size;
                    peak = row;
                }
            }
            kept.insert(peak);
        }
    }
    if (count > 0) kept.insert(count - 1);
    rows_.assign(kept.begin(), kept.end());
}

std::size_t ResponseData::count_bytes() const {
    return rows_.size() * bytes_of_row() + 2 * (block_frame_bytes + 4);
}

std::string ResponseData::left_out() const {
    if (rows_.size() == omegas_.size()) return "";
    return fmt::format("Of {} frequencies of stage {}, charts have {}, with every peak.",
                       omegas_.size(),
                       stage_.name,
                       rows_.size());
}

nlohmann::ordered_json ResponseData::describe(std::size_t block) const {
    nlohmann::ordered_json curves = nlohmann::ordered_json::array();
    for (const Curve& curve : curves_) {
        curves.push_back({{"history", curve.history},
                          {"quantity", curve.quantity},
                          {"component", curve.component},
                          {"dimension", curve.dimension}});
    }
    return {{"stage", stage_.name}, {"block", block}, {"curves", curves}};
}

void ResponseData::write(std::size_t block, std::ostream& out) const {
    std::vector<double> omegas;
    for (const std::size_t row : rows_) omegas.push_back(omegas_[row]);
    write_block(out, fmt::format("response-omegas-{}", block), omegas);
    write_block(out, fmt::format("response-values-{}", block), [&](Base64Writer& base64) {
        for (const Curve& curve : curves_) {
            for (const auto* part : {&curve.real, &curve.imaginary}) {
                std::vector<float> values;
                for (const std::size_t row : rows_) values.push_back(static_cast<float>((*part)[row]));
                base64.write(std::span<const float>(values));
            }
        }
    });
}

}  // namespace gxrod
