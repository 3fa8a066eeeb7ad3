#pragma once

#include <vector>

#include "deck/places/build_context.hpp"

// Where tendons start and end, and where they pass between.
namespace gxrod {

// Points of rods at which tendons start, end or have a kink, so that a node has to be there; none of tendons
// that are not right, which build_drives says.
std::vector<RodPoint> list_tendon_points(const BuildContext& context);

// The range of a tendon, as fractions of its rod's length; nullopt, with a fault, if there is none.
struct TendonRange {
    double from;
    double to;
};
std::optional<TendonRange> find_tendon_range(const CheckedTable& tendon, const BuildContext& context);

// Its path along a rod of this length, by the arc length. Its slope is exact between rows, and of functions
// has about 12 digits. Calls throw EvaluationError where a function has no finite value.
std::function<TendonPlace(double s)> make_tendon_path(const CheckedTendonPath& offset,
                                                      const TendonRange& range,
                                                      double length);

}  // namespace gxrod
