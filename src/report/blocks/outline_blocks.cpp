#include "report/blocks/outline_blocks.hpp"

#include <algorithm>
#include <array>
#include <nlohmann/json.hpp>

#include "report/blocks/data_blocks.hpp"

namespace gxrod {

OutlineBlocks::OutlineBlocks(const std::vector<BodyOutline>& outlines, std::size_t most, std::size_t room) {
    std::size_t points = 0, triangles = 0, lines = 0;
    for (const BodyOutline& outline : outlines) {
        if (!outline.is_given || static_cast<std::size_t>(outline.body) >= most) continue;
        drawn_.push_back(&outline);
        points += outline.points.size();
        triangles += outline.triangles.size();
        lines += outline.lines.size();
    }
    if (drawn_.empty()) return;
    bytes_ = 3 * block_frame_bytes + base64_length(3 * points * sizeof(float)) +
             base64_length(3 * triangles * sizeof(std::int32_t)) +
             base64_length(2 * lines * sizeof(std::int32_t));
    if (bytes_ <= room) return;
    left_out_ = fmt::format("Looks of bodies are not drawn: they would take {:.1f} MB.",
                            static_cast<double>(bytes_) / 1e6);
    drawn_.clear();
    bytes_ = 0;
}

void OutlineBlocks::describe(nlohmann::ordered_json& bodies) const {
    std::array<std::size_t, 3> at{};
    for (const BodyOutline* outline : drawn_) {
        const std::array<std::size_t, 3> counts{
            outline->points.size(), outline->triangles.size(), outline->lines.size()};
        double reach = 0.0;
        for (const Vec3& point : outline->points) reach = std::max(reach, point.norm());
        nlohmann::ordered_json& body = bodies[static_cast<std::size_t>(outline->body)];
        body["reach"] = reach;
        body["outline"] = nlohmann::ordered_json::array();
        for (std::size_t i = 0; i < at.size(); ++i) {
            body["outline"].push_back({at[i], at[i] + counts[i]});
            at[i] += counts[i];
        }
    }
}

void OutlineBlocks::write(std::ostream& out) const {
    if (drawn_.empty()) return;
    std::vector<float> points;
    std::vector<std::int32_t> triangles, lines;
    for (const BodyOutline* outline : drawn_) {
        for (const Vec3& point : outline->points)
            for (const double x : point) points.push_back(static_cast<float>(x));
        for (const std::array<int, 3>& corners : outline->triangles)
            triangles.insert(triangles.end(), corners.begin(), corners.end());
        for (const std::array<int, 2>& ends : outline->lines)
            lines.insert(lines.end(), ends.begin(), ends.end());
    }
    write_block(out, "outline-points", points);
    write_block(out, "outline-triangles", triangles);
    write_block(out, "outline-lines", lines);
}

}  // namespace gxrod
