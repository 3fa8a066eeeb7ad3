#pragma once

#include <vector>

#include "deck/loads/acting.hpp"

// The ends of tendons, and their paths between them.
namespace gxrod {

struct TendonTable : ActingTable {
    TableName on;
    CheckedTendonPath offset;
    std::optional<CheckedTimeFunction> tension, shortening, length;
    std::optional<double> stiffness;
    double friction = 0.0;
    TendonEnd pulled_at = TendonEnd::from;
    std::optional<bool> slack;
    double from = 0.0;
    double to = 1.0;
};

// Lists points of rods at which tendons start, end or have a kink, so that a node has to be there. Skips
// wrong tendons, which build_drives reports.
std::vector<RodPoint> list_tendon_points(const BuildContext& context);

// The range of a tendon, as fractions of its rod's length.
struct TendonRange {
    double from;
    double to;
};
std::optional<TendonRange> find_tendon_range(const TendonTable& tendon, const BuildContext& context);

// Lays a tendon or a chamber along its rod, without what pulls it; reports faults of its path. nullopt if it
// has no place.
std::optional<Tendon> lay_tendon(const TendonTable& given, const BuildContext& context);

// How a given length, or volume, that grows without t comes from its value at t = 0 to its own.
TimeFunction find_share(const TimeFunction& length, const Acting& acting);

// Makes the path of a tendon along a rod of this length, by the arc length. Its slope is exact between rows;
// the slope of functions has about 12 digits. Calls throw EvaluationError where a function has no finite
// value.
std::function<TendonPlace(double s)> make_tendon_path(const CheckedTendonPath& offset,
                                                      const TendonRange& range,
                                                      double length);

}  // namespace gxrod
