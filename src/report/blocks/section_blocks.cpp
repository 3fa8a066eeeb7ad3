#include "report/blocks/section_blocks.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <nlohmann/json.hpp>
#include <stdexcept>

#include "report/blocks/data_blocks.hpp"

namespace gxrod {

using Json = nlohmann::ordered_json;

namespace {

constexpr std::size_t numbers_of_operator = 36;
constexpr std::size_t blocks_of_section = 5;

// Rows of a table whose numbers are `width` a row, those that are chosen.
template <class Number>
std::vector<Number> take_points(const std::vector<double>& table,
                                std::size_t width,
                                const std::vector<std::int32_t>& chosen) {
    std::vector<Number> rows;
    rows.reserve(width * chosen.size());
    for (const std::int32_t row : chosen) {
        for (std::size_t i = 0; i < width; ++i)
            rows.push_back(static_cast<Number>(table.at(width * static_cast<std::size_t>(row) + i)));
    }
    return rows;
}

}  // namespace

SectionBlocks::SectionBlocks(const Hdf5Reader& file, std::size_t bytes) : file_(file) {
    if (!file.has("/sections/name")) return;
    const std::vector<std::string> names = file.texts("/sections/name");
    for (std::size_t i = 0; i < names.size(); ++i) {
        sections_.push_back(read_cells(i));
        sections_.back().name = names[i];
    }
    kept_ = count_kept(bytes);
    if (kept_ == sections_.size()) return;
    has_all_points_ = false;
    kept_ = count_kept(bytes);
}

SectionBlocks::Cells SectionBlocks::read_cells(std::size_t number) const {
    const std::string group = fmt::format("/sections/{}", number);
    Cells cells;
    cells.all_points = file_.size(group + "/points").at(0);
    cells.width = file_.width(group + "/cell_points");
    std::vector<bool> is_corner(cells.all_points, false);
    for (const double point : file_.numbers(group + "/cell_points")) {
        if (!(point >= 0.0 && point < static_cast<double>(cells.all_points)))
            throw std::runtime_error(group + " has a cell with a point that is not there");
        cells.corners.push_back(static_cast<std::int32_t>(point));
        is_corner[static_cast<std::size_t>(point)] = true;
    }
    for (std::size_t point = 0; point < is_corner.size(); ++point) {
        if (is_corner[point]) cells.corner_points.push_back(static_cast<std::int32_t>(point));
    }
    return cells;
}

std::size_t SectionBlocks::count_bytes_of(const Cells& cells) const {
    const std::size_t points = has_all_points_ ? cells.all_points : cells.corner_points.size();
    return blocks_of_section * block_frame_bytes +
           base64_length(cells.corners.size() * sizeof(std::int32_t)) +
           base64_length(points * 2 * sizeof(float)) + 2 * base64_length(points * sizeof(std::int32_t)) +
           base64_length(points * numbers_of_operator * sizeof(float));
}

// Counts the sections, from the first one on, that fit.
std::size_t SectionBlocks::count_kept(std::size_t bytes) const {
    std::size_t used = 0, kept = 0;
    for (const Cells& cells : sections_) {
        used += count_bytes_of(cells);
        if (used > bytes) break;
        ++kept;
    }
    return kept;
}

std::size_t SectionBlocks::count_bytes() const {
    std::size_t bytes = 0;
    for (std::size_t i = 0; i < kept_; ++i) bytes += count_bytes_of(sections_[i]);
    return bytes;
}

std::vector<std::string> SectionBlocks::left_out() const {
    std::vector<std::string> sentences;
    if (kept_ < sections_.size())
        sentences.push_back(fmt::format("Of {} sections, the first {} are drawn.", sections_.size(), kept_));
    if (!has_all_points_ && kept_ > 0)
        sentences.push_back(
            "Stresses within sections are those at the corners of cells: points on their edges are left "
            "out.");
    return sentences;
}

void SectionBlocks::describe(Json& json) const {
    if (sections_.empty()) return;
    Json list = Json::array();
    for (std::size_t i = 0; i < sections_.size(); ++i) {
        const std::string group = fmt::format("/sections/{}", i);
        list.push_back({{"name", sections_[i].name},
                        {"source", file_.text_attribute(group, "source")},
                        {"layers", file_.texts(group + "/layers")},
                        {"corners", sections_[i].width},
                        {"is_drawn", i < kept_}});
    }
    json["sections"] = std::move(list);
}

void SectionBlocks::write(std::ostream& out) const {
    for (std::size_t i = 0; i < kept_; ++i) write_section(i, out);
}

void SectionBlocks::write_section(std::size_t number, std::ostream& out) const {
    const Cells& cells = sections_[number];
    std::vector<std::int32_t> chosen = cells.corner_points, number_of(cells.all_points, 0);
    if (has_all_points_) {
        chosen.clear();
        for (std::size_t i = 0; i < cells.all_points; ++i) chosen.push_back(static_cast<std::int32_t>(i));
    }
    for (std::size_t i = 0; i < chosen.size(); ++i)
        number_of[static_cast<std::size_t>(chosen[i])] = static_cast<std::int32_t>(i);
    std::vector<std::int32_t> corners;
    for (const std::int32_t corner : cells.corners)
        corners.push_back(number_of[static_cast<std::size_t>(corner)]);
    const std::string group = fmt::format("/sections/{}/", number);
    const auto read = [&](const char* dataset, std::size_t width) {
        return file_.rows(group + dataset, 0, cells.all_points, width);
    };
    const auto name = [&](const char* block) { return fmt::format("section-{}-{}", block, number); };
    write_block(out, name("cells"), corners);
    write_block(out, name("points"), take_points<float>(read("points", 2), 2, chosen));
    write_block(out, name("layers"), take_points<std::int32_t>(read("point_layer", 1), 1, chosen));
    write_block(out, name("singular"), take_points<std::int32_t>(read("is_singular", 1), 1, chosen));
    write_block(
        out,
        name("operators"),
        take_points<float>(read("stress_operator", numbers_of_operator), numbers_of_operator, chosen));
}

}  // namespace gxrod
