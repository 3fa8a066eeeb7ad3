#include "mesh/triangles/triangle_file.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <cerrno>
#include <cstring>
#include <fstream>
#include <map>
#include <set>
#include <sstream>
#include <system_error>
#include <unordered_map>

#include "machine/child_process.hpp"
#include "mesh/gmsh_session.hpp"
#include "mesh/triangles/stl_file.hpp"

namespace gxrod {

std::string read_mesh_file(const std::filesystem::path& file) {
    std::error_code ignored;
    const std::filesystem::file_status status = std::filesystem::status(file, ignored);
    if (std::filesystem::is_directory(status)) throw MeshError("is a folder, expected a mesh");
    if (std::filesystem::exists(status) && !std::filesystem::is_regular_file(status))
        throw MeshError("is not a regular file, expected a mesh");
    std::ifstream stream(file, std::ios::binary);
    if (!stream) throw MeshError("cannot be read (" + std::generic_category().message(errno) + ")");
    std::ostringstream bytes;
    bytes << stream.rdbuf();
    return std::move(bytes).str();
}

namespace {

// Types of elements in two dimensions, by the nodes of the triangles they are cut into.
const std::vector<std::array<std::size_t, 3>>* find_cut(int type, std::size_t& nodes) {
    static const std::vector<std::array<std::size_t, 3>> triangle{{0, 1, 2}},
        quadrangle{{0, 1, 2}, {0, 2, 3}}, six{{0, 3, 5}, {3, 1, 4}, {5, 4, 2}, {3, 4, 5}};
    nodes = type == 2 ? 3 : type == 3 ? 4 : 6;
    return type == 2 ? &triangle : type == 3 ? &quadrangle : type == 9 ? &six : nullptr;
}

std::vector<Corners> read_triangles_with_gmsh(const GmshLibrary& gmsh, const std::filesystem::path& file) {
    GmshSession session(gmsh);
    session.open(file);
    const GmshSession::Nodes nodes = session.nodes();
    std::unordered_map<std::size_t, std::size_t> index;
    for (std::size_t i = 0; i < nodes.numbers.size(); ++i) index[nodes.numbers[i]] = i;
    std::vector<Corners> triangles;
    for (const GmshElements& elements : session.elements_of_entity(2, -1)) {
        std::size_t count = 0;
        const auto* cut = find_cut(elements.type, count);
        if (cut == nullptr)
            throw MeshError(fmt::format(
                "has elements of type {}; expected triangles of 3 or 6 nodes, or quadrangles of 4",
                elements.type));
        for (std::size_t first = 0; first + count <= elements.nodes.size(); first += count) {
            for (const auto& corners : *cut) {
                triangles.emplace_back();
                for (std::size_t i = 0; i < 3; ++i)
                    triangles.back()[i] = nodes.positions[index.at(elements.nodes[first + corners[i]])];
            }
        }
    }
    return triangles;
}

constexpr char has_triangles = 't';
constexpr char has_message = 'e';

std::string answer_triangles(const GmshLibrary& gmsh, const std::filesystem::path& file) {
    try {
        std::string bytes(1, has_triangles);
        for (const Corners& triangle : read_triangles_with_gmsh(gmsh, file))
            for (const Vec3& corner : triangle)
                bytes.append(reinterpret_cast<const char*>(corner.data()), 3 * sizeof(double));
        return bytes;
    } catch (const MeshError& error) {
        return has_message + std::string(error.what());
    } catch (const std::out_of_range&) {
        return has_message + std::string("an element has a node that the mesh lacks");
    }
}

// In a process of its own, as line meshes are.
std::vector<Corners> read_msh(const std::filesystem::path& file) {
    if (const std::string start = read_mesh_file(file).substr(0, 20);
        !start.starts_with("$MeshFormat") && !start.starts_with("$NOD") && !start.starts_with("$Comments"))
        throw MeshError("is no mesh; a .msh file starts with $MeshFormat");
    const GmshLibrary& gmsh = gmsh_library();
    std::string said;
    try {
        said = run_in_child([&] { return answer_triangles(gmsh, file); },
                            {.processor_seconds = 600, .waiting_seconds = 30, .reads_only = true});
    } catch (const ChildError& error) {
        throw MeshError(std::string("Gmsh cannot read it: ") + error.what());
    }
    if (said.empty() || said[0] != has_triangles)
        throw MeshError(said.empty() ? "Gmsh gives nothing" : said.substr(1));
    std::vector<Corners> triangles((said.size() - 1) / (9 * sizeof(double)));
    for (std::size_t t = 0; t < triangles.size(); ++t)
        for (std::size_t i = 0; i < 3; ++i)
            std::memcpy(triangles[t][i].data(),
                        said.data() + 1 + (9 * t + 3 * i) * sizeof(double),
                        3 * sizeof(double));
    return triangles;
}

// Corners at the same place are one.
class Corner {
  public:
    Corner(TriangleMesh& mesh, double scale) : mesh_(mesh), scale_(scale) {}
    int add(const Vec3& given) {
        const Vec3 position = scale_ * given + Vec3::Zero();  // −0 becomes 0
        const auto [found, is_new] = indices_.emplace(std::array{position.x(), position.y(), position.z()},
                                                      static_cast<int>(mesh_.positions.size()));
        if (is_new) mesh_.positions.push_back(position);
        return found->second;
    }

  private:
    TriangleMesh& mesh_;
    double scale_;
    std::map<std::array<double, 3>, int> indices_;
};

// A triangle as low as this, next to its longest side, is a line as files have them.
bool has_area(const TriangleMesh& mesh, const std::array<int, 3>& corners) {
    constexpr double least_height = 1e-6;
    const auto side = [&](std::size_t i) -> Vec3 {
        return mesh.positions[static_cast<std::size_t>(corners[(i + 1) % 3])] -
               mesh.positions[static_cast<std::size_t>(corners[i])];
    };
    const double longest = std::max({side(0).norm(), side(1).norm(), side(2).norm()});
    return side(0).cross(side(1)).norm() > least_height * longest * longest;
}

std::size_t count_open_edges(const TriangleMesh& mesh) {
    std::map<std::pair<int, int>, int> edges;
    for (const std::array<int, 3>& corners : mesh.triangles)
        for (std::size_t i = 0; i < 3; ++i) ++edges[std::minmax(corners[i], corners[(i + 1) % 3])];
    return static_cast<std::size_t>(
        std::ranges::count_if(edges, [](const auto& edge) { return edge.second == 1; }));
}

TriangleMesh join(const std::vector<Corners>& triangles, double scale) {
    TriangleMesh mesh;
    Corner corner(mesh, scale);
    std::set<std::array<int, 3>> known;
    for (std::size_t t = 0; t < triangles.size(); ++t) {
        std::array<int, 3> corners{};
        for (std::size_t i = 0; i < 3; ++i) corners[i] = corner.add(triangles[t][i]);
        std::array<int, 3> sorted = corners;
        std::ranges::sort(sorted);
        if (!has_area(mesh, corners)) {
            ++mesh.left_out;
        } else if (!known.insert(sorted).second) {
            ++mesh.repeated;
        } else {
            mesh.triangles.push_back(corners);
            mesh.numbers.push_back(static_cast<int>(t) + 1);
        }
    }
    if (mesh.triangles.empty()) throw MeshError("has no triangles");
    mesh.open_edges = count_open_edges(mesh);
    return mesh;
}

}  // namespace

bool is_stl(const std::filesystem::path& file) {
    std::string extension = file.extension().string();
    std::ranges::transform(
        extension, extension.begin(), [](unsigned char letter) { return std::tolower(letter); });
    return extension == ".stl";
}

TriangleMesh read_triangle_mesh(const std::filesystem::path& file, double scale) {
    const bool is_msh = file.extension() == ".msh";
    if (!is_msh && !is_stl(file)) throw MeshError("has another ending than .stl and .msh");
    return join(is_msh ? read_msh(file) : read_stl(read_mesh_file(file)), scale);
}

}  // namespace gxrod
