#pragma once

#include <cmath>
#include <cstdint>
#include <numbers>
#include <random>

#include "contact/pairs/pair_energy.hpp"

// Two segments that touch, of random and of given positions.
namespace gxrod::test {

inline const PairLaw wires{2.0, {0.02, 30.0}};

struct FourEnds {
    Vec3 ends[4];

    Segment a() const { return {ends[0], ends[1]}; }
    Segment b() const { return {ends[2], ends[3]}; }
    FourEnds moved(const Vec12& by) const {
        FourEnds result = *this;
        for (int k = 0; k < 4; ++k) result.ends[k] += by.segment<3>(3 * k);
        return result;
    }
};

inline PairEnergy compute_pair(const FourEnds& ends, double length_a = 1.0, double length_b = 1.0) {
    return compute_pair_energy(wires, ends.a(), ends.b(), length_a, length_b);
}

class RandomPairs {
  public:
    explicit RandomPairs(std::uint64_t seed) : random_(seed) {}

    double number() { return uniform_(random_); }
    Vec3 vector() {
        const double x = number(), y = number(), z = number();
        return {x, y, z};
    }
    Vec12 direction() {
        Vec12 by;
        for (double& x : by) x = number();
        return by.normalized();
    }
    // Segments of any position, as far apart as leaves x of the skin: crossings, ends, nearly parallel ones.
    FourEnds make(double x, double size = 1.0) {
        while (true) {
            FourEnds pair{{size * vector(), size * vector(), size * vector(), size * vector()}};
            if (number() > 0.5)
                pair.ends[3] = pair.ends[2] + (pair.ends[1] - pair.ends[0]) + 0.1 * size * vector();
            const ClosestPoints closest = find_closest_points(pair.a(), pair.b());
            if (closest.distance < 0.01) continue;
            const double wanted = wires.radii + x * wires.law.skin;
            const Vec3 shift = (wanted / closest.distance - 1.0) * closest.offset;
            pair.ends[0] += shift;
            pair.ends[1] += shift;
            if (std::abs(find_closest_points(pair.a(), pair.b()).distance - wanted) < 1e-9) return pair;
        }
    }

  private:
    std::mt19937_64 random_;
    std::uniform_real_distribution<double> uniform_{-1.0, 1.0};
};

// Long lines at the distance d, at an angle.
inline FourEnds cross_lines(double angle, double d, double length) {
    const Vec3 along(std::cos(angle), std::sin(angle), 0.0), up(0.0, 0.0, d);
    return {{Vec3(-0.45 * length, 0, 0),
             Vec3(0.55 * length, 0, 0),
             up - 0.52 * length * along,
             up + 0.48 * length * along}};
}

}  // namespace gxrod::test
