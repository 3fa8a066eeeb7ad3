#include <cmath>

#include "deck/decks.hpp"
#include "deck/round_trips.hpp"

namespace gxrod::test {
namespace {

// rod_deck with other keys for its section's stiffness and inertia.
std::string with_shape(const std::string& shape, const std::string& material) {
    const std::size_t first = rod_deck.find("stiffness");
    const std::size_t last = rod_deck.find("[rod.r]");
    return std::string(rod_deck).replace(
        first, last - first, "shape = { " + shape + " }\nmaterial = { " + material + " }\n");
}

const std::string circle = "circle = { radius = 1 }";

}  // namespace

std::vector<RoundTrip> section_trips() {
    const auto stiffness = [](int i, double value) {
        return [=](const Problem& p) { return p.model.sections[0].stiffness(i, i) == value; };
    };
    const auto mass = [](int i, double value) {
        return [=](const Problem& p) { return p.model.sections[0].mass(i, i) == value; };
    };
    return {{"section.NAME.stiffness.EA", replaced(rod_deck, "EA = 1e4", "EA = 77"), stiffness(0, 77)},
            {"section.NAME.stiffness.GAy", replaced(rod_deck, "GAy = 2e4", "GAy = 77"), stiffness(1, 77)},
            {"section.NAME.stiffness.GAz", replaced(rod_deck, "GAz = 3e4", "GAz = 77"), stiffness(2, 77)},
            {"section.NAME.stiffness.GJ", replaced(rod_deck, "GJ = 500", "GJ = 77"), stiffness(3, 77)},
            {"section.NAME.stiffness.EIy", replaced(rod_deck, "EIy = 600", "EIy = 77"), stiffness(4, 77)},
            {"section.NAME.stiffness.EIz", replaced(rod_deck, "EIz = 700", "EIz = 77"), stiffness(5, 77)},
            {"section.NAME.inertia.rhoA",
             replaced(rod_deck, "rhoA = 1.0", "rhoA = 7"),
             [](const Problem& p) { return p.model.sections[0].mass.diagonal().head<3>() == Vec3(7, 7, 7); }},
            {"section.NAME.inertia.rhoJ", replaced(rod_deck, "rhoJ = 20", "rhoJ = 77"), mass(3, 77)},
            {"section.NAME.inertia.rhoIy", replaced(rod_deck, "rhoIy = 10", "rhoIy = 77"), mass(4, 77)},
            {"section.NAME.inertia.rhoIz", replaced(rod_deck, "rhoIz = 11", "rhoIz = 77"), mass(5, 77)}};
}

std::vector<RoundTrip> shape_trips() {
    const auto area = [](double value) {
        return [=](const Problem& p) {
            return std::abs(p.model.sections[0].mass(0, 0) - value) < 1e-14 * value;
        };
    };
    const std::string steel = "E = 3, nu = 0.5, density = 1";
    return {
        {"section.NAME.shape.circle.radius", with_shape("circle = { radius = 2 }", steel), area(4 * M_PI)},
        {"section.NAME.shape.tube.outer_radius",
         with_shape("tube = { outer_radius = 3, inner_radius = 1 }", steel),
         area(8 * M_PI)},
        {"section.NAME.shape.tube.inner_radius",
         with_shape("tube = { outer_radius = 3, inner_radius = 2 }", steel),
         area(5 * M_PI)},
        {"section.NAME.shape.rectangle.width_y",
         with_shape("rectangle = { width_y = 2, height_z = 1 }", steel),
         [](const Problem& p) { return std::abs(p.model.sections[0].mass(5, 5) - 8.0 / 12.0) < 1e-15; }},
        {"section.NAME.shape.rectangle.height_z",
         with_shape("rectangle = { width_y = 1, height_z = 2 }", steel),
         [](const Problem& p) { return std::abs(p.model.sections[0].mass(4, 4) - 8.0 / 12.0) < 1e-15; }},
        {"section.NAME.material.E",
         with_shape(circle, "E = 7, nu = 0, density = 1"),
         [](const Problem& p) { return p.model.sections[0].stiffness(0, 0) == 7 * M_PI; }},
        {"section.NAME.material.nu",
         with_shape(circle, "E = 3, nu = 0.5, density = 1"),
         [](const Problem& p) { return p.model.sections[0].stiffness(3, 3) == M_PI / 2.0; }},
        {"section.NAME.material.G",
         with_shape(circle, "E = 3, G = 5, density = 1"),
         [](const Problem& p) { return p.model.sections[0].stiffness(3, 3) == 5.0 * M_PI / 2.0; }},
        {"section.NAME.material.density", with_shape(circle, "E = 3, nu = 0, density = 9"), area(9 * M_PI)},
        {"section.NAME.material.expansion",
         with_shape(circle, "E = 3, nu = 0, density = 1, expansion = 2e-5"),
         [](const Problem& p) { return p.model.sections[0].expansion == 2e-5; }},
        {"section.NAME.material.shear_factor",
         with_shape(circle, "E = 2, nu = 0, density = 1, shear_factor = 0.25"),
         [](const Problem& p) { return p.model.sections[0].stiffness(1, 1) == 0.25 * M_PI; }}};
}

std::vector<RoundTrip> matrix_trips() {
    const std::string identity =
        "[[2,0,0,0,0,0],[0,2,0,0,0,0],[0,0,2,0,0,0],[0,0,0,3,1,0],[0,0,0,1,4,0],[0,0,0,0,0,5]]";
    const auto has_entry = [](const Mat6& matrix) { return matrix(3, 4) == 1.0 && matrix(5, 5) == 5.0; };
    return {{"section.NAME.stiffness_matrix",
             replaced(rod_deck,
                      "stiffness = { EA = 1e4, GAy = 2e4, GAz = 3e4, GJ = 500, EIy = 600, EIz = 700 }",
                      "stiffness_matrix = " + identity),
             [=](const Problem& p) { return has_entry(p.model.sections[0].stiffness); }},
            {"section.NAME.mass_matrix",
             replaced(rod_deck,
                      "inertia = { rhoA = 1.0, rhoJ = 20, rhoIy = 10, rhoIz = 11 }",
                      "mass_matrix = " + identity),
             [=](const Problem& p) { return has_entry(p.model.sections[0].mass); }},
            {"section.NAME.damping.kelvin_voigt",
             replaced(rod_deck, "[rod.r]", "damping = { kelvin_voigt = 0.125 }\n[rod.r]"),
             [](const Problem& p) { return p.model.sections[0].kelvin_voigt == 0.125; }},
            {"section.NAME.damping.mass_proportional",
             replaced(rod_deck, "[rod.r]", "damping = { mass_proportional = 0.125 }\n[rod.r]"),
             [](const Problem& p) { return p.model.sections[0].mass_proportional == 0.125; }}};
}

std::vector<RoundTrip> rod_trips() {
    return {{"rod.NAME.section",
             replaced(rod_deck, "section = \"s\"", "section = \"other\"") +
                 "[section.other]\nstiffness = { EA = 1, GAy = 1, GAz = 1, GJ = 1, EIy = 1, EIz = 1 }\n"
                 "inertia = { rhoA = 1, rhoIy = 1, rhoIz = 1 }\n",
             [](const Problem& p) { return p.model.sections[p.model.rods[0].section].name == "other"; }}};
}

std::vector<RoundTrip> body_trips() {
    const auto node = [](const Problem& p) { return p.model.nodes[p.model.bodies[0].node]; };
    return {{"body.NAME.mass",
             replaced(body_deck, "mass = 1.0", "mass = 2.5"),
             [](const Problem& p) { return p.model.bodies[0].mass == 2.5; }},
            {"body.NAME.inertia",
             replaced(body_deck, "[1, 1, 1]", "[2, 3, 4]"),
             [](const Problem& p) { return p.model.bodies[0].inertia == Mat3(Vec3(2, 3, 4).asDiagonal()); }},
            {"body.NAME.at",
             with_body_key("at = [1, 2, 3]"),
             [=](const Problem& p) { return node(p).position == Vec3(1, 2, 3); }},
            {"body.NAME.centre_of_mass",
             with_body_key("centre_of_mass = [1, 2, 3]"),
             [](const Problem& p) { return p.model.bodies[0].centre_of_mass == Vec3(1, 2, 3); }},
            {"body.NAME.rotation_vector",
             with_body_key("rotation_vector = [0, 0, \"pi/2\"]"),
             [](const Problem& p) {
                 return (p.model.bodies[0].attitude * Vec3::UnitX()).isApprox(Vec3::UnitY(), 1e-15);
             }},
            {"body.NAME.velocity",
             with_body_key("velocity = [1, 2, 3]"),
             [=](const Problem& p) { return node(p).velocity == Vec3(1, 2, 3); }},
            {"body.NAME.angular_velocity",
             with_body_key("rotation_vector = [0, 0, \"pi/2\"]\nangular_velocity = [1, 2, 3]"),
             [=](const Problem& p) { return node(p).angular_velocity == Vec3(1, 2, 3); }},
            {"body.NAME.angular_velocity_material",
             with_body_key("rotation_vector = [0, 0, \"pi/2\"]\nangular_velocity_material = [1, 2, 3]"),
             [=](const Problem& p) { return node(p).angular_velocity.isApprox(Vec3(-2, 1, 3), 1e-15); }}};
}

}  // namespace gxrod::test
