#include "deck/checks/check_memory.hpp"

#include <fmt/format.h>

#include "deck/rods/rod_table.hpp"
#include "state/motion.hpp"

namespace gxrod {
namespace {

constexpr double bytes_in_gigabyte = 1e9;

// Its nodes, as far as the deck says how many; and which key does.
struct RodSize {
    double nodes = 0.0;
    Place place;
    std::string path;
};

RodSize find_size(const RodTable& rod, const NamedNet* net) {
    if (net != nullptr) {
        const RodMeshTable& mesh = *rod.mesh;
        return {static_cast<double>(net->net.positions.size()),
                mesh.place_of(&mesh.group),
                mesh.path_of(&mesh.group)};
    }
    if (!rod.elements) return {};
    return {static_cast<double>(*rod.elements) * static_cast<double>(rod.order) + 1.0,
            rod.place_of(&rod.elements),
            rod.path_of(&rod.elements)};
}

}  // namespace

double least_bytes_of_node() {
    constexpr double bytes_per_entry = sizeof(double) + sizeof(int);
    constexpr double entries = 3 * 6 * 6;
    return 2.0 * sizeof(NodeMotion) + 2.0 * entries * bytes_per_entry;
}

void check_memory(const CheckedTable& deck, const RodNets& nets, double usable_bytes, FaultList& faults) {
    double nodes = 0.0;
    RodSize largest;
    const auto rods = rods_of(deck);
    for (std::size_t i = 0; i < rods.size(); ++i) {
        const auto net = nets.find(static_cast<int>(i));
        const RodSize size = find_size(rods[i], net == nets.end() ? nullptr : &net->second);
        nodes += size.nodes;
        if (size.nodes > largest.nodes) largest = size;
    }
    const double bytes = nodes * least_bytes_of_node();
    if (bytes <= usable_bytes) return;
    faults.add(
        largest.place,
        largest.path,
        fmt::format(
            "the model would have {:.0f} nodes and need more than {:.3g} GB of memory, where {:.3g} GB "
            "may be used; expected fewer elements",
            nodes,
            bytes / bytes_in_gigabyte,
            usable_bytes / bytes_in_gigabyte));
}

}  // namespace gxrod
