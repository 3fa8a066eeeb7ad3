#pragma once

#include <string>
#include <vector>

#include "model/model.hpp"

// Lines for a reader: what water, air and ground see of a model.
namespace gxrod {

// Diameter, area, coefficients and contents of a section; "" if it has no part in fluids.
std::string describe_fluid(const Section& section);

// What a rod displaces and weighs in water, and how deep it sinks into the ground; "" without either.
std::string describe_fluid(const Model& model, const Rod& rod);

// The same of a body.
std::string describe_fluid(const Model& model, const Body& body);

// Water, its current and waves, air and ground, a text each.
std::vector<std::string> list_surroundings(const Surroundings& surroundings);

// Gravity where it is whole; its size.
double find_gravity(const Model& model);

// The sections of a rod: those at its nodes, or the one that it has everywhere.
std::vector<const Section*> list_sections(const Model& model, const Rod& rod);

// Weight less buoyancy per length of a section in water.
double find_wet_weight(const Section& section, double water_density, double gravity);

}  // namespace gxrod
