#include "deck/surroundings/vessel_table.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <memory>

#include "deck/places/point_patterns.hpp"
#include "deck/schema/schema_tables.hpp"
#include "deck/supports/components.hpp"
#include "deck/supports/support_merge.hpp"
#include "deck/table/kinds.hpp"
#include "environment/vessel_motion.hpp"
#include "model/settings/analysis_traits.hpp"

namespace gxrod {

const TableSpec& vessel_table() {
    using T = VesselTable;
    // clang-format off
    static const TableSpec table = Table<T>("[vessel.NAME]",
            "A vessel that follows the waves by response amplitude operators. What a [[support]] with vessel = NAME "
            "holds moves with it, as a rigid body.")
        .key("rao", &T::rao, "A CSV file, relative to the deck's folder. Its first line names the columns: period (or "
             "frequency, rad a time), heading, in degrees, and surge, surge_phase, sway, sway_phase, heave … yaw_phase: "
             "amplitudes for waves of amplitude 1, phases in degrees. Heading 0 is of waves that go along the vessel's "
             "x axis, 90 along its y, to port. A file of one side holds for the other, too.")
            .required().also("raos file response responses rao_file")
        .key("at", &T::at, "Whose motion the file has, at t = 0.")
            .unit("length").required().also("origin reference reference_point position")
        .key("heading", &T::heading, "Of its x axis at t = 0, from the global x towards y.")
            .unit("angle").also("yaw orientation direction")
        .key("offset", &T::offset, "Of its mean place from there: in a first static stage it grows with t.")
            .unit("length").also("displacement shift")
        .key("phases", &T::phases, "lag: the crest of a motion comes by its phase later than the wave's at `at`, as in "
             "OrcaFlex. lead: earlier, as in WAMIT.")
            .required().words({"lag", "lead"}).also("phase convention phase_convention")
        .key("rotations", &T::rotations, "The unit of roll, pitch and yaw for waves of amplitude 1.")
            .words({"deg", "rad"}).otherwise("deg").also("rotation_unit angles");
    // clang-format on
    return table;
}

namespace {

constexpr double vessel_in_plane = 1e-9;

ResponseTable make_table(const VesselTable& given, const std::vector<RaoRow>& rows) {
    const double degree = M_PI / 180.0;
    const double sign = given.phases.word == "lag" ? -1.0 : 1.0;
    const double turns = given.rotations && given.rotations->word == "rad" ? 1.0 : degree;
    ResponseTable table;
    for (const RaoRow& row : rows) {
        if (row.heading == rows.front().heading) table.frequencies.push_back(row.frequency);
        const double heading = degree * row.heading;
        if (table.headings.empty() || table.headings.back() != heading) table.headings.push_back(heading);
        VesselResponse response;
        for (std::size_t i = 0; i < 6; ++i)
            response[i] =
                std::polar(1.0, sign * degree * row.phases[i]) * row.amplitudes[i] * (i < 3 ? 1.0 : turns);
        table.responses.push_back(response);
    }
    return table;
}

double degrees_of(double angle) { return angle * 180.0 / M_PI; }

void refuse_beyond(const VesselTable& given,
                   const ResponseTable& table,
                   const WaveTrain& wave,
                   const BuildContext& context) {
    context.add_fault(
        given,
        given.rao,
        fmt::format(
            "no responses to a wave with a period of {:.4g} that goes {:.4g}° from the vessel's x axis: {} "
            "has periods from {:.4g} to {:.4g} and headings from {:.4g}° to {:.4g}°; expected rows for all "
            "waves, 0 where the vessel does not follow",
            2.0 * M_PI / wave.frequency,
            degrees_of(std::remainder(wave.direction - given.heading, 2.0 * M_PI)),
            given.rao,
            2.0 * M_PI / table.frequencies.back(),
            2.0 * M_PI / table.frequencies.front(),
            degrees_of(table.headings.front()),
            degrees_of(table.headings.back())));
}

void check_vessel(const VesselTable& given,
                  const VesselMotion& motion,
                  const Water& water,
                  const BuildContext& context) {
    const bool is_timed_start = context.stage == 0 && is_timed(context.analysis());
    if (is_timed_start && !given.offset.isZero(0.0)) {
        context.add_fault(
            given, given.offset, "is not there at t = 0; expected a static stage first, which goes there");
    }
    if (!water.waves.empty() && water.ramp == 0.0) {
        context.add_fault(
            given,
            given.rao,
            "the waves are there at once, and the vessel would jump; expected [fluid] with ramp, one "
            "or two periods of the waves");
    }
    if (!context.model.plane) return;
    for (int i = 0; i < 6; ++i) {
        const double offset = i < 3 ? given.offset[i] : 0.0;
        if (!context.model.plane->holds(i)) continue;
        if (motion.largest()[i] + std::abs(offset) <= vessel_in_plane) continue;
        return context.add_fault(
            given,
            given.rao,
            fmt::format("the vessel leaves the plane of the deck: {}; expected responses in "
                        "the plane alone, or a deck without plane",
                        component_names[static_cast<std::size_t>(i)]));
    }
}

using MotionOfVessel = std::shared_ptr<const VesselMotion>;

MotionOfVessel find_motion(const VesselTable& given,
                           const SurroundingsFiles& files,
                           const BuildContext& context) {
    const auto rows = files.vessels.find(given.name);
    if (rows == files.vessels.end()) return nullptr;
    const ResponseTable table = make_table(given, rows->second);
    const Water water = context.model.surroundings.water.value_or(Water{});
    std::optional<WaveTrain> beyond;
    auto motion =
        std::make_shared<VesselMotion>(Vessel{given.at, given.offset, given.heading}, table, water, beyond);
    if (beyond) refuse_beyond(given, table, *beyond, context);
    check_vessel(given, *motion, water, context);
    return motion;
}

// The motion of a point, evaluated once for its components.
class PointOnVessel {
  public:
    PointOnVessel(MotionOfVessel motion, const Vec3& point) : motion_(std::move(motion)), point_(point) {}

    double at(double time, int component) {
        if (!is_known_ || time != time_) {
            value_ = motion_->of_point(point_, time);
            time_ = time;
            is_known_ = true;
        }
        return value_[component];
    }

  private:
    MotionOfVessel motion_;
    Vec3 point_;
    bool is_known_ = false;
    double time_ = 0.0;
    Vec6 value_ = Vec6::Zero();
};

TimeFunction make_motion(const MotionOfVessel& motion,
                         const Vec3& point,
                         int component,
                         const BuildContext& context) {
    if (!is_timed(context.analysis())) {
        // The waves wait: `at` is the offset.
        const double there = motion->at(0.0)[component];
        if (context.stage > 0) return TimeFunction(there);
        return TimeFunction([there](double t) { return t * there; });
    }
    auto on_vessel = std::make_shared<PointOnVessel>(motion, point);
    return TimeFunction([on_vessel, component](double t) { return on_vessel->at(t, component); });
}

// Lets the support of a node follow a vessel.
void move_with_vessel(const SupportTable& given,
                      int node,
                      const MotionOfVessel& motion,
                      BuildContext& context) {
    const auto support = std::ranges::find(context.model.supports, node, &Support::node);
    if (support == context.model.supports.end()) return;
    const Vec3& place = context.model.nodes[static_cast<std::size_t>(node)].position;
    for (const int component : components_on_vessel(given, context))
        support->motion[static_cast<std::size_t>(component)] = make_motion(motion, place, component, context);
}

}  // namespace

void move_with_vessels(const SurroundingsFiles& files, BuildContext& context) {
    std::map<std::string, MotionOfVessel> motions;
    for (const VesselTable& given : tables_of<VesselTable>(context.deck, vessel_table()))
        motions[given.name] = find_motion(given, files, context);
    for (const SupportTable& given : tables_of<SupportTable>(context.deck, support_table())) {
        if (!given.vessel || !acts_in_stage(given, context)) continue;
        const auto motion = motions.find(given.vessel->word);
        if (motion == motions.end() || !motion->second) continue;
        for (const PlacedPoint& point : find_points(given, given.at, given.where, context))
            move_with_vessel(given, point.node, motion->second, context);
    }
}

}  // namespace gxrod
