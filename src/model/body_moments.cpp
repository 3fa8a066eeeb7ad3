#include "model/body_moments.hpp"

namespace gxrod {
namespace {

constexpr double round_off = 1e-9;
// A number of two digits, 10 at least, is rounded by a half.
constexpr double rounding = 0.05;

bool exceed_sum(const Vec3& moments, double tolerance) {
    return moments[2] > moments[0] + moments[1] + tolerance * moments.cwiseAbs().sum();
}

}  // namespace

bool exceed_sum(const Vec3& moments) { return exceed_sum(moments, round_off); }

bool is_beyond_rounding(const Vec3& moments) { return exceed_sum(moments, rounding); }

}  // namespace gxrod
