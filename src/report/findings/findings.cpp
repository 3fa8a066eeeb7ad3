#include "report/findings/findings.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <nlohmann/json.hpp>

#include "report/base64.hpp"
#include "report/blocks/data_blocks.hpp"
#include "report/findings/mode_json.hpp"
#include "report/findings/sweep_json.hpp"
#include "results/shape_file.hpp"

namespace gxrod {

using Json = nlohmann::ordered_json;

namespace {

constexpr std::size_t vector_bytes = 3 * sizeof(float);
constexpr std::size_t blocks_of_shapes = 6;

}  // namespace

Findings::Findings(const Hdf5Reader& file,
                   const std::filesystem::path& results,
                   const std::vector<StepChart>& charts,
                   const ReportContent& content,
                   std::size_t bytes)
    : file_(file),
      stages_(list_stages(file)),
      times_(stages_.empty() ? std::vector<double>{} : file.rows("/histories/time", 0, content.steps, 1)),
      path_(file, stages_, charts, content.steps, bytes / 10) {
    std::vector<const FoundStage*> responses;
    for (const FoundStage& stage : stages_) {
        if (ResponseData::has_any(file, stage)) responses.push_back(&stage);
    }
    for (const FoundStage* stage : responses)
        responses_.emplace_back(file, *stage, bytes / 10 / responses.size());
    if (!times_.empty()) add_shapes(results, content, bytes);
}

void Findings::add_shapes(const std::filesystem::path& results,
                          const ReportContent& content,
                          std::size_t bytes) {
    for (const FoundStage& stage : stages_) {
        std::vector<double> times;
        if (has_modes(file_, stage) || has_sweep(file_, stage)) {
            const std::size_t row = std::min(find_row_of_state(file_, stage), times_.size() - 1);
            times.assign(
                has_sweep(file_, stage) ? count_sweep_shapes(file_, stage) : count_modes(file_, stage),
                times_[row]);
        } else {
            for (const std::size_t row : path_.list_rows_of_shapes(stage))
                times.push_back(times_[std::min(row, times_.size() - 1)]);
        }
        if (times.empty()) continue;
        shapes_.push_back(
            {stage.name, StageShapes(file_, shape_file_path(results, stage.name), times, content)});
    }
    limit_shapes(content, bytes);
}

// So that they fit into three tenths of the bytes or, where frames are few, into what these leave of six
// tenths.
void Findings::limit_shapes(const ReportContent& content, std::size_t bytes) {
    constexpr std::size_t most_elements = 30000;  // more are joined to straight pieces
    constexpr std::size_t vectors_of_frame = 8;   // at most, of a node and an element
    const auto nodes = static_cast<std::size_t>(content.topology->nodes);
    const bool is_joined = content.topology->rod_cells.size() > most_elements;
    const std::size_t vector =
        base64_length(vector_bytes * (is_joined ? std::min(nodes, most_elements) : nodes));
    const std::size_t frames = content.frames * vectors_of_frame * vector;
    const std::size_t room = std::max(bytes / 10 * 3, bytes / 10 * 6 - std::min(frames, bytes / 10 * 6));
    const std::size_t all = count_shape_vectors() * vector;
    if (all <= room) return;
    for (ShapesOfStage& of_stage : shapes_) {
        const std::size_t kept = of_stage.shapes.kept() * room / all;
        of_stage.shapes.keep(std::max<std::size_t>(kept, 1));
    }
}

std::size_t Findings::count_bytes() const {
    std::size_t bytes = path_.count_bytes() + shapes_.size() * blocks_of_shapes * (block_frame_bytes + 4);
    for (const ResponseData& response : responses_) bytes += response.count_bytes();
    return bytes;
}

std::size_t Findings::count_shape_vectors() const {
    std::size_t vectors = 0;
    for (const ShapesOfStage& of_stage : shapes_) vectors += of_stage.shapes.count_vectors();
    return vectors;
}

std::vector<std::string> Findings::left_out() const {
    std::vector<std::string> sentences{path_.left_out()};
    for (const ResponseData& response : responses_) sentences.push_back(response.left_out());
    for (const auto& [stage, shapes] : shapes_) {
        if (!shapes.why_none().empty() || shapes.kept() == shapes.count()) continue;
        sentences.push_back(fmt::format(
            "Of {} shapes of stage {}, the first {} move.", shapes.count(), stage, shapes.kept()));
    }
    std::erase(sentences, "");
    return sentences;
}

Json Findings::describe_swing(const std::string& stage) const {
    for (std::size_t i = 0; i < shapes_.size(); ++i) {
        if (shapes_[i].stage == stage) return shapes_[i].shapes.describe(i);
    }
    return nullptr;
}

void Findings::describe(Json& json) const {
    const auto add = [&](const char* name, Json list) {
        if (!list.empty()) json[name] = std::move(list);
    };
    add("stages", describe_stages(file_, stages_, times_));
    Json paths = path_.describe();
    for (Json& path : paths) path["swing"] = describe_swing(path.at("stage"));
    add("paths", std::move(paths));
    Json modes = Json::array();
    for (const FoundStage& stage : stages_) {
        if (!has_modes(file_, stage)) continue;
        modes.push_back(describe_modes(file_, stage));
        modes.back()["swing"] = describe_swing(stage.name);
    }
    add("modes", std::move(modes));
    Json responses = Json::array();
    for (std::size_t i = 0; i < responses_.size(); ++i) responses.push_back(responses_[i].describe(i));
    add("responses", std::move(responses));
    Json sweeps = Json::array();
    for (const FoundStage& stage : stages_) {
        if (!has_sweep(file_, stage)) continue;
        sweeps.push_back(describe_sweep(file_, stage));
        sweeps.back()["swing"] = describe_swing(stage.name);
    }
    add("sweeps", std::move(sweeps));
}

void Findings::write(const ReportPlan& plan, std::ostream& out) const {
    path_.write(out);
    for (std::size_t i = 0; i < responses_.size(); ++i) responses_[i].write(i, out);
    for (std::size_t i = 0; i < shapes_.size(); ++i) shapes_[i].shapes.write(i, plan, out);
}

}  // namespace gxrod
