#pragma once

#include <optional>
#include <string_view>
#include <vector>

#include "deck/loads/acting.hpp"
#include "deck/places/build_context.hpp"
#include "deck/reading/copies.hpp"
#include "deck/schema/schema_tables.hpp"

// The tables [joint.NAME], what acts on the turn and the slide of a joint, and the places of its sides.
namespace gxrod {

struct JointSpringTable : TableHead {
    double stiffness = 0.0;
    double damping = 0.0;
    std::optional<CheckedTimeFunction> rest;
};

struct JointFrictionTable : TableHead {
    std::optional<double> moment, force, coefficient, radius, stick;
};

struct JointLimitsTable : TableHead {
    std::optional<double> lower, upper, stiffness;
    double damping = 0.0;
};

// A table of the only coordinate of a joint, or one with tables of the turn and of the slide.
template <class One>
struct CoordinateTable : One {
    std::optional<One> turn, slide;
};

struct JointClearanceTable : TableHead {
    double gap = 0.0;
    double stiffness = 0.0;
    double exponent = 1.0;
    double damping = 0.0;
    std::optional<double> restitution, impact_speed, radius, slip_speed;
    double friction = 0.0;
};

struct JointBreakTable : TableHead {
    std::optional<double> force, moment, time;
    std::optional<TableName> stage;
};

struct CamCurveTable : TableHead {
    std::optional<CheckedPairs> points;
    std::optional<std::string> file;
    std::optional<CheckedAngleFunction> radius;
    bool closed = true;
};

struct JointTable : ActingTable {
    JointKind type = JointKind::ball;
    Ends between;
    std::optional<Vec3> at, at_a, at_b, axis, axis_b, x_axis, y_axis;
    std::optional<CamCurveTable> curve;
    double roller = 0.0;
    bool lifts = false;
    std::optional<WordList> holds;
    double lead = 0.0;
    std::optional<double> length;
    std::optional<bool> slack, turn;
    std::optional<CoordinateFunctions> move, drive;
    std::optional<CoordinateTable<JointSpringTable>> spring;
    std::optional<CoordinateTable<JointFrictionTable>> friction;
    std::optional<CoordinateTable<JointLimitsTable>> limits;
    std::optional<JointClearanceTable> clearance;
    std::optional<JointBreakTable> breaks;
    Copies copies;

    bool is_sleeve() const { return type == JointKind::sleeve; }
};

// Finds the joint of this name; nullptr if the deck has none.
const JointTable* find_joint(const CheckedTable& deck, std::string_view name);

// Returns the coordinate of keys that do not name one; "" for a joint with both, whose keys have to name it.
std::string_view plain_coordinate(JointKind kind);

// Lists every f(t) of a joint.
std::vector<const CheckedTimeFunction*> functions_of(const JointTable& joint);

// Adds faults of keys whose coordinate a joint of this kind lacks, or that contradict each other.
void check_coordinates(const JointTable& given, const BuildContext& context);

// Adds notes on numbers that are probably in another unit: the radius of a pin, limits of a turn. `size` is
// the size of the model.
void note_coordinates(const JointTable& given, const Joint& joint, double size, const BuildContext& context);

// Adds faults of motions that do not begin at 0 or jump. `size` is the size of what slides.
void check_motors(const JointTable& given, double size, const BuildContext& context);

// Sets turn and slide as they act in the current stage. `size` is the size of what slides.
void set_coordinates(const JointTable& given, double size, Joint& joint, const BuildContext& context);

// Builds the slide as it acts in the current stage, likewise.
JointCoordinate build_slide(const JointTable& given, double size, const BuildContext& context);

// Builds the clearance of a joint that has one, with faults of what contradicts it.
JointClearance build_clearance(const JointTable& given, const BuildContext& context);

// Sets the curve of a cam in `joint`, which has its points and axes, and moves B's point by the rounding of
// the deck's numbers. Returns whether it could; if not, there is a fault. `size` is the size of the model.
bool set_cam(const JointTable& given, double size, Joint& joint, const BuildContext& context);

// Sets the points and axes of both sides in `joint`, which has its kind. Returns whether it could; if not,
// there is a fault or a point without a node. `size` is the size of the model.
bool place_joint(const JointTable& given, double size, Joint& joint, const BuildContext& context);

}  // namespace gxrod
