#pragma once

#include <algorithm>
#include <span>
#include <string>
#include <type_traits>
#include <vector>

#include "machine/checksum.hpp"
#include "results/file/hdf5_objects.hpp"
#include "state/records/restart_record.hpp"

// The storage, in a slot of /restart, of the state from which to resume.
namespace gxrod {

inline constexpr std::int64_t no_slot = -1;
inline constexpr std::int64_t form_version = 20;  // version of /restart; raise it with every change
inline std::string slot_name(std::int64_t slot) { return slot == 0 ? "a" : "b"; }

using Vec1 = Eigen::Matrix<double, 1, 1>;

// Calls visit(vector) for each vector of a row, const or not.
template <class Row, class Visitor>
void visit_vectors(Row& row, Visitor&& visit) {
    using Kind = std::remove_const_t<Row>;
    if constexpr (std::is_same_v<Kind, NodeMotion>) {
        visit(row.r);
        visit(row.Lambda.coeffs());
        visit(row.v);
        visit(row.omega);
        visit(row.a);
        visit(row.alpha);
    } else if constexpr (std::is_same_v<Kind, SectionHistory>) {
        visit(row.Lambda.coeffs());
        visit(row.K);
    } else if constexpr (std::is_same_v<Kind, CarriedAcceleration>) {
        visit(row.a);
        visit(row.alpha);
    } else if constexpr (std::is_same_v<Kind, PointSurroundings>) {
        for (auto* vector : {&row.water_velocity, &row.fluid_force, &row.bed_force}) visit(*vector);
        for (auto* number : {&row.wet_fraction, &row.pressure_force}) visit_vectors(*number, visit);
    } else if constexpr (std::is_same_v<Kind, PointValues>) {
        visit_vectors(row.motion, visit);
        for (auto* vector : {&row.start, &row.force, &row.moment, &row.strain, &row.curvature})
            visit(*vector);
        visit(row.triad.coeffs());
        visit_vectors(row.surroundings, visit);
    } else if constexpr (std::is_same_v<Kind, JointState>) {
        visit(Eigen::Map<std::conditional_t<std::is_const_v<Row>, const Vec6, Vec6>>(row.multipliers.data()));
        for (auto* number : {&row.turn, &row.slide}) visit_vectors(*number, visit);
    } else if constexpr (std::is_same_v<Kind, InputState>) {
        for (auto* number : {&row.is_set, &row.planned, &row.from_time, &row.from, &row.to_time, &row.to})
            visit_vectors(*number, visit);
    } else if constexpr (std::is_same_v<Kind, SignalState>) {
        for (auto* number :
             {&row.measured, &row.is_started, &row.time, &row.filtered, &row.integral, &row.largest})
            visit_vectors(*number, visit);
    } else if constexpr (std::is_same_v<Kind, double>) {
        visit(Eigen::Map<std::conditional_t<std::is_const_v<Row>, const Vec1, Vec1>>(&row));
    } else {
        static_assert(std::is_same_v<Kind, Vec6> || std::is_same_v<Kind, PairTractionRow>);
        visit(row);
    }
}

template <class Row>
hsize_t count_columns() {
    hsize_t columns = 0;
    Row row{};
    visit_vectors(row, [&](const auto& vector) { columns += static_cast<hsize_t>(vector.size()); });
    return columns;
}

struct RestartNumbers {
    hsize_t columns;
    std::vector<double> values = {};
};

template <class Row>
RestartNumbers table_of(std::span<const Row> rows) {
    RestartNumbers table{count_columns<Row>()};
    table.values.reserve(rows.size() * table.columns);
    for (const Row& row : rows) {
        visit_vectors(row, [&](const auto& vector) {
            table.values.insert(table.values.end(), vector.data(), vector.data() + vector.size());
        });
    }
    return table;
}

template <class Row>
std::vector<Row> rows_of(const RestartNumbers& table) {
    std::vector<Row> rows(table.values.size() / table.columns);
    const double* next = table.values.data();
    for (Row& row : rows) {
        visit_vectors(row, [&](auto&& vector) {
            std::copy_n(next, vector.size(), vector.data());
            next += vector.size();
        });
    }
    return rows;
}

// Calls visit(name, member) for each single number of a place.
template <class Place, class Visitor>
void visit_numbers(Place& place, Visitor&& visit) {
    auto& [record, steps, frames, samples] = place;
    visit("steps", steps);
    visit("frames", frames);
    visit("samples", samples);
    visit("time", record.steps.time);
    visit("has_failed", record.steps.has_failed);
    visit("is_off_grid", record.steps.is_off_grid);
    visit("lead", record.steps.lead);
    visit("next_step", record.steps.step);
    visit("error_before", record.steps.error_before);
    visit("just_rejected", record.steps.just_rejected);
    visit("steps_by_error", record.steps.accepted);
    visit("initial_energy", record.ledger.initial_energy);
    visit("initial_potential", record.ledger.initial_potential);
    visit("work", record.ledger.work);
    visit("dissipated", record.ledger.dissipated);
    visit("dissipated_by_scheme", record.ledger.dissipated_by_scheme);
    visit("fluid_work", record.ledger.fluid_work);
    visit("contact_loss", record.ledger.contact_loss);
    visit("contact_energy", record.ledger.contact_energy);
    visit("initial_contact_energy", record.ledger.initial_contact_energy);
    visit("driving_power", record.ledger.driving_power);
    visit("damping_power", record.ledger.damping_power);
    visit("negative_pivots", record.negative_pivots);
    visit("load_step", record.ledger.load_step);
    visit("strain_energy", record.ledger.strain_energy);
    visit("largest_strain_energy_or_work", record.ledger.largest_energy);
    visit("is_framed", record.is_framed);
    visit("accepted_steps", record.totals.steps);
    visit("rejected_steps", record.totals.rejected_steps);
    visit("newton_iterations", record.totals.newton_iterations);
    visit("largest_energy", record.totals.largest_energy);
    visit("largest_energy_error", record.totals.largest_energy_error);
    visit("jumps", record.totals.jumps.count);
    visit("jump_from", record.totals.jumps.largest.from);
    visit("jump_to", record.totals.jumps.largest.to);
    visit("jump_energy", record.totals.jumps.largest.energy);
    visit("stage", record.stage);
    visit("axis_start", record.axis_start);
    visit("load_factor", record.path.load_factor);
    visit("load_scale", record.path.load_scale);
    visit("load_rate", record.path.load_rate);
    visit("load_sense", record.path.load_sense);
    visit("critical_points", record.path.points);
}

inline std::uint32_t sum_of(const RestartNumbers& table, std::uint32_t before) {
    return checksum(std::span<const double>(table.values), before);
}

inline const DatasetLabel nodes_label{
    "nodes",
    "of each node: position, rotation as quaternion x y z w, velocity, angular "
    "velocity, acceleration, angular acceleration",
    "spatial",
    ""};
inline const DatasetLabel sections_label{
    "sections",
    "of each force point that remembers: section axes as quaternion x y z w, "
    "material curvature",
    "none",
    ""};
inline const DatasetLabel memory_label{
    "memory",
    "all other numbers that parts remember from step to step: tensions of tendons with friction, laws of "
    "sections, the ground, obstacles, slip points of joints",
    "none",
    ""};
// Rows whose number changes within a stage have a dataset for each number, a power of two.
inline const DatasetLabel pair_tractions_label{
    "pair_tractions",
    "of each pair of pieces of rods that touch: the pieces, friction on the first; then rows of zeros",
    "spatial",
    ""};
inline const DatasetLabel carried_label{
    "carried",
    "of each node: accelerations and angular accelerations that the scheme carries to the next step",
    "spatial",
    ""};
inline const DatasetLabel points_label{
    "points",
    "of each point that histories show: what they show of it, as motion, forces and surroundings",
    "none",
    ""};
inline const DatasetLabel point_places_label{
    "point_places",
    "of each of these points: rod, element, place in it, whether it is asked for",
    "none",
    ""};
// Appends the number of rows to the name, as a list can have other numbers in other stages or at other times.
inline DatasetLabel with_rows(DatasetLabel label, std::size_t rows) {
    if (label.name == pair_tractions_label.name || label.name == carried_label.name ||
        label.name == points_label.name || label.name == point_places_label.name)
        label.name += "_" + std::to_string(rows);
    return label;
}
inline const DatasetLabel joints_label{
    "joints", "of each joint: up to six multipliers, turn, slide", "none", ""};
inline const DatasetLabel reactions_label{
    "reactions", "force and moment that the support of each node exerts", "spatial", ""};
inline const DatasetLabel bodies_label{
    "bodies", "of each body: water, air and ground around it", "spatial", ""};
inline const DatasetLabel forces_label{
    "forces", "force and moment that does work on each node", "spatial", ""};
inline const DatasetLabel fluid_forces_label{
    "fluid_forces", "force and moment of water, air and the ground on each node", "spatial", ""};
inline const DatasetLabel force_change_label{
    "force_change", "change of these in the last load step", "spatial", ""};
inline const DatasetLabel movement_label{
    "movement", "displacement and rotation vector of each node in the last load step", "spatial", ""};
inline const DatasetLabel path_tangent_label{
    "path_tangent", "of each node: displacement and spin of the path's unit tangent", "spatial", ""};

inline const DatasetLabel stage_ends_label{
    "stage_ends", "t where each stage ended, or is to end as far as that is known", "none", ""};

inline const DatasetLabel inputs_label{
    "inputs",
    "of each input: whether it was set (1) or has the deck's course, the deck's value at t = 0, and the line "
    "on which it goes: time and value at its start and its end",
    "none",
    ""};

inline const DatasetLabel signals_label{"signals",
                                        "of each signal: what it measured, whether it was set (1) and when, "
                                        "its value behind the filter then, and "
                                        "the integral of the error",
                                        "none",
                                        ""};

// Calls visit(label, rows) for each list of a record. Some are empty in some stages and not in others.
template <class Record, class Visitor>
void visit_lists(Record& record, Visitor&& visit) {
    visit(nodes_label, record.nodes);
    visit(sections_label, record.sections);
    visit(memory_label, record.memory);
    visit(pair_tractions_label, record.pair_tractions);
    visit(carried_label, record.carried);
    visit(joints_label, record.joints);
    visit(reactions_label, record.reactions);
    visit(points_label, record.points);
    visit(point_places_label, record.point_places);
    visit(bodies_label, record.bodies);
    visit(forces_label, record.ledger.forces);
    visit(fluid_forces_label, record.ledger.fluid_forces);
    visit(force_change_label, record.ledger.force_change);
    visit(movement_label, record.ledger.movement);
    visit(path_tangent_label, record.path.tangent);
    visit(stage_ends_label, record.stage_ends);
    visit(inputs_label, record.inputs);
    visit(signals_label, record.signals);
}

inline DatasetLabel numbers_label() {
    std::string names;
    const RestartPlace none;
    visit_numbers(none, [&](const char* name, const auto&) { names += std::string(" ") + name; });
    visit_lists(none.record,
                [&](const DatasetLabel& label, const auto&) { names += " rows_of_" + label.name; });
    return {"numbers", "single numbers, in order:" + names + " checksum_of_state", "none", ""};
}

}  // namespace gxrod
