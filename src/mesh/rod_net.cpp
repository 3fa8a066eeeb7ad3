#include "mesh/rod_net.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <unordered_map>

#include "geometry/polynomial_curve.hpp"
#include "mesh/rod_mesh.hpp"

namespace gxrod {
namespace {

class NetMaker {
  public:
    NetMaker(const LineMesh& mesh, const MeshLines& lines, int order)
        : mesh_(mesh), lines_(lines), order_(static_cast<std::size_t>(lines.orders.front())) {
        net_.order = std::max(order, lines.orders.front());
    }

    RodNet make() {
        std::vector<std::array<std::size_t, 2>> ends;
        for (std::size_t e = 0; e < element_count(); ++e) {
            ends.push_back({node_of(e, 0), node_of(e, order_)});
            if (ends.back()[0] == ends.back()[1]) refuse(e, "ends where it starts");
        }
        for (const Chain& chain : find_chains(ends)) add_chain(chain);
        return std::move(net_);
    }

  private:
    std::size_t element_count() const { return lines_.nodes.size() / (order_ + 1); }
    std::size_t node_of(std::size_t element, std::size_t i) const {
        return lines_.nodes[element * (order_ + 1) + i];
    }

    [[noreturn]] void refuse(std::size_t element, const char* reason) const {
        const Vec3& at = mesh_.positions[node_of(element, 0)];
        throw MeshError(
            fmt::format("the element at ({:.6g}, {:.6g}, {:.6g}) {}", at[0], at[1], at[2], reason));
    }

    void add_chain(const Chain& chain) {
        NetChain& added = net_.chains.emplace_back();
        added.is_closed = chain.is_closed;
        for (const ChainLink& link : chain.links) {
            added.elements.push_back(make_element(link));
            added.length += added.elements.back().length();
        }
    }

    Cubic find_curve(const ChainLink& link) const {
        std::vector<Vec3> points;
        for (std::size_t i = 0; i <= order_; ++i) {
            points.push_back(mesh_.positions[node_of(link.element, link.is_reversed ? order_ - i : i)]);
        }
        Cubic cubic = interpolate(points);
        if (points.front() == points.back()) refuse(link.element, "has no length");
        if (find_fold({&cubic, 1})) refuse(link.element, "turns back on itself");
        return cubic;
    }

    NetElement make_element(const ChainLink& link) {
        const Cubic cubic = find_curve(link);
        const PolynomialCurve curve({&cubic, 1});
        NetElement element{.start_tangent = curve.tangent(0.0),
                           .end_tangent = curve.tangent(curve.length()),
                           .turn = curve.turn(curve.length())};
        if (link.element < lines_.curves.size()) element.curve = lines_.curves[link.element];
        const std::vector<double> parameters = compute_element_nodes(net_.order);
        const std::size_t last = parameters.size() - 1;
        for (std::size_t i = 0; i <= last; ++i) {
            const std::size_t mesh_node = find_mesh_node(link, i, last);
            const bool is_inside = i > 0 && i < last;
            const Vec3 position = is_inside ? cubic.position(parameters[i]) : mesh_.positions[mesh_node];
            element.nodes.push_back(find_node(mesh_node, position));
            element.arc_length.push_back(i == last ? curve.length() : curve.arc_length_at(parameters[i]));
            element.transports.push_back(curve.transport(element.arc_length.back()));
        }
        return element;
    }

    // Of node i of 0 to `last`; inner ones of an element of raised order have none.
    std::size_t find_mesh_node(const ChainLink& link, std::size_t i, std::size_t last) const {
        if (last != order_ && i > 0 && i < last) return RodNet::no_mesh_node;
        const std::size_t along = i == last ? order_ : i;
        return node_of(link.element, link.is_reversed ? order_ - along : along);
    }

    int find_node(std::size_t mesh_node, const Vec3& position) {
        const auto next = static_cast<int>(net_.positions.size());
        if (mesh_node != RodNet::no_mesh_node) {
            const auto [entry, is_new] = numbers_.emplace(mesh_node, next);
            if (!is_new) return entry->second;
        }
        net_.positions.push_back(position);
        net_.mesh_nodes.push_back(mesh_node);
        return next;
    }

    const LineMesh& mesh_;
    const MeshLines& lines_;
    std::size_t order_;
    RodNet net_;
    std::unordered_map<std::size_t, int> numbers_;  // of mesh nodes in the net
};

}  // namespace

double RodNet::length() const {
    double sum = 0.0;
    for (const NetChain& chain : chains) sum += chain.length;
    return sum;
}

std::vector<double> RodNet::fractions() const {
    std::vector<double> found(positions.size());
    double start = 0.0;
    for (const NetElement& element : chains.front().elements) {
        for (std::size_t i = 0; i < element.nodes.size(); ++i) {
            found[static_cast<std::size_t>(element.nodes[i])] =
                (start + element.arc_length[i]) / chains.front().length;
        }
        start += element.length();
    }
    found[static_cast<std::size_t>(chains.front().elements.back().nodes.back())] = 1.0;
    return found;
}

RodNet make_rod_net(const LineMesh& mesh, const MeshLines& lines, int order) {
    return NetMaker(mesh, lines, order).make();
}

}  // namespace gxrod
