#include "deck/surroundings/body_fluid.hpp"

#include <fmt/format.h>

#include <cmath>

#include "numerics/eigenvalues.hpp"

namespace gxrod {
namespace {

// Relative to the largest entry: what of a matrix is round-off.
constexpr double round_off = 1e-9;

Mat6 find_added_mass(const CheckedTable& fluid, const BuildContext& context) {
    Mat6 mass = Mat6::Zero();
    if (fluid.gives("added_mass")) mass.diagonal().head<3>() = fluid.get<Vec3>("added_mass");
    if (!fluid.gives("added_mass_matrix")) return mass;
    const Mat6& given = fluid.get<Mat6>("added_mass_matrix");
    const double size = given.cwiseAbs().maxCoeff();
    if ((given - given.transpose()).cwiseAbs().maxCoeff() > round_off * size) {
        context.add_fault(fluid, "added_mass_matrix", "expected a symmetric matrix");
        return mass;
    }
    mass = 0.5 * (given + given.transpose());
    const double least = find_symmetric_eigen(mass).values[0];
    if (least < -round_off * size) {
        context.add_fault(
            fluid,
            "added_mass_matrix",
            fmt::format("expected no eigenvalue below 0, found {:.6g}: water would push what moves", least));
    }
    return mass;
}

}  // namespace

std::optional<BodyInFluid> find_body_fluid(const CheckedTable& body, const BuildContext& context) {
    if (!body.gives("fluid")) return std::nullopt;
    const CheckedTable& table = body.tables("fluid").front();
    BodyInFluid fluid{.volume = table.get<double>("volume"), .centre = table.get<Vec3>("centre_of_buoyancy")};
    if (table.gives("height")) {
        fluid.height = table.get<double>("height");
    } else {
        fluid.height = std::cbrt(6.0 * fluid.volume / M_PI);
        if (fluid.volume == 0.0)
            context.add_fault(
                table, "height", "missing; without a volume it is needed; expected a number greater than 0");
    }
    fluid.drag_area = table.get<double>("drag_coefficient") * table.get<Vec3>("drag_area");
    fluid.added_mass = find_added_mass(table, context);
    return fluid;
}

}  // namespace gxrod
