#include "deck/surroundings/build_waves.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "deck/loads/acting.hpp"
#include "deck/surroundings/build_seabed.hpp"
#include "environment/dispersion.hpp"
#include "environment/sea.hpp"
#include "model/settings/analysis_traits.hpp"

namespace gxrod {
namespace {

const CheckedTable& only(const CheckedTable& table, const char* key) { return table.tables(key).front(); }

bool acts_with_time(const CheckedTable& wave, std::size_t stage, const BuildContext& context) {
    return is_timed(context.stages[stage].analysis) && acts_in_stage(acting_keys(wave), stage, context);
}

// How long the stages with time have lasted before the one at hand, from the first one with waves on.
double find_time_before(const BuildContext& context) {
    const std::vector<CheckedTable>& waves = context.deck.tables("wave");
    double time = 0.0;
    bool has_begun = false;
    for (std::size_t i = 0; i < context.stage; ++i) {
        has_begun = has_begun || std::ranges::any_of(waves, [&](const CheckedTable& wave) {
                        return acts_with_time(wave, i, context);
                    });
        if (has_begun && is_timed(context.stages[i].analysis)) time += end_of(context.stages[i].analysis);
    }
    return time;
}

// Where a wave goes, from x towards y; nullopt with a fault.
std::optional<double> find_direction(const CheckedTable& wave, const BuildContext& context) {
    const Vec3& direction = wave.get<Vec3>("direction");
    if (direction.head<2>().isZero(0.0) || direction.z() != 0.0) {
        context.add_fault(wave, "direction", "expected a horizontal direction, [x, y, 0], that is not zero");
        return std::nullopt;
    }
    return std::atan2(direction.y(), direction.x());
}

std::vector<WaveTrain> make_airy_wave(const CheckedTable& airy, double direction, const WavePlace& place) {
    const double frequency = 2.0 * M_PI / airy.get<double>("period");
    return {{.amplitude = 0.5 * airy.get<double>("height"),
             .frequency = frequency,
             .number = find_wave_number(frequency, place.depth, place.gravity),
             .direction = direction,
             .phase = airy.get<double>("phase")}};
}

std::vector<WaveTrain> make_sea(const CheckedTable& jonswap, double direction, const WavePlace& place) {
    IrregularSea sea{.significant_height = jonswap.get<double>("Hs"),
                     .peak_period = jonswap.get<double>("Tp"),
                     .enhancement = jonswap.get<double>("gamma"),
                     .components = static_cast<int>(jonswap.get<long>("components")),
                     .seed = static_cast<std::uint64_t>(jonswap.get<long>("seed")),
                     .direction = direction};
    if (jonswap.gives("spreading")) sea.spreading = jonswap.get<double>("spreading");
    return make_irregular_sea(sea, place);
}

std::vector<WaveTrain> make_recorded_waves(const CheckedTable& elevation,
                                           ElevationRecord record,
                                           double direction,
                                           const WavePlace& place) {
    const Vec3& at = elevation.get<Vec3>("at");
    record.x = at.x();
    record.y = at.y();
    record.direction = direction;
    if (elevation.gives("longest_period"))
        record.lowest_frequency = 2.0 * M_PI / elevation.get<double>("longest_period");
    if (elevation.gives("shortest_period"))
        record.highest_frequency = 2.0 * M_PI / elevation.get<double>("shortest_period");
    return make_recorded_sea(record, place);
}

// The waves of one table, t from the start of the first stage with waves.
std::vector<WaveTrain> make_waves(std::size_t index,
                                  const SurroundingsFiles& files,
                                  const WavePlace& place,
                                  const BuildContext& context) {
    const CheckedTable& wave = context.deck.tables("wave")[index];
    const std::optional<double> direction = find_direction(wave, context);
    if (!direction) return {};
    if (wave.gives("airy")) return make_airy_wave(only(wave, "airy"), *direction, place);
    if (wave.gives("jonswap")) return make_sea(only(wave, "jonswap"), *direction, place);
    const auto record = files.waves.find(index);
    if (record == files.waves.end()) return {};  // a fault already
    return make_recorded_waves(only(wave, "elevation"), record->second, *direction, place);
}

// Gravity under which waves run; nullopt with a fault.
std::optional<double> find_gravity(const BuildContext& context) {
    if (!context.deck.gives("gravity")) return std::nullopt;  // of the surface a fault already
    const CheckedTimeFunction& down = context.deck.get<CheckedTimeVector>("gravity")[2];
    if (down.function.is_constant())
        return down.function(0.0) < 0.0 ? std::optional(-down.function(0.0)) : std::nullopt;
    context.faults.add(down.place, down.path, "waves take a number: the waves of a deck have one gravity");
    return std::nullopt;
}

// That there is a stage in which they act.
void check_wave(const CheckedTable& wave, const BuildContext& context) {
    for (std::size_t i = 0; i < context.stages.size(); ++i) {
        if (acts_with_time(wave, i, context)) return;
    }
    if (wave.gives("stages")) {
        context.add_fault(wave, "stages", "no stage with time among them; waves need one");
    } else {
        context.faults.add(wave.place,
                           wave.path,
                           "acts in stages with time only, and the deck has none; expected a stage of the "
                           "kind dynamic or quasi-static");
    }
}

}  // namespace

std::optional<double> find_depth(const CheckedTable& fluid, const BuildContext& context) {
    const CheckedTable& deck = context.deck;
    if (!fluid.gives("surface") || !deck.gives("wave")) return std::nullopt;
    if (fluid.gives("depth")) return fluid.get<double>("depth");
    const std::vector<CheckedTable>& seabeds = deck.tables("seabed");
    if (seabeds.empty()) return std::nullopt;
    const std::optional<double> bed = find_bed_height(deck);
    if (!bed) {
        context.add_fault(fluid, "depth", "missing; the ground is not horizontal, and waves feel one depth");
        return std::nullopt;
    }
    const double depth = fluid.get<double>("surface") - *bed;
    if (depth > 0.0) return depth;
    context.faults.add(seabeds.front().place,
                       seabeds.front().path,
                       fmt::format("at z = {:.6g}, which is not below the surface of the water", *bed));
    return std::nullopt;
}

void check_waves(const BuildContext& context) {
    const std::vector<CheckedTable>& fluids = context.deck.tables("fluid");
    const bool has_surface = !fluids.empty() && fluids.front().gives("surface");
    for (const CheckedTable& wave : context.deck.tables("wave")) {
        if (!has_surface)
            context.faults.add(wave.place, wave.path, "waves need a surface; expected surface in [fluid]");
        check_wave(wave, context);
    }
}

void set_waves(const SurroundingsFiles& files, Water& water, const BuildContext& context) {
    const std::vector<CheckedTable>& waves = context.deck.tables("wave");
    if (!water.surface || waves.empty()) return;
    const std::optional<double> gravity = find_gravity(context);
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
