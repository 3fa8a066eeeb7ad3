#include "deck/schema/top_level.hpp"

#include "deck/drives/chamber_table.hpp"
#include "deck/schema/schema.hpp"
#include "deck/schema/schema_tables.hpp"
#include "deck/sections/shapes/material_tables.hpp"
#include "deck/surroundings/vessel_table.hpp"
#include "deck/table/table.hpp"
#include "deck/ties/ties.hpp"
#include "model/ties/ties.hpp"

namespace gxrod {
namespace {

const TableSpec& parameters_table() {
    static const TableSpec table{
        .path = "parameters",
        .heading = "[parameters]",
        .sentence =
            "Names for numbers, which every expression of the deck can use. They may use each other, in any "
            "order.",
        .keys = {},
        .example =
            "[parameters]\n"
            "EI = 500.0\n"
            "GJ = \"0.8*EI\"\n"};
    return table;
}

void add_element_ties(Table<TopLevelTable>& table) {
    for (std::size_t kind = 0; kind < element_tie_tables.size(); ++kind) {
        table
            .tables(
                std::string(tie_cards[kind].table), KeyShape::named_tables, element_tie_tables[kind].spec())
            .also(element_tie_tables[kind].other_names);
    }
}

// clang-format off
// Adds the tables of what a model is made of.
void add_parts(Table<TopLevelTable>& table) {
    table
        .tables("section", KeyShape::named_tables, section_table())
            .also("cross_section cross_sections profile profiles")
        .tables("material", KeyShape::named_tables, elastic_material_table())
            .also("materials")
        .tables("layup", KeyShape::named_tables, layup_table())
            .also("layups laminate laminates stack plies ply")
        .tables("rod", KeyShape::named_tables, rod_table())
            .also("beam beams cable cables rope string element elements")
        .tables("body", KeyShape::named_tables, body_table())
            .also("rigid_body rigid_bodies mass point_mass");
    add_element_ties(table);
    table
        .tables("joint", KeyShape::named_tables, joint_table())
            .also("joints hinge hinges pin pins revolute ball "
                  "spherical universal cardan prismatic cylindrical screw mechanism motor")
        .tables("gear", KeyShape::named_tables, gear_table())
            .also("gears gearbox rack pinion transmission coupling")
        .tables("connect", KeyShape::table_list, connect_table())
            .also("tie ties merge weld")
        .tables("imperfection", KeyShape::table_list, imperfection_table())
            .also("imperfections initial_imperfection geometric_imperfection imperfect");
}

// Adds the tables of what acts on it.
void add_actions(Table<TopLevelTable>& table) {
    table
        .tables("load", KeyShape::table_list, load_table())
            .also("force forces moment")
        .tables("combination", KeyShape::named_tables, combination_table())
            .also("combinations load_combination load_combinations combo combos load_cases load_case")
        .tables("tendon", KeyShape::named_tables, tendon_table())
            .also("tendons actuator actuators wire wires")
        .tables("chamber", KeyShape::named_tables, chamber_table())
            .also("chambers pneumatic pneumatics bellows pressure_chamber fluidic")
        .tables("actuation", KeyShape::table_list, actuation_table())
            .also("actuations muscle muscles thermal heat temperature eigenstrain growth")
        .tables("magnetic", KeyShape::table_list, magnetic_table())
            .also("magnet magnets magnetic_field field")
        .tables("fluid", KeyShape::table, fluid_table())
            .also("water sea current ocean environment hydro")
        .tables("wave", KeyShape::table_list, wave_table())
            .also("waves sea_state irregular")
        .tables("vessel", KeyShape::named_tables, vessel_table())
            .also("vessels ship ships rao raos")
        .tables("air", KeyShape::table, air_table())
            .also("wind aero")
        .tables("seabed", KeyShape::table, seabed_table())
            .also("bed ground soil floor terrain bottom")
        .tables("contact", KeyShape::table, contact_table())
            .also("contacts collision collisions touching")
        .tables("obstacle", KeyShape::named_tables, obstacle_table())
            .also("obstacles wall surface")
        .tables("support", KeyShape::table_list, support_table())
            .also("boundary boundaries boundary_condition boundary_conditions bc bcs constraint constraints clamp");
}

// Adds the tables of what is asked.
void add_tasks(Table<TopLevelTable>& table) {
    table
        .tables("initial", KeyShape::table_list, initial_table())
            .also("initial_condition initial_conditions initial_velocity ic")
        .tables("rotation", KeyShape::table, rotation_table())
        .tables("analysis", KeyShape::table, analysis_table())
            .also("solver simulation solution step integration")
        .tables("stage", KeyShape::table_list, stage_table())
        .tables("output", KeyShape::table, output_table())
            .may_change()
            .also("results frames writer")
        .tables("history", KeyShape::table_list, history_table())
            .may_change()
            .also("sensor sensors probe probes monitor monitors recorder");
}

// clang-format on

}  // namespace

const TableSpec& deck_schema() {
    using T = TopLevelTable;
    // clang-format off
    static const TableSpec table = Table<T>("", "Keys that stand before the first [table].")
        .key("title", &T::title, "What the deck is about.")
            .may_change()
            .also("name description")
        .key("units", &T::units, "A label that results carry; the numbers are in any consistent units.")
            .may_change()
        .key("gravity", &T::gravity, gravity_table(), "Acceleration that acts on every mass, global components.")
            .unit("length/time²").otherwise("[0, 0, 0]")
            .also("g gravity_vector gravitation acceleration_of_gravity")
        .key("plane", &T::plane, "The plane in which the model stays: displacements across it and rotations out of it "
             "are held at every node, which halves the unknowns.")
            .otherwise("none: a model in space")
        .key("apply", &T::apply, "The [combination.NAME] of load cases that acts.")
            .otherwise("the first one")
        .tables("parameters", KeyShape::parameters, parameters_table())
            .also("params constants variables")
        .tables("function", KeyShape::named_tables, function_table())
            .also("amplitude amplitudes curve curves time_function")
        .tables("input", KeyShape::named_tables, input_table())
            .may_change()
        .tables("signal", KeyShape::named_tables, signal_table())
            .also("signals controller control")
        .with(add_parts)
        .with(add_actions)
        .with(add_tasks)
        .at_least_one_of({"rod", "body"})
        .exactly_one_of({"analysis", "stage"})
        .shown_by(
            "title = \"Flexible rod in free flight, and a top\"\n"
            "units = \"m kg s\"\n"
            "gravity = [0, 0, -9.81]\n");
    // clang-format on
    return table;
}

const TopLevelTable& top_level_of(const CheckedTable& deck) {
    return static_cast<const TopLevelTable&>(*deck.record);
}

}  // namespace gxrod
