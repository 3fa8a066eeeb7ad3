#include "report/section/section_picture.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "cross_section/stress_measures.hpp"
#include "model/sections/section_centres.hpp"
#include "report/section/colour_scale.hpp"

namespace gxrod {
namespace {

constexpr double picture_width = 720.0;
constexpr double picture_height = 620.0;
constexpr double margin = 40.0;
constexpr double legend_height = 90.0;
constexpr int font_size = 14;

std::string escape(const std::string& text) {
    std::string escaped;
    for (const char letter : text) {
        if (letter == '<')
            escaped += "&lt;";
        else if (letter == '&')
            escaped += "&amp;";
        else
            escaped += letter;
    }
    return escaped;
}

// From the section to the picture, whose second axis points down.
class View {
  public:
    explicit View(const SectionMesh& mesh) : least_(PlanePoint::Zero()), most_(PlanePoint::Zero()) {
        for (const PlanePoint& node : mesh.nodes) {
            least_ = least_.cwiseMin(node);
            most_ = most_.cwiseMax(node);
        }
        const PlanePoint extent = most_ - least_;
        scale_ =
            std::min((picture_width - 2 * margin) / extent.x(), (picture_height - 2 * margin) / extent.y());
    }

    PlanePoint at(const PlanePoint& point) const {
        const PlanePoint middle = 0.5 * (least_ + most_);
        return {picture_width / 2 + scale_ * (point.x() - middle.x()),
                picture_height / 2 - scale_ * (point.y() - middle.y())};
    }
    std::string text(const PlanePoint& point) const {
        const PlanePoint place = at(point);
        return fmt::format("{:.2f},{:.2f}", place.x(), place.y());
    }
    double pixel() const { return 1.0 / scale_; }

  private:
    PlanePoint least_, most_;
    double scale_ = 1.0;
};

// The corners of a cell and the nodes on its edges, around it.
std::vector<std::size_t> list_edge(const SectionCell& cell) {
    const auto p = static_cast<std::size_t>(cell.order);
    std::vector<std::size_t> edge;
    if (cell.shape == CellShape::quad) {
        const std::size_t row = p + 1;
        for (std::size_t i = 0; i < p; ++i) edge.push_back(i);
        for (std::size_t j = 0; j < p; ++j) edge.push_back(p + row * j);
        for (std::size_t i = p; i > 0; --i) edge.push_back(row * p + i);
        for (std::size_t j = p; j > 0; --j) edge.push_back(row * j);
        return edge;
    }
    std::vector<std::size_t> rows{0};
    for (std::size_t j = 0; j < p; ++j) rows.push_back(rows.back() + p + 1 - j);
    for (std::size_t i = 0; i < p; ++i) edge.push_back(i);
    for (std::size_t j = 0; j < p; ++j) edge.push_back(rows[j] + p - j);
    for (std::size_t j = p; j > 0; --j) edge.push_back(rows[j]);
    return edge;
}

// Small triangles between the nodes of a cell.
std::vector<std::array<std::size_t, 3>> list_triangles(const SectionCell& cell) {
    std::vector<std::array<std::size_t, 3>> triangles;
    const auto p = static_cast<std::size_t>(cell.order);
    std::size_t row = 0;
    for (std::size_t j = 0; j < p; ++j) {
        const std::size_t width = cell.shape == CellShape::quad ? p : p - j;
        const std::size_t next = row + width + 1;
        for (std::size_t i = 0; i < width; ++i) {
            triangles.push_back({row + i, row + i + 1, next + i});
            if (cell.shape == CellShape::quad || i + 1 < width)
                triangles.push_back({row + i + 1, next + i + 1, next + i});
        }
        row = next;
    }
    return triangles;
}

std::string draw_edges(const View& view,
                       const SectionMesh& mesh,
                       const SectionCell& cell,
                       const std::string& fill) {
    std::string points;
    for (const std::size_t i : list_edge(cell))
        points += view.text(mesh.nodes[static_cast<std::size_t>(cell.nodes[i])]) + " ";
    return fmt::format("<polygon points=\"{}\" fill=\"{}\"/>\n", points, fill);
}

std::string draw_layers(const View& view, const CrossSection& section) {
    std::string text = "<g stroke=\"#666\" stroke-width=\"0.4\">\n";
    for (const SectionCell& cell : section.mesh.cells)
        text += draw_edges(view, section.mesh, cell, colour_of_group(static_cast<std::size_t>(cell.layer)));
    return text + "</g>\n";
}

struct Stresses {
    std::vector<double> values;  // by point of the field
    std::size_t largest = 0;     // the point of the largest, sharp corners left out
};

Stresses find_stresses(const StressField& field, const Vec6& resultants) {
    Stresses stresses;
    double largest = -1.0;
    for (std::size_t i = 0; i < field.points.size(); ++i) {
        const StressPoint& point = field.points[i];
        stresses.values.push_back(compute_von_mises(point.stress_operator * resultants));
        if (point.is_singular || stresses.values.back() <= largest) continue;
        largest = stresses.values.back();
        stresses.largest = i;
    }
    return stresses;
}

std::string draw_stresses(const View& view,
                          const CrossSection& section,
                          const Stresses& stresses,
                          bool shows_cells) {
    const double largest = stresses.values[stresses.largest];
    std::string text = "<g stroke-width=\"0.5\">\n";
    for (std::size_t c = 0; c < section.mesh.cells.size(); ++c) {
        const std::vector<int>& points = section.stresses.points_of_cells[c];
        for (const auto& corners : list_triangles(section.mesh.cells[c])) {
            std::string places;
            double mean = 0.0;
            for (const std::size_t corner : corners) {
                const auto point = static_cast<std::size_t>(points[corner]);
                places += view.text(section.stresses.points[point].at) + " ";
                mean += stresses.values[point] / 3.0;
            }
            const std::string colour = colour_of_value(largest > 0.0 ? mean / largest : 0.0);
            text +=
                fmt::format("<polygon points=\"{}\" fill=\"{}\" stroke=\"{}\"/>\n", places, colour, colour);
        }
    }
    text += "</g>\n";
    if (!shows_cells) return text;
    text += "<g stroke=\"#fff\" stroke-width=\"0.4\" stroke-opacity=\"0.5\">\n";
    for (const SectionCell& cell : section.mesh.cells) text += draw_edges(view, section.mesh, cell, "none");
    return text + "</g>\n";
}

std::string draw_mark(const View& view, const PlanePoint& at, const char* shape, const char* label) {
    const PlanePoint place = view.at(at);
    return fmt::format(
        "<g transform=\"translate({:.2f},{:.2f})\">{}<text x=\"9\" y=\"-7\" stroke=\"none\" "
        "fill=\"#b00020\">{}</text></g>\n",
        place.x(),
        place.y(),
        shape,
        label);
}

// Lines through a point, `length` pixels to each side, turned about x.
std::string draw_axes(const View& view, const PlanePoint& at, double turn) {
    std::string text;
    constexpr double length = 290.0;
    for (const double angle : {turn, turn + M_PI / 2}) {
        const PlanePoint along = length * view.pixel() * PlanePoint(std::cos(angle), std::sin(angle));
        const PlanePoint from = view.at(at - along), to = view.at(at + along);
        text += fmt::format(
            "<line x1=\"{:.2f}\" y1=\"{:.2f}\" x2=\"{:.2f}\" y2=\"{:.2f}\" stroke=\"#555\" "
            "stroke-width=\"0.8\" stroke-dasharray=\"8 3 2 3\"/>\n",
            from.x(),
            from.y(),
            to.x(),
            to.y());
    }
    return text;
}

std::string draw_centres(const View& view, const CrossSection& section) {
    const SectionCentres centres(section.properties.stiffness, section.properties.mass);
    std::string text = draw_axes(view, centres.tension_centre(), centres.bending().turn);
    text += fmt::format("<g stroke=\"#b00020\" stroke-width=\"1.6\" fill=\"none\" font-size=\"{}\">\n",
                        font_size);
    text += draw_mark(view, PlanePoint::Zero(), "<path d=\"M-5,0H5M0,-5V5\"/>", "");
    text += draw_mark(view, centres.tension_centre(), "<circle r=\"5\"/>", "");
    text += draw_mark(view, centres.shear_centre(), "<path d=\"M-5,-5L5,5M-5,5L5,-5\"/>", "");
    return text + "</g>\n";
}

std::string write_line(double y, const std::string& text) {
    return fmt::format("<text x=\"{}\" y=\"{}\">{}</text>\n", margin, y, escape(text));
}

// A coloured square and the name of each layer, in two rows at most.
std::string list_layers(const std::vector<SectionLayer>& layers) {
    std::string text;
    double x = margin, y = picture_height + 28;
    for (std::size_t i = 0; i < layers.size(); ++i) {
        const double width = 40.0 + 8.0 * static_cast<double>(layers[i].name.size());
        if (x + width > picture_width) {
            if (y > picture_height + 28) return text;
            x = margin;
            y += 24;
        }
        text += fmt::format(
            "<rect x=\"{:.1f}\" y=\"{}\" width=\"14\" height=\"14\" fill=\"{}\"/>"
            "<text x=\"{:.1f}\" y=\"{}\">{}</text>\n",
            x,
            y,
            colour_of_group(i),
            x + 19,
            y + 12,
            escape(layers[i].name));
        x += width;
    }
    return text;
}

std::string draw_legend(const CrossSection& section, const std::optional<Stresses>& stresses) {
    std::string text = fmt::format("<g font-size=\"{}\" fill=\"#222\">\n", font_size);
    text += write_line(picture_height + 12, section.source + ": + origin, ○ tension centre, × shear centre");
    if (!stresses) return text + list_layers(section.mesh.layers) + "</g>\n";
    const StressPoint& worst = section.stresses.points[stresses->largest];
    constexpr int steps = 60;
    constexpr double width = 240.0;
    for (int i = 0; i < steps; ++i)
        text += fmt::format("<rect x=\"{:.2f}\" y=\"{}\" width=\"{:.2f}\" height=\"14\" fill=\"{}\"/>\n",
                            margin + width * i / steps,
                            picture_height + 28,
                            width / steps + 0.5,
                            colour_of_value((i + 0.5) / steps));
    text += fmt::format("<text x=\"{}\" y=\"{}\">von Mises 0 … {:.5g}, largest at ({:.4g}, {:.4g})</text>\n",
                        margin + width + 10,
                        picture_height + 40,
                        stresses->values[stresses->largest],
                        worst.at.x(),
                        worst.at.y());
    return text + "</g>\n";
}

}  // namespace

std::string draw_section(const CrossSection& section, const PictureRequest& request) {
    const View view(section.mesh);
    std::string text = fmt::format(
        "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 {0} {1}\" width=\"{0}\" height=\"{1}\" "
        "font-family=\"sans-serif\">\n<rect width=\"100%\" height=\"100%\" fill=\"#fff\"/>\n",
        picture_width,
        picture_height + legend_height);
    std::optional<Stresses> stresses;
    if (request.resultants) {
        stresses = find_stresses(section.stresses, *request.resultants);
        text += draw_stresses(view, section, *stresses, request.shows_cells);
    } else {
        text += draw_layers(view, section);
    }
    text += draw_centres(view, section);
    if (stresses)
        text += fmt::format(
            "<g stroke=\"#b00020\" stroke-width=\"1.6\" fill=\"none\" font-size=\"{}\">\n{}</g>\n",
            font_size,
            draw_mark(view,
                      section.stresses.points[stresses->largest].at,
                      "<path d=\"M0,-8L7,6H-7Z\"/>",
                      "largest"));
    return text + draw_legend(section, stresses) + "</svg>\n";
}

}  // namespace gxrod
