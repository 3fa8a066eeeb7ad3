#pragma once

#include <cmath>

#include "model/sections/section_law.hpp"

namespace gxrod::tools {

// A smooth law with a memory, for tests of what elements and systems make of any law: an elastic part
// C E + a |E|² E, and a force r g (E − E_n) towards the strains E_n of the last accepted step, which fades
// with the time since then, g = 1/(1 + elapsed). Its tangent is symmetric; the same in every orientation of
// the section if C turns with it.
class SampleLaw : public SectionLaw {
  public:
    SampleLaw(const Mat6& C, double a, double r) : C_(C), a_(a), r_(r) {}

    int memory_size() const override { return 6; }
    std::string describe() const override { return "a sample"; }
    SectionResponse respond(const Vec6& strain,
                            std::span<const double> memory,
                            double elapsed,
                            std::span<double> after) const override {
        const double rg = r_ / (1.0 + elapsed);
        const Vec6 change = strain - Eigen::Map<const Vec6>(memory.data());
        const double square = strain.squaredNorm();
        SectionResponse response;
        response.resultants = C_ * strain + a_ * square * strain + rg * change;
        response.tangent = C_ + a_ * (square * Mat6::Identity() + 2.0 * strain * strain.transpose());
        response.tangent.diagonal().array() += rg;
        response.dissipated = 0.5 * rg * change.squaredNorm();
        response.stored = 0.5 * strain.dot(C_ * strain) + 0.25 * a_ * square * square + response.dissipated;
        if (!after.empty()) Eigen::Map<Vec6>(after.data()) = strain;
        return response;
    }

  private:
    Mat6 C_;
    double a_, r_;
};

}  // namespace gxrod::tools
