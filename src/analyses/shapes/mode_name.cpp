#include "analyses/shapes/mode_name.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

namespace gxrod {
namespace {

// What a rod does in a mode, in the order of the names.
enum class Motion { flap, edge, torsion, extension };
constexpr std::array<const char*, 4> motion_names{"flap", "edge", "torsion", "extension"};

// Of the largest value: smaller ones have no sign.
constexpr double without_sign = 0.01;

int count_sign_changes(const std::vector<double>& values) {
    double largest = 0.0;
    for (const double value : values) largest = std::max(largest, std::abs(value));
    int changes = 0;
    double last = 0.0;
    for (const double value : values) {
        if (std::abs(value) <= without_sign * largest) continue;
        if (last * value < 0.0) ++changes;
        last = value;
    }
    return changes;
}

bool is_one_line(const Rod& rod) {
    const auto nodes = static_cast<std::size_t>(rod.order) + 1;
    for (std::size_t first = nodes; first < rod.element_nodes.size(); first += nodes) {
        if (rod.element_nodes[first] != rod.element_nodes[first - 1]) return false;
    }
    return !rod.element_nodes.empty();
}

std::string write_order(int order) {
    const bool is_teen = order % 100 > 10 && order % 100 < 14;
    const int last = is_teen ? 0 : order % 10;
    return fmt::format("{}{}", order, last == 1 ? "st" : last == 2 ? "nd" : last == 3 ? "rd" : "th");
}

double& energy_of(std::array<double, 4>& energies, Motion motion) {
    return energies[static_cast<std::size_t>(motion)];
}

// A rod in a shape, node by node of its elements.
class MovingRod {
  public:
    MovingRod(const System& system, const State& state, std::size_t rod)
        : model_(system.model()), state_(state), rod_(model_.rods[rod]) {}

    // Adds the kinetic energy of velocities in proportion to the shape: across the rod along `axis` and in
    // the plane across it, about the rod's own axis, and along it.
    void add_energies(const std::vector<Vec6>& shape,
                      const Vec3& axis,
                      std::array<double, 4>& energies) const {
        for (std::size_t i = 0; i < rod_.element_nodes.size(); ++i) {
            const Vec3 tangent = axes_at(i).col(0);
            const Vec6& motion = shape[node_at(i)];
            const Mat6& mass = section_at_node(i).mass;
            const double weight = length_of(i) * mass(0, 0);
            const double along = motion.head<3>().dot(tangent);
            const Vec3 across = motion.head<3>() - along * tangent;
            const double out = across.dot(direction(Motion::flap, i, axis));
            energy_of(energies, Motion::flap) += weight * out * out;
            energy_of(energies, Motion::edge) += weight * std::max(across.squaredNorm() - out * out, 0.0);
            energy_of(energies, Motion::torsion) +=
                length_of(i) * mass(3, 3) * std::pow(motion.tail<3>().dot(tangent), 2);
            energy_of(energies, Motion::extension) += weight * along * along;
        }
    }

    // Counts the order of the shape in a motion; `across`: the direction of a flap, at each node of an
    // element.
    template <class Across>
    int find_order(const std::vector<Vec6>& shape, Motion motion, const Across& across) const {
        std::vector<double> values, moments;
        const auto nodes = static_cast<std::size_t>(rod_.order) + 1;
        const bool is_along = motion == Motion::torsion || motion == Motion::extension;
        for (std::size_t i = 0; i < rod_.element_nodes.size(); ++i) {
            const Vec3 tangent = axes_at(i).col(0);
            const Vec3 way = is_along ? tangent : across(i);
            const Vec6& moved = shape[node_at(i)];
            values.push_back((motion == Motion::torsion ? moved.tail<3>() : moved.head<3>()).dot(way));
            if (i % nodes == 0) continue;
            const Vec6 change = moved - shape[node_at(i - 1)];
            moments.push_back(
                motion == Motion::extension
                    ? find_resultant(i, change.head<3>(), tangent, 0)
                    : find_resultant(i, change.tail<3>(), is_along ? tangent : tangent.cross(way), 3));
        }
        return 1 + std::min(count_sign_changes(values), count_sign_changes(moments));
    }

    Mat3 axes_at(std::size_t i) const {
        return (state_.trial[node_at(i)].Lambda * rod_.triads[i]).toRotationMatrix();
    }
    // The direction of a flap, or of an edge, of a frame that turns about the axis; any one where the rod is
    // along it.
    Vec3 direction(Motion motion, std::size_t i, const Vec3& axis) const {
        const Mat3 axes = axes_at(i);
        const Vec3 tangent = axes.col(0);
        const Vec3 out = axis - axis.dot(tangent) * tangent;
        const Vec3 flapping = out.norm() > 1e-6 ? Vec3(out.normalized()) : Vec3(axes.col(1));
        return motion == Motion::flap ? flapping : Vec3(tangent.cross(flapping));
    }

  private:
    // The force, `first` 0, or the moment, 3, about an axis by a change of displacement, or turn, from the
    // node before to this one, by the section's stiffness against that alone.
    double find_resultant(std::size_t i, const Vec3& change, const Vec3& axis, Eigen::Index first) const {
        const Vec3 own = axes_at(i).transpose() * axis;
        const Mat3 stiffness = section_at_node(i).stiffness.block<3, 3>(first, first);
        return own.dot(stiffness * own) * change.dot(axis) / (rod_.arc_length[i] - rod_.arc_length[i - 1]);
    }
    std::size_t node_at(std::size_t i) const { return static_cast<std::size_t>(rod_.element_nodes[i]); }
    const Section& section_at_node(std::size_t i) const {
        return rod_.has_varying_sections() ? rod_.varying.at_nodes[i]
                                           : model_.sections[static_cast<std::size_t>(rod_.section)];
    }
    // The length that a node of an element stands for.
    double length_of(std::size_t i) const {
        const auto nodes = static_cast<std::size_t>(rod_.order) + 1;
        const std::size_t first = i - i % nodes, last = first + nodes - 1;
        const double before = i == first ? rod_.arc_length[i] : rod_.arc_length[i - 1];
        const double after = i == last ? rod_.arc_length[i] : rod_.arc_length[i + 1];
        return 0.5 * (after - before);
    }

    const Model& model_;
    const State& state_;
    const Rod& rod_;
};

// The strain with the largest share of energy, and the rod with the largest share of that.
struct Strained {
    std::size_t rod = 0;
    int strain = 0;
    double share = 0.0;
};

Strained find_strained(const Shape& shape) {
    Vec6 sums = Vec6::Zero();
    for (const Vec6& shares : shape.energy_shares) sums += shares;
    Strained found;
    sums.maxCoeff(&found.strain);
    const auto share = [&](const Vec6& shares) { return shares[found.strain]; };
    const auto largest = std::ranges::max_element(shape.energy_shares, {}, share);
    found.rod = static_cast<std::size_t>(largest - shape.energy_shares.begin());
    found.share = share(*largest);
    return found;
}

// Whether words are those of a strain, not of a rigid motion.
bool is_strain(const std::string& words) {
    return std::ranges::any_of(std::array{"extension of", "shear along", "torsion of", "bending about"},
                               [&](const char* start) { return words.starts_with(start); });
}

// The order in words of the motion that belongs to a strain: "2nd "; "" of shear.
std::string find_strain_order(const MovingRod& moving, const Shape& shape, int strain) {
    if (strain == 1 || strain == 2) return "";
    // Bending about y moves along z, bending about z along y.
    const auto across = [&](std::size_t i) { return Vec3(moving.axes_at(i).col(strain == 4 ? 2 : 1)); };
    const Motion motion = strain == 0 ? Motion::extension : strain == 3 ? Motion::torsion : Motion::flap;
    return write_order(moving.find_order(shape.nodes, motion, across)) + " ";
}

}  // namespace

std::string name_mode(const System& system,
                      const State& state,
                      const Shape& shape,
                      const std::vector<Vec6>* imaginary) {
    if (shape.energy_shares.empty() || !is_strain(shape.words)) return shape.words;
    const Strained strained = find_strained(shape);
    if (strained.share <= 0.0 || !is_one_line(system.model().rods[strained.rod])) return shape.words;
    const MovingRod moving(system, state, strained.rod);
    const std::optional<TurningFrame>& frame = system.model().rotation;
    if (!frame || frame->is_at_rest()) return find_strain_order(moving, shape, strained.strain) + shape.words;
    std::array<double, 4> energies{}, of_imaginary{};
    moving.add_energies(shape.nodes, frame->axis, energies);
    const std::array<double, 4> of_real = energies;
    if (imaginary != nullptr) moving.add_energies(*imaginary, frame->axis, of_imaginary);
    for (std::size_t i = 0; i < 4; ++i) energies[i] += of_imaginary[i];
    const auto motion = static_cast<Motion>(std::ranges::max_element(energies) - energies.begin());
    const auto across = [&](std::size_t i) { return moving.direction(motion, i, frame->axis); };
    // Counted where most of the motion is: the other part can be round-off.
    const auto place = static_cast<std::size_t>(motion);
    const bool is_in_real = imaginary == nullptr || of_real[place] >= of_imaginary[place];
    const std::string order =
        write_order(moving.find_order(is_in_real ? shape.nodes : *imaginary, motion, across));
    if (shape.words.starts_with(motion_names[static_cast<std::size_t>(motion)]))
        return order + " " + shape.words;
    return fmt::format("{} {}: {}", order, motion_names[static_cast<std::size_t>(motion)], shape.words);
}

}  // namespace gxrod
