#include "deck/rods/build_nets.hpp"

#include <fmt/format.h>

#include <functional>

#include "deck/rods/element_turn.hpp"
#include "deck/sections/section_axes.hpp"
#include "geometry/curve.hpp"

namespace gxrod {
namespace {

std::string name_node(const std::string& rod, const NetPoints& points, int position) {
    for (const NetPoints::Group& group : points.groups) {
        if (group.positions == std::vector{position}) return rod + "." + group.name;
    }
    if (!points.fractions.empty()) {
        const double fraction = points.fractions[static_cast<std::size_t>(position)];
        if (fraction == 0.0) return rod + ".start";
        if (fraction == 1.0) return rod + ".end";
    }
    return fmt::format("{} node {}", rod, position);
}

// Whether a direction of the deck, not of zero length, is parallel to a tangent.
bool is_parallel(const SectionDirections& axes, const Vec3& tangent, const BuildContext& context) {
    const Vec3* vector = std::get_if<Vec3>(&*axes.given());
    return vector != nullptr && !vector->isZero(0.0) && !project_axes(axes, tangent, context);
}

// The axes at the start of each chain; empty, with a fault, if one cannot be.
std::vector<Quat> find_chain_axes(const RodTable& table, const RodNet& net, BuildContext& context) {
    std::vector<Quat> axes;
    if (net.chains.size() > 1 && !table.axes.are_given()) {
        context.notes.push_back(fmt::format(
            "{}: not given; section y at the start of each of {} lines is from the global axis least aligned "
            "with it",
            table.path_of(&table.axes.y_axis),
            net.chains.size()));
        for (const NetChain& chain : net.chains) {
            axes.push_back(choose_axes(chain.elements.front().start_tangent));
        }
        return axes;
    }
    for (const NetChain& chain : net.chains) {
        const NetElement& first = chain.elements.front();
        if (net.chains.size() > 1 && is_parallel(table.axes, first.start_tangent, context)) {
            const Vec3& at = net.positions[static_cast<std::size_t>(first.nodes.front())];
            context.add_fault(
                table,
                table.axes.given(),
                fmt::format(
                    "parallel to the line that starts at ({:.6g}, {:.6g}, {:.6g}), so that section {} is "
                    "not defined there; expected another direction, \"up\", or rods of their own for its "
                    "lines",
                    at[0],
                    at[1],
                    at[2],
                    table.axes.z_axis ? 'z' : 'y'));
            return {};
        }
        const std::optional<Quat> start = find_start_axes(table, table.axes, first.start_tangent, context);
        if (!start) return {};
        axes.push_back(*start);
    }
    return axes;
}

struct NetBuilder {
    Rod& rod;
    double twist;                                                  // from start to end of each chain
    std::function<std::optional<Quat>(const Vec3& tangent)> rule;  // of the axes of each element, if any
    double start = 0.0;                                            // arc length where the chain starts
    double largest_turn = 0.0;

    void add_chain(const NetChain& chain, Quat axes) {
        double s = 0.0;
        for (std::size_t e = 0; e < chain.elements.size(); ++e) {
            const NetElement& element = chain.elements[e];
            if (e > 0) {
                axes = smallest_rotation(chain.elements[e - 1].end_tangent, element.start_tangent) * axes;
            }
            if (rule) axes = *rule(element.start_tangent);
            for (std::size_t i = 0; i < element.nodes.size(); ++i) {
                const double at = s + element.arc_length[i];
                rod.element_nodes.push_back(rod.nodes[static_cast<std::size_t>(element.nodes[i])]);
                rod.arc_length.push_back(start + at);
                rod.triads.push_back(twisted(element.transports[i] * axes, twist * at / chain.length));
            }
            largest_turn = std::max(
                largest_turn, compute_element_turn(element.turn, twist * element.length() / chain.length));
            axes = (element.transports.back() * axes).normalized();
            s += element.length();
        }
        start += chain.length;
    }
};

// Gives members of a mesh, each a curve of its geometry, nodes of their own where they have a hinge.
class MemberHinges {
  public:
    MemberHinges(const RodTable& table, int index, BuildContext& context)
        : table_(table),
          index_(index),
          context_(context),
          rod_(context.model.rods[static_cast<std::size_t>(index)]) {}

    // The elements of the chain are the rod's from `first` on.
    void add(const NetChain& chain, std::size_t first) {
        const std::size_t count = chain.elements.size();
        for (std::size_t e = 0; e < count; ++e) {
            const int curve = chain.elements[e].curve;
            const bool is_first = e == 0 || chain.elements[e - 1].curve != curve;
            const bool is_last = e + 1 == count || chain.elements[e + 1].curve != curve;
            if (is_first && has_hinge(table_, "start")) release((first + e) * per_element());
            if (is_last && has_hinge(table_, "end")) release((first + e) * per_element() + per_element() - 1);
        }
    }

  private:
    std::size_t per_element() const { return static_cast<std::size_t>(rod_.order) + 1; }

    void release(std::size_t entry) {
        const int node = rod_.element_nodes[entry];
        const auto own = static_cast<int>(context_.model.nodes.size());
        const Node& at = context_.model.nodes[static_cast<std::size_t>(node)];
        const std::string name = fmt::format("{} hinge {}", rod_.name, ++count_);
        context_.hinges.push_back({name, at.name, node, own, index_});
        context_.model.nodes.push_back({name, at.position});
        rod_.element_nodes[entry] = own;
        rod_.nodes.push_back(own);
    }

    const RodTable& table_;
    int index_;
    BuildContext& context_;
    Rod& rod_;
    int count_ = 0;
};

// Where a chain goes straight back, with a fault.
bool has_reversal(const RodTable& table, const RodNet& net, const BuildContext& context) {
    constexpr double zero_angle = 1e-10;
    for (const NetChain& chain : net.chains) {
        for (std::size_t e = 1; e < chain.elements.size(); ++e) {
            const NetElement& element = chain.elements[e];
            if ((chain.elements[e - 1].end_tangent + element.start_tangent).norm() > zero_angle) continue;
            const Vec3& at = net.positions[static_cast<std::size_t>(element.nodes.front())];
            context.add_fault(
                *table.mesh,
                table.mesh->group,
                fmt::format("a line goes straight back at ({:.6g}, {:.6g}, {:.6g})", at[0], at[1], at[2]));
            return true;
        }
    }
    return false;
}

void add_member_hinges(const RodTable& table, const RodNet& net, int index, BuildContext& context) {
    MemberHinges hinges(table, index, context);
    std::size_t first = 0;
    for (const NetChain& chain : net.chains) {
        hinges.add(chain, first);
        first += chain.elements.size();
    }
}

// The rule for the axes of each element; empty if the deck has none.
std::function<std::optional<Quat>(const Vec3&)> find_rule(const RodTable& table,
                                                          const RodNet& net,
                                                          BuildContext& context) {
    if (!table.axes.has_rule()) return {};
    std::size_t vertical = 0, all = 0;
    for (const NetChain& chain : net.chains) {
        for (const NetElement& element : chain.elements) {
            ++all;
            vertical += is_vertical(element.start_tangent, find_up(context)) ? 1 : 0;
        }
    }
    note_vertical(table, table.axes, "elements", vertical, all, context);
    return [&table, &context](const Vec3& tangent) { return project_axes(table.axes, tangent, context); };
}

}  // namespace

void check_meshed_rod(const RodTable& table, const BuildContext& context) {
    const auto refuse = [&](const auto& field) {
        if (table.gives(field)) context.add_fault(table, field, "comes from the mesh; leave it out");
    };
    refuse(table.elements);
    refuse(table.spacing);
    if (table.rest)
        context.add_fault(table, table.rest, "a rod from a mesh is free of stress where the mesh has it");
    if (std::holds_alternative<CheckedProfile>(table.twist))
        context.add_fault(table, table.twist, "along a rod from a mesh twist is even; expected a number");
}

void build_net(const RodTable& table, const NamedNet& named, int index, BuildContext& context) {
    const RodNet& net = named.net;
    if (has_reversal(table, net, context)) return;
    const std::vector<Quat> axes = find_chain_axes(table, net, context);
    if (axes.empty()) return;
    Rod& rod = context.model.rods[static_cast<std::size_t>(index)];
    rod.order = net.order;
    rod.length = net.length();
    for (std::size_t i = 0; i < net.positions.size(); ++i) {
        rod.nodes.push_back(static_cast<int>(context.model.nodes.size()));
        context.model.nodes.push_back(
            {name_node(rod.name, named.points, static_cast<int>(i)), net.positions[i]});
    }
    const double* twist = std::get_if<double>(&table.twist);
    if (twist == nullptr) return;
    NetBuilder builder{rod, *twist, find_rule(table, net, context)};
    for (std::size_t i = 0; i < net.chains.size(); ++i) builder.add_chain(net.chains[i], axes[i]);
    if (table.hinges) add_member_hinges(table, net, index, context);
    check_element_turn(builder.largest_turn, net.order, table, &table.mesh, context);
    context.rod_fractions[static_cast<std::size_t>(index)] = named.points.fractions;
}

}  // namespace gxrod
