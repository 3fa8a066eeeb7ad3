#include "report/model/mesh_picture.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numeric>

namespace gxrod {
namespace {

constexpr double view_size = 360.0;
constexpr double view_margin = 30.0;

// A direction to look along, with the axes to the right and up: what is nearer to the eye is less along it.
struct MeshView {
    int right, up, along;
    double towards;  // the sign of `along` at the eye
    const char* label;
};
constexpr MeshView mesh_views[] = {
    {0, 1, 2, 1.0, "x → y ↑"}, {0, 2, 1, -1.0, "x → z ↑"}, {1, 2, 0, 1.0, "y → z ↑"}};

class MeshSheet {
  public:
    MeshSheet(const TriangleMesh& mesh, const TriangleExamination& examination)
        : mesh_(mesh), examination_(examination) {
        const Vec3 size = examination.high - examination.low;
        scale_ = (view_size - 2.0 * view_margin) / std::max(size.maxCoeff(), 1e-300);
    }

    // Draws one view, its left border at a place of the sheet.
    std::string draw(const MeshView& view, double left) const {
        std::string text = fmt::format("<g transform=\"translate({:.0f},0)\">\n", left);
        std::vector<std::size_t> order(mesh_.triangles.size());
        std::iota(order.begin(), order.end(), 0);
        std::vector<double> nearness;
        for (const std::array<int, 3>& corners : mesh_.triangles)
            nearness.push_back(view.towards * (at(corners[0]) + at(corners[1]) + at(corners[2]))[view.along]);
        std::ranges::stable_sort(order,
                                 [&](std::size_t a, std::size_t b) { return nearness[a] < nearness[b]; });
        for (const std::size_t t : order) text += draw_triangle(view, mesh_.triangles[t]);
        for (const auto& [a, b] : examination_.open_edges)
            text += fmt::format(
                "<polyline points=\"{} {}\" fill=\"none\" stroke=\"#c00\" stroke-width=\"1.5\"/>\n",
                place(view, a),
                place(view, b));
        return text + fmt::format(
                          "<text x=\"{0:.0f}\" y=\"{1:.0f}\" font-size=\"14\" font-family=\"sans-serif\">"
                          "{2}</text>\n</g>\n",
                          view_margin,
                          view_size - 8.0,
                          view.label);
    }

  private:
    const Vec3& at(int corner) const { return mesh_.positions[static_cast<std::size_t>(corner)]; }

    std::string place(const MeshView& view, int corner) const {
        const Vec3 offset = scale_ * (at(corner) - 0.5 * (examination_.low + examination_.high));
        return fmt::format(
            "{:.2f},{:.2f}", 0.5 * view_size + offset[view.right], 0.5 * view_size - offset[view.up]);
    }

    // The lighter the more it faces the eye.
    std::string draw_triangle(const MeshView& view, const std::array<int, 3>& corners) const {
        const Vec3 area = (at(corners[1]) - at(corners[0])).cross(at(corners[2]) - at(corners[0]));
        const double facing = std::abs(area[view.along]) / std::max(area.norm(), 1e-300);
        const int light = 110 + static_cast<int>(std::lround(120.0 * facing));
        return fmt::format(
            "<polygon points=\"{} {} {}\" fill=\"rgb({},{},{})\" stroke=\"#456\" stroke-width=\"0.3\"/>\n",
            place(view, corners[0]),
            place(view, corners[1]),
            place(view, corners[2]),
            light - 20,
            light - 5,
            light + 10);
    }

    const TriangleMesh& mesh_;
    const TriangleExamination& examination_;
    double scale_ = 1.0;
};

}  // namespace

std::string draw_mesh(const TriangleMesh& mesh, const TriangleExamination& examination) {
    const MeshSheet sheet(mesh, examination);
    const double width = view_size * std::size(mesh_views);
    std::string text = fmt::format(
        "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 {0:.0f} {1:.0f}\" width=\"{0:.0f}\" "
        "height=\"{1:.0f}\">\n<rect width=\"100%\" height=\"100%\" fill=\"white\"/>\n",
        width,
        view_size);
    double left = 0.0;
    for (const MeshView& view : mesh_views) {
        text += sheet.draw(view, left);
        left += view_size;
    }
    return text + "</svg>\n";
}

}  // namespace gxrod
