#include "deck/surroundings/body_fluid.hpp"

#include <fmt/format.h>

#include <cmath>

#include "numerics/eigenvalues.hpp"

namespace gxrod {
namespace {

// Relative to the largest entry: what of a matrix is round-off.
constexpr double round_off = 1e-9;

Mat6 find_added_mass(const BodyFluidTable& fluid, const BuildContext& context) {
    Mat6 mass = Mat6::Zero();
    if (fluid.added_mass) mass.diagonal().head<3>() = *fluid.added_mass;
    if (!fluid.added_mass_matrix) return mass;
    const Mat6& given = *fluid.added_mass_matrix;
    const double size = given.cwiseAbs().maxCoeff();
    if ((given - given.transpose()).cwiseAbs().maxCoeff() > round_off * size) {
        context.add_fault(fluid, fluid.added_mass_matrix, "expected a symmetric matrix");
        return mass;
    }
    mass = 0.5 * (given + given.transpose());
    const double least = find_symmetric_eigen(mass).values[0];
    if (least < -round_off * size) {
        context.add_fault(
            fluid,
            fluid.added_mass_matrix,
            fmt::format("expected no eigenvalue below 0, found {:.6g}: water would push what moves", least));
    }
    return mass;
}

}  // namespace

BodyInFluid find_body_fluid(const BodyFluidTable& given, const BuildContext& context) {
    BodyInFluid fluid{.volume = given.volume, .centre = given.centre_of_buoyancy};
    if (given.height) {
        fluid.height = *given.height;
    } else {
        fluid.height = std::cbrt(6.0 * fluid.volume / M_PI);
        if (fluid.volume == 0.0)
            context.add_fault(given,
                              given.height,
                              "missing; without a volume it is needed; expected a number greater than 0");
    }
    fluid.drag_area = given.drag_coefficient * given.drag_area;
    fluid.added_mass = find_added_mass(given, context);
    return fluid;
}

}  // namespace gxrod
