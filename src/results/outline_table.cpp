#include "results/outline_table.hpp"

#include <array>
#include <string>
#include <vector>

namespace gxrod {
namespace {

using OutlineNumbers = std::vector<std::int64_t>;

// The outlines of all bodies one after the other, as columns of the file.
struct OutlineColumns {
    std::vector<double> points;
    OutlineNumbers triangles, lines;  // rows of points
    OutlineNumbers first_point{0}, first_triangle{0}, first_line{0};
    OutlineNumbers given;

    void append(const Body& body, const BodyOutline& outline) {
        const std::int64_t start = first_point.back();
        for (const Vec3& point : outline.points) {
            const Vec3 turned = body.attitude * point;
            points.insert(points.end(), turned.begin(), turned.end());
        }
        for (const std::array<int, 3>& corners : outline.triangles)
            for (const int corner : corners) triangles.push_back(start + corner);
        for (const std::array<int, 2>& ends : outline.lines)
            for (const int end : ends) lines.push_back(start + end);
        first_point.push_back(static_cast<std::int64_t>(points.size() / 3));
        first_triangle.push_back(static_cast<std::int64_t>(triangles.size() / 3));
        first_line.push_back(static_cast<std::int64_t>(lines.size() / 2));
        given.push_back(outline.is_given ? 1 : 0);
    }
};

void write_columns(const Hdf5Handle& group, const OutlineColumns& columns) {
    const auto write = [&](const char* name, const char* sentence, const OutlineNumbers& values) {
        write_dataset(group, {name, sentence, "none", "1"}, std::span<const std::int64_t>(values));
    };
    const auto write_corners =
        [&](const char* name, const char* sentence, hsize_t corners, const OutlineNumbers& values) {
            const std::array<hsize_t, 2> size{values.size() / corners, corners};
            write_dataset(group,
                          {name, sentence, "none", "1"},
                          std::span<const hsize_t>(size),
                          std::span<const std::int64_t>(values));
        };
    const std::array<hsize_t, 2> size{columns.points.size() / 3, 3};
    write_dataset(group,
                  {"outline", "corners, from the point of the body, at t = 0", "spatial", "length"},
                  std::span<const hsize_t>(size),
                  std::span<const double>(columns.points));
    write_corners("triangles", "surface: rows of outline", 3, columns.triangles);
    write_corners("lines", "edges: rows of outline", 2, columns.lines);
    write("outline_offsets", "where each body begins in outline", columns.first_point);
    write("triangle_offsets", "where each body begins in triangles", columns.first_triangle);
    write("line_offsets", "where each body begins in lines", columns.first_line);
    write("given", "1 if the deck has its looks, 0 if they follow from mass and inertia", columns.given);
}

}  // namespace

void write_outline_table(const Hdf5Handle& root, const Model& model, std::span<const BodyOutline> outlines) {
    // A list of more names would not be read.
    if (outlines.empty() || outlines.size() > most_texts || has_link(root, "bodies")) return;
    const Hdf5Handle group = require_group(root, "bodies");
    std::vector<std::string> names;
    OutlineNumbers points;
    OutlineColumns columns;
    for (const BodyOutline& outline : outlines) {
        const Body& body = model.bodies[static_cast<std::size_t>(outline.body)];
        names.push_back(body.name);
        points.push_back(body.node);
        columns.append(body, outline);
    }
    write_dataset(
        group, {"name", "of each, as the deck has it", "none", ""}, std::span<const std::string>(names));
    write_dataset(group,
                  {"point", "point of /VTKHDF that carries it", "none", "1"},
                  std::span<const std::int64_t>(points));
    write_columns(group, columns);
}

}  // namespace gxrod
