#include "deck/mesh/line_mesh.hpp"

#include <algorithm>
#include <cerrno>
#include <fstream>
#include <set>
#include <system_error>
#include <unordered_map>

#include "deck/mesh/gmsh_session.hpp"

namespace gxrod {
namespace {

using NodeIndex = std::unordered_map<std::size_t, std::size_t>;  // from Gmsh's numbers

constexpr int highest_order = 3;

// The order of a type of line elements, as the MSH format numbers them.
int order_of(int type) {
    switch (type) {
        case 1:
            return 1;
        case 8:
            return 2;
        case 26:
            return 3;
        case 27:
            return 4;
        case 28:
            return 5;
        default:
            return 6;  // types 62 to 66: orders 6 to 10
    }
}

// Gmsh has the ends of an element first.
void add_element(const std::size_t* numbers,
                 int order,
                 const NodeIndex& index,
                 std::vector<std::size_t>& nodes) {
    nodes.push_back(index.at(numbers[0]));
    for (int i = 2; i <= order; ++i) nodes.push_back(index.at(numbers[i]));
    nodes.push_back(index.at(numbers[1]));
}

MeshLines read_lines(const GmshSession& session, const GmshSession::Group& group, const NodeIndex& index) {
    MeshLines lines{group.number, group.name, {}, {}};
    const std::vector<GmshElements> all = session.elements_of(group);
    std::set<int> orders;
    for (const GmshElements& elements : all) orders.insert(order_of(elements.type));
    lines.orders.assign(orders.begin(), orders.end());
    if (orders.size() != 1 || *orders.begin() > highest_order) return lines;
    const int order = *orders.begin();
    const auto per_element = static_cast<std::size_t>(order) + 1;
    // Version 2 of the format has an element once for each group that it is in.
    std::set<std::vector<std::size_t>> known;
    for (const GmshElements& elements : all) {
        for (auto first = elements.nodes.begin(); first != elements.nodes.end(); first += per_element) {
            std::vector<std::size_t> nodes(first, first + per_element);
            std::sort(nodes.begin(), nodes.end());
            if (known.insert(std::move(nodes)).second) add_element(&*first, order, index, lines.nodes);
        }
    }
    return lines;
}

MeshPoints read_points(const GmshSession& session, const GmshSession::Group& group, const NodeIndex& index) {
    MeshPoints points{group.number, group.name, {}};
    for (const std::size_t number : session.nodes_of(group)) points.nodes.push_back(index.at(number));
    return points;
}

void check_file(const std::filesystem::path& file) {
    std::error_code ignored;
    if (std::filesystem::is_directory(file, ignored)) throw MeshError("is a folder, expected a mesh");
    std::ifstream stream(file);
    if (!stream) throw MeshError("cannot be read (" + std::generic_category().message(errno) + ")");
    // Anything else would be parsed as geometry.
    char first = '\0';
    if (file.extension() == ".msh" && (!(stream >> first) || first != '$')) {
        throw MeshError("is no mesh; a .msh file starts with $MeshFormat");
    }
}

}  // namespace

LineMesh read_line_mesh(const std::filesystem::path& file) {
    check_file(file);
    GmshSession session(gmsh_library());
    session.open(file);
    GmshSession::Nodes nodes = session.nodes();
    if (nodes.numbers.empty()) {
        session.generate_lines();
        nodes = session.nodes();
    }
    NodeIndex index;
    for (std::size_t i = 0; i < nodes.numbers.size(); ++i) index[nodes.numbers[i]] = i;
    LineMesh mesh;
    mesh.positions = std::move(nodes.positions);
    for (const GmshSession::Group& group : session.groups()) {
        if (group.dimension == 0) {
            mesh.points.push_back(read_points(session, group, index));
        } else if (group.dimension == 1) {
            mesh.lines.push_back(read_lines(session, group, index));
        } else {
            mesh.regions.push_back({group.number, group.name, group.dimension});
        }
    }
    return mesh;
}

std::string name_of_group(int number, const std::string& name) {
    return name.empty() ? std::to_string(number) : name;
}

}  // namespace gxrod
