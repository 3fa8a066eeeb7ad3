#pragma once

#include <array>

namespace gxrod {

struct GaussPoint {
    double at;  // from 0 to 1
    double weight;
};

// The 12-point Gauss-Legendre rule on [0, 1], exact for polynomials of degree 23.
const std::array<GaussPoint, 12>& gauss_rule();

}  // namespace gxrod
