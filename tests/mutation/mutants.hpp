#pragma once

#include <cstdlib>

// What tests/mutation puts before every source of its copy: one sign or coefficient is wrong, the one whose
// number the environment variable GXROD_MUTANT has.

inline const int gxrod_active_mutant = [] {
    const char* text = std::getenv("GXROD_MUTANT");
    return text == nullptr ? 0 : std::atoi(text);
}();

// A factor 1 or -1, of numbers of any type, which they keep, and of Eigen's expressions.
struct GxrodSign {
    bool is_minus;
};

inline GxrodSign gxrod_sign(int mutant) { return {gxrod_active_mutant == mutant}; }

inline GxrodSign operator-(GxrodSign sign) { return {!sign.is_minus}; }

template <class Value>
Value operator*(GxrodSign sign, const Value& value) {
    return sign.is_minus ? static_cast<Value>(-value) : value;
}

template <class Expression>
    requires requires { typename Expression::PlainObject; }
typename Expression::PlainObject operator*(GxrodSign sign, const Expression& expression) {
    typename Expression::PlainObject value = expression;
    if (sign.is_minus) value = -value;
    return value;
}

// Of a unit quaternion, which turns its operand as its negative would.
template <class Quaternion>
    requires requires(const Quaternion& q) { q.toRotationMatrix(); }
auto operator*(GxrodSign sign, const Quaternion& quaternion) {
    return sign * quaternion.toRotationMatrix();
}

inline double gxrod_coefficient(int mutant, double right, double wrong) {
    return gxrod_active_mutant == mutant ? wrong : right;
}
