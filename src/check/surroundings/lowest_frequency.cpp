#include "check/surroundings/lowest_frequency.hpp"

#include <algorithm>
#include <cmath>

#include "numerics/eigenvalues.hpp"

namespace gxrod {
namespace {

constexpr int beam_elements = 40;

// A beam of cubic elements in one plane, in which it moves by v: two numbers a place, v and v′.
class SwingingBeam {
  public:
    SwingingBeam(double length, int elements)
        : h_(length / elements),
          stiffness_(Eigen::MatrixXd::Zero(2 * elements + 2, 2 * elements + 2)),
          mass_(stiffness_) {}

    void add(int element, double bending, double tension, double mass) {
        const double h = h_;
        Eigen::Matrix4d bend, pull, inertia;
        bend << 12, 6 * h, -12, 6 * h, 6 * h, 4 * h * h, -6 * h, 2 * h * h, -12, -6 * h, 12, -6 * h, 6 * h,
            2 * h * h, -6 * h, 4 * h * h;
        pull << 36, 3 * h, -36, 3 * h, 3 * h, 4 * h * h, -3 * h, -h * h, -36, -3 * h, 36, -3 * h, 3 * h,
            -h * h, -3 * h, 4 * h * h;
        inertia << 156, 22 * h, 54, -13 * h, 22 * h, 4 * h * h, 13 * h, -3 * h * h, 54, 13 * h, 156, -22 * h,
            -13 * h, -3 * h * h, -22 * h, 4 * h * h;
        const int at = 2 * element;
        stiffness_.block<4, 4>(at, at) += bending / (h * h * h) * bend + tension / (30 * h) * pull;
        mass_.block<4, 4>(at, at) += mass * h / 420 * inertia;
    }

    // The smallest ω², with these numbers held.
    std::optional<double> find_lowest(const std::vector<int>& held) const {
        std::vector<int> free;
        for (int i = 0; i < stiffness_.rows(); ++i)
            if (std::ranges::find(held, i) == held.end()) free.push_back(i);
        const Eigen::MatrixXd K = stiffness_(free, free), M = mass_(free, free);
        const std::optional<Eigen::VectorXd> all = find_generalized_eigenvalues(K, M);
        if (!all || !std::isfinite((*all)[0])) return std::nullopt;
        return (*all)[0];
    }

  private:
    double h_;
    Eigen::MatrixXd stiffness_, mass_;
};

// The numbers of a beam that supports hold at the ends of what hangs, which moves along section y or z.
std::vector<int> list_held(const Model& model, const Rod& rod, const LineAtRest& line, int axis) {
    std::vector<int> held;
    const auto hold = [&](int node, std::size_t entry, bool is_on_ground, int number) {
        const Support* support = find_support_of(model, node);
        if (is_on_ground || is_held_along(model, node, rod.triads[entry] * Vec3::Unit(axis)))
            held.push_back(number);
        if (!is_on_ground && support != nullptr && support->holds_all(3)) held.push_back(number + 1);
    };
    hold(rod.nodes.front(), line.first, line.first > 0, 0);
    hold(rod.nodes.back(), line.last, line.last + 1 < line.arc_length.size(), 2 * beam_elements);
    return held;
}

// What hangs, as it moves along section y or z.
SwingingBeam make_beam(const Model& model, const Rod& rod, const LineAtRest& line, int axis) {
    const int bending = axis == 1 ? 5 : 4;  // along y a section bends about z
    const double length = line.to - line.from;
    const double density = model.surroundings.water ? model.surroundings.water->density_at(1.0) : 0.0;
    SwingingBeam beam(length, beam_elements);
    std::size_t entry = line.first;
    for (int e = 0; e < beam_elements; ++e) {
        const double s = line.from + length * (e + 0.5) / beam_elements;
        while (entry + 1 < line.last && line.arc_length[entry + 1] < s) ++entry;
        const double part =
            (s - line.arc_length[entry]) / (line.arc_length[entry + 1] - line.arc_length[entry]);
        const Section& section = section_at_entry(model, rod, part < 0.5 ? entry : entry + 1);
        const double added =
            section.fluid ? density * section.fluid->area * section.fluid->added_mass[axis] : 0.0;
        beam.add(e,
                 section.stiffness(bending, bending),
                 (1.0 - part) * line.tension[entry] + part * line.tension[entry + 1],
                 section.mass(0, 0) + added);
    }
    return beam;
}

bool has_body(const Model& model, int node) {
    return std::ranges::any_of(model.bodies, [&](const Body& body) { return body.node == node; });
}

}  // namespace

std::optional<double> find_lowest_frequency(const Model& model, const Rod& rod, const LineAtRest& line) {
    std::optional<double> lowest;
    for (const int axis : {1, 2}) {
        const Vec3 direction = rod.triads[line.first] * Vec3::Unit(axis);
        if (model.plane && std::abs(direction[model.plane->normal]) > 0.5) continue;
        for (const int node : {rod.nodes.front(), rod.nodes.back()})
            if (has_body(model, node) && !is_held_along(model, node, direction)) return std::nullopt;
        const std::vector<int> held = list_held(model, rod, line, axis);
        if (std::ranges::none_of(held, [](int number) { return number % 2 == 0; })) return std::nullopt;
        const std::optional<double> square = make_beam(model, rod, line, axis).find_lowest(held);
        if (!square || !(*square > 0.0)) return std::nullopt;
        lowest = lowest ? std::min(*lowest, *square) : *square;
    }
    if (!lowest) return std::nullopt;
    return std::sqrt(*lowest) / (2.0 * M_PI);
}

}  // namespace gxrod
