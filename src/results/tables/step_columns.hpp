#pragma once

#include <array>
#include <cstdint>
#include <type_traits>
#include <variant>

#include "state/records/step_record.hpp"

// The columns of /ledger and /solver, one row a step: the only list of them.
namespace gxrod {

template <class Row>
struct StepColumn {
    const char* name;
    const char* description;
    const char* dimension;
    std::variant<double Row::*, Vec3 Row::*, int Row::*, std::int64_t Row::*> member;
    bool is_of_statics = false;  // only

    constexpr int width() const { return std::holds_alternative<Vec3 Row::*>(member) ? 3 : 1; }
    constexpr const char* frame() const { return width() == 3 ? "spatial" : "none"; }
};

using LedgerColumn = StepColumn<LedgerRow>;
using SolverColumn = StepColumn<SolverRow>;

inline constexpr std::array<LedgerColumn, 12> ledger_columns{{
    {"kinetic_energy", "kinetic energy", "force·length", &LedgerRow::kinetic_energy},
    {"strain_energy", "strain energy", "force·length", &LedgerRow::strain_energy},
    {"external_work",
     "work of loads, gravity and moved supports since t = 0",
     "force·length",
     &LedgerRow::external_work},
    {"fluid_work",
     "the part of external_work that water, air and the ground do",
     "force·length",
     &LedgerRow::fluid_work},
    {"contact_energy",
     "stored between rods and what they touch, and in friction that holds",
     "force·length",
     &LedgerRow::contact_energy},
    {"contact_loss",
     "energy lost to contact since t = 0, by impacts and friction",
     "force·length",
     &LedgerRow::contact_loss},
    {"work_uncertainty",
     "how far the work of the load step that ended here may be off; 0 in dynamics",
     "force·length",
     &LedgerRow::work_uncertainty},
    {"dissipated_energy",
     "energy lost to damping since t = 0",
     "force·length",
     &LedgerRow::dissipated_energy},
    {"numerical_dissipation",
     "energy that the time integration itself takes away since t = 0",
     "force·length",
     &LedgerRow::numerical_dissipation},
    {"energy_error",
     "(kinetic + strain + contact energy) - its value at t = 0 - external work + dissipated energy + "
     "numerical dissipation + contact loss",
     "force·length",
     &LedgerRow::energy_error},
    {"linear_momentum", "linear momentum", "mass·length/time", &LedgerRow::linear_momentum},
    {"angular_momentum",
     "angular momentum about the origin",
     "mass·length²/time",
     &LedgerRow::angular_momentum},
}};

inline constexpr std::array<SolverColumn, 8> solver_columns{{
    {"time_step", "length of the step that ended here", "time", &SolverRow::time_step},
    {"residual", "scaled residual of the step's last equilibrium", "1", &SolverRow::residual},
    {"newton_iterations",
     "Newton iterations over all stages of the step",
     "1",
     &SolverRow::newton_iterations},
    {"rejected_steps", "trial steps cut before this one was accepted", "1", &SolverRow::rejected_steps},
    {"contacts", "places of rods that touch something", "1", &SolverRow::contacts},
    {"least_gap",
     "the least gap of all iterations of the step; 0 without contact",
     "length",
     &SolverRow::least_gap},
    {"shortened",
     "iterations of the step whose increment was shortened so that no gap closes",
     "1",
     &SolverRow::shortened},
    {"negative_pivots",
     "negative pivots of the tangent: 0 where the equilibrium is stable; -1 where that is unknown, as with "
     "loads that have no potential",
     "1",
     &SolverRow::negative_pivots,
     true},
}};

// Counts the numbers in a row of these columns.
template <class Columns>
constexpr int count_numbers(const Columns& columns, bool is_static) {
    int numbers = 0;
    for (const auto& column : columns) numbers += !column.is_of_statics || is_static ? column.width() : 0;
    return numbers;
}

// Returns the numbers of a column in a row; a single number comes first.
template <class Row>
std::array<double, 3> numbers_of(const StepColumn<Row>& column, const Row& row) {
    return std::visit(
        [&](auto member) -> std::array<double, 3> {
            const auto& value = row.*member;
            if constexpr (std::is_same_v<decltype(value), const Vec3&>) {
                return {value[0], value[1], value[2]};
            } else {
                return {static_cast<double>(value)};
            }
        },
        column.member);
}

}  // namespace gxrod
