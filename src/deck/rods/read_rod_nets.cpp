#include "deck/rods/read_rod_nets.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <fstream>
#include <iterator>
#include <optional>

#include "deck/rods/rod_table.hpp"
#include "deck/schema/suggestion.hpp"

namespace gxrod {
namespace {

std::string read_bytes(const std::filesystem::path& file) {
    std::ifstream stream(file, std::ios::binary);
    return {std::istreambuf_iterator<char>(stream), {}};
}

std::optional<int> read_number(const std::string& text) {
    int number = 0;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number);
    return error == std::errc() && end == text.data() + text.size() ? std::optional(number) : std::nullopt;
}

// A group that a deck asks for: by its name, or by its number.
struct GroupKey {
    std::string text;
    std::optional<int> number;

    bool names(int number_of_group, const std::string& name) const {
        const bool has_number = number == number_of_group;
        return text.empty() ? has_number : text == name || (name.empty() && has_number);
    }
    std::string quoted() const {
        return text.empty() ? std::to_string(*number) : fmt::format("\"{}\"", text);
    }
};

GroupKey group_key_of(const RodMeshTable& table) {
    if (const auto* number = std::get_if<long>(&table.group)) return {"", static_cast<int>(*number)};
    const std::string& text = std::get<std::string>(table.group);
    return {text, read_number(text)};
}

template <class Group>
const Group* find_group(const std::vector<Group>& groups, const GroupKey& key) {
    const auto found = std::find_if(groups.begin(), groups.end(), [&](const Group& group) {
        return key.names(group.number, group.name);
    });
    return found == groups.end() ? nullptr : &*found;
}

// Why no group of lines goes by the key.
std::string explain_no_lines(const LineMesh& mesh, const GroupKey& key) {
    const char* what = nullptr;
    if (find_group(mesh.points, key) != nullptr) what = "points";
    if (const MeshRegion* region = find_group(mesh.regions, key)) {
        what = region->dimension == 2 ? "surfaces" : "volumes";
    }
    if (what != nullptr)
        return fmt::format("physical group {} is one of {}; expected lines", key.quoted(), what);
    std::vector<std::string> known;
    for (const MeshLines& lines : mesh.lines) known.push_back(name_of_group(lines.number, lines.name));
    std::string hint = did_you_mean(key.text, known);
    if (hint.empty()) {
        hint = known.empty() ? "; the mesh has no physical group of lines"
                             : "; the mesh has " + plain_list(known);
    }
    return fmt::format("no physical group {} of lines{}", key.quoted(), hint);
}

// Why the elements of a group cannot make a rod, or "".
std::string explain_elements(const MeshLines& lines) {
    const std::string name = name_of_group(lines.number, lines.name);
    if (lines.orders.empty()) return fmt::format("physical group {} has no line elements", name);
    if (lines.orders.size() > 1) {
        return fmt::format("physical group {} has elements of orders {}; expected one order",
                           name,
                           fmt::join(lines.orders, " and "));
    }
    if (lines.nodes.empty()) {
        return fmt::format(
            "physical group {} has elements of order {}; expected order 1 to 3", name, lines.orders.front());
    }
    return "";
}

NetPoints find_points(const LineMesh& mesh, const RodNet& net) {
    std::map<std::size_t, int> positions;
    for (std::size_t i = 0; i < net.mesh_nodes.size(); ++i)
        positions[net.mesh_nodes[i]] = static_cast<int>(i);
    NetPoints points;
    for (const MeshPoints& group : mesh.points) {
        NetPoints::Group named{name_of_group(group.number, group.name), {}};
        for (const std::size_t node : group.nodes) {
            if (const auto found = positions.find(node); found != positions.end())
                named.positions.push_back(found->second);
        }
        if (!named.positions.empty()) points.groups.push_back(named);
    }
    if (net.is_line()) points.fractions = net.fractions();
    return points;
}

class NetReader {
  public:
    NetReader(const MeshFiles& files, FaultList& faults, std::vector<MeshRecord>& records)
        : files_(files), faults_(faults), records_(records) {}

    std::optional<NamedNet> read(const RodTable& rod) {
        const RodMeshTable& table = *rod.mesh;
        const LineMesh* mesh = find_mesh(table);
        if (mesh == nullptr) return std::nullopt;
        const GroupKey key = group_key_of(table);
        const MeshLines* lines = find_group(mesh->lines, key);
        const std::string reason = lines == nullptr ? explain_no_lines(*mesh, key) : explain_elements(*lines);
        if (!reason.empty()) {
            add(table, &table.group, reason);
            return std::nullopt;
        }
        if (const int order = lines->orders.front(); order > 1 && rod.gives(rod.order)) {
            faults_.add(
                rod.place_of(&rod.order),
                rod.path_of(&rod.order),
                fmt::format("the mesh has curved elements, of order {}, which keep it; expected the key "
                            "left out, or a mesh of order 1",
                            order));
            return std::nullopt;
        }
        try {
            RodNet net = make_rod_net(*mesh, *lines, static_cast<int>(rod.order));
            NetPoints points = find_points(*mesh, net);
            return NamedNet{std::move(net), std::move(points)};
        } catch (const MeshError& error) {
            add(table, &table.group, error.what());
            return std::nullopt;
        }
    }

  private:
    void add(const RodMeshTable& table, const void* field, const std::string& message) {
        faults_.add(table.place_of(field), table.path_of(field), message);
    }

    // Several rods may be groups of one file. nullptr if it cannot be read.
    const LineMesh* find_mesh(const RodMeshTable& table) {
        const std::filesystem::path path = files_.find(table.file);
        auto found = meshes_.find(path);
        if (found == meshes_.end()) {
            std::optional<LineMesh> mesh;
            try {
                mesh = read_line_mesh(path);
                records_.push_back({table.file, read_bytes(path)});
            } catch (const MeshError& error) {
                add(table, &table.file, fmt::format("{}: {}", path.string(), error.what()));
            }
            found = meshes_.emplace(path, std::move(mesh)).first;
        }
        return found->second ? &*found->second : nullptr;
    }

    const MeshFiles& files_;
    FaultList& faults_;
    std::vector<MeshRecord>& records_;
    std::map<std::filesystem::path, std::optional<LineMesh>> meshes_;
};

}  // namespace

RodNets read_rod_nets(const CheckedTable& deck,
                      const MeshFiles& files,
                      FaultList& faults,
                      std::vector<MeshRecord>& records) {
    NetReader reader(files, faults, records);
    RodNets nets;
    const auto rods = rods_of(deck);
    for (std::size_t i = 0; i < rods.size(); ++i) {
        if (!rods[i].get().mesh) continue;
        if (auto net = reader.read(rods[i])) nets.emplace(static_cast<int>(i), *net);
    }
    return nets;
}

std::map<int, NetPoints> points_of(const RodNets& nets) {
    std::map<int, NetPoints> points;
    for (const auto& [rod, net] : nets) points.emplace(rod, net.points);
    return points;
}

}  // namespace gxrod
