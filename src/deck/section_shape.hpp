#pragma once

// Geometric constants of cross-sections, about their centroid.
namespace gxrod {

struct ShapeConstants {
    double area = 0.0;
    double second_moment_y = 0.0;   // ∫ z² dA: of bending about y
    double second_moment_z = 0.0;   // ∫ y² dA
    double torsion_constant = 0.0;  // Saint-Venant's J; the torsional stiffness is G J
    // Cowper (1966), "The shear coefficient in Timoshenko's beam theory", for one Poisson's ratio.
    double shear_factor = 0.0;
};

ShapeConstants compute_circle(double radius, double nu);
// `inner` below `outer`.
ShapeConstants compute_tube(double outer, double inner, double nu);
// `width` along y, `height` along z.
ShapeConstants compute_rectangle(double width, double height, double nu);

}  // namespace gxrod
