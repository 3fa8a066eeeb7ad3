#pragma once

#include "deck/schema/schema.hpp"

// The tables of a deck, as schema.cpp lists them.
namespace gxrod {

const TableSpec& function_table();
const TableSpec& input_table();
const TableSpec& signal_table();
const TableSpec& section_table();
const TableSpec& damping_table();  // of sections
const TableSpec& law_table();
const TableSpec& rod_table();
const TableSpec& body_table();
const TableSpec& spring_table();
const TableSpec& bushing_table();
const TableSpec& joint_table();
const TableSpec& gear_table();
const TableSpec& connect_table();
const TableSpec& imperfection_table();
const TableSpec& load_table();
const TableSpec& combination_table();
const TableSpec& tendon_table();
const TableSpec& actuation_table();
const TableSpec& magnetic_table();
const TableSpec& fluid_table();
const TableSpec& wave_table();
const TableSpec& air_table();
const TableSpec& seabed_table();
const TableSpec& section_fluid_table();
const TableSpec& contact_table();
const TableSpec& obstacle_table();
const TableSpec& support_table();
const TableSpec& initial_table();
const TableSpec& analysis_table();
const TableSpec& stage_table();
const TableSpec& rotation_table();
const TableSpec& output_table();
const TableSpec& history_table();

// Whether expressions use the names of these tables.
inline bool is_for_expressions(const KeySpec& key) {
    return key.table == &function_table() || key.table == &input_table() || key.table == &signal_table();
}

inline constexpr Range positive{.lower = 0.0, .at_lower = Bound::open};

// Ends messages about a rotary inertia that is missing or not positive.
inline constexpr const char* no_inertia = "a rotation without inertia cannot be integrated in time";

// Numbers of elements and steps beyond which a deck is refused.
inline constexpr long largest_element_count = 10'000'000;
inline constexpr long largest_step_count = 1'000'000'000'000;

}  // namespace gxrod
