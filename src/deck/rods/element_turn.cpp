#include "deck/rods/element_turn.hpp"

#include <fmt/format.h>

#include <cmath>
#include <numbers>
#include <string>

namespace gxrod {
namespace {

constexpr double round_off = 1e-9;

int limit_in_degrees(int order) { return order == 1 ? 180 : 360; }

std::string advise(const RodTable& rod) { return rod.mesh ? "more elements in the mesh" : "more elements"; }

}  // namespace

double compute_element_turn(double bend, double twist) { return std::hypot(bend, twist); }

void check_element_turn(
    double turn, int order, const RodTable& rod, const void* field, const BuildContext& context) {
    const double limit = limit_in_degrees(order) * std::numbers::pi / 180.0;
    if (turn < limit * (1.0 - round_off)) return;
    context.faults.add(rod.place_of(field),
                       rod.path_of(field),
                       fmt::format("the {} is bent and twisted by {:.4g}° within one element of order {}; "
                                   "expected less than {}°: {}",
                                   field == &rod.rest ? "rest" : "rod",
                                   turn * 180.0 / std::numbers::pi,
                                   order,
                                   limit_in_degrees(order),
                                   advise(rod)));
}

}  // namespace gxrod
