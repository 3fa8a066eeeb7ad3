#include "deck/rods/sectioned_catenary.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "deck/bodies/body_table.hpp"
#include "deck/loads/loads.hpp"
#include "deck/rods/still_water.hpp"
#include "deck/schema/schema_tables.hpp"
#include "geometry/sectioned_line.hpp"
#include "mesh/rod_mesh.hpp"

namespace gxrod {
namespace {

// The fraction of a point between the ends of a rod; nullopt of all others.
std::optional<double> find_inner_fraction(const std::string& text, int rod, const BuildContext& context) {
    const auto found = context.names.find(text);
    const auto* point = std::get_if<Point>(&found);
    const auto* of_rod = point != nullptr ? std::get_if<RodPoint>(point) : nullptr;
    if (of_rod == nullptr || of_rod->rod != rod) return std::nullopt;
    if (of_rod->fraction <= same_fraction || of_rod->fraction >= 1.0 - same_fraction) return std::nullopt;
    return of_rod->fraction;
}

// By height: less what the water bears.
std::function<double(double)> weigh_body(const BodyTable& body, const BuildContext& context) {
    const StillWater water = find_still_water(context);
    const double gravity = -water.gravity.z();
    const double weight = gravity * body.mass.value_or(0.0);
    if (!body.fluid || water.density == 0.0) return [weight](double) { return weight; };
    const double volume = body.fluid->volume;
    const double buoyancy = gravity * water.density * volume;
    const double height = std::max(body.fluid->height.value_or(std::cbrt(6.0 * volume / M_PI)), 1e-300);
    return [=](double z) {
        const double wet = water.surface ? std::clamp((*water.surface - z) / height + 0.5, 0.0, 1.0) : 1.0;
        return weight - buoyancy * wet;
    };
}

std::vector<LineStretch> list_stretches(const std::vector<SectionPart>& parts,
                                        const std::vector<HungWeight>& weights,
                                        double length,
                                        bool stretches,
                                        const StillWater& water) {
    std::vector<LineStretch> list;
    for (const SectionPart& part : parts) {
        const double stiffness = part.section.stiffness(0, 0);
        list.push_back({.length = length * (part.last - part.first),
                        .weight = water.weight_in_water(part.section),
                        .dry_weight = water.weight_in_air(part.section),
                        .compliance = stretches && stiffness > 0.0 ? 1.0 / stiffness : 0.0});
        for (const HungWeight& one : weights) {
            if (std::abs(one.fraction - part.last) > 2.0 * same_fraction) continue;
            const auto before = list.back().end_weight;
            list.back().end_weight = [one, before](double z) {
                return one.weight(z) + (before ? before(z) : 0.0);
            };
        }
    }
    return list;
}

double find_least_bending(const std::vector<SectionPart>& parts) {
    double least = std::numeric_limits<double>::infinity();
    for (const SectionPart& part : parts) {
        const Mat6& stiffness = part.section.stiffness;
        least = std::min({least, stiffness(4, 4), stiffness(5, 5)});
    }
    return std::max(least, 0.0);
}

bool has_gravity(const StillWater& water) {
    return water.gravity.z() < 0.0 && water.gravity.x() == 0.0 && water.gravity.y() == 0.0;
}

}  // namespace

std::vector<HungWeight> list_hung_weights(int rod, const BuildContext& context) {
    std::vector<HungWeight> weights;
    for (const BodyTable& body : tables_of<BodyTable>(context.deck, body_table())) {
        const auto* name = std::get_if<PointName>(&body.at);
        if (name == nullptr) continue;
        if (const auto fraction = find_inner_fraction(name->word, rod, context))
            weights.push_back({*fraction, weigh_body(body, context)});
    }
    for (const SteadyLoad& load : list_steady_loads(context)) {
        if (const auto fraction = find_inner_fraction(load.point, rod, context))
            weights.push_back({*fraction, [force = load.force.z()](double) { return -force; }});
    }
    return weights;
}

bool hangs_by_its_weight(const RodTable& table,
                         const std::vector<Station>& stations,
                         const BuildContext& context) {
    constexpr double most_stretched = 0.9;  // a shorter line is a mistake, which the plain catenary reports
    const CatenaryTable& given = *table.catenary;
    const double distance = (given.to - given.from).norm();
    const bool is_upright = (given.to - given.from).head<2>().norm() <= same_fraction * distance;
    if (table.rest || is_upright || given.length < most_stretched * distance) return false;
    if (context.model.sections.empty()) return false;
    const StillWater water = find_still_water(context);
    const Section& section = context.model.sections[static_cast<std::size_t>(stations.front().section)];
    return has_gravity(water) && section.stiffness(0, 0) > 0.0 && water.weight_in_water(section) > 0.0;
}

std::optional<Centreline> find_sectioned_catenary(const RodTable& table,
                                                  const std::vector<Station>& stations,
                                                  const std::vector<HungWeight>& weights,
                                                  const BuildContext& context) {
    const CatenaryTable& given = *table.catenary;
    const StillWater water = find_still_water(context);
    if (!has_gravity(water)) {
        context.add_fault(given,
                          given.length,
                          "a line of several sections, or with weights on it, hangs by its weights; expected "
                          "gravity along -z, as gravity = [0, 0, -9.81]");
        return std::nullopt;
    }
    std::vector<double> fractions;
    for (const HungWeight& one : weights) fractions.push_back(one.fraction);
    Rod rod;
    rod.name = table.name;
    rod.length = given.length;
    const std::vector<SectionPart> parts = list_section_parts(stations, rod, fractions, context);
    const bool starts_lower = given.from.z() <= given.to.z();
    const Section& lower = (starts_lower ? parts.front() : parts.back()).section;
    SectionedLine::Ends ends{.from = given.from, .to = given.to, .surface = water.surface};
    ends.bed = find_line_bed(given, &lower, context);
    ends.stretches = list_stretches(parts, weights, given.length, !table.rest, water);
    ends.kink = {find_least_bending(parts),
                 1.0 * given.length / static_cast<double>(table.elements.value_or(1))};
    try {
        std::vector<std::unique_ptr<Curve>> pieces;
        pieces.push_back(std::make_unique<SectionedLine>(ends));
        return Centreline(std::move(pieces));
    } catch (const std::invalid_argument& error) {
        context.add_fault(given, given.length, error.what());
        return std::nullopt;
    }
}

}  // namespace gxrod
