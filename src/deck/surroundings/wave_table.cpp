#include "deck/surroundings/build_waves.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "deck/loads/combinations.hpp"
#include "deck/schema/schema_tables.hpp"
#include "deck/schema/top_level.hpp"
#include "deck/surroundings/build_seabed.hpp"
#include "environment/dispersion.hpp"
#include "environment/sea.hpp"
#include "model/settings/analysis_traits.hpp"

namespace gxrod {
namespace {

const TableSpec& airy_table() {
    using T = AiryTable;
    // clang-format off
    static const TableSpec table = Table<T>("wave.airy", "")
        .key("height", &T::height, "From trough to crest.")
            .unit("length").above(0).required().also("h wave_height").also("amplitude a", "twice the amplitude")
        .key("period", &T::period, "Of a point at rest.")
            .unit("time").above(0).required().also("t wave_period")
        .key("phase", &T::phase,
             "At the origin the surface is height/2 cos(phase − ω t), t from the start of the first stage with time.")
            .unit("angle");
    // clang-format on
    return table;
}

const TableSpec& jonswap_table() {
    using T = JonswapTable;
    // clang-format off
    static const TableSpec table = Table<T>("wave.jonswap", "")
        .key("Hs", &T::significant_height, "Significant height: 4 √(variance).")
            .unit("length").above(0).required().also("significant_height hm0 h height")
        .key("Tp", &T::peak_period, "Period of the peak.")
            .unit("time").above(0).required().also("peak_period t period")
        .key("gamma", &T::gamma, "Peak enhancement; 1 is the spectrum of Pierson and Moskowitz.")
            .unit("1").at_least(1)
        .key("components", &T::components, "How many waves of equal energy.")
            .between(1, 100000).also("n count waves")
        .key("seed", &T::seed, "Of the random phases: the same seed is the same sea on every machine.")
            .between(0, 1e15)
        .key("spreading", &T::spreading,
             "s: directions spread about the given one as cos^2s of half the angle between.")
            .unit("1").at_least(0).otherwise("none: all of one direction");
    // clang-format on
    return table;
}

const TableSpec& elevation_table() {
    using T = ElevationTable;
    // clang-format off
    static const TableSpec table = Table<T>("wave.elevation", "")
        .key("file", &T::file, "A CSV file of two columns, t and the height of the surface above still water, t "
             "rising in equal steps; relative to the deck's folder.")
            .required()
        .key("at", &T::at, "Where it was measured; its height says nothing.")
            .unit("length")
        .key("shortest_period", &T::shortest_period, "Shorter waves are left out.")
            .unit("time").above(0).otherwise("two steps of the record")
        .key("longest_period", &T::longest_period, "Longer waves are left out.")
            .unit("time").above(0).otherwise("the length of the record");
    // clang-format on
    return table;
}

}  // namespace

const TableSpec& wave_table() {
    using T = WaveTable;
    // clang-format off
    static const TableSpec table = Table<T>("[[wave]]",
            "Linear waves on the surface of [fluid], in stages that have time. Several add up.")
        .key("airy", &T::airy, airy_table(), "One regular wave.")
            .also("regular linear height period")
        .key("jonswap", &T::jonswap, jonswap_table(), "A sea by its spectrum.")
            .also("spectrum irregular hs tp sea")
        .key("elevation", &T::elevation, elevation_table(), "A record of the surface.")
            .also("record file table time_series")
        .key("direction", &T::direction, "Where they go, horizontal and of any length.")
            .unit("1").also("heading dir")
        .key("stages", &T::stages, "The stages with waves, of those that have time.")
            .otherwise("all").names_of({"stage"})
        .with(add_load_case<T>)
        .exactly_one_of({"airy", "jonswap", "elevation"})
        .shown_by(
            "[[wave]]\n"
            "airy      = { height = 2, period = 8 }\n"
            "direction = [0, 1, 0]\n");
    // clang-format on
    return table;
}

namespace {

std::vector<std::reference_wrapper<const WaveTable>> waves_of(const BuildContext& context) {
    return tables_of<WaveTable>(context.deck, wave_table());
}

bool acts_with_time(const WaveTable& wave, std::size_t stage, const BuildContext& context) {
    return is_timed(context.stages[stage].analysis) && acts_in_stage(wave, stage, context) &&
           find_case_factor(wave.load_case, context) != 0.0;
}

// How long the stages with time have lasted before the one at hand, from the first one with waves on.
double find_time_before(const BuildContext& context) {
    const auto waves = waves_of(context);
    double time = 0.0;
    bool has_begun = false;
    for (std::size_t i = 0; i < context.stage; ++i) {
        has_begun = has_begun || std::ranges::any_of(waves, [&](const WaveTable& wave) {
                        return acts_with_time(wave, i, context);
                    });
        if (has_begun && is_timed(context.stages[i].analysis)) time += end_of(context.stages[i].analysis);
    }
    return time;
}

// Where a wave goes, from x towards y; nullopt with a fault.
std::optional<double> find_direction(const WaveTable& wave, const BuildContext& context) {
    const Vec3& direction = wave.direction;
    if (direction.head<2>().isZero(0.0) || direction.z() != 0.0) {
        context.add_fault(
            wave, wave.direction, "expected a horizontal direction, [x, y, 0], that is not zero");
        return std::nullopt;
    }
    return std::atan2(direction.y(), direction.x());
}

std::vector<WaveTrain> make_airy_wave(const AiryTable& airy, double direction, const WavePlace& place) {
    const double frequency = 2.0 * M_PI / airy.period;
    return {{.amplitude = 0.5 * airy.height,
             .frequency = frequency,
             .number = find_wave_number(frequency, place.depth, place.gravity),
             .direction = direction,
             .phase = airy.phase}};
}

std::vector<WaveTrain> make_sea(const JonswapTable& jonswap, double direction, const WavePlace& place) {
    IrregularSea sea{.significant_height = jonswap.significant_height,
                     .peak_period = jonswap.peak_period,
                     .enhancement = jonswap.gamma,
                     .components = static_cast<int>(jonswap.components),
                     .seed = static_cast<std::uint64_t>(jonswap.seed),
                     .direction = direction};
    if (jonswap.spreading) sea.spreading = *jonswap.spreading;
    return make_irregular_sea(sea, place);
}

std::vector<WaveTrain> make_recorded_waves(const ElevationTable& elevation,
                                           ElevationRecord record,
                                           double direction,
                                           const WavePlace& place) {
    record.x = elevation.at.x();
    record.y = elevation.at.y();
    record.direction = direction;
    if (elevation.longest_period) record.lowest_frequency = 2.0 * M_PI / *elevation.longest_period;
    if (elevation.shortest_period) record.highest_frequency = 2.0 * M_PI / *elevation.shortest_period;
    return make_recorded_sea(record, place);
}

// The waves of one table, t from the start of the first stage with waves.
std::vector<WaveTrain> make_waves(std::size_t index,
                                  const SurroundingsFiles& files,
                                  const WavePlace& place,
                                  const BuildContext& context) {
    const WaveTable& wave = waves_of(context)[index];
    const std::optional<double> direction = find_direction(wave, context);
    if (!direction) return {};
    if (wave.airy) return make_airy_wave(*wave.airy, *direction, place);
    if (wave.jonswap) return make_sea(*wave.jonswap, *direction, place);
    const auto record = files.waves.find(index);
    if (record == files.waves.end()) return {};  // a fault already
    return make_recorded_waves(*wave.elevation, record->second, *direction, place);
}

// Gravity under which waves run; nullopt with a fault.
std::optional<double> find_wave_gravity(const BuildContext& context) {
    const CheckedTimeVector* gravity = find_gravity(context.deck);
    if (gravity == nullptr) return std::nullopt;  // of the surface a fault already
    const CheckedTimeFunction& down = (*gravity)[2];
    if (down.function.is_constant())
        return down.function(0.0) < 0.0 ? std::optional(-down.function(0.0)) : std::nullopt;
    context.faults.add(down.place, down.path, "waves take a number: the waves of a deck have one gravity");
    return std::nullopt;
}

// Notes waves that no stage sees; reports stages that they ask for and that have no time.
void check_wave(const WaveTable& wave, const BuildContext& context) {
    if (find_case_factor(wave.load_case, context) == 0.0) return;
    for (std::size_t i = 0; i < context.stages.size(); ++i) {
        if (acts_with_time(wave, i, context)) return;
    }
    if (wave.stages) {
        context.add_fault(wave, wave.stages, "no stage with time among them; waves need one");
    } else {
        context.notes.push_back(wave.path +
                                ": without effect: waves act in stages with time, of the kind "
                                "dynamic or quasi-static, and the deck has none");
    }
}

}  // namespace

std::optional<double> find_depth(const FluidTable& fluid, const BuildContext& context) {
    const CheckedTable& deck = context.deck;
    if (!fluid.surface || !deck.gives("wave")) return std::nullopt;
    if (fluid.depth) return fluid.depth;
    const auto seabeds = tables_of<SeabedTable>(deck, seabed_table());
    if (seabeds.empty()) return std::nullopt;
    const std::optional<double> bed = find_bed_height(deck);
    if (!bed) {
        context.add_fault(
            fluid, fluid.depth, "missing; the ground is not horizontal, and waves feel one depth");
        return std::nullopt;
    }
    const double depth = *fluid.surface - *bed;
    if (depth > 0.0) return depth;
    const SeabedTable& seabed = seabeds.front();
    context.faults.add(seabed.place,
                       seabed.path,
                       fmt::format("at z = {:.6g}, which is not below the surface of the water", *bed));
    return std::nullopt;
}

void check_waves(const BuildContext& context) {
    const auto fluids = tables_of<FluidTable>(context.deck, fluid_table());
    const bool has_surface = !fluids.empty() && fluids.front().get().surface;
    for (const WaveTable& wave : waves_of(context)) {
        if (!has_surface)
            context.faults.add(wave.place, wave.path, "waves need a surface; expected surface in [fluid]");
        check_wave(wave, context);
        refuse_case_factor(wave, "the force of waves", context);
    }
}

void set_waves(const SurroundingsFiles& files, Water& water, const BuildContext& context) {
    const auto waves = waves_of(context);
    if (!water.surface || waves.empty()) return;
    const std::optional<double> gravity = find_wave_gravity(context);
    if (!gravity) return;
    const double before = find_time_before(context);
    water.ramp_start = -before;
    for (std::size_t i = 0; i < waves.size(); ++i) {
        // Those of stages to come are made as well, for their faults.
        if (context.stage > 0 && !acts_with_time(waves[i], context.stage, context)) continue;
        std::vector<WaveTrain> trains = make_waves(i, files, {water.depth, *gravity}, context);
        if (!acts_with_time(waves[i], context.stage, context)) continue;
        for (WaveTrain& train : trains) {
            train.phase -= train.frequency * before;
            water.waves.push_back(train);
        }
    }
}

}  // namespace gxrod
