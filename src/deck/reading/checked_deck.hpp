#pragma once

#include <array>
#include <map>
#include <memory>
#include <string>
#include <string_view>
#include <utility>
#include <variant>
#include <vector>

#include "deck/expressions/expression.hpp"
#include "deck/text/fault_list.hpp"
#include "model/time/time_function.hpp"
#include "rotation/types.hpp"

// A deck that agrees with the schema: every value typed, evaluated and in range, defaults filled in.
// Conditions that the schema cannot state are not yet checked, for example that names exist or axes are not
// parallel.
namespace gxrod {

// A word of a list.
struct CheckedWord {
    std::string word;
    Place place;
    std::string path;
};

// A value f(t).
struct CheckedTimeFunction {
    TimeFunction function;
    Place place;
    std::string path;
};

// A value f(t) for the stage, or the coordinate of a joint, of that name; "" for all stages, or for the only
// coordinate.
struct CheckedNamedFunction {
    std::string name;
    CheckedTimeFunction value;
};

// f(s) along a rod.
struct CheckedArcFunction {
    std::function<double(double s)> function;
};

// A value f(t, s).
struct CheckedLineFunction {
    LineExpression expression;
    Place place;
    std::string path;
};

// A value f(x, y, z, s).
struct CheckedPlaceFunction {
    PlaceExpression expression;
    Place place;
    std::string path;
};

// A value by time and the motion of a point.
struct CheckedMotionFunction {
    MotionExpression expression;
    Place place;
    std::string path;
};

// The same along a rod.
struct CheckedLineMotionFunction {
    LineMotionExpression expression;
    Place place;
    std::string path;
};

// A value f(length, rate).
struct CheckedSpringFunction {
    SpringExpression expression;
    Place place;
    std::string path;
};

// A value f(angle).
struct CheckedAngleFunction {
    AngleExpression expression;
    Place place;
    std::string path;
};

// A vector of a list.
struct CheckedVector {
    Vec3 value;
    Place place;
    std::string path;
};

// The path of a tendon: y and z as functions of the arc length, or rows of a fraction of the rod's length, y
// and z.
struct CheckedTendonPath {
    std::array<std::function<double(double s)>, 2> functions;  // empty with rows
    std::vector<std::array<double, 3>> rows;
};

using CheckedTimeVector = std::array<CheckedTimeFunction, 3>;
using CheckedLinePair = std::array<CheckedLineFunction, 2>;
using CheckedLineVector = std::array<CheckedLineFunction, 3>;
using CheckedMotionVector = std::array<CheckedMotionFunction, 3>;
using CheckedLineMotionVector = std::array<CheckedLineMotionFunction, 3>;
using CheckedPlaceVector = std::array<CheckedPlaceFunction, 3>;
using TimeTable = std::vector<std::pair<double, double>>;
// Rows of 2 numbers, each row with its place.
struct CheckedPairs {
    std::vector<std::pair<double, double>> rows;
    std::vector<Place> places;
};

// A section at a place along a rod, 0 … 1.
struct CheckedStation {
    double fraction;
    CheckedWord section;
};

// Rows of a fraction, 0 … 1, and a number.
struct CheckedProfile {
    std::vector<std::pair<double, double>> rows;
};

struct CheckedValue;
struct TableHead;

struct CheckedTable {
    std::string name;  // NAME of a [rod.NAME]; the key otherwise
    std::string path;  // "rod.flyer", "load[0]"
    Place place;
    std::vector<CheckedValue> values;             // values that are given or have a default
    std::shared_ptr<TableHead> record = nullptr;  // the struct that the table is read into
    std::map<std::string, std::shared_ptr<Input>> inputs =
        {};  // values that expressions read, in a whole deck

    // Finds the value of a key; nullptr if it is neither given nor has a default.
    const CheckedValue* find(std::string_view key) const;
    // Returns whether the deck has the key.
    bool gives(std::string_view key) const;
    // Returns the place of the key's value in the deck; the table's place if the key is not given.
    Place place_of(std::string_view key) const;
    std::string path_of(std::string_view key) const {
        return path.empty() ? std::string(key) : path + "." + std::string(key);
    }
    // Returns the tables of a key such as "rod" or "load", in deck order; none if it is not given.
    const std::vector<CheckedTable>& tables(std::string_view key) const;
};

struct CheckedValue {
    std::string key;
    Place place;
    bool given = true;
    // A word, on which other keys may depend; tables, one for a single table; nothing of other values, which
    // are in the record.
    std::variant<std::monostate, std::string, std::vector<CheckedTable>> value;
};

}  // namespace gxrod
