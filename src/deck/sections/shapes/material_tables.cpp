#include "deck/sections/shapes/material_tables.hpp"

#include "deck/table/table.hpp"

namespace gxrod {
namespace {

constexpr const char* stress_unit = "mass/(length·time²)";

const TableSpec& strength_table() {
    using T = StrengthTable;
    // clang-format off
    static const TableSpec table = Table<T>("material.NAME.strength", "")
        .key("Xt", &T::Xt, "In tension along the fibres.")
            .unit(stress_unit).above(0).required().also("f1t")
        .key("Xc", &T::Xc, "In compression along the fibres, a positive number.")
            .unit(stress_unit).above(0).required().also("f1c")
        .key("Yt", &T::Yt, "In tension across the fibres.")
            .unit(stress_unit).above(0).required().also("f2t")
        .key("Yc", &T::Yc, "In compression across the fibres, a positive number.")
            .unit(stress_unit).above(0).required().also("f2c")
        .key("S12", &T::S12, "In shear along the fibres, 12 and 13.")
            .unit(stress_unit).above(0).required().also("s s6 f6 s_lt")
        .key("S23", &T::S23, "In shear across the fibres.")
            .unit(stress_unit).above(0).required().also("st s4 f4")
        .key("f12", &T::f12, "Tsai and Wu's F12 is f12 √(F11 F22).")
            .unit("1").above(-1).at_most(1);
    // clang-format on
    return table;
}

}  // namespace

const TableSpec& elastic_material_table() {
    using T = ElasticMaterialTable;
    // clang-format off
    static const TableSpec table = Table<T>("[material.NAME]",
            "A material of sections. Numbers make it isotropic; arrays are by its own axes: 1 along the fibres, 2 across them in "
            "the wall, 3 through the wall; those of one whole shape are x, y and z of the section. "
            "[Sections](guide/sections.md#materials-plies-and-meshes) has pictures.")
        .key("E", &T::E, "Young's modulus, or [E1, E2, E3]; E3 is E2 if left out.")
            .unit(stress_unit).above(0).required()
            .also("youngs_modulus young young_modulus elastic_modulus modulus_of_elasticity modulus e1")
        .key("G", &T::G, "Shear modulus, or [G12, G13, G23]; left out, G13 is G12 and G23 is E2/(2(1 + nu23)).")
            .unit(stress_unit).above(0).also("shear_modulus mu g12")
        .key("nu", &T::nu, "Poisson's ratio, or [nu12, nu13, nu23]: pulled along 1, it strains along 2 by −nu12 times as much.")
            .unit("1").also("poisson poisson_ratio poissons_ratio poissons v nu12")
        .key("density", &T::density, "Mass per volume.")
            .unit("mass/length³").at_least(0).also("rho mass_density specific_mass")
        .key("yield_stress", &T::yield_stress, "A limit that von Mises' stress is compared with: exposure. Circles, tubes and rectangles "
             "yield at it ([materials](guide/materials.md#yield-stress-of-a-material)).")
            .unit(stress_unit).above(0).also("yield yield_strength sigma_y fy")
        .key("interaction", &T::interaction, "true: what is made of it yields by fibres, so that axial force and bending moments "
             "interact; torsion and shear of what is cut into cells stay elastic. Isotropic materials only.")
            .only_with("yield_stress").also("fibres fibers interact")
        .key("elastic", &T::elastic, "true: nothing yields, and the yield stress is a limit that stresses are compared with "
             "([stresses](guide/sections.md#stresses-over-time)), for circles, tubes and rectangles as for other shapes.")
            .only_with("yield_stress")
        .key("strength", &T::strength, strength_table(), "Limits of a ply, for the criteria of Tsai and Wu, of Hashin and of "
             "the largest stress, by which exposure is recorded.")
            .also("strengths limits failure")
        .key("expansion", &T::expansion, "Strain by heat, or by axis, for the temperatures of [[actuation]].")
            .unit("1/temperature").otherwise("0").also("alpha thermal_expansion cte")
        .at_most_one_of({"interaction", "elastic"})
        .shown_by(
            "[material.carbon]\n"
            "E        = [141e9, 9.8e9]\n"
            "G        = [6e9, 6e9, 4.8e9]\n"
            "nu       = [0.30, 0.30, 0.34]\n"
            "density  = 1600\n"
            "strength = { Xt = 1500e6, Xc = 1200e6, Yt = 40e6, Yc = 200e6, S12 = 70e6, S23 = 50e6 }\n");
    // clang-format on
    return table;
}

const TableSpec& layup_table() {
    using T = LayupTable;
    // clang-format off
    static const TableSpec table = Table<T>("[layup.NAME]",
            "Plies one on the other, of the walls of sections.")
        .key("plies", &T::plies, "Material, thickness, angle of the fibres and how many times, one row a ply, from the right of "
             "the walk along the wall to its left: of a closed wall from outside in. The angle goes from x towards the walk; "
             "it is 0 and the times are 1 if left out.")
            .required().also("layers laminate stack stacking sequence")
        .shown_by(
            "[layup.skin]\n"
            "plies = [[\"carbon\", 1.25e-4, 0, 2], [\"carbon\", 1.25e-4, \"pi/4\"], [\"carbon\", 1.25e-4, \"-pi/4\"]]\n");
    // clang-format on
    return table;
}

}  // namespace gxrod
