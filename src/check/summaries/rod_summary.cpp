#include "check/summaries/rod_summary.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "check/summaries/rod_lines.hpp"
#include "check/summaries/section_summary.hpp"
#include "check/summaries/shape_summary.hpp"
#include "check/surroundings/fluid_summary.hpp"
#include "model/sections/element_lengths.hpp"
#include "rotation/vector_text.hpp"

namespace gxrod {
namespace {

// Relative to its neighbours.
constexpr double round_off = 1e-12;
// By which lengths of elements differ that are worth a line.
constexpr double graded = 0.1;
// Less is the error of compute_twist on a coarse mesh.
constexpr double least_twist = 0.01;

// Components are zero where they are round-off compared with the others or `size`.
std::string describe(const Vec3& v, double size = 0.0) {
    return in_parentheses(v, 6, round_off * std::max(size, v.cwiseAbs().maxCoeff()));
}

// Other entries are round-off compared with the diagonal ones of their row and column.
bool is_diagonal(const Mat6& matrix) {
    for (int i = 0; i < 6; ++i) {
        for (int j = 0; j < i; ++j) {
            const double scale = std::sqrt(matrix(i, i)) * std::sqrt(matrix(j, j));
            if (std::abs(matrix(i, j)) > round_off * scale) return false;
        }
    }
    return true;
}

std::string describe_rows(const Mat6& matrix) {
    std::string text;
    for (int i = 0; i < 6; ++i) {
        text += "   ";
        for (int j = 0; j < 6; ++j) text += fmt::format(" {:>12.6g}", matrix(i, j));
        text += "\n";
    }
    return text;
}

std::string describe_stiffness(const Mat6& C) {
    if (!is_diagonal(C)) return "  stiffness (x y z rx ry rz):\n" + describe_rows(C);
    return fmt::format("  stiffness: EA {:.6g}, GAy {:.6g}, GAz {:.6g}, GJ {:.6g}, EIy {:.6g}, EIz {:.6g}\n",
                       C(0, 0),
                       C(1, 1),
                       C(2, 2),
                       C(3, 3),
                       C(4, 4),
                       C(5, 5));
}

std::string describe_inertia(const Mat6& M) {
    if (M.isZero(0.0)) return "  inertia per length: none\n";
    if (!is_diagonal(M)) return "  inertia per length (x y z rx ry rz):\n" + describe_rows(M);
    return fmt::format("  inertia per length: rhoA {:.6g}, rhoJ {:.6g}, rhoIy {:.6g}, rhoIz {:.6g}\n",
                       M(0, 0),
                       M(3, 3),
                       M(4, 4),
                       M(5, 5));
}

// Whether the elements follow each other from the first to the last node.
bool is_line(const Rod& rod) {
    const auto per_element = static_cast<std::size_t>(rod.order) + 1;
    for (std::size_t i = per_element; i < rod.element_nodes.size(); i += per_element) {
        if (rod.element_nodes[i] != rod.element_nodes[i - 1]) return false;
    }
    return true;
}

std::string describe_axes(const Quat& triad) {
    const Mat3 axes = triad.toRotationMatrix();
    return fmt::format(
        "x {}, y {}, z {}", describe(axes.col(0)), describe(axes.col(1)), describe(axes.col(2)));
}

// Its ends, or of a net the box that it fills.
std::string describe_extent(const Model& model, const Rod& rod) {
    if (is_line(rod)) {
        const auto end = [&](int node) {
            return describe(model.nodes[static_cast<std::size_t>(node)].position, rod.length);
        };
        return fmt::format("  from {} to {}\n", end(rod.nodes.front()), end(rod.nodes.back()));
    }
    Eigen::AlignedBox3d box;
    for (const int node : rod.nodes) box.extend(model.nodes[static_cast<std::size_t>(node)].position);
    return fmt::format(
        "  within {} and {}\n", describe(box.min(), rod.length), describe(box.max(), rod.length));
}

double angle_between(const Vec3& a, const Vec3& b) { return std::atan2(a.cross(b).norm(), a.dot(b)); }

// Section y carried by `step` from where the tangent is `tangent` to where it is `next_tangent`.
Vec3 reflect_twice(const Vec3& y, const Vec3& tangent, const Vec3& step, const Vec3& next_tangent) {
    const auto reflect = [](const Vec3& v, const Vec3& normal) -> Vec3 {
        return v - 2.0 * normal.dot(v) / normal.squaredNorm() * normal;
    };
    const Vec3 normal = next_tangent - reflect(tangent, step);
    const Vec3 once = reflect(y, step);
    return normal.isZero(1e-14) ? once : reflect(once, normal);
}

// Of section axes by Rod::element_nodes.
double compute_largest_turn(const std::vector<Quat>& triads, int order) {
    const auto per_element = static_cast<std::size_t>(order) + 1;
    double largest = 0.0;
    for (std::size_t first = 0; first < triads.size(); first += per_element) {
        double turn = 0.0;
        for (std::size_t i = first; i + 1 < first + per_element; ++i) {
            turn += angle_between(triads[i] * Vec3::UnitX(), triads[i + 1] * Vec3::UnitX());
        }
        largest = std::max(largest, turn);
    }
    return largest;
}

// What a rod that does not start free of stress starts with.
std::string describe_rest(const Rod& rod) {
    if (rod.starts_free_of_stress()) return "";
    if (rod.rest_positions.empty()) return "  rest: as long as the start, bent or twisted another way\n";
    const Quat& first = rod.rest_triads.front();
    const Vec3 chord = first.conjugate() * (rod.rest_positions.back() - rod.rest_positions.front());
    const double change = rod.start_stretch - 1.0;
    return fmt::format(
        "  rest: length {:.6g}, end at {} in section axes of the start; starts {}\n",
        rod.length,
        describe(chord, rod.length),
        std::abs(change) < round_off
            ? "as long"
            : fmt::format("{:.6g}, a stretch of {:.3g} %", rod.length * rod.start_stretch, 100.0 * change));
}

// The diagonals of a section that varies.
std::string describe_diagonals(const Section& section) {
    const auto c = section.stiffness.diagonal();
    return fmt::format("EA {:.6g}, GAy {:.6g}, GAz {:.6g}, GJ {:.6g}, EIy {:.6g}, EIz {:.6g}, rhoA {:.6g}",
                       c[0],
                       c[1],
                       c[2],
                       c[3],
                       c[4],
                       c[5],
                       section.mass(0, 0));
}

}  // namespace

double compute_largest_turn(const Rod& rod) {
    return std::max(compute_largest_turn(rod.triads, rod.order),
                    compute_largest_turn(rod.rest_triads, rod.order));
}

double compute_twist(const Model& model, const Rod& rod) {
    const auto per_element = static_cast<std::size_t>(rod.order) + 1;
    double twist = 0.0;
    for (std::size_t i = 0; i + 1 < rod.triads.size(); ++i) {
        if ((i + 1) % per_element == 0) continue;
        const auto position = [&](std::size_t entry) {
            return model.nodes[static_cast<std::size_t>(rod.element_nodes[entry])].position;
        };
        const Mat3 axes = rod.triads[i].toRotationMatrix();
        const Mat3 next = rod.triads[i + 1].toRotationMatrix();
        const Vec3 carried =
            reflect_twice(axes.col(1), axes.col(0), position(i + 1) - position(i), next.col(0));
        twist += std::atan2(next.col(1).dot(next.col(0).cross(carried)), next.col(1).dot(carried));
    }
    return twist;
}

std::string describe_section(const Section& section) {
    std::string text = fmt::format("section {}:\n", section.name);
    text += describe_stiffness(section.stiffness) + describe_inertia(section.mass);
    if (section.shape) text += describe_shape(*section.shape);
    text += describe_centres(section) + describe_fluid(section);
    if (section.law) text += fmt::format("  law: {}\n", section.law->describe());
    if (section.kelvin_voigt == 0.0 && section.mass_proportional == 0.0) return text;
    std::string kelvin_voigt = fmt::format("{:.6g}", section.kelvin_voigt);
    if (section.kelvin_voigt_components)
        kelvin_voigt = fmt::format("[{:.6g}]", fmt::join(*section.kelvin_voigt_components, ", "));
    return text + fmt::format("  damping: kelvin_voigt {}, mass_proportional {:.6g}\n",
                              kelvin_voigt,
                              section.mass_proportional);
}

std::string describe_rod(const Model& model, const Rod& rod) {
    const Section& section = model.sections[static_cast<std::size_t>(rod.section)];
    std::string text =
        fmt::format("rod {}: length {:.6g}, mass {:.6g}, {} {} elements of order {}, section {}\n",
                    rod.name,
                    rod.length,
                    section.mass(0, 0) * rod.length,
                    rod.element_count(),
                    rod.kind == ElementKind::simo ? "simo" : "objective",
                    rod.order,
                    section.name);
    text += describe_extent(model, rod) + describe_rest(rod);
    const ElementLengths lengths = find_element_lengths(rod);
    if (lengths.most > (1.0 + graded) * lengths.least)
        text += fmt::format("  elements {:.4g} to {:.4g} long\n", lengths.least, lengths.most);
    if (rod.has_varying_sections()) {
        text += "  section at the start: " + describe_diagonals(rod.varying.at_nodes.front()) + "\n";
        text += "  section at the end: " + describe_diagonals(rod.varying.at_nodes.back()) + "\n";
        text += describe_varying_centres(rod);
    }
    text += describe_fluid(model, rod);
    text += "  axes at the start: " + describe_axes(rod.triads.front()) + "\n";
    const bool are_equal = rod.triads.front().angularDistance(rod.triads.back()) < round_off;
    if (is_line(rod) && !are_equal) text += "  axes at the end: " + describe_axes(rod.triads.back()) + "\n";
    const double twist = compute_twist(model, rod);
    if (std::abs(twist) >= least_twist) text += fmt::format("  twist: {:.4g} rad\n", twist);
    text += fmt::format("  slenderness L √(EA/EI): {:.4g}\n", compute_slenderness(section, rod.length));
    const double turn = compute_largest_turn(rod);
    if (turn < 1e-9) return text;
    return text + fmt::format("  largest turn of the tangent in an element: {:.3g}°\n", turn * 180.0 / M_PI);
}

}  // namespace gxrod
