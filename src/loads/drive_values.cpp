#include "loads/drive_values.hpp"

#include "loads/pressure.hpp"
#include "loads/shape_functions.hpp"
#include "numerics/gauss_legendre.hpp"

namespace gxrod {
namespace {

std::size_t count_force_points(const Rod& rod) {
    return static_cast<std::size_t>(rod.element_count()) * static_cast<std::size_t>(rod.order);
}

// The section at a force point.
const Section& section_at(const Model& model, const Rod& rod, std::size_t point) {
    return rod.has_varying_sections() ? rod.varying.at_forces[point]
                                      : model.sections[static_cast<std::size_t>(rod.section)];
}

double middle_of(const Rod& rod, int element) {
    const auto first = static_cast<std::size_t>(element) * static_cast<std::size_t>(rod.order + 1);
    return 0.5 * (rod.arc_length[first] + rod.arc_length[first + static_cast<std::size_t>(rod.order)]);
}

// The strain by heat at a point (y, z) of the section is expansion (T + T_y y + T_z z): that of a section
// whose line stretches, and which bends about y and z: Γx + Ky z − Kz y.
Vec6 compute_strain(const Actuation& actuation, double expansion, double time, double s) {
    Vec6 strain;
    for (int i = 0; i < 6; ++i) strain[i] = actuation.strain[static_cast<std::size_t>(i)](time, s);
    if (expansion == 0.0) return strain;
    strain[0] += expansion * actuation.temperature(time, s);
    strain[4] += expansion * actuation.temperature_gradient[1](time, s);
    strain[5] -= expansion * actuation.temperature_gradient[0](time, s);
    return strain;
}

}  // namespace

DriveValues::DriveValues(const Model& model, TendonsIn tendons)
    : model_(&model), first_point_(model.rods.size(), no_point) {
    if (tendons == TendonsIn::none) return;
    const std::size_t pressed = model.surroundings.is_empty() ? 0 : model.rods.size();
    for (std::size_t rod = 0; rod < pressed; ++rod) place_pressures(static_cast<int>(rod));
    for (const Actuation& actuation : model.actuations) place(actuation);
    strands_.reserve(model.tendons.size());
    for (const Tendon& tendon : model.tendons) {
        if (tendon.winch && tendons == TendonsIn::prescribed) {
            strands_.emplace_back();
        } else {
            place(tendon);
        }
    }
}

void DriveValues::lay_out(int rod) {
    std::size_t& first = first_point_[static_cast<std::size_t>(rod)];
    if (first != no_point) return;
    first = drives_.size();
    drives_.resize(first + count_force_points(model_->rods[static_cast<std::size_t>(rod)]));
}

void DriveValues::place(const Actuation& actuation) {
    lay_out(actuation.rod);
    const Rod& rod = model_->rods[static_cast<std::size_t>(actuation.rod)];
    const std::size_t first = first_point_[static_cast<std::size_t>(actuation.rod)];
    const std::vector<double> points = list_force_points(rod);
    for (std::size_t i = 0; i < points.size(); ++i)
        actuated_.push_back({first + i, &actuation, points[i], section_at(*model_, rod, i).expansion});
}

void DriveValues::place(const Tendon& tendon) {
    lay_out(tendon.rod);
    const Rod& rod = model_->rods[static_cast<std::size_t>(tendon.rod)];
    const std::size_t first = first_point_[static_cast<std::size_t>(tendon.rod)];
    const auto order = static_cast<std::size_t>(rod.order);
    const std::vector<double> points = list_force_points(rod);
    Strand strand;
    for (std::size_t i = 0; i < points.size(); ++i) {
        const double middle = middle_of(rod, static_cast<int>(i / order));
        if (middle < tendon.from || middle >= tendon.to) continue;
        const TendonPlace place = tendon.path(points[i]);
        std::vector<TendonPull>& pulls = drives_[first + i].pulls;
        strand.push_back({first + i, pulls.size()});
        pulls.push_back({0.0, place.at, place.slope});
    }
    strands_.push_back(std::move(strand));
}

void DriveValues::place_pressures(int index) {
    const Rod& rod = model_->rods[static_cast<std::size_t>(index)];
    const auto is_pressed = [](const Section& section) {
        return section.fluid && section.fluid->poisson != 0.5;
    };
    if (!is_pressed(section_at(*model_, rod, 0))) return;
    lay_out(index);
    const std::size_t first = first_point_[static_cast<std::size_t>(index)];
    const auto order = static_cast<std::size_t>(rod.order);
    const ShapeFunctions shapes_at = find_shape_functions(rod.order);
    const std::vector<QuadraturePoint> rule = list_gauss_rule(rod.order);
    for (std::size_t i = 0; i < count_force_points(rod); ++i) {
        const ShapeValues shapes = shapes_at(rule[i % order].xi);
        PressedPoint pressed{.point = first + i, .section = &section_at(*model_, rod, i), .heights = {}};
        for (std::size_t k = 0; k <= order; ++k)
            pressed.heights.emplace_back(rod.element_nodes[i / order * (order + 1) + k], shapes.value[k]);
        pressed_.push_back(std::move(pressed));
    }
}

void DriveValues::press(const std::vector<NodeMotion>& motions, double time) {
    const std::optional<Water>& water = model_->surroundings.water;
    const double gravity = model_->gravity(time).norm();
    const double water_factor = water ? water->factor(time) : 1.0;
    for (const PressedPoint& one : pressed_) {
        double z = 0.0;
        for (const auto& [node, share] : one.heights)
            z += share * motions[static_cast<std::size_t>(node)].r.z();
        const double force = compute_pressure_force(*one.section->fluid, water, gravity, z, water_factor);
        drives_[one.point].strain[0] =
            one.given + compute_pressure_strain(*one.section->fluid, force, one.section->stiffness(0, 0));
    }
}

void DriveValues::move_strains(double time) {
    for (const ActuatedPoint& one : actuated_) drives_[one.point].strain.setZero();
    for (const PressedPoint& one : pressed_) drives_[one.point].strain.setZero();
    for (const ActuatedPoint& one : actuated_)
        drives_[one.point].strain += compute_strain(*one.actuation, one.expansion, time, one.s);
    for (PressedPoint& one : pressed_) one.given = drives_[one.point].strain[0];
}

void DriveValues::move_to(double time) {
    if (time_ == time) return;
    time_.reset();
    move_strains(time);
    std::vector<double> tensions;
    if (!strands_.empty()) {
        for (const Tendon& tendon : model_->tendons) tensions.push_back(tendon.tension(time));
        set_tensions(tensions);
    }
    time_ = time;
}

void DriveValues::set_tensions(std::span<const double> tensions) {
    for (std::size_t i = 0; i < strands_.size(); ++i) {
        for (const TendonPoint& one : strands_[i]) drives_[one.point].pulls[one.pull].tension = tensions[i];
    }
}

void DriveValues::set_tensions(std::size_t tendon, std::span<const double> at_points) {
    const Strand& strand = strands_[tendon];
    for (std::size_t i = 0; i < strand.size(); ++i)
        drives_[strand[i].point].pulls[strand[i].pull].tension = at_points[i];
}

std::span<const PointDrive> DriveValues::of(int rod, int element) const {
    if (!is_driven(rod)) return {};
    const auto order = static_cast<std::size_t>(model_->rods[static_cast<std::size_t>(rod)].order);
    return std::span(drives_).subspan(
        first_point_[static_cast<std::size_t>(rod)] + static_cast<std::size_t>(element) * order, order);
}

}  // namespace gxrod
