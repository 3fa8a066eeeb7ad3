#include <fmt/format.h>

#include <algorithm>
#include <limits>

#include "deck/schema/choices.hpp"
#include "deck/schema/schema_tables.hpp"
#include "deck/sections/build_sections.hpp"
#include "deck/sections/shape_laws.hpp"
#include "deck/sections/shapes/cut_shape.hpp"
#include "deck/sections/shapes/shape_material.hpp"
#include "laws/layered_law.hpp"
#include "laws/moment_curvature_law.hpp"
#include "laws/moved_law.hpp"
#include "laws/plastic_law.hpp"
#include "laws/stretch_law.hpp"
#include "laws/syrope_law.hpp"
#include "laws/trapeze_law.hpp"
#include "laws/viscoelastic_law.hpp"

namespace gxrod {
namespace {

const TableSpec& layer_table() {
    using T = LayerTable;
    // clang-format off
    static const TableSpec table = Table<T>("section.NAME.law.layers[]", "")
        .key("on", &T::on, "The strains that it takes part in. Of bending and shear it resists both, up to a limit of "
             "their resultant.")
            .required()
        .key("stiffness", &T::stiffness, "What it adds to the section's stiffness until it slips.")
            .unit("of stiffness").above(0).required()
        .key("limit", &T::limit, "The force or moment at which it slips.")
            .unit("of force or moment").at_least(0).required()
        .key("limit_per_tension", &T::limit_per_tension,
             "What the limit grows by with the axial force, where that is tension.")
            .unit("1 or length").at_least(0);
    // clang-format on
    return table;
}

const TableSpec& moment_curvature_table() {
    using T = MomentCurvatureTable;
    // clang-format off
    static const TableSpec table = Table<T>("section.NAME.law.moment_curvature", "")
        .key("table", &T::table, "Rows [curvature, moment] from [0, 0] on, linear in between and beyond: of bending in "
             "any direction. EIy and EIz are not used then.")
            .unit("1/length, moment").at_least(0)
        .key("y", &T::y, "The same of bending about y alone, in place of EIy.")
            .unit("1/length, moment").at_least(0)
        .key("z", &T::z, "The same of bending about z alone, in place of EIz.")
            .unit("1/length, moment").at_least(0)
        .key("hysteresis", &T::hysteresis, "Whether the moment follows the table back, or the section yields at each "
             "kink and hardens kinematically.")
        .at_least_one_of({"table", "y", "z"})
        .at_most_one_of({"table", "y"})
        .at_most_one_of({"table", "z"});
    // clang-format on
    return table;
}

const TableSpec& tension_strain_table() {
    using T = TensionStrainTable;
    // clang-format off
    static const TableSpec table = Table<T>("section.NAME.law.tension_strain", "")
        .key("table", &T::table, "Rows [strain, tension], both rising, with the row [0, 0]; linear in between and "
             "beyond. Rows of negative strain say what shortening takes; without them it takes the first slope of "
             "stretching. EA is not used then.")
            .unit("1, force").required()
        .key("unloading_stiffness", &T::unloading_stiffness, "Force per strain with which the tension falls below "
             "that at the largest strain so far, and returns to it: a stretched rope stays longer. Not less than "
             "any slope of the table.")
            .unit("force").above(0).otherwise("the tension follows the table back")
            .also("dynamic_stiffness unloading");
    // clang-format on
    return table;
}

const TableSpec& syrope_table() {
    using T = SyropeTable;
    // clang-format off
    static const TableSpec table = Table<T>("section.NAME.law.syrope", "")
        .key("original", &T::original, "The original curve: rows [strain, mean tension] of a new rope that is stretched "
             "slowly, from [0, 0] on, both rising; linear in between and beyond. EA is not used then.")
            .unit("1, force").at_least(0).required().also("original_curve owc original_working_curve table")
        .key("working_curve", &T::working_curve, "Shape of the curve on which the mean tension falls and returns below the "
             "largest one so far.")
            .otherwise("exponential").also("shape wc wc_type wctype")
        .key("k1", &T::k1, "How much of the largest strain stays where the mean tension has gone; of a linear curve from 1 on its "
             "slope, a force.")
            .unit("1").at_least(0).required()
        .key("k2", &T::k2, "How much the working curve bends: of a quadratic one up to 1. Required but for a linear one.")
            .unit("1").above(0)
        .key("dynamic_stiffness", &T::dynamic_stiffness, "Force per strain of fast changes, without mean tension.")
            .unit("force").above(0).required().also("alpha")
        .key("per_tension", &T::per_tension, "What the dynamic stiffness grows by with the mean tension.")
            .unit("1").at_least(0).also("beta")
        .key("damping", &T::damping, "Of the dashpot in parallel with the slow spring: force per rate of its strain.")
            .unit("force·time").above(0).required().also("ba_s c1 slow_damping")
        .key("largest_tension", &T::largest_tension, "The largest mean tension of the rope before the start. The rod's length is then "
             "that of the rope as this has left it, without tension.")
            .unit("force").at_least(0).also("tmax tmax0");
    // clang-format on
    return table;
}

const TableSpec& yield_table() {
    constexpr std::array<std::pair<const char*, const char*>, 6> resultants{
        {{"N", "Axial force at which it yields. What is left out does not yield."},
         {"Vy", "Shear force along y."},
         {"Vz", "Shear force along z."},
         {"T", "Torque."},
         {"My", "Bending moment about y."},
         {"Mz", "Bending moment about z."}}};
    static const TableSpec table = [&] {
        Table<YieldTable> made("section.NAME.law.plastic.yield", "");
        for (std::size_t i = 0; i < resultants.size(); ++i) {
            const auto [name, sentence] = resultants[i];
            made.key(
                    name, [i](auto& yield) -> auto& { return yield.limits[i]; }, sentence)
                .unit(i < 3 ? "force" : "moment")
                .above(0);
        }
        return made.at_least_one_of({"N", "Vy", "Vz", "T", "My", "Mz"});
    }();
    return table;
}

const TableSpec& plastic_table() {
    using T = PlasticTable;
    // clang-format off
    static const TableSpec table = Table<T>("section.NAME.law.plastic", "")
        .key("yield", &T::yield, yield_table(), "Resultants at which the section yields; \"shape\": N, My and Mz at which its shape "
             "yields as a whole by the yield_stress of its materials, about the point where that axial force acts.")
            .words({"shape"}).required()
        .key("interaction", &T::interaction, "Whether it yields where the squares of resultants over their limits add "
             "up to 1, or each yields by itself.")
        .key("isotropic", &T::isotropic, "How much all limits grow, over themselves, per plastic strain in multiples "
             "of the strain at yield; or rows [that plastic strain, factor on limits] from [0, 1] on.")
            .unit("1").at_least(0).otherwise("0")
        .key("kinematic", &T::kinematic, "Resultants move the yield surface by kinematic × stiffness × plastic strain.")
            .unit("1").at_least(0);
    // clang-format on
    return table;
}

const TableSpec& viscoelastic_table() {
    using T = ViscoelasticTable;
    // clang-format off
    static const TableSpec table = Table<T>("section.NAME.law.viscoelastic", "")
        .key("prony", &T::prony, "Rows [r, tau]: after a sudden strain the stiffness is that of the section, which is "
             "the relaxed one, × (1 + Σ r exp(−t/tau)).")
            .unit("1, time").at_least(0).required()
        .key("on", &T::on, "The strains that relax.")
            .words(words_of(strain_part_choices)).otherwise("all strains");
    // clang-format on
    return table;
}

}  // namespace

const TableSpec& law_table() {
    using T = LawTable;
    // clang-format off
    static const TableSpec table = Table<T>("section.NAME.law", "")
        .key("layers", &T::layers, layer_table(),
             "Springs that slip, next to the stiffness: friction of strands, plasticity.")
        .key("moment_curvature", &T::moment_curvature, moment_curvature_table(), "Moments by tables.")
        .key("plastic", &T::plastic, plastic_table(), "Resultants that yield and harden.")
        .key("viscoelastic", &T::viscoelastic, viscoelastic_table(),
             "Resultants that relax: a generalised Maxwell model.")
        .key("tension_strain", &T::tension_strain, tension_strain_table(), "The axial force by a table: ropes.")
        .key("syrope", &T::syrope, syrope_table(), "A fibre rope, by the Syrope model: slow and fast stretch.")
        .exactly_one_of({"layers", "moment_curvature", "plastic", "viscoelastic", "tension_strain", "syrope"});
    // clang-format on
    return table;
}

namespace {

using SharedLaw = std::shared_ptr<const SectionLaw>;

// Of a section's size: nearer to its point nothing is away from it.
constexpr double round_off_of_place = 1e-9;

// The rows that a table has for a key.
struct KeyRows {
    const TableHead& table;
    const void* field;
    const CheckedPairs& pairs;

    void add_fault(std::size_t row, std::string message, const BuildContext& context) const {
        context.faults.add(
            pairs.places[row], fmt::format("{}[{}]", table.path_of(field), row), std::move(message));
    }
};

// Rows that start at (0, start), the first number rising and the second not falling.
std::optional<PiecewiseLine> find_line(const KeyRows& given, double start, const BuildContext& context) {
    const auto& rows = given.pairs.rows;
    const auto refuse = [&](std::size_t row, std::string message) {
        given.add_fault(row, std::move(message), context);
        return std::nullopt;
    };
    if (rows.front() != std::pair(0.0, start)) {
        return refuse(
            0,
            fmt::format(
                "expected [0, {}] first, found [{}, {}]", start, rows.front().first, rows.front().second));
    }
    if (rows.size() < 2) return refuse(0, "expected another row after the first one");
    for (std::size_t i = 1; i < rows.size(); ++i) {
        if (rows[i].first <= rows[i - 1].first) {
            return refuse(i,
                          fmt::format("the first number must rise from row to row: {} follows {}",
                                      rows[i].first,
                                      rows[i - 1].first));
        }
        if (rows[i].second < rows[i - 1].second) {
            return refuse(i,
                          fmt::format("the second number must not fall from row to row: {} follows {}",
                                      rows[i].second,
                                      rows[i - 1].second));
        }
    }
    return PiecewiseLine(rows);
}

std::optional<Layer> find_layer(const LayerTable& given,
                                const SectionPlace& at,
                                const BuildContext& context) {
    const Layer layer{.on = given.on,
                      .stiffness = number_of(given, given.stiffness, at, context),
                      .limit = number_of(given, given.limit, at, context),
                      .limit_per_tension = number_of(given, given.limit_per_tension, at, context)};
    if (layer.on == StrainPart::tension && layer.limit_per_tension > 0.0) {
        context.add_fault(
            given, given.limit_per_tension, "a layer on tension has a limit that does not depend on tension");
        return std::nullopt;
    }
    if (layer.limit > 0.0 || layer.limit_per_tension > 0.0) return layer;
    context.add_fault(
        given, given.limit, "expected a number greater than 0, or limit_per_tension greater than 0, found 0");
    return std::nullopt;
}

SharedLaw make_layered_law(const std::vector<LayerTable>& given,
                           const Mat6& C,
                           const SectionPlace& at,
                           const BuildContext& context) {
    std::vector<Layer> layers;
    for (const LayerTable& one : given) {
        const std::optional<Layer> layer = find_layer(one, at, context);
        if (layer) layers.push_back(*layer);
    }
    return std::make_shared<LayeredLaw>(C, std::move(layers));
}

// nullopt, with a fault, if it is not what a curve of moments must be.
std::optional<MomentCurve> find_curve(const MomentCurvatureTable& given,
                                      const CheckedPairs& pairs,
                                      StrainPart on,
                                      const Mat6& C,
                                      const BuildContext& context) {
    const KeyRows rows{given, &pairs, pairs};
    const std::optional<PiecewiseLine> line = find_line(rows, 0.0, context);
    if (!line) return std::nullopt;
    if (line->slope(0) <= 0.0) {
        rows.add_fault(1, "expected a moment greater than 0", context);
        return std::nullopt;
    }
    const std::optional<std::size_t> rising = find_rising_slope(*line);
    if (rising && given.hysteresis == Hysteresis::kinematic) {
        rows.add_fault(
            *rising + 1,
            fmt::format("a section that yields gets softer from row to row; the slope {} follows {}",
                        line->slope(*rising),
                        line->slope(*rising - 1)),
            context);
        return std::nullopt;
    }
    const StrainEntries entries = entries_of(on);
    // A curve for both replaces what couples them, too.
    Mat6 others = C;
    if (entries.count == 2) others(4, 5) = others(5, 4) = 0.0;
    if (couples(others, entries.list())) {
        context.add_fault(given,
                          pairs,
                          "the stiffness couples this bending with another strain, which a table of moments "
                          "cannot; expected a stiffness without, such as stiffness = { … }");
        return std::nullopt;
    }
    return MomentCurve{on, *line};
}

SharedLaw make_curve_law(const MomentCurvatureTable& given, const Mat6& C, const BuildContext& context) {
    std::vector<MomentCurve> curves;
    const auto add = [&](const std::optional<CheckedPairs>& rows, StrainPart on) {
        if (!rows) return;
        std::optional<MomentCurve> curve = find_curve(given, *rows, on, C, context);
        if (curve) curves.push_back(std::move(*curve));
    };
    add(given.table, StrainPart::bending);
    add(given.y, StrainPart::bending_y);
    add(given.z, StrainPart::bending_z);
    if (given.hysteresis == Hysteresis::kinematic) return make_kinematic_law(C, curves);
    return std::make_shared<MomentCurvatureLaw>(C, std::move(curves));
}

// The rows of one side, from (0, 0) on; with the other signs those of shortening.
std::vector<std::pair<double, double>> take_side(const CheckedPairs& rows, double sign) {
    std::vector<std::pair<double, double>> side;
    for (const auto& [strain, tension] : rows.rows) {
        if (sign * strain >= 0.0) side.emplace_back(sign * strain, sign * tension);
    }
    std::ranges::sort(side);
    return side;
}

// Returns whether the rows are a curve through (0, 0); a fault where not.
bool check_stretch_rows(const TensionStrainTable& given, const BuildContext& context) {
    const KeyRows rows{given, &given.table, given.table};
    const auto& pairs = given.table.rows;
    for (std::size_t i = 0; i < pairs.size(); ++i) {
        const auto& [strain, tension] = pairs[i];
        std::string fault;
        if (i > 0 && strain <= pairs[i - 1].first)
            fault = fmt::format(
                "the strain must rise from row to row: {} follows {}", strain, pairs[i - 1].first);
        else if (i > 0 && tension < pairs[i - 1].second)
            fault = fmt::format(
                "the tension must not fall from row to row: {} follows {}", tension, pairs[i - 1].second);
        else if ((strain == 0.0) != (tension == 0.0) && strain >= 0.0)
            fault = fmt::format(
                "expected no tension at strain 0 and some above, found [{}, {}]", strain, tension);
        if (fault.empty()) continue;
        rows.add_fault(i, std::move(fault), context);
        return false;
    }
    const bool has_origin = std::ranges::find(pairs, std::pair(0.0, 0.0)) != pairs.end();
    if (has_origin && pairs.back().first > 0.0) return true;
    rows.add_fault(has_origin ? pairs.size() - 1 : 0,
                   has_origin ? "expected a row of positive strain after this one" : "expected a row [0, 0]",
                   context);
    return false;
}

SharedLaw make_stretch_law(const TensionStrainTable& given, const Mat6& C, const BuildContext& context) {
    if (!check_stretch_rows(given, context)) return nullptr;
    constexpr std::array<int, 1> axial{0};
    if (couples(C, axial)) {
        context.add_fault(given,
                          given.table,
                          "the stiffness couples stretch with another strain, which a table of tensions "
                          "cannot; expected a stiffness without, such as stiffness = { … }");
        return nullptr;
    }
    const PiecewiseLine pulled(take_side(given.table, 1.0));
    auto shortening = take_side(given.table, -1.0);
    if (shortening.size() < 2) shortening = {{0.0, 0.0}, {1.0, pulled.slope(0)}};
    double steepest = 0.0;
    for (std::size_t i = 0; i < pulled.piece_count(); ++i) steepest = std::max(steepest, pulled.slope(i));
    if (given.unloading_stiffness && *given.unloading_stiffness < steepest) {
        context.add_fault(given,
                          given.unloading_stiffness,
                          fmt::format("expected at least {}, the steepest slope of the table", steepest));
        return nullptr;
    }
    return std::make_shared<StretchLaw>(
        C, StretchCurve{pulled, PiecewiseLine(std::move(shortening)), given.unloading_stiffness});
}

// The strain of a new rope at a mean tension.
double find_strain(const PiecewiseLine& original, double tension) {
    std::size_t i = 0;
    while (i + 1 < original.piece_count() && tension > original.points()[i + 1].second) ++i;
    return original.points()[i].first + (tension - original.points()[i].second) / original.slope(i);
}

// Adds faults of k1 and k2 beyond what the shape allows; returns whether both are allowed.
bool check_working_curve(const SyropeTable& given, const BuildContext& context) {
    const bool is_linear = given.working_curve == WorkingShape::linear;
    const bool is_quadratic = given.working_curve == WorkingShape::quadratic;
    if (!is_linear && given.k1 >= 1.0) {
        context.add_fault(
            given, given.k1, "expected a number less than 1; from 1 on it is the slope of a linear curve");
        return false;
    }
    if (!is_linear && !given.k2) {
        context.add_fault(given, given.k2, "missing; expected how much the working curve bends");
        return false;
    }
    if (!is_quadratic || *given.k2 <= 1.0) return true;
    context.add_fault(given, given.k2, "expected a number of at most 1: a quadratic curve falls otherwise");
    return false;
}

SharedLaw make_syrope_law(const SyropeTable& given, const Mat6& C, const BuildContext& context) {
    const KeyRows rows{given, &given.original, given.original};
    const std::optional<PiecewiseLine> original = find_line(rows, 0.0, context);
    if (!original || !check_working_curve(given, context)) return nullptr;
    for (std::size_t i = 0; i < original->piece_count(); ++i) {
        if (original->slope(i) > 0.0) continue;
        rows.add_fault(i + 1, "expected a tension that rises from row to row", context);
        return nullptr;
    }
    constexpr std::array<int, 1> axial{0};
    if (couples(C, axial)) {
        context.add_fault(
            given,
            given.original,
            "the stiffness couples stretch with another strain, which a rope by the Syrope model "
            "cannot; expected a stiffness without, such as stiffness = { … }");
        return nullptr;
    }
    SyropeRope rope{.original = *original,
                    .shape = given.working_curve,
                    .k1 = given.k1,
                    .k2 = given.k2.value_or(0.0),
                    .stiffness = given.dynamic_stiffness,
                    .per_tension = given.per_tension,
                    .damping = given.damping,
                    .largest = find_strain(*original, given.largest_tension)};
    if (const std::optional<SteepCurve> steep = find_steep_curve(rope)) {
        context.add_fault(
            given,
            given.dynamic_stiffness,
            fmt::format(
                "where the largest mean tension is {:.4g} a curve rises by {:.4g} per strain, not less than "
                "the "
                "dynamic stiffness, {:.4g}; expected a stiffer rope, a curve that bends less, or a greater "
                "largest_tension",
                original->at(steep->largest).value,
                steep->slope,
                steep->stiffness));
        return nullptr;
    }
    return std::make_shared<SyropeLaw>(C, std::move(rope));
}

// A factor on limits over plastic strain; nullopt without one, or with a fault.
std::optional<PiecewiseLine> find_isotropic(const PlasticTable& given, const BuildContext& context) {
    if (const auto* rows = std::get_if<CheckedPairs>(&given.isotropic))
        return find_line({given, &given.isotropic, *rows}, 1.0, context);
    const double slope = std::get<double>(given.isotropic);
    if (slope == 0.0) return std::nullopt;
    return PiecewiseLine({{0.0, 1.0}, {1.0, 1.0 + slope}});
}

// The limits of a law and the point that they are about, in the axes of the section.
struct PlacedLimits {
    std::vector<std::pair<int, double>> limits = {};
    PlanePoint about = PlanePoint::Zero();
};

// nullopt, with a fault, if the shape has no limits.
std::optional<PlacedLimits> find_limits(const PlasticTable& given, const ShapeLawSource& source) {
    if (const auto* table = std::get_if<YieldTable>(&*given.yield)) {
        PlacedLimits found;
        for (int entry = 0; entry < 6; ++entry) {
            const std::optional<ArcNumber>& limit = table->limits[static_cast<std::size_t>(entry)];
            if (limit) found.limits.emplace_back(entry, number_of(*table, *limit, source.at, source.context));
        }
        return found;
    }
    const std::optional<PlasticCapacity> capacity = find_plastic_capacity(given, source);
    if (!capacity) return std::nullopt;
    return PlacedLimits{{{0, capacity->axial_force}, {4, capacity->moment_y}, {5, capacity->moment_z}},
                        capacity->centre};
}

SharedLaw make_plastic_law(const PlasticTable& given, const ShapeLawSource& source) {
    const BuildContext& context = source.context;
    const std::optional<PlacedLimits> found = find_limits(given, source);
    if (!found) return nullptr;
    const YieldLimits yield{.limits = found->limits,
                            .interaction = given.interaction,
                            .isotropic = find_isotropic(given, context),
                            .kinematic = number_of(given, given.kinematic, source.at, context)};
    const double size = std::sqrt(source.section.stiffness(4, 4) / source.section.stiffness(0, 0));
    const bool is_away = found->about.norm() > round_off_of_place * size;
    const SectionFrame frame{.y = is_away ? found->about.x() : 0.0, .z = is_away ? found->about.y() : 0.0};
    const Mat6 C = move_to(frame, source.section.stiffness);
    std::vector<int> entries;
    for (const auto& [entry, limit] : yield.limits) entries.push_back(entry);
    if (yield.interaction == YieldInteraction::none && couples_within(C, entries)) {
        context.add_fault(given,
                          given.interaction,
                          "the stiffness couples resultants that yield, so that none yields by itself; "
                          "expected \"ellipsoid\"");
        return nullptr;
    }
    auto law = std::make_shared<PlasticLaw>(C, yield);
    if (!is_away) return law;
    return std::make_shared<MovedLaw>(frame, std::move(law));
}

SharedLaw make_viscoelastic_law(const ViscoelasticTable& given, const Mat6& C, const BuildContext& context) {
    std::vector<PronyBranch> branches;
    for (std::size_t i = 0; i < given.prony.rows.size(); ++i) {
        const auto& [ratio, time] = given.prony.rows[i];
        if (time > 0.0) {
            branches.push_back({ratio, time});
        } else {
            KeyRows{given, &given.prony, given.prony}.add_fault(
                i, "expected a time tau greater than 0, found 0", context);
        }
    }
    std::vector<StrainPart> on;
    for (const CheckedWord& word : given.on.words) on.push_back(value_of(strain_part_choices, word.word));
    return std::make_shared<ViscoelasticLaw>(C, std::move(branches), on);
}

SharedLaw make_law(const LawTable& law, const ShapeLawSource& source) {
    const Mat6& C = source.section.stiffness;
    if (law.gives(law.layers)) return make_layered_law(law.layers, C, source.at, source.context);
    if (law.moment_curvature) return make_curve_law(*law.moment_curvature, C, source.context);
    if (law.plastic) return make_plastic_law(*law.plastic, source);
    if (law.syrope) return make_syrope_law(*law.syrope, C, source.context);
    if (law.tension_strain) return make_stretch_law(*law.tension_strain, C, source.context);
    return make_viscoelastic_law(*law.viscoelastic, C, source.context);
}

// Whether the yield stress of the material is for the limits of the law.
bool takes_limits_of_shape(const SectionTable& section) {
    return section.law && section.law->plastic && section.law->plastic->yield &&
           std::holds_alternative<ChosenWord>(*section.law->plastic->yield);
}

// Makes the law of a section in its own axes; nullptr without one, or with a fault.
SharedLaw find_law(const ShapeLawSource& source) {
    const SectionTable& given = source.given;
    const bool yields = yields_by_shape(source);
    if (!given.law) return yields ? make_shape_law(source) : nullptr;
    const std::optional<MaterialTable> material =
        yields && !is_cut(given, source.context) ? find_shape_material(given, source.context) : std::nullopt;
    const bool has_interaction = yields && (!material || material->interaction.value_or(false));
    if (!yields || (takes_limits_of_shape(given) && !has_interaction)) return make_law(*given.law, source);
    source.context.add_fault(given,
                             given.law,
                             fmt::format("{} of the material is given too; only one of them can be",
                                         has_interaction ? "interaction" : "yield_stress"));
    return nullptr;
}

}  // namespace

void set_law(const SectionTable& given,
             const SectionPlace& at,
             const SectionFrame& frame,
             Section& section,
             const BuildContext& context) {
    const Mat6 C = section.stiffness;
    // One that is at fault itself has none.
    const bool is_right = (C.diagonal().array() > 0.0).all();
    SharedLaw law = is_right ? find_law({given, at, section, context}) : nullptr;
    section.stiffness = move_from(frame, C);
    const bool is_trapeze = given.trapeze.value_or(false) && is_right;
    if (!law && !is_trapeze) return;
    const Mat6 moved = section.stiffness;
    if (law) {
        const std::vector<double> memory(static_cast<std::size_t>(law->memory_size()));
        section.stiffness = move_from(
            frame, law->respond(Vec6::Zero(), memory, std::numeric_limits<double>::infinity(), {}).tangent);
        if (!frame.is_trivial()) law = std::make_shared<MovedLaw>(frame, std::move(law));
    }
    // About the rod, where the fibres of a section are.
    if (is_trapeze) law = std::make_shared<TrapezeLaw>(moved, std::move(law));
    section.law = std::move(law);
}

}  // namespace gxrod
