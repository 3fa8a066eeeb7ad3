#include "mesh/gmsh_session.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <string_view>

namespace gxrod {

GmshSession::GmshSession(const GmshLibrary& gmsh) : gmsh_(gmsh) {
    int error = 0;
    gmsh_.initialize(0, nullptr, 0, 0, &error);
    if (error == 0) gmsh_.set_number("General.Terminal", 0.0, &error);
    // An exception out of Gmsh's parser would leave the rest of the file to be read before the next one.
    if (error == 0) gmsh_.set_number("General.AbortOnError", 0.0, &error);
    if (error == 0) gmsh_.start_log(&error);
    if (error != 0) throw MeshError("libgmsh does not start");
}

GmshSession::~GmshSession() {
    int ignored = 0;
    // The log would outlive the session.
    gmsh_.stop_log(&ignored);
    gmsh_.finalize(&ignored);
}

std::string GmshSession::messages() const {
    constexpr std::string_view mark = "Error: ";
    constexpr int most = 3;
    int error = 0;
    char** lines = nullptr;
    std::size_t count = 0;
    gmsh_.get_log(&lines, &count, &error);
    std::string errors;
    int found = 0;
    for (std::size_t i = 0; i < count; ++i) {
        const std::string_view line = lines[i];
        if (line.starts_with(mark) && ++found <= most) {
            errors += (errors.empty() ? "" : "; ") + std::string(line.substr(mark.size()));
        }
        gmsh_.release(lines[i]);
    }
    gmsh_.release(lines);
    // It can quote a file that is not text.
    std::replace_if(
        errors.begin(), errors.end(), [](unsigned char letter) { return letter < ' '; }, '?');
    return errors;
}

void GmshSession::check(int error, const std::string& failure) const {
    const std::string said = messages();
    if (error == 0 && said.empty()) return;
    throw MeshError(failure + (said.empty() ? "" : ": " + said));
}

void GmshSession::open(const std::filesystem::path& file) {
    int error = 0;
    gmsh_.open(file.c_str(), &error);
    check(error, "Gmsh cannot read it");
}

void GmshSession::generate_lines() {
    int error = 0;
    gmsh_.generate(1, &error);
    check(error, "Gmsh cannot mesh it");
}

void GmshSession::begin_area() {
    int error = 0;
    gmsh_.add_model("area", &error);
    check(error, "Gmsh has no model");
    loops_.clear();
    lines_.clear();
}

std::vector<int> GmshSession::add_loop(const std::vector<PlanePoint>& corners,
                                       const std::vector<double>& sizes) {
    int error = 0;
    std::vector<int> points, lines;
    for (std::size_t i = 0; i < corners.size() && error == 0; ++i)
        points.push_back(gmsh_.add_point(corners[i].x(), corners[i].y(), 0.0, sizes[i], -1, &error));
    for (std::size_t i = 0; i < points.size() && error == 0; ++i)
        lines.push_back(gmsh_.add_line(points[i], points[(i + 1) % points.size()], -1, &error));
    if (error == 0) loops_.push_back(gmsh_.add_curve_loop(lines.data(), lines.size(), -1, 0, &error));
    check(error, "Gmsh does not take the outline");
    lines_.insert(lines_.end(), lines.begin(), lines.end());
    return lines;
}

void GmshSession::generate_triangles() {
    constexpr double frontal_delaunay = 6.0;
    int error = 0;
    gmsh_.add_plane_surface(loops_.data(), loops_.size(), -1, &error);
    if (error == 0) gmsh_.synchronize(&error);
    for (const int line : lines_) {
        if (error == 0) gmsh_.set_curve_nodes(line, 2, "Progression", 1.0, &error);
    }
    if (error == 0) gmsh_.set_number("Mesh.Algorithm", frontal_delaunay, &error);
    if (error == 0) gmsh_.generate(2, &error);
    check(error, "Gmsh cannot mesh it");
}

std::vector<GmshSession::Group> GmshSession::groups() const {
    int error = 0;
    GmshArray<int> found(gmsh_);
    gmsh_.get_groups(&found.data, &found.count, -1, &error);
    check(error, "its physical groups cannot be read");
    std::vector<Group> groups;
    for (std::size_t i = 0; i + 1 < found.count; i += 2) {
        GmshArray<char> name(gmsh_);
        gmsh_.get_group_name(found.data[i], found.data[i + 1], &name.data, &error);
        check(error, "the name of a physical group cannot be read");
        groups.push_back({found.data[i], found.data[i + 1], name.data == nullptr ? "" : name.data});
    }
    return groups;
}

GmshSession::Nodes GmshSession::nodes() const {
    int error = 0;
    GmshArray<std::size_t> numbers(gmsh_);
    GmshArray<double> coordinates(gmsh_), parameters(gmsh_);
    gmsh_.get_nodes(&numbers.data,
                    &numbers.count,
                    &coordinates.data,
                    &coordinates.count,
                    &parameters.data,
                    &parameters.count,
                    -1,
                    -1,
                    0,
                    0,
                    &error);
    check(error, "its nodes cannot be read");
    Nodes nodes;
    for (std::size_t i = 0; i < numbers.count; ++i) {
        nodes.numbers.push_back(numbers.data[i]);
        nodes.positions.emplace_back(coordinates.data + 3 * i);
    }
    return nodes;
}

std::vector<std::size_t> GmshSession::nodes_of(const Group& group) const {
    int error = 0;
    GmshArray<std::size_t> numbers(gmsh_);
    GmshArray<double> coordinates(gmsh_);
    gmsh_.get_group_nodes(group.dimension,
                          group.number,
                          &numbers.data,
                          &numbers.count,
                          &coordinates.data,
                          &coordinates.count,
                          &error);
    check(error,
          fmt::format("the nodes of group {} cannot be read", name_of_group(group.number, group.name)));
    return {numbers.values().begin(), numbers.values().end()};
}

std::vector<GmshElements> GmshSession::elements_of(const Group& group) const {
    int error = 0;
    GmshArray<int> entities(gmsh_);
    gmsh_.get_group_entities(group.dimension, group.number, &entities.data, &entities.count, &error);
    check(error, "the entities of a physical group cannot be read");
    std::vector<GmshElements> elements;
    for (const int entity : entities.values()) {
        for (GmshElements& some : elements_of_entity(group.dimension, entity))
            elements.push_back(std::move(some));
    }
    return elements;
}

std::vector<GmshElements> GmshSession::elements_of_entity(int dimension, int entity) const {
    int error = 0;
    GmshArray<int> types(gmsh_);
    GmshArray<std::size_t*> numbers(gmsh_), nodes(gmsh_);
    GmshArray<std::size_t> number_counts(gmsh_), node_counts(gmsh_);
    gmsh_.get_elements(&types.data,
                       &types.count,
                       &numbers.data,
                       &number_counts.data,
                       &numbers.count,
                       &nodes.data,
                       &node_counts.data,
                       &nodes.count,
                       dimension,
                       entity,
                       &error);
    check(error, "its elements cannot be read");
    std::vector<GmshElements> elements;
    for (std::size_t i = 0; i < types.count; ++i) {
        elements.push_back({types.data[i],
                            {nodes.data[i], nodes.data[i] + node_counts.data[i]},
                            {numbers.data[i], numbers.data[i] + number_counts.data[i]},
                            entity});
        gmsh_.release(numbers.data[i]);
        gmsh_.release(nodes.data[i]);
    }
    return elements;
}

std::vector<GmshSession::ElementData> GmshSession::element_data() const {
    int error = 0;
    GmshArray<int> views(gmsh_);
    gmsh_.get_views(&views.data, &views.count, &error);
    check(error, "its data cannot be read");
    std::vector<ElementData> all;
    for (std::size_t view = 0; view < views.count; ++view) {
        GmshArray<char> name(gmsh_), of_what(gmsh_);
        GmshArray<std::size_t> numbers(gmsh_), counts(gmsh_);
        GmshArray<double*> values(gmsh_);
        double time = 0.0;
        int components = 0;
        gmsh_.get_text(fmt::format("View[{}].Name", view).c_str(), &name.data, &error);
        if (error == 0)
            gmsh_.get_view_data(views.data[view],
                                0,
                                &of_what.data,
                                &numbers.data,
                                &numbers.count,
                                &values.data,
                                &counts.data,
                                &values.count,
                                &time,
                                &components,
                                &error);
        check(error, "its data cannot be read");
        ElementData data{name.data == nullptr ? "" : name.data, {}, {}};
        for (std::size_t i = 0; i < values.count; ++i) {
            data.numbers.push_back(numbers.data[i]);
            data.values.emplace_back(values.data[i], values.data[i] + counts.data[i]);
            gmsh_.release(values.data[i]);
        }
        const bool is_of_elements = std::string_view(of_what.data).starts_with("Element");
        if (is_of_elements && components == 1) all.push_back(std::move(data));
    }
    return all;
}

}  // namespace gxrod
