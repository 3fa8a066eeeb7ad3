#include "deck/drives/tendon_path.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "deck/drives/chamber_table.hpp"
#include "deck/places/part.hpp"
#include "deck/schema/schema_tables.hpp"

namespace gxrod {
namespace {

using Offset = std::array<std::function<double(double s)>, 2>;

Vec3 place_at(const Offset& offset, double s) { return {0.0, offset[0](s), offset[1](s)}; }

// By central differences on nine points, of order 8.
Vec3 differ(const Offset& offset, double s, double step) {
    const auto pair = [&](double steps) {
        return Vec3(place_at(offset, s + steps * step) - place_at(offset, s - steps * step));
    };
    return (672.0 * pair(1.0) - 168.0 * pair(2.0) + 32.0 * pair(3.0) - 3.0 * pair(4.0)) / (840.0 * step);
}

// Of steps from long to short the one whose result differs least from the one before: longer ones miss the
// function's turns, shorter ones lose digits. None reaches beyond the range, where there may be no value.
Vec3 find_slope(const Offset& offset, double s, double from, double to) {
    constexpr int most_halvings = 12;
    constexpr double widest = 1.0 / 512.0;  // of the range: paths of hundreds of turns do not repeat over it
    double step = std::min(widest * (to - from), 0.25 * std::min(s - from, to - s));
    if (!(step > 0.0)) step = widest * (to - from);
    Vec3 slope = differ(offset, s, step);
    Vec3 best = slope;
    double least = std::numeric_limits<double>::infinity();
    for (int i = 0; i < most_halvings; ++i) {
        step *= 0.5;
        const Vec3 finer = differ(offset, s, step);
        const double change = (finer - slope).norm();
        if (change < least) {
            least = change;
            best = slope;
        }
        slope = finer;
    }
    return best;
}

TendonPlace place_between(const std::vector<std::array<double, 3>>& rows, double s, double length) {
    const double fraction = s / length;
    std::size_t i = 1;
    while (i + 1 < rows.size() && fraction > rows[i][0]) ++i;
    const auto& [first, y, z] = rows[i - 1];
    const auto& [last, next_y, next_z] = rows[i];
    const Vec3 slope = Vec3(0.0, next_y - y, next_z - z) / ((last - first) * length);
    return {Vec3(0.0, y, z) + (s - first * length) * slope, slope};
}

}  // namespace

std::optional<TendonRange> find_tendon_range(const TendonTable& tendon, const BuildContext& context) {
    if (tendon.offset.rows.empty()) {
        if (tendon.from < tendon.to) return TendonRange{tendon.from, tendon.to};
        context.add_fault(
            tendon,
            tendon.gives(tendon.to) ? tendon.to : tendon.from,
            fmt::format("expected from < to, found from = {} and to = {}", tendon.from, tendon.to));
        return std::nullopt;
    }
    for (const double* field : {&tendon.from, &tendon.to}) {
        if (!tendon.gives(*field)) continue;
        context.add_fault(tendon, *field, "goes with functions; the first and the last row say it here");
        return std::nullopt;
    }
    return TendonRange{tendon.offset.rows.front()[0], tendon.offset.rows.back()[0]};
}

std::vector<RodPoint> list_tendon_points(const BuildContext& context) {
    std::vector<RodPoint> points;
    const auto add_all = [&](const TendonTable& tendon) {
        const std::optional<int> rod = find_index(context.deck.tables("rod"), tendon.on.word);
        if (!rod) return;
        const auto add = [&](double fraction) {
            if (fraction > 0.0 && fraction < 1.0) points.push_back({*rod, fraction});
        };
        for (const auto& row : tendon.offset.rows) add(row[0]);
        if (!tendon.offset.rows.empty()) return;
        add(tendon.from);
        add(tendon.to);
    };
    for (const TableSpec* spec : {&tendon_table(), &chamber_table()}) {
        for (const TendonTable& tendon : tables_of<TendonTable>(context.deck, *spec)) add_all(tendon);
    }
    return points;
}

std::function<TendonPlace(double s)> make_tendon_path(const CheckedTendonPath& offset,
                                                      const TendonRange& range,
                                                      double length) {
    if (!offset.rows.empty())
        return [rows = offset.rows, length](double s) { return place_between(rows, s, length); };
    return [functions = offset.functions, from = range.from * length, to = range.to * length](double s) {
        return TendonPlace{place_at(functions, s), find_slope(functions, s, from, to)};
    };
}

}  // namespace gxrod
