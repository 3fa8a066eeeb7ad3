#include "deck/drives/build_drives.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "deck/checks/check_moves.hpp"
#include "deck/drives/chamber_table.hpp"
#include "deck/drives/tendon_path.hpp"
#include "deck/loads/acting.hpp"
#include "deck/places/part.hpp"
#include "deck/rods/rod_table.hpp"
#include "deck/schema/schema_tables.hpp"
#include "model/settings/scheme_card.hpp"

namespace gxrod {
const TableSpec& tendon_table() {
    using T = TendonTable;
    // clang-format off
    static const TableSpec table = Table<T>("[tendon.NAME]",
            "A tendon that slides along a path within a rod, fixed to it at both ends. [Tendons and "
            "muscles](guide/tendons.md) explains it.")
        .key("on", &T::on, "The name of a rod.")
            .required().names_of({"rod"}).also("rod beam along")
        .key("offset", &T::offset, "Where it passes through the section: y and z, from the line of the rod. Functions "
             "of s, the arc length from the rod's start; or at fractions of the rod's length, straight between them, "
             "with a node at each.")
            .unit("length").required().also("path position route routing")
        .key("tension", &T::tension, "The same all along; with friction where it is pulled. Below 0 it pushes: −p A "
             "of a chamber of the area A across, under the pressure p.")
            .unit("mass·length/time²").also("force pull t")
        .key("shortening", &T::shortening, "What a winch draws in: by how much the tendon's part within the rod is "
             "shorter than at t = 0. The tension follows.")
            .unit("length").also("displacement stroke u move pulled winch")
        .key("length", &T::length, "The same by the length of that part. A value without t is reached from that at t "
             "= 0 in the first static stage.")
            .unit("length")
        .key("stiffness", &T::stiffness,
             "EA of a tendon with a winch, or of one that sticks by friction: a force over the strain that it causes.")
            .unit("mass·length/time²").above(0).otherwise("does not stretch").also("ea e k")
        .key("friction", &T::friction, "Coefficient μ of a tendon whose tension is given: where the tendon turns by "
             "dφ its tension changes by μ T dφ as it slips.")
            .unit("1").at_least(0).also("mu coefficient friction_coefficient capstan")
        .key("pulled_at", &T::pulled_at, "With friction, the end that has the tension; the other one is anchored.")
            .also("actuator end actuated_at motor")
        .key("slack", &T::slack,
             "Whether a tendon with a winch hangs loose where it is too long; otherwise it pushes there.")
            .otherwise("true")
        .key("from", &T::from, "Where it starts, as a fraction of the rod's length, where a node is placed.")
            .unit("1").between(0, 1)
        .key("to", &T::to, "Where it ends, likewise.")
            .unit("1").between(0, 1)
        .key("factor", &T::factor, factor_sentence("tension or shortening"))
            .unit("1").otherwise(factor_default)
        .key("stages", &T::stages, "The stages in which it pulls; in others it hangs loose.")
            .otherwise("all").names_of({"stage"})
        .with(add_load_case<T>)
        .exactly_one_of({"tension", "shortening", "length"})
        .shown_by(
            "[tendon.pull]\n"
            "on      = \"flyer\"\n"
            "offset  = [\"0.1*cos(s)\", \"0.1*sin(s)\"]\n"
            "tension = \"5*pulse(t)\"\n"
            "to      = 0.75\n");
    // clang-format on
    return table;
}

namespace {

const Rod& rod_of(int index, const BuildContext& context) {
    return context.model.rods[static_cast<std::size_t>(index)];
}

// What is wrong with a path where elements look at it.
void check_path(const TendonTable& given, const Tendon& tendon, const BuildContext& context) {
    try {
        for (const double s : list_force_points(rod_of(tendon.rod, context))) {
            if (s > tendon.from && s < tendon.to) tendon.path(s);
        }
    } catch (const EvaluationError& error) {
        // Its text begins with the key, "tendon.pull.offset[1]".
        const std::string text = error.what();
        const std::size_t end = text.find(": ");
        context.faults.add(given.place_of(&given.offset), text.substr(0, end), text.substr(end + 2));
    }
}

bool is_explicit(const AnalysisSettings& analysis) {
    const auto* dynamic = std::get_if<DynamicSettings>(&analysis);
    return dynamic != nullptr && card_of(dynamic->scheme).is_explicit;
}

// Keys that need a winch, or do not go with one.
void check_winch_keys(const TendonTable& given, const BuildContext& context) {
    if (given.tension && given.slack)
        context.add_fault(given, given.slack, "goes with shortening or length, not with a tension");
    if (given.tension && given.stiffness && !given.gives(given.friction))
        context.add_fault(
            given, given.stiffness, "goes with shortening or length, or with a tension and friction");
    constexpr const char* of_length = "of a length has no meaning; expected shortening in its place";
    if (given.length && given.factor) context.add_fault(given, given.factor, of_length);
    if (given.length && given.load_case) context.add_fault(given, given.load_case, of_length);
}

std::optional<TendonWinch> make_winch(const TendonTable& given,
                                      double length,
                                      const Acting& acting,
                                      const BuildContext& context) {
    if (given.tension) return std::nullopt;
    TendonWinch winch{.pulls_only = given.slack.value_or(true), .is_released = acting.is_absent};
    winch.stiffness = given.stiffness.value_or(winch.stiffness);
    if (winch.stiffness == 0.0 && winch.pulls_only && is_explicit(context.analysis()))
        context.add_fault(given,
                          given.slack,
                          "a tendon that does not stretch cannot become taut in an explicit scheme; expected "
                          "a stiffness, or slack = false");
    if (given.length) {
        const auto& function = given.length->function;
        winch.length = function;
        winch.share = find_share(function, acting);
        return winch;
    }
    const CheckedTimeFunction& shortening = *given.shortening;
    winch.shortening = acting.apply(shortening.function);
    if (winch.stiffness == 0.0) check_move(shortening, length, context);
    return winch;
}

// A winch's length would depend on the tension all along.
std::optional<CapstanFriction> make_friction(const TendonTable& given, const BuildContext& context) {
    if (given.friction == 0.0) {
        if (given.gives(given.pulled_at) && !given.gives(given.friction))
            context.add_fault(given, given.pulled_at, "goes with friction; without it both ends are alike");
        return std::nullopt;
    }
    if (!given.tension) {
        context.add_fault(given,
                          given.friction,
                          "goes with a tension, not with shortening or length; expected tension, which an "
                          "input can control");
        return std::nullopt;
    }
    return CapstanFriction{.coefficient = given.friction,
                           .stiffness = given.stiffness.value_or(0.0),
                           .is_pulled_at_start = given.pulled_at == TendonEnd::from};
}

void add_tendon(const TendonTable& given, BuildContext& context) {
    std::optional<Tendon> tendon = lay_tendon(given, context);
    if (!tendon) return;
    check_winch_keys(given, context);
    const Acting acting = find_acting(given, context);
    tendon->winch = make_winch(given, rod_of(tendon->rod, context).length, acting, context);
    tendon->friction = make_friction(given, context);
    if (!tendon->winch) tendon->tension = acting.apply(given.tension->function);
    context.model.tendons.push_back(std::move(*tendon));
}

}  // namespace

TimeFunction find_share(const TimeFunction& length, const Acting& acting) {
    return length.has_time() ? TimeFunction(1.0) : acting.apply(TimeFunction(1.0));
}

std::optional<Tendon> lay_tendon(const TendonTable& given, const BuildContext& context) {
    const std::optional<Part> part = find_part(given, given.on, context);
    const std::optional<TendonRange> range = find_tendon_range(given, context);
    if (!part || !range) return std::nullopt;
    if (rods_of(context.deck)[static_cast<std::size_t>(part->rod)].get().mesh) {
        context.add_fault(
            given, given.on, "a rod from a mesh has no tendons or chambers; expected one along a line");
        return std::nullopt;
    }
    const double length = rod_of(part->rod, context).length;
    Tendon tendon{.name = given.name,
                  .rod = part->rod,
                  .from = range->from * length,
                  .to = range->to * length,
                  .path = make_tendon_path(given.offset, *range, length)};
    if (context.stage == 0) check_path(given, tendon, context);
    return tendon;
}

void build_tendons(BuildContext& context) {
    for (const TendonTable& given : tables_of<TendonTable>(context.deck, tendon_table()))
        add_tendon(given, context);
    build_chambers(context);
}

}  // namespace gxrod
