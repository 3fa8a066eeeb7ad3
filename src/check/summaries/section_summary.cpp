#include "check/summaries/section_summary.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <vector>

#include "model/sections/section_centres.hpp"

namespace gxrod {
namespace {

// Of stiffnesses compared with each other.
constexpr double round_off = 1e-9;
constexpr double degrees = 180.0 / M_PI;

struct Centre {
    const char* name;
    SectionPoint point;
};

// Without those of a section that has none.
std::vector<Centre> list_centres(const SectionCentres& centres) {
    std::vector<Centre> list{{"shear centre", centres.shear_centre()},
                             {"tension centre", centres.tension_centre()}};
    if (centres.centre_of_mass()) list.push_back({"centre of mass", *centres.centre_of_mass()});
    return list;
}

bool differ(double a, double b) { return std::abs(a - b) > round_off * std::max(std::abs(a), std::abs(b)); }

// Whether they say more than the matrix does, about y and z through the node.
bool is_worth(const PrincipalAxes& axes, const Mat6& matrix) {
    return axes.turn != 0.0 || differ(axes.about_y, matrix(4, 4)) || differ(axes.about_z, matrix(5, 5));
}

std::string describe_axes(const PrincipalAxes& axes) {
    const std::string values = fmt::format("{:.6g} and {:.6g} about y and z", axes.about_y, axes.about_z);
    return axes.turn == 0.0 ? values : fmt::format("{} turned by {:.4g}°", values, axes.turn * degrees);
}

// Models that no deck has made may have no stiffness.
bool has_centres(const Section& section) { return section.stiffness.diagonal().minCoeff() > 0.0; }

// The centres that are not at the node and the axes, a text each.
std::vector<std::string> list_findings(const Section& section) {
    if (!has_centres(section)) return {};
    const SectionCentres centres(section.stiffness, section.mass);
    std::vector<std::string> findings;
    for (const auto& [name, point] : list_centres(centres)) {
        const SectionPoint at = centres.clean(point);
        if (!at.isZero(0.0)) findings.push_back(fmt::format("{} at ({:.6g}, {:.6g})", name, at.x(), at.y()));
    }
    if (is_worth(centres.bending(), section.stiffness))
        findings.push_back("bending stiffness " + describe_axes(centres.bending()));
    if (centres.inertia() && is_worth(*centres.inertia(), section.mass))
        findings.push_back("rotary inertia about its centre " + describe_axes(*centres.inertia()));
    return findings;
}

std::string indent(const std::vector<std::string>& findings, const char* lead) {
    return findings.empty() ? "" : fmt::format("  {}{}\n", lead, fmt::join(findings, ", "));
}

class Extremes {
  public:
    void add(double value) {
        least_ = std::min(least_, value);
        most_ = std::max(most_, value);
    }
    bool is_zero() const { return least_ == 0.0 && most_ == 0.0; }
    std::string describe() const { return fmt::format("{:.6g} … {:.6g}", least_, most_); }

  private:
    double least_ = std::numeric_limits<double>::infinity();
    double most_ = -std::numeric_limits<double>::infinity();
};

// Of the y and z of a centre along a rod, or of a turn in degrees.
struct NamedRange {
    std::string name;
    Extremes values;
};

void add(const std::string& name, double value, std::vector<NamedRange>& ranges) {
    auto found = std::ranges::find(ranges, name, &NamedRange::name);
    if (found == ranges.end()) found = ranges.insert(ranges.end(), {name, {}});
    found->values.add(value);
}

std::vector<NamedRange> find_ranges(const Rod& rod) {
    std::vector<NamedRange> ranges;
    for (const auto* sections : {&rod.varying.at_nodes, &rod.varying.at_forces, &rod.varying.at_masses}) {
        for (const Section& section : *sections) {
            if (!has_centres(section)) continue;
            const SectionCentres centres(section.stiffness, section.mass);
            for (const auto& [name, point] : list_centres(centres)) {
                add(fmt::format("{} y", name), centres.clean(point).x(), ranges);
                add(fmt::format("{} z", name), centres.clean(point).y(), ranges);
            }
            add("turn in degrees of the axes of bending", centres.bending().turn * degrees, ranges);
            if (centres.inertia())
                add("turn in degrees of those of inertia", centres.inertia()->turn * degrees, ranges);
        }
    }
    return ranges;
}

}  // namespace

std::string describe_centres(const Section& section) { return indent(list_findings(section), ""); }

std::string describe_varying_centres(const Rod& rod) {
    std::vector<std::string> along;
    for (const NamedRange& range : find_ranges(rod)) {
        if (!range.values.is_zero()) along.push_back(range.name + " " + range.values.describe());
    }
    return indent(list_findings(rod.varying.at_nodes.front()), "at the start: ") +
           indent(list_findings(rod.varying.at_nodes.back()), "at the end: ") +
           indent(along, "along the rod: ");
}

}  // namespace gxrod
