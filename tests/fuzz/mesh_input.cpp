#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstring>

#include "fuzz/expectation.hpp"
#include "fuzz/inputs.hpp"
#include "fuzz/scratch_folder.hpp"
#include "mesh/line_mesh_bytes.hpp"
#include "mesh/rod_net.hpp"

namespace gxrod::fuzz {
namespace {

const ScratchFolder& folder() {
    static const ScratchFolder all;
    return all;
}

// The chains of a net have each element once, and go from node to node.
void check_net(const RodNet& net, const MeshLines& lines) {
    const auto nodes_per_element = static_cast<std::size_t>(net.order) + 1;
    std::size_t elements = 0;
    for (const NetChain& chain : net.chains) {
        elements += chain.elements.size();
        for (std::size_t e = 0; e < chain.elements.size(); ++e) {
            const NetElement& element = chain.elements[e];
            expect(element.nodes.size() == nodes_per_element, "an element has not its nodes");
            expect(std::isfinite(element.length()) && element.length() > 0.0, "an element has no length");
            if (e > 0) {
                expect(chain.elements[e - 1].nodes.back() == element.nodes.front(),
                       "a chain is not one line");
            }
        }
    }
    expect(elements * nodes_per_element == lines.nodes.size(), "an element is lost");
}

void try_lines(const LineMesh& mesh) {
    for (const MeshLines& lines : mesh.lines) {
        if (lines.nodes.empty() || lines.orders.size() != 1) continue;
        try {
            check_net(make_rod_net(mesh, lines), lines);
        } catch (const MeshError&) {
            continue;
        }
    }
}

// Two bytes a node, its place on a coarse grid or, now and then, where numbers end; then the nodes of
// elements.
LineMesh make_mesh(std::string_view input) {
    constexpr std::size_t node_count = 12;
    const auto byte = [&](std::size_t i) {
        return i < input.size() ? static_cast<std::uint8_t>(input[i]) : 0u;
    };
    LineMesh mesh;
    for (std::size_t i = 0; i < node_count; ++i) {
        const unsigned place = byte(1 + 2 * i);
        const double far = byte(2 + 2 * i) == 255 ? 1e200 : byte(2 + 2 * i) == 254 ? 1e-200 : 1.0;
        mesh.positions.emplace_back(far * (place % 8), place / 8 % 8, byte(2 + 2 * i) % 16);
    }
    MeshLines lines{1, "", {1 + static_cast<int>(byte(0) % 3)}, {}};
    const auto per_element = static_cast<std::size_t>(lines.orders.front()) + 1;
    for (std::size_t i = 1 + 2 * node_count; i < input.size(); ++i)
        lines.nodes.push_back(byte(i) % node_count);
    lines.nodes.resize(lines.nodes.size() / per_element * per_element);
    mesh.lines.push_back(lines);
    return mesh;
}

// The bytes that one process hands to another, cut short or changed, are a mesh or an error.
void try_bytes(std::string_view input) {
    LineMesh mesh;
    try {
        mesh = read_mesh_bytes(input);
    } catch (const MeshError&) {
        return;
    }
    expect(write_mesh_bytes(mesh) == input, "a mesh is another one when it is written again");
}

}  // namespace

void try_mesh(std::string_view input) {
    constexpr std::size_t most_bytes = 4096;
    if (input.size() > most_bytes) return;
    if (!input.starts_with('$')) {
        try_bytes(input);
        return try_lines(make_mesh(input));
    }
    try {
        try_lines(read_line_mesh(folder().write("mesh.msh", input)));
    } catch (const MeshError& error) {
        expect(!std::string(error.what()).empty(), "a mesh is refused without a reason");
    }
}

}  // namespace gxrod::fuzz
