#include "loads/drive_values.hpp"

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

DriveValues::DriveValues(const Model& model) : model_(&model), first_point_(model.rods.size(), no_point) {
    for (const Actuation& actuation : model.actuations) place(actuation);
    strands_.reserve(model.tendons.size());
    for (const Tendon& tendon : model.tendons) place(tendon);
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

void DriveValues::move_strains(double time) {
    for (const ActuatedPoint& one : actuated_) drives_[one.point].strain.setZero();
    for (const ActuatedPoint& one : actuated_)
        drives_[one.point].strain += compute_strain(*one.actuation, one.expansion, time, one.s);
}

void DriveValues::move_to(double time) {
    if (time_ == time) return;
    time_.reset();
    move_strains(time);
    for (std::size_t i = 0; i < strands_.size(); ++i) {
        const double tension = model_->tendons[i].tension(time);
        for (const TendonPoint& one : strands_[i]) drives_[one.point].pulls[one.pull].tension = tension;
    }
    time_ = time;
}

std::span<const PointDrive> DriveValues::of(int rod, int element) const {
    if (!is_driven(rod)) return {};
    const auto order = static_cast<std::size_t>(model_->rods[static_cast<std::size_t>(rod)].order);
    return std::span(drives_).subspan(
        first_point_[static_cast<std::size_t>(rod)] + static_cast<std::size_t>(element) * order, order);
}

}  // namespace gxrod
