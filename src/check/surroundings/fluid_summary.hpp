#pragma once

#include <string>
#include <vector>

#include "model/model.hpp"

// Lines about the data of a model for water, air and ground.
namespace gxrod {

// Describes diameter, area, coefficients and contents of a section; "" if it has no part in fluids.
std::string describe_fluid(const Section& section);

// Describes a rod's displacement and weight in water, and its depth in the ground; "" without either.
std::string describe_fluid(const Model& model, const Rod& rod);

// Describes a body in fluids likewise.
std::string describe_fluid(const Model& model, const Body& body);

// Lists water, its current and waves, air and ground, a text each.
std::vector<std::string> list_surroundings(const Surroundings& surroundings);

// Finds the size of the full gravity.
double find_gravity(const Model& model);

// Lists the sections of a rod: one for each of its nodes, or its only one.
std::vector<const Section*> list_sections(const Model& model, const Rod& rod);

// Computes weight less buoyancy per length of a section in water.
double find_wet_weight(const Section& section, double water_density, double gravity);

}  // namespace gxrod
