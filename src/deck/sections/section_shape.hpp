#pragma once

// Geometric constants of cross-sections, about their centroid.
namespace gxrod {

struct ShapeConstants {
    double area = 0.0;
    double second_moment_y = 0.0;   // ∫ z² dA, for bending about y
    double second_moment_z = 0.0;   // ∫ y² dA
    double torsion_constant = 0.0;  // Saint-Venant's J; the torsional stiffness is G J
    // Shear stiffness over G A for one Poisson's ratio, by the energy of Saint-Venant's flexure.
    double shear_factor_y = 0.0;  // for forces along y
    double shear_factor_z = 0.0;
};

ShapeConstants compute_circle(double radius, double nu);
// Computes the constants of a tube, `inner` below `outer`.
ShapeConstants compute_tube(double outer, double inner, double nu);
// Computes the constants of a rectangle, `width` along y, `height` along z.
ShapeConstants compute_rectangle(double width, double height, double nu);

}  // namespace gxrod
