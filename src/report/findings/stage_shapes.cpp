#include "report/findings/stage_shapes.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>
#include <system_error>

#include "report/blocks/data_blocks.hpp"
#include "results/file/file_seal.hpp"

namespace gxrod {

namespace {

constexpr const char* digest_name = "deck_sha256";

std::string describe_loss(const std::filesystem::path& path, const std::string& why) {
    return fmt::format("The shapes do not move, because {} {}.", path.filename().string(), why);
}

double find_largest(const Hdf5Reader& file, const std::string& dataset, std::size_t rows) {
    double largest = 0.0;
    constexpr std::size_t most_rows_at_once = 8192;
    for (std::size_t first = 0; first < rows; first += most_rows_at_once) {
        for (const double value : file.rows(dataset, first, std::min(most_rows_at_once, rows - first), 3))
            largest = std::max(largest, std::abs(value));
    }
    return largest;
}

}  // namespace

StageShapes::StageShapes(const Hdf5Reader& results,
                         const std::filesystem::path& path,
                         std::vector<double> times,
                         const ReportContent& content)
    : results_(results),
      times_(std::move(times)),
      nodes_(static_cast<std::size_t>(content.topology->nodes)),
      frame_times_(results.rows("/VTKHDF/Steps/Values", 0, content.frames, 1)) {
    open(path);
    if (!file_) return;
    kept_ = times_.size();
    is_complex_ = find_imaginary_parts();
}

// HDF5 crashes on some damaged files, so only a file that is as it was written is read.
void StageShapes::open(const std::filesystem::path& path) {
    std::error_code ignored;
    if (!std::filesystem::exists(path, ignored)) {
        why_none_ = describe_loss(path, "is not in the folder of the results");
        return;
    }
    try {
        if (look_at_seal(path) != SealState::kept) {
            why_none_ = describe_loss(path, "is not as the run wrote it");
            return;
        }
        Hdf5Reader file(path);
        const bool is_of_run =
            file.text_attribute("/", digest_name) == results_.text_attribute("/", digest_name) &&
            static_cast<std::size_t>(file.count("/VTKHDF/NumberOfPoints")) == nodes_ &&
            file.size("/VTKHDF/PointData/displacement").at(0) == times_.size() * nodes_;
        if (!is_of_run) {
            why_none_ = describe_loss(path, "is of another run");
            return;
        }
        has_one_state_ = file.size("/VTKHDF/Points").at(0) == nodes_;
        file_.emplace(std::move(file));
    } catch (const std::exception&) {
        why_none_ = describe_loss(path, "cannot be read");
    }
}

// Whether they are more than round-off.
bool StageShapes::find_imaginary_parts() const {
    constexpr double round_off = 1e-6;
    const std::size_t rows = times_.size() * nodes_;
    for (const std::string name : {"displacement", "rotation_vector"}) {
        const std::string real = "/VTKHDF/PointData/" + name;
        const std::string imaginary = real + "_imaginary";
        if (!file_->has(imaginary)) return false;
        if (find_largest(*file_, imaginary, rows) > round_off * find_largest(*file_, real, rows)) return true;
    }
    return false;
}

void StageShapes::keep(std::size_t most) { kept_ = std::min(kept_, most); }

std::size_t StageShapes::count_vectors() const {
    return 2 * (kept_ == 0 ? 0 : count_states()) + (is_complex_ ? 4 : 2) * kept_;
}

nlohmann::ordered_json StageShapes::describe(std::size_t block) const {
    const std::size_t states = kept_ == 0 ? 0 : count_states();
    return {
        {"block", block},
        {"kept", kept_},
        {"is_complex", is_complex_},
        {"times", std::vector<double>(times_.begin(), times_.begin() + static_cast<std::ptrdiff_t>(states))},
        {"why_none", why_none_}};
}

std::size_t StageShapes::nearest_frame(double time) const {
    std::size_t nearest = 0;
    for (std::size_t frame = 1; frame < frame_times_.size(); ++frame) {
        if (std::abs(frame_times_[frame] - time) < std::abs(frame_times_[nearest] - time)) nearest = frame;
    }
    return nearest;
}

void StageShapes::write(std::size_t block, const ReportPlan& plan, std::ostream& out) const {
    if (kept_ == 0) return;
    // Of so many blocks of rows, one a node, those of the nodes that are kept.
    const auto write_vectors = [&](const std::string& part,
                                   const Hdf5Reader& file,
                                   const std::string& dataset,
                                   std::size_t count,
                                   auto&& find_first) {
        write_block(out, fmt::format("shape-{}-{}", part, block), [&](Base64Writer& base64) {
            for (std::size_t i = 0; i < count; ++i) {
                const std::vector<double> rows = file.rows(dataset, find_first(i) * nodes_, nodes_, 3);
                std::vector<float> values;
                for (const int node : plan.nodes) {
                    for (std::size_t k = 0; k < 3; ++k)
                        values.push_back(static_cast<float>(rows[3 * static_cast<std::size_t>(node) + k]));
                }
                base64.write(std::span<const float>(values));
            }
        });
    };
    const auto in_order = [](std::size_t i) { return i; };
    const auto frame_of = [&](std::size_t i) { return nearest_frame(times_[i]); };
    const std::string data = "/VTKHDF/PointData/";
    write_vectors("places", *file_, "/VTKHDF/Points", count_states(), in_order);
    write_vectors("attitudes", results_, data + "rotation_vector", count_states(), frame_of);
    write_vectors("moves", *file_, data + "displacement", kept_, in_order);
    write_vectors("turns", *file_, data + "rotation_vector", kept_, in_order);
    if (!is_complex_) return;
    write_vectors("moves-imaginary", *file_, data + "displacement_imaginary", kept_, in_order);
    write_vectors("turns-imaginary", *file_, data + "rotation_vector_imaginary", kept_, in_order);
}

}  // namespace gxrod
