#pragma once

#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include "deck/expressions/table_function.hpp"
#include "model/point_motion.hpp"
#include "model/time/input.hpp"
#include "model/time/time_function.hpp"
#include "rotation/types.hpp"

// Expressions of a deck: text such as "EI/2" or "0.5*pulse(t)". For their grammar see
// deck/expressions/expression_syntax.hpp.
namespace gxrod {

// An expression that cannot be read or has no finite value; what() says why.
class ExpressionError : public std::runtime_error {
  public:
    using std::runtime_error::runtime_error;
};

// A [function.NAME] of the deck: a table or an expression in t.
struct FunctionDefinition {
    std::vector<std::pair<double, double>>
        table;  // (t, value), t increasing; empty if there is an expression
    std::string expression;
    double operations = 1.0;                               // largest number in one evaluation
    int depth = 1;                                         // depth of functions that call functions
    Interpolation interpolation = Interpolation::linear;   // interpolation of the table
    std::shared_ptr<const TableFunction> curve = nullptr;  // the curve of the table, if it was made already
};

// The names that a deck defines. nullopt: defined but wrong, and already reported.
struct Symbols {
    std::map<std::string, std::optional<double>, std::less<>> parameters;
    std::map<std::string, std::optional<FunctionDefinition>, std::less<>> functions;
    std::map<std::string, std::shared_ptr<Input>, std::less<>> inputs;  // inputs of the problem
};

// Evaluates an expression in the parameters; nullopt if it uses a wrong one. Throws ExpressionError.
std::optional<double> evaluate_constant(const std::string& expression, const Symbols& symbols);

// Makes a function of time from an expression in t, the parameters and the functions; a constant if neither t
// nor a function of t occurs. nullopt if it uses a wrong name. Throws ExpressionError. Where it has no finite
// value, a call throws EvaluationError with `key` and the time.
std::optional<TimeFunction> compile_time_function(const std::string& expression,
                                                  const std::string& key,
                                                  const Symbols& symbols);

struct LineExpression {
    LineFunction function;
    bool has_time = false;  // whether t occurs
};

// Makes a function of t and s, the arc length along a rod.
std::optional<LineExpression> compile_line_function(const std::string& expression,
                                                    const std::string& key,
                                                    const Symbols& symbols);

// A number that varies along a rod with s, without t.
struct ArcExpression {
    std::function<double(double s)> function;  // empty for a constant
    double constant = 0.0;
};

// Makes a function of s. Calls throw EvaluationError with `key` and s where there is no finite value.
std::optional<ArcExpression> compile_arc_function(const std::string& expression,
                                                  const std::string& key,
                                                  const Symbols& symbols);

// A number that varies with the place in the reference shape.
struct PlaceExpression {
    std::function<double(const Vec3& position, double s)> function;
    bool has_arc_length = false;  // whether s occurs
};

// Makes a function of x, y, z and s, without t.
std::optional<PlaceExpression> compile_place_function(const std::string& expression,
                                                      const std::string& key,
                                                      const Symbols& symbols);

// A component of a load as a function of the motion of its point. One of both functions is used.
struct MotionExpression {
    TimeFunction by_time{};     // used if nothing of the motion occurs
    PointFunction by_motion{};  // returns NaN where it has no value
    bool has_time = false;      // whether t occurs
    bool turns = false;         // whether rotation or angular velocity occurs
};

// Makes a function of t, x, y, z, vx, vy, vz, rx, ry, rz, wx, wy and wz.
std::optional<MotionExpression> compile_motion_function(const std::string& expression,
                                                        const std::string& key,
                                                        const Symbols& symbols);

// The same along a rod.
struct LineMotionExpression {
    LineExpression by_line{};  // used if nothing of the motion occurs
    PointFunction by_motion{};
    bool turns = false;
};

// Makes a function of these and s.
std::optional<LineMotionExpression> compile_line_motion_function(const std::string& expression,
                                                                 const std::string& key,
                                                                 const Symbols& symbols);

// Makes a function of t, x, y and z.
std::optional<MotionExpression> compile_field_function(const std::string& expression,
                                                       const std::string& key,
                                                       const Symbols& symbols);

// A force as a function of a spring's length and its rate.
struct SpringExpression {
    std::function<double(double length, double rate)> function;  // NaN where it has no value
    bool has_rate = false;                                       // whether the rate occurs
};

// Makes a function of length and rate.
std::optional<SpringExpression> compile_spring_function(const std::string& expression,
                                                        const std::string& key,
                                                        const Symbols& symbols);

// A number that varies with an angle, in rad.
struct AngleExpression {
    std::function<double(double angle)> function;
};

// Makes a function of an angle. Calls throw EvaluationError with `key` and the angle where there is no finite
// value.
std::optional<AngleExpression> compile_angle_function(const std::string& expression,
                                                      const std::string& key,
                                                      const Symbols& symbols);

}  // namespace gxrod
