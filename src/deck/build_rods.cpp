#include "deck/build_rods.hpp"

#include <fmt/format.h>

#include <array>
#include <cmath>

#include "deck/choices.hpp"
#include "deck/rod_mesh.hpp"
#include "deck/suggestion.hpp"

namespace gxrod {
namespace {

// Below these, a length relative to the coordinates and the sine of an angle count as zero.
constexpr double zero_length = 1e-12;
constexpr double zero_angle = 1e-6;

int find_section(const CheckedTable& rod, const BuildContext& context) {
    const std::string& name = rod.get<std::string>("section");
    std::vector<std::string> known;
    for (std::size_t i = 0; i < context.model.sections.size(); ++i) {
        if (context.model.sections[i].name == name) return static_cast<int>(i);
        known.push_back(context.model.sections[i].name);
    }
    std::string hint = did_you_mean(name, known);
    if (hint.empty())
        hint = known.empty() ? "; the deck has no section" : "; the deck has " + plain_list(known);
    context.add_fault(rod, "section", fmt::format("no section \"{}\"{}", name, hint));
    return 0;
}

struct GlobalAxis {
    char name;
    Vec3 direction;
};

// The global axis least aligned with a tangent; of equals the first of y, z, x, so that a rod along x, y or z
// has section axes along the global ones.
GlobalAxis choose_y_axis(const Vec3& tangent) {
    const std::array<GlobalAxis, 3> axes{{{'y', Vec3::UnitY()}, {'z', Vec3::UnitZ()}, {'x', Vec3::UnitX()}}};
    GlobalAxis chosen = axes[0];
    for (const GlobalAxis& axis : axes) {
        if (std::abs(axis.direction.dot(tangent)) < std::abs(chosen.direction.dot(tangent)) - 1e-9)
            chosen = axis;
    }
    return chosen;
}

std::string describe(const Vec3& vector) {
    // −0 would read as a finding.
    return fmt::format("[{:.6g}, {:.6g}, {:.6g}]", vector[0] + 0.0, vector[1] + 0.0, vector[2] + 0.0);
}

// Section y: what the deck says or a global axis, projected perpendicular to the unit tangent.
std::optional<Vec3> find_y_axis(const CheckedTable& rod, const Vec3& tangent, const BuildContext& context) {
    if (!rod.gives("y_axis")) {
        const GlobalAxis axis = choose_y_axis(tangent);
        const Vec3 projected = (axis.direction - axis.direction.dot(tangent) * tangent).normalized();
        context.notes.push_back(fmt::format("{}: not given; section y at the start is {}, from global {}",
                                            rod.path_of("y_axis"),
                                            describe(projected),
                                            axis.name));
        return projected;
    }
    const Vec3& given = rod.get<Vec3>("y_axis");
    if (given.isZero(0.0)) {
        context.add_fault(rod, "y_axis", "expected a direction, found a vector of zero length");
        return std::nullopt;
    }
    const Vec3 direction = given.stableNormalized();
    const Vec3 projected = direction - direction.dot(tangent) * tangent;
    if (projected.norm() < zero_angle) {
        context.add_fault(
            rod,
            "y_axis",
            "parallel to the rod, so that section y is not defined; expected another direction");
        return std::nullopt;
    }
    return projected.normalized();
}

std::optional<Quat> find_triad(const CheckedTable& rod, const Vec3& tangent, const BuildContext& context) {
    const std::optional<Vec3> y = find_y_axis(rod, tangent, context);
    if (!y) return std::nullopt;
    Mat3 axes;
    axes << tangent, *y, tangent.cross(*y);
    return Quat(axes).normalized();
}

std::vector<double> find_fractions(const CheckedTable& rod,
                                   const std::vector<double>& points,
                                   const BuildContext& context) {
    const long elements = rod.get<long>("elements");
    std::vector<double> fractions = compute_node_fractions(points, elements);
    if (fractions.empty()) {
        context.add_fault(
            rod,
            "elements",
            fmt::format("expected at least {}, one for each piece between the points that the deck names, "
                        "found {}",
                        count_pieces(points),
                        elements));
    }
    return fractions;
}

std::string name_node(const std::string& rod, double fraction, std::size_t position, bool is_named) {
    if (position == 0) return rod + ".start";
    if (fraction == 1.0) return rod + ".end";
    return is_named ? fmt::format("{}@{:.9g}", rod, fraction) : fmt::format("{} node {}", rod, position);
}

bool is_near_any(double fraction, const std::vector<double>& points) {
    for (const double point : points) {
        if (std::abs(point - fraction) <= 2.0 * same_fraction) return true;
    }
    return false;
}

struct Line {
    Vec3 from, to;

    double length() const { return (to - from).stableNorm(); }
    Vec3 at(double fraction) const { return (1.0 - fraction) * from + fraction * to; }
};

std::optional<Line> find_line(const CheckedTable& table, const BuildContext& context) {
    const Line line{table.get<Vec3>("from"), table.get<Vec3>("to")};
    const double size = std::max(line.from.lpNorm<Eigen::Infinity>(), line.to.lpNorm<Eigen::Infinity>());
    if (line.length() <= zero_length * size) {
        context.add_fault(table, "to", "the rod has no length; expected an end away from its start");
        return std::nullopt;
    }
    return line;
}

void add_nodes(const Line& line,
               const Quat& triad,
               const std::vector<double>& points,
               int index,
               BuildContext& context) {
    Rod& rod = context.model.rods[index];
    const std::vector<double>& fractions = context.rod_fractions[index];
    std::vector<double> arc_length;
    for (std::size_t i = 0; i < fractions.size(); ++i) {
        const bool is_named = is_near_any(fractions[i], points);
        rod.nodes.push_back(static_cast<int>(context.model.nodes.size()));
        arc_length.push_back(fractions[i] * line.length());
        context.model.nodes.push_back(
            {name_node(rod.name, fractions[i], i, is_named), line.at(fractions[i])});
    }
    set_line_elements(rod, arc_length, std::vector<Quat>(arc_length.size(), triad));
}

void build_rod(const CheckedTable& table,
               const std::vector<double>& points,
               int index,
               BuildContext& context) {
    Rod& rod = context.model.rods[index];
    rod.name = table.name;
    rod.section = find_section(table, context);
    rod.kind = value_of(element_kind_choices, table.get<std::string>("element"));
    rod.order = static_cast<int>(table.get<long>("order"));
    const std::optional<Line> line = find_line(table.tables("line").front(), context);
    const std::vector<double> fractions = find_fractions(table, points, context);
    if (!line) return;
    const std::optional<Quat> triad = find_triad(table, (line->to - line->from).stableNormalized(), context);
    if (!triad || fractions.empty()) return;
    context.rod_fractions[index] = fractions;
    add_nodes(*line, *triad, points, index, context);
}

}  // namespace

void build_sections(BuildContext& context) {
    for (const CheckedTable& table : context.deck.tables("section")) {
        const CheckedTable& stiffness = table.tables("stiffness").front();
        const CheckedTable& inertia = table.tables("inertia").front();
        const auto c = [&](const char* key) { return stiffness.get<double>(key); };
        const auto m = [&](const char* key) { return inertia.get<double>(key); };
        const double polar = inertia.gives("rhoJ") ? m("rhoJ") : m("rhoIy") + m("rhoIz");
        Section section{table.name, Mat6::Zero(), Mat6::Zero()};
        section.stiffness.diagonal() << c("EA"), c("GAy"), c("GAz"), c("GJ"), c("EIy"), c("EIz");
        section.mass.diagonal() << m("rhoA"), m("rhoA"), m("rhoA"), polar, m("rhoIy"), m("rhoIz");
        context.model.sections.push_back(section);
    }
}

void build_rods(const std::vector<RodPoint>& points, BuildContext& context) {
    const std::vector<CheckedTable>& tables = context.deck.tables("rod");
    std::vector<std::vector<double>> fractions(tables.size());
    for (const RodPoint& point : points) fractions[point.rod].push_back(point.fraction);
    context.model.rods.resize(tables.size());
    context.rod_fractions.resize(tables.size());
    for (std::size_t i = 0; i < tables.size(); ++i) {
        build_rod(tables[i], fractions[i], static_cast<int>(i), context);
    }
}

}  // namespace gxrod
