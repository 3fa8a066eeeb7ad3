#include "cross_section/walls/graded_line.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace gxrod {

std::vector<double> grade_line(double length, const LineGrading& grading) {
    // The elements are 1/size dense; each has the same part of the integral of that.
    constexpr std::size_t samples = 4000;
    const double step = length / samples;
    std::vector<double> elements{0.0};
    for (std::size_t i = 0; i < samples; ++i) {
        const double s = (static_cast<double>(i) + 0.5) * step;
        const double size = std::min({grading.at_start + grading.growth * s,
                                      grading.at_end + grading.growth * (length - s),
                                      grading.largest});
        elements.push_back(elements.back() + step / size);
    }
    const std::size_t count =
        std::max<std::size_t>(2, static_cast<std::size_t>(std::ceil(elements.back() - 0.1)));
    std::vector<double> fractions{0.0};
    std::size_t at = 0;
    for (std::size_t i = 1; i < count; ++i) {
        const double wanted = elements.back() * static_cast<double>(i) / static_cast<double>(count);
        while (elements[at + 1] < wanted) ++at;
        const double within = (wanted - elements[at]) / (elements[at + 1] - elements[at]);
        fractions.push_back((static_cast<double>(at) + within) / samples);
    }
    fractions.push_back(1.0);
    return fractions;
}

}  // namespace gxrod
