#include "deck/rods/rod_table.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <functional>

#include "deck/checks/check_memory.hpp"
#include "deck/rods/build_nets.hpp"
#include "deck/rods/build_rods.hpp"
#include "deck/rods/element_turn.hpp"
#include "deck/rods/sectioned_catenary.hpp"
#include "deck/schema/schema_tables.hpp"
#include "deck/sections/rest_shape.hpp"
#include "deck/sections/rod_sections.hpp"
#include "deck/sections/section_axes.hpp"
#include "deck/sections/section_twist.hpp"
#include "machine/reserve_more.hpp"
#include "mesh/rod_mesh.hpp"
#include "rotation/rotation_map.hpp"

namespace gxrod {
namespace {

std::string describe_memory_of_largest_rod() {
    return fmt::format("{} elements already need more than {:.0f} GB of memory",
                       largest_element_count,
                       least_bytes_of_node() * static_cast<double>(largest_element_count) / 1e9);
}

const TableSpec& section_file_table() {
    using T = SectionFileTable;
    // clang-format off
    static const TableSpec table = Table<T>("rod.NAME.sections", "")
        .key("file", &T::file, "A CSV file with a row for each station, relative to the deck's folder. A first line "
             "names its columns: fraction, from 0 to 1; twist, if given, as the key twist; K11 K12 … K66, the "
             "stiffness on and above the diagonal; M11 … M66, the inertia. Entries off the diagonal without a column "
             "are 0. [Sections](guide/sections.md) has an example.")
            .required()
        .key("damping", &T::damping, damping_table(), "Of the rod; none if left out.")
        .key("trapeze", &T::trapeze, "Whether twist pulls its sections together, like the key of a section.")
            .otherwise("false");
    // clang-format on
    return table;
}

const TableSpec& rod_mesh_table() {
    using T = RodMeshTable;
    // clang-format off
    static const TableSpec table = Table<T>("rod.NAME.mesh", "")
        .key("file", &T::file, "A Gmsh file: .msh of any version, or .geo, which is meshed. Relative to the deck's "
             "folder.")
            .required()
        .key("group", &T::group, "The physical group of its line elements, of order 1 to 3.")
            .required();
    // clang-format on
    return table;
}

// The keys of section axes, of a rod and of its rest.
constexpr auto y_axis_of = [](auto& table) -> auto& { return table.axes.y_axis; };
constexpr auto z_axis_of = [](auto& table) -> auto& { return table.axes.z_axis; };

const TableSpec& rest_table() {
    using T = RestTable;
    // clang-format off
    static const TableSpec table = Table<T>("rod.NAME.rest", "")
        .key("curvature", &T::curvature, "Of a rest as long as the start, in section axes: the twist per length, and "
             "the curvatures about y and z, as functions of s, the arc length, or of the place at t = 0. [0, 0, 0] is "
             "straight and without twist.")
            .unit("angle/length")
        .keys_of(curve_keys())
        .key("y_axis", y_axis_of, "Section y at the start of a rest that is a curve, as in the rod itself.")
            .unit("1").otherwise("that of the rod")
        .key("z_axis", z_axis_of, "Section z there, in its place.")
            .unit("1").otherwise("by y_axis")
        .key("twist", &T::twist, "Of a rest that is a curve, as in the rod itself.")
            .unit("angle").otherwise("that of the rod")
        .exactly_one_of({"curvature", "line", "arc", "helix", "polyline", "spline", "catenary"})
        .at_most_one_of({"y_axis", "z_axis"});
    // clang-format on
    return table;
}

constexpr const char* rod_examples =
    "[rod.flyer]\n"
    "section  = \"tube\"\n"
    "line     = { from = [6, 0, 0], to = [0, 8, 0] }\n"
    "elements = 10\n"
    "spacing  = [[0, 1], [0.5, 4], [1, 4]]\n"
    "y_axis   = [0, 0, 1]\n"
    "\n"
    "[rod.spring]\n"
    "section  = \"wire\"\n"
    "helix    = { centre = [0, 0, 0], axis = [0, 0, 1], from = [0.05, 0, 0], turns = 3, pitch = 0.05 }\n"
    "elements = 24\n"
    "order    = 3\n"
    "\n"
    "[rod.bow]\n"
    "section  = \"wire\"\n"
    "arc      = { from = [1, 0, 0], through = [0, 0, 1], to = [-1, 0, 0] }\n"
    "elements = 8\n"
    "order    = 2\n"
    "element  = \"simo\"\n"
    "\n"
    "[rod.frame]\n"
    "section  = \"laminate\"\n"
    "polyline = [[0, 0, 0], [0, 0, 2], [1, 0, 2]]\n"
    "elements = 6\n"
    "z_axis   = \"up\"\n"
    "twist    = \"pi/2\"\n";

}  // namespace

const TableSpec& rod_table() {
    using T = RodTable;
    // clang-format off
    static const TableSpec table = Table<T>("[rod.NAME]",
            "A rod. Its points are NAME.start, NAME.end and NAME@FRACTION, a fraction of the length from 0 to 1, where "
            "a node is placed, but for a history. [Geometry](guide/geometry.md) shows each shape and the points of a "
            "mesh.")
        .key("section", &T::section, "The name of a [section.NAME].")
            .names_of({"section"}).also("cross_section profile material")
        .key("sections", &T::sections, section_file_table(), "In place of section, sections along the rod: fractions of "
             "its length and names. Between them the 6×6 matrices are linear, entry by entry; where a fraction stands "
             "twice they jump, and a node is placed. Or a table that names a file of them.")
        .keys_of(curve_keys())
            .has_as("line", "from to start end points geometry path").has_as("catenary", "hung mooring")
        .key("mesh", &T::mesh, rod_mesh_table(), "The line elements of a mesh.")
        .key("elements", &T::elements, "How many, of equal length if `spacing` does not say otherwise; between corners "
             "and points NAME@FRACTION in proportion to length.")
            .between(1, static_cast<double>(largest_element_count)).above_range(describe_memory_of_largest_rod())
            .otherwise("needed, but for a mesh")
            .also("n n_elements num_elements number_of_elements nelem divisions segments")
            .also("mesh_size element_length", "their number, the length over their size")
        .key("spacing", &T::spacing, "How long the elements are at fractions of the rod's length, compared with each "
             "other; linear between the rows, with a jump where a fraction stands twice. [[0, 1], [0.2, 10], [1, 10]] "
             "makes them a tenth as long at the start. For boundary layers and where a line touches the ground.")
            .unit("1").above(0).otherwise("even")
            .also("grading bias sizes element_sizes spacings mesh_grading")
        .key("order", &T::order, "Nodes per element − 1. The straight elements of a mesh of order 1 take it, too; curved ones keep "
             "their own.")
            .between(1, 4).also("degree p polynomial_degree")
        .key("element", &T::element, "objective: rotations relative to a triad of the element interpolated (Crisfield "
             "and Jelenić 1999). simo: incremental rotation vectors interpolated (Simo and Vu-Quoc 1986).")
            .also("type element_type formulation")
        .key("y_axis", y_axis_of, "Section y at the start, projected perpendicular to the rod and carried along it "
             "without twisting. up: against gravity (without it along z, or the second axis of `plane`), anew after "
             "each corner and in each element of a mesh; where the rod is vertical (sine below 1e-3) along global x "
             "(y, if x is up).")
            .unit("1").otherwise("the global axis least aligned with the rod")
            .also("y orientation normal reference_axis")
        .key("z_axis", z_axis_of, "Section z, in its place; with up, webs of profiles are vertical.")
            .unit("1").otherwise("by y_axis")
            .also("z up web web_direction depth")
        .key("twist", &T::twist, "Turn of the section about the tangent from start to end, even along the length, "
             "right-handed; free of stress. Or the turn at fractions of the length, linear between them, from y_axis "
             "on.")
            .unit("angle").also("pretwist pre_twist")
        .key("rest", &T::rest, rest_table(), "The shape in which the rod is free of stress, where that is not the one "
             "in which it starts: its curvature, or a curve. Only the curve's shape counts, not where it is; fractions "
             "of its length are those of the rod, and the rod's arc length, mass and stiffness are by it. Left out, "
             "the rod starts free of stress, but for a catenary, which is straight then.")
        .key("hinges", &T::hinges, "Ends that [[connect]] ties to others by a hinge: it bends freely both ways there, and hands on "
             "forces and torsion. The joint is NAME.start or NAME.end. Of a mesh the ends of each curve of its geometry.")
            .words({"start", "end"}).otherwise("none: corners are rigid")
            .also("hinge releases release end_releases pinned pins")
        .with(add_copies<T>)
        .not_here("force moment torque load",
                  "a [[load]] at a point of the rod, or on it, has its forces and moments")
        .exactly_one_of({"section", "sections"})
        .exactly_one_of({"line", "arc", "helix", "polyline", "spline", "catenary", "mesh"})
        .at_most_one_of({"y_axis", "z_axis"})
        .shown_by(rod_examples);
    // clang-format on
    return table;
}

bool has_hinge(const RodTable& table, std::string_view end) {
    if (!table.hinges) return false;
    const auto& words = table.hinges->words;
    return std::ranges::find(words, end, &CheckedWord::word) != words.end();
}

std::vector<std::reference_wrapper<const RodTable>> rods_of(const CheckedTable& deck) {
    return tables_of<RodTable>(deck, rod_table());
}

namespace {

// How many elements; nullopt, with a fault, if the deck does not say.
std::optional<long> find_element_count(const RodTable& rod, const BuildContext& context) {
    if (!rod.elements) {
        const std::string expected = describe_expected(rod.key_of(&rod.elements));
        context.add_fault(rod, rod.elements, "missing; expected " + expected);
    }
    return rod.elements;
}

// Elements shorter than points that are one are a fault.
bool are_apart(const std::vector<double>& fractions, const RodTable& rod, const BuildContext& context) {
    double least = 1.0;
    for (std::size_t i = 1; i < fractions.size(); ++i)
        least = std::min(least, fractions[i] - fractions[i - 1]);
    if (least > same_fraction) return true;
    context.add_fault(rod,
                      rod.spacing,
                      fmt::format("the shortest of {} elements has {:.2g} of the length of the rod; expected "
                                  "sizes nearer to each other",
                                  fractions.size() - 1,
                                  least));
    return false;
}

std::vector<double> find_fractions(const RodTable& rod,
                                   const RodBreaks& breaks,
                                   const BuildContext& context) {
    const std::optional<long> elements = find_element_count(rod, context);
    if (!elements) return {};
    std::vector<double> fractions = compute_element_fractions(breaks, *elements);
    if (fractions.empty()) {
        const char* between = breaks.corners.empty() ? "the points that the deck names"
                                                     : "corners and the points that the deck names";
        context.add_fault(rod,
                          rod.elements,
                          fmt::format("expected at least {}, one for each piece between {}, found {}",
                                      count_pieces(breaks),
                                      between,
                                      *elements));
    } else if (!breaks.grading.is_even() && !are_apart(fractions, rod, context)) {
        return {};
    }
    return fractions;
}

std::string name_node(const std::string& rod, double fraction, std::size_t position, bool is_named) {
    if (position == 0) return rod + ".start";
    if (fraction == 1.0) return rod + ".end";
    return is_named ? fmt::format("{}@{:.9g}", rod, fraction) : fmt::format("{} node {}", rod, position);
}

Grading find_grading(const RodTable& rod) { return rod.spacing ? Grading(rod.spacing->rows) : Grading(); }

bool is_near_any(double fraction, const std::vector<double>& points) {
    return std::any_of(points.begin(), points.end(), [&](double point) {
        return std::abs(point - fraction) <= 2.0 * same_fraction;
    });
}

// Adds the nodes and elements of one rod along its centreline.
class LineBuilder {
  public:
    LineBuilder(const Centreline& line,
                const std::vector<Quat>& piece_axes,
                const SectionTwist& twist,
                const std::vector<double>& points,
                int index,
                BuildContext& context)
        : line_(line),
          piece_axes_(piece_axes),
          twist_(twist),
          points_(points),
          rod_(context.model.rods[static_cast<std::size_t>(index)]),
          nodes_(context.model.nodes),
          fractions_(context.rod_fractions[static_cast<std::size_t>(index)]),
          twists_(context.rod_twists[static_cast<std::size_t>(index)]) {}

    // The section axes on a piece of the line, at a fraction of its length.
    std::function<Quat(std::size_t, double)> axes() const {
        return [this](std::size_t piece, double fraction) {
            return twisted(line_.transport(piece, fraction) * piece_axes_[piece], twist_.at(fraction));
        };
    }

    // The largest turn within one of the elements that were added.
    double largest_turn() const { return largest_turn_; }

    void add(const std::vector<double>& element_fractions) {
        rod_.length = line_.length();
        const std::vector<double> within = compute_element_nodes(rod_.order);
        reserve(element_fractions.size() - 1);
        for (std::size_t e = 0; e + 1 < element_fractions.size(); ++e) {
            const double first = element_fractions[e];
            const double last = element_fractions[e + 1];
            const std::size_t piece = line_.piece_at(0.5 * (first + last));
            largest_turn_ =
                std::max(largest_turn_,
                         compute_element_turn(line_.turn(piece, first, last), twist_.between(first, last)));
            for (std::size_t i = 0; i < within.size(); ++i) {
                const bool is_last = i + 1 == within.size();
                const double fraction = is_last ? last : first + (last - first) * within[i];
                if (e == 0 || i > 0) add_node(piece, fraction);
                add_entry(piece, fraction);
            }
        }
    }

  private:
    void reserve(std::size_t elements) {
        const auto order = static_cast<std::size_t>(rod_.order);
        rod_.nodes.reserve(elements * order + 1);
        fractions_.reserve(elements * order + 1);
        twists_.reserve(elements * order + 1);
        reserve_more(elements * order + 1, nodes_);
        rod_.element_nodes.reserve(elements * (order + 1));
        rod_.arc_length.reserve(elements * (order + 1));
        rod_.triads.reserve(elements * (order + 1));
    }

    void add_node(std::size_t piece, double fraction) {
        const std::size_t position = rod_.nodes.size();
        rod_.nodes.push_back(static_cast<int>(nodes_.size()));
        fractions_.push_back(fraction);
        twists_.push_back(twist_.at(fraction));
        nodes_.push_back({name_node(rod_.name, fraction, position, is_near_any(fraction, points_)),
                          line_.position(piece, fraction)});
    }

    void add_entry(std::size_t piece, double fraction) {
        rod_.element_nodes.push_back(rod_.nodes.back());
        rod_.arc_length.push_back(fraction * line_.length());
        rod_.triads.push_back(axes()(piece, fraction));
    }

    const Centreline& line_;
    const std::vector<Quat>& piece_axes_;
    const SectionTwist& twist_;
    const std::vector<double>& points_;
    Rod& rod_;
    std::vector<Node>& nodes_;
    std::vector<double>& fractions_;  // of nodes
    std::vector<double>& twists_;     // there
    double largest_turn_ = 0.0;
};

// What varies along a rod.
struct Variation {
    std::vector<Station> stations;
    SectionTwist twist;
};

void build_line(const RodTable& table,
                const Variation& along,
                std::vector<double> points,
                int index,
                BuildContext& context) {
    const std::vector<double> jumps = find_jumps(along.stations);
    points.insert(points.end(), jumps.begin(), jumps.end());
    const std::vector<HungWeight> weights =
        table.catenary ? list_hung_weights(index, context) : std::vector<HungWeight>{};
    const bool is_sectioned = table.catenary && (along.stations.size() > 1 || !weights.empty() ||
                                                 hangs_by_its_weight(table, along.stations, context));
    const std::optional<Centreline> line =
        is_sectioned ? find_sectioned_catenary(table, along.stations, weights, context)
                     : find_centreline(table, context, table.section);
    std::optional<RestCurve> rest = find_rest_curve(table, along.twist, context);
    if (is_sectioned && line && !table.rest) rest = make_straight_rest(line->length(), along.twist);
    RodBreaks breaks{points, line ? line->corners() : std::vector<double>{}, find_grading(table)};
    if (rest) add_corners(rest->line.corners(), breaks);
    const std::vector<double> fractions = find_fractions(table, breaks, context);
    if (!line) return;
    const auto axes = find_piece_axes(table, table.axes, *line, context);
    if (!axes || fractions.empty()) return;
    const auto order = static_cast<int>(table.order);
    Rod& rod = context.model.rods[static_cast<std::size_t>(index)];
    rod.order = order;
    LineBuilder builder(*line, *axes, along.twist, points, index, context);
    builder.add(fractions);
    if (rest) {
        set_rest(table, *rest, fractions, rod, context);
    } else {
        set_rest(table, {*line, builder.axes()}, fractions, rod, context);
    }
    set_sections(along.stations, fractions, rod, context);
    check_element_turn(builder.largest_turn(), order, table, &table.elements, context);
}

}  // namespace

void build_rods(const std::vector<RodPoint>& points,
                const RodNets& nets,
                const SectionFiles& files,
                BuildContext& context) {
    const auto tables = rods_of(context.deck);
    std::vector<std::vector<double>> fractions(tables.size());
    for (const RodPoint& point : points) fractions[point.rod].push_back(point.fraction);
    context.model.rods.resize(tables.size());
    context.rod_fractions.resize(tables.size());
    context.rod_twists.resize(tables.size());
    for (std::size_t i = 0; i < tables.size(); ++i) {
        const RodTable& table = tables[i];
        Rod& rod = context.model.rods[i];
        rod.name = table.name;
        const int index = static_cast<int>(i);
        const SectionFile* file = files.contains(index) ? &files.at(index) : nullptr;
        const std::vector<Station> stations = find_stations(table, file, context);
        rod.section = stations.front().section;
        rod.kind = table.element;
        if (table.mesh && stations.size() > 1) {
            const void* field = &table.sections;
            if (table.section) field = &table.section;
            context.faults.add(table.place_of(field),
                               table.path_of(field),
                               "a rod from a mesh has one section, the same everywhere and without s");
        }
        if (!table.mesh) {
            build_line(table, {stations, find_twist(table, file, context)}, fractions[i], index, context);
        } else if (check_meshed_rod(table, context); nets.contains(index)) {
            build_net(table, nets.at(index), index, context);
        }
    }
}

}  // namespace gxrod
