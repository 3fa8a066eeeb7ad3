#include "deck/sections/rod_sections.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <memory>

#include "deck/schema/suggestion.hpp"
#include "deck/sections/build_sections.hpp"
#include "deck/sections/shapes/cut_shape.hpp"
#include "deck/surroundings/section_fluid.hpp"
#include "laws/layered_law.hpp"
#include "laws/mixed_law.hpp"
#include "mesh/rod_mesh.hpp"
#include "numerics/gauss_legendre.hpp"

namespace gxrod {
namespace {

int find_section(const CheckedWord& name, const BuildContext& context) {
    std::vector<std::string> known;
    for (std::size_t i = 0; i < context.model.sections.size(); ++i) {
        if (context.model.sections[i].name == name.word) return static_cast<int>(i);
        known.push_back(context.model.sections[i].name);
    }
    std::string hint = did_you_mean(name.word, known);
    if (hint.empty())
        hint = known.empty() ? "; the deck has no section" : "; the deck has " + plain_list(known);
    context.faults.add(name.place, name.path, fmt::format("no section \"{}\"{}", name.word, hint));
    return 0;
}

std::vector<Station> list_stations(const RodTable& rod,
                                   const SectionFile& file,
                                   const BuildContext& context) {
    if (context.needs_inertia() && file.rows.front().section.mass.isZero(0.0)) {
        const SectionFileTable& table = *rod.find_section_file();
        context.add_fault(table, table.file, "has no columns M11 … M66; a dynamic analysis needs them");
    }
    std::vector<Station> stations;
    for (const SectionRow& row : file.rows)
        stations.push_back({.fraction = row.fraction, .of_file = &row.section});
    return stations;
}

// The section at one end of a rod, for what stands for the rod as a whole.
const Section& section_of(const Station& station, const BuildContext& context) {
    if (station.of_file != nullptr) return *station.of_file;
    return context.model.sections[static_cast<std::size_t>(station.section)];
}

// Damping is that of a rod, not of its points.
void check_damping(const RodTable& rod, const std::vector<Station>& stations, const BuildContext& context) {
    if (context.model.sections.empty()) return;
    const Section& first = section_of(stations.front(), context);
    for (const Station& station : stations) {
        const Section& other = section_of(station, context);
        if (other.kelvin_voigt == first.kelvin_voigt &&
            other.kelvin_voigt_components == first.kelvin_voigt_components &&
            other.mass_proportional == first.mass_proportional)
            continue;
        context.add_fault(
            rod,
            rod.sections,
            fmt::format("expected the same damping in all sections of a rod, found kelvin_voigt "
                        "= {}, mass_proportional = {} in \"{}\", {} and {} in \"{}\"",
                        first.kelvin_voigt,
                        first.mass_proportional,
                        first.name,
                        other.kelvin_voigt,
                        other.mass_proportional,
                        other.name));
        return;
    }
}

// All of a rod takes part in fluids, or nothing of it.
void check_fluid(const RodTable& rod, const std::vector<Station>& stations, const BuildContext& context) {
    if (context.model.sections.empty()) return;
    const Section& first = section_of(stations.front(), context);
    for (const Station& station : stations) {
        const Section& other = section_of(station, context);
        if (other.fluid.has_value() == first.fluid.has_value()) continue;
        const bool is_first = first.fluid.has_value();
        return context.add_fault(rod,
                                 rod.sections,
                                 fmt::format("section \"{}\" has `fluid` and \"{}\" has not; expected it in "
                                             "all sections of a rod, or in none",
                                             (is_first ? first : other).name,
                                             (is_first ? other : first).name));
    }
}

bool has_law(const Station& station, const BuildContext& context) {
    return section_of(station, context).law != nullptr;
}

// Whether a rod has the same section with a law everywhere, which does not vary.
bool has_one_law(const std::vector<Station>& stations, const BuildContext& context) {
    if (context.model.sections.empty() || !has_law(stations.front(), context)) return false;
    const int first = stations.front().section;
    return !varies_along_rod(context.deck.tables("section")[static_cast<std::size_t>(first)]) &&
           std::ranges::all_of(stations, [&](const Station& station) { return station.section == first; });
}

bool are_one(double a, double b) { return std::abs(a - b) <= 2.0 * same_fraction; }

Section nameless(Section section) {
    section.name.clear();
    return section;
}

// The law of a section; of one without a law, its stiffness as a law.
std::shared_ptr<const SectionLaw> law_of(const Section& section) {
    if (section.law) return section.law;
    return std::make_shared<const LayeredLaw>(section.stiffness, std::vector<Layer>{});
}

// (1 − t) a + t b.
Section mix(const Section& a, const Section& b, double t) {
    Section section = nameless(a);
    if (a.shape != b.shape) {
        const bool has_both = a.shape && b.shape;
        section.shape = has_both ? (t < 0.5 ? a.shape : b.shape) : nullptr;
        section.other_part = has_both ? std::min(t, 1.0 - t) : 0.0;
        if (section.other_part > 0.0) section.other_shape = t < 0.5 ? b.shape : a.shape;
    }
    section.stiffness = (1.0 - t) * a.stiffness + t * b.stiffness;
    section.mass = (1.0 - t) * a.mass + t * b.mass;
    section.expansion = (1.0 - t) * a.expansion + t * b.expansion;
    section.fluid = combine(1.0 - t, a.fluid, t, b.fluid);
    if (a.law || b.law) section.law = mix_laws(law_of(a), law_of(b), t);
    section.radius = a.radius > 0.0 && b.radius > 0.0 ? (1.0 - t) * a.radius + t * b.radius : 0.0;
    return section;
}

// Linear between stations; at a jump that of the side on which `inside` lies.
class SectionsAlong {
  public:
    SectionsAlong(const std::vector<Station>& stations, const Rod& rod, const BuildContext& context)
        : stations_(stations), rod_(rod), context_(context) {}

    Section at(double fraction, double inside, bool is_node = false) const {
        std::size_t i = 1;
        while (i + 1 < stations_.size() && is_behind(i, fraction, inside)) ++i;
        const Station& a = stations_[i - 1];
        const Station& b = stations_[i];
        const double length = b.fraction - a.fraction;
        const double t = length > 0.0 ? std::clamp((fraction - a.fraction) / length, 0.0, 1.0) : 0.0;
        if (a.of_file != nullptr) return mix(*a.of_file, *b.of_file, t);
        SectionPlace place = place_between(a, b, fraction);
        place.is_node = is_node;
        if (a.section == b.section) return nameless(section(a, place));
        return mix(section(a, place), section(b, place), t);
    }
    // Notes how exact sections are that are computed at a few stations.
    void note_stations() const {
        for (std::size_t i = 1; i < stations_.size(); ++i) {
            const Station& a = stations_[i - 1];
            const Station& b = stations_[i];
            if (a.of_file != nullptr || b.fraction <= a.fraction) continue;
            gxrod::note_stations(table_of(a), place_between(a, b, a.fraction), context_);
            if (a.section != b.section)
                gxrod::note_stations(table_of(b), place_between(a, b, a.fraction), context_);
        }
    }

  private:
    // Whether a fraction lies behind the end of an interval: at the end itself, if the inside does.
    bool is_behind(std::size_t interval, double fraction, double inside) const {
        const double end = stations_[interval].fraction;
        return are_one(fraction, end) ? inside > end : fraction > end;
    }
    SectionPlace place_between(const Station& a, const Station& b, double fraction) const {
        return {.s = fraction * rod_.length,
                .rod = "rod." + rod_.name,
                .first = a.fraction * rod_.length,
                .last = b.fraction * rod_.length};
    }
    const SectionTable& table_of(const Station& station) const {
        const CheckedTable& table =
            context_.deck.tables("section")[static_cast<std::size_t>(station.section)];
        return static_cast<const SectionTable&>(*table.record);
    }
    Section section(const Station& station, const SectionPlace& place) const {
        const auto index = static_cast<std::size_t>(station.section);
        if (!varies_along_rod(context_.deck.tables("section")[index])) return context_.model.sections[index];
        return build_section(table_of(station), place, context_);
    }

    const std::vector<Station>& stations_;
    const Rod& rod_;
    const BuildContext& context_;
};

// Whether a rod has one section from one fraction of its length to another, between two stations.
bool has_one_section(const std::vector<Station>& stations, double inside, const BuildContext& context) {
    const auto after = std::ranges::upper_bound(stations, inside, {}, &Station::fraction);
    if (stations.size() == 1 || after == stations.begin() || after == stations.end()) return true;
    const Station& before = *(after - 1);
    return before.of_file == nullptr && before.section == after->section &&
           !varies_along_rod(context.deck.tables("section")[static_cast<std::size_t>(before.section)]);
}

// Where one section has a law, all have one. The mean has the first that is not the stiffness alone.
void set_laws(std::vector<Section>& sections, Section& mean) {
    const auto first = std::ranges::find_if(sections, [](const Section& one) { return one.law != nullptr; });
    mean.law = first == sections.end() ? nullptr : first->law;
    if (!mean.law) return;
    for (Section& section : sections) section.law = law_of(section);
}

}  // namespace

std::vector<double> list_force_points(int order) {
    std::vector<double> points;
    for (const QuadraturePoint& point : list_gauss_rule(order)) points.push_back(0.5 * (1.0 + point.xi));
    return points;
}

std::vector<Station> find_stations(const RodTable& rod, const SectionFile* file, BuildContext& context) {
    if (file != nullptr) return list_stations(rod, *file, context);
    if (rod.section) {
        const int section = find_section(*rod.section, context);
        const std::vector<CheckedTable>& tables = context.deck.tables("section");
        if (tables.empty() || !varies_along_rod(tables[static_cast<std::size_t>(section)]))
            return {{0.0, section}};
        return {{0.0, section}, {1.0, section}};
    }
    std::vector<Station> stations;
    for (const CheckedStation& station : std::get<std::vector<CheckedStation>>(*rod.sections))
        stations.push_back({station.fraction, find_section(station.section, context)});
    check_damping(rod, stations, context);
    check_fluid(rod, stations, context);
    if (has_one_law(stations, context)) return {stations.front()};
    return stations;
}

std::vector<double> find_jumps(const std::vector<Station>& stations) {
    std::vector<double> jumps;
    for (std::size_t i = 1; i < stations.size(); ++i) {
        const double fraction = stations[i].fraction;
        const bool is_inside = !are_one(fraction, 0.0) && !are_one(fraction, 1.0);
        if (is_inside && are_one(fraction, stations[i - 1].fraction)) jumps.push_back(fraction);
    }
    return jumps;
}

std::vector<SectionPart> list_section_parts(const std::vector<Station>& stations,
                                            const Rod& rod,
                                            std::vector<double> fractions,
                                            const BuildContext& context) {
    constexpr int parts_of_varying = 16;
    const SectionsAlong profile(stations, rod, context);
    for (const Station& station : stations) fractions.push_back(station.fraction);
    fractions.insert(fractions.end(), {0.0, 1.0});
    std::ranges::sort(fractions);
    std::vector<SectionPart> parts;
    double first = 0.0;
    for (const double last : fractions) {
        if (last - first <= 2.0 * same_fraction) continue;
        const bool is_one = has_one_section(stations, 0.5 * (first + last), context);
        const int count = is_one ? 1 : parts_of_varying;
        for (int i = 0; i < count; ++i) {
            const double begin = first + (last - first) * i / count;
            const double end = i + 1 == count ? last : first + (last - first) * (i + 1) / count;
            const double middle = 0.5 * (begin + end);
            parts.push_back(
                {begin,
                 end,
                 stations.size() == 1 ? section_of(stations.front(), context) : profile.at(middle, middle)});
        }
        first = last;
    }
    return parts;
}

void set_sections(const std::vector<Station>& stations,
                  const std::vector<double>& element_fractions,
                  Rod& rod,
                  BuildContext& context) {
    std::vector<Section>& known = context.model.sections;
    rod.section = stations.front().section;
    const bool is_unknown = stations.front().of_file == nullptr && known.empty();
    if (stations.size() == 1 || is_unknown) return;
    const SectionsAlong profile(stations, rod, context);
    const std::vector<double> force_points = list_force_points(rod.order);
    const std::vector<double> nodes = compute_element_nodes(rod.order);
    const std::vector<QuadraturePoint> mass_points = list_gauss_rule(rod.order + 1);
    Section mean = section_of(stations.front(), context);
    mean.stiffness.setZero();
    mean.shape = nullptr;
    mean.mass.setZero();
    if (mean.fluid) mean.fluid = combine(0.0, mean.fluid, 0.0, mean.fluid);
    for (std::size_t e = 0; e + 1 < element_fractions.size(); ++e) {
        const double first = element_fractions[e];
        const double length = element_fractions[e + 1] - first;
        const auto find = [&](double point, bool is_node = false) {
            return profile.at(first + point * length, first + 0.5 * length, is_node);
        };
        for (const double point : force_points) rod.varying.at_forces.push_back(find(point));
        for (const double point : nodes) rod.varying.at_nodes.push_back(find(point, true));
        for (const auto& [xi, weight] : mass_points) {
            rod.varying.at_masses.push_back(find(0.5 * (1.0 + xi)));
            const Section& here = rod.varying.at_masses.back();
            const double part = 0.5 * weight * length;
            mean.stiffness += part * here.stiffness;
            mean.mass += part * here.mass;
            mean.fluid = combine(1.0, mean.fluid, part, here.fluid);
        }
    }
    profile.note_stations();
    set_laws(rod.varying.at_forces, mean);
    if (stations.front().section != stations.back().section)
        mean.name += " … " + known[static_cast<std::size_t>(stations.back().section)].name;
    mean.name += " along " + rod.name;
    rod.section = static_cast<int>(known.size());
    known.push_back(std::move(mean));
}

}  // namespace gxrod
