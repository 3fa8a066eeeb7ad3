#pragma once

#include <cstdint>
#include <type_traits>
#include <xsimd/xsimd.hpp>

// Sine, cosine and exponential of several doubles at once, by products and sums alone, so that every
// instruction set gives the same bits. Polynomials are interpolated at Chebyshev points, with an error of
// less than 1e-16. Only for sources that are compiled for one instruction set; see elements/lanes/lanes.hpp.
namespace gxrod {

template <class Real>
struct LaneFunctions {
    using Bits = xsimd::batch<std::int64_t, typename Real::arch_type>;

    // Added to a number of less than 2⁵¹, this rounds it to an integer, which is then in the last bits.
    static constexpr double rounder = 6755399441055744.0;  // 1.5 · 2⁵²

    // Casts with the same bits. xsimd 8 takes the batch type of the result, later versions its element type.
    template <class To, class From>
    static To cast_bits(const From& from) {
        if constexpr (std::is_same_v<decltype(xsimd::bitwise_cast<To>(from)), To>) {
            return xsimd::bitwise_cast<To>(from);
        } else {
            return xsimd::bitwise_cast<typename To::value_type>(from);
        }
    }

    // Evaluates a polynomial with coefficients from the lowest; by pairs, then pairs of pairs and so on
    // (Estrin's scheme), since processors work on several products at once.
    template <std::size_t Count>
    static Real polynomial(const Real& x, const double (&coefficients)[Count]) {
        Real terms[Count];
        for (std::size_t i = 0; i < Count; ++i) terms[i] = Real(coefficients[i]);
        return add_terms(x, terms);
    }
    template <std::size_t Count>
    static Real add_terms(const Real& power, const Real (&terms)[Count]) {
        if constexpr (Count == 1) {
            return terms[0];
        } else {
            Real pairs[(Count + 1) / 2];
            for (std::size_t i = 0; i < Count / 2; ++i) pairs[i] = terms[2 * i] + terms[2 * i + 1] * power;
            if constexpr (Count % 2 == 1) pairs[Count / 2] = terms[Count - 1];
            return add_terms(power * power, pairs);
        }
    }

    struct SineCosine {
        Real sine, cosine;
    };

    // Computes both to 2e-16, plus the error from the rounding of a large x.
    static SineCosine sine_cosine(const Real& x) {
        // n = x/π rounded; r = x − nπ with π in three parts, the first two with 33 bits.
        const Real rounded = x * Real(0.3183098861837907) + Real(rounder);
        const Real n = rounded - Real(rounder);
        const Real r = x - n * Real(3.1415926534682512) - n * Real(1.2154201012607932e-10) -
                       n * Real(4.044532497591901e-21);
        const Real square = r * r;
        constexpr double sine_series[] = {-0.16666666666666666,
                                          0.008333333333333316,
                                          -0.00019841269841254955,
                                          2.755731921915843e-06,
                                          -2.5052107616384595e-08,
                                          1.6058977272815506e-10,
                                          -7.643969031052769e-13,
                                          2.731428986122616e-15};
        constexpr double cosine_series[] = {0.04166666666666666,
                                            -0.0013888888888884763,
                                            2.4801587298910888e-05,
                                            -2.7557318572848315e-07,
                                            2.0876681513907184e-09,
                                            -1.1466250478536745e-11,
                                            4.64640971522779e-14};
        const Real sine = r + r * square * polynomial(square, sine_series);
        const Real cosine =
            Real(1.0) - Real(0.5) * square + square * square * polynomial(square, cosine_series);
        // Both change their sign with odd n.
        const Real sign = cast_bits<Real>(cast_bits<Bits>(rounded) << 63);
        return {sine ^ sign, cosine ^ sign};
    }

    // Computes exp(x) for x within ±700, else for the nearest of these.
    static Real exponential(const Real& unlimited) {
        const Real x = xsimd::max(xsimd::min(unlimited, Real(700.0)), Real(-700.0));
        // x = n ln 2 + r; 2ⁿ from n in the bits of the exponent.
        const Real rounded = x * Real(1.4426950408889634) + Real(rounder);
        const Real n = rounded - Real(rounder);
        const Real r = x - n * Real(0.6931471804855391) - n * Real(7.440617110012397e-11);
        constexpr double series[] = {0.5000000000000001,
                                     0.16666666666666669,
                                     0.04166666666662413,
                                     0.008333333333330062,
                                     0.0013888888917213717,
                                     0.00019841269863053618,
                                     2.4801521295954376e-05,
                                     2.7557268459997064e-06,
                                     2.7620088445409746e-07,
                                     2.510038549551032e-08};
        const Real power = cast_bits<Real>((cast_bits<Bits>(rounded) + Bits(1023)) << 52);
        return (Real(1.0) + (r + r * r * polynomial(r, series))) * power;
    }
};

}  // namespace gxrod
