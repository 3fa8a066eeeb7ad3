#include "rotation/vector_text.hpp"

#include <fmt/format.h>

#include <cmath>

namespace gxrod {

namespace {

std::string list_components(const Vec3& v, int digits, double least) {
    const auto clean = [least](double x) { return std::abs(x) < least ? 0.0 : x + 0.0; };
    return fmt::format(
        "{:.{}g}, {:.{}g}, {:.{}g}", clean(v[0]), digits, clean(v[1]), digits, clean(v[2]), digits);
}

}  // namespace

std::string in_parentheses(const Vec3& v, int digits, double least) {
    return '(' + list_components(v, digits, least) + ')';
}

std::string in_brackets(const Vec3& v, int digits, double least) {
    return '[' + list_components(v, digits, least) + ']';
}

}  // namespace gxrod
