#pragma once

#include <algorithm>
#include <cmath>

namespace gxrod {

// Two places at which a function has values of opposite sign.
struct RootRange {
    double a, value_at_a;
    double b, value_at_b;
};

// Tolerances of a root: its place, its value, and the largest number of evaluations.
struct RootTolerance {
    double place, value;
    int evaluations;
};

// Finds a zero of a continuous function within the range (Chandrupatla 1997: inverse quadratic interpolation
// if that is safe, else halving). The function is last evaluated there, so that its side effects belong to
// the zero. If it returns NaN, the search ends and returns NaN.
template <class Function>
double find_root(const RootRange& range, const RootTolerance& tolerance, const Function& function) {
    double a = range.b, fa = range.value_at_b;
    double b = range.a, fb = range.value_at_a;
    double part = fa / (fa - fb);  // part of the way from a to b
    for (int i = 0; i < tolerance.evaluations; ++i) {
        const double x = a + part * (b - a);
        const double fx = function(x);
        if (!std::isfinite(fx)) return fx;
        double c = a, fc = fa;  // the end that is given up
        if ((fx > 0.0) != (fa > 0.0)) {
            c = b;
            fc = fb;
            b = a;
            fb = fa;
        }
        a = x;
        fa = fx;
        const double room = tolerance.place / std::abs(b - a);
        if (std::abs(fx) <= tolerance.value || room > 0.5) break;
        const double xi = (a - b) / (c - b);
        const double phi = (fa - fb) / (fc - fb);
        const bool is_safe = phi * phi < xi && (1.0 - phi) * (1.0 - phi) < 1.0 - xi;
        part = is_safe ? fa / (fb - fa) * fc / (fb - fc) + (c - a) / (b - a) * fa / (fc - fa) * fb / (fc - fb)
                       : 0.5;
        part = std::min(1.0 - room, std::max(room, part));
    }
    return a;
}

}  // namespace gxrod
