#include "mesh/line_mesh.hpp"

#include <algorithm>
#include <cerrno>
#include <fstream>
#include <set>
#include <stdexcept>
#include <system_error>
#include <unordered_map>

#include "machine/child_process.hpp"
#include "mesh/gmsh_session.hpp"
#include "mesh/line_mesh_bytes.hpp"

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
    MeshLines lines{group.number, group.name, {}, {}, {}};
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
            if (!known.insert(std::move(nodes)).second) continue;
            add_element(&*first, order, index, lines.nodes);
            lines.curves.push_back(elements.entity);
        }
    }
    return lines;
}

MeshPoints read_points(const GmshSession& session, const GmshSession::Group& group, const NodeIndex& index) {
    MeshPoints points{group.number, group.name, {}};
    for (const std::size_t number : session.nodes_of(group)) points.nodes.push_back(index.at(number));
    return points;
}

// A file of any other beginning Gmsh would take for a geometry script and run.
bool starts_as_mesh(std::ifstream& stream) {
    std::string line;
    std::getline(stream, line);
    return line.starts_with("$MeshFormat") || line.starts_with("$NOD") || line.starts_with("$Comments");
}

void check_file(const std::filesystem::path& file) {
    std::error_code ignored;
    const std::filesystem::file_status status = std::filesystem::status(file, ignored);
    if (std::filesystem::is_directory(status)) throw MeshError("is a folder, expected a mesh");
    // It is read several times; a device can have no end, and a pipe no writer.
    if (std::filesystem::exists(status) && !std::filesystem::is_regular_file(status))
        throw MeshError("is not a regular file, expected a mesh");
    std::ifstream stream(file);
    if (!stream) throw MeshError("cannot be read (" + std::generic_category().message(errno) + ")");
    if (file.extension() == ".msh" && !starts_as_mesh(stream)) {
        throw MeshError("is no mesh; a .msh file starts with $MeshFormat");
    }
}

LineMesh read_with_gmsh(const GmshLibrary& gmsh, const std::filesystem::path& file) {
    GmshSession session(gmsh);
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

constexpr char is_mesh = 'm';
constexpr char is_message = 'e';

// The answer of the child: a mesh, or why there is none.
std::string answer(const GmshLibrary& gmsh, const std::filesystem::path& file) {
    try {
        return is_mesh + write_mesh_bytes(read_with_gmsh(gmsh, file));
    } catch (const MeshError& error) {
        return is_message + std::string(error.what());
    } catch (const std::out_of_range&) {
        return is_message + std::string("an element or a group has a node that the mesh lacks");
    }
}

}  // namespace

// Gmsh crashes on some files that are not meshes, and a geometry script can run programs and write
// files: so it reads in a process of its own, which can do neither.
LineMesh read_line_mesh(const std::filesystem::path& file) {
    constexpr int most_seconds = 600;
    check_file(file);
    const GmshLibrary& gmsh = gmsh_library();
    std::string said;
    try {
        said = run_in_child([&] { return answer(gmsh, file); },
                            {.processor_seconds = most_seconds, .waiting_seconds = 30, .reads_only = true});
    } catch (const ChildError& error) {
        throw MeshError(std::string("Gmsh cannot read it: ") + error.what());
    }
    const std::string_view content = std::string_view(said).substr(std::min<std::size_t>(1, said.size()));
    if (said.empty() || said[0] != is_mesh) throw MeshError(std::string(content));
    return read_mesh_bytes(content);
}

std::string name_of_group(int number, const std::string& name) {
    return name.empty() ? std::to_string(number) : name;
}

}  // namespace gxrod
