#pragma once

#include <memory>
#include <string>
#include <vector>

#include "model/sections/section_law.hpp"

namespace gxrod::test {

// A section that goes from strain to strain, each accepted.
class LawPath {
  public:
    explicit LawPath(const SectionLaw& law)
        : law_(law), memory_(static_cast<std::size_t>(law.memory_size())), after_(memory_) {}

    // Where it would be, without accepting it.
    SectionResponse look(const Vec6& strain, double elapsed) const {
        return law_.respond(strain, memory_, elapsed, {});
    }
    const SectionResponse& go(const Vec6& strain, double elapsed);
    // In equal parts, straight and at the same speed.
    const SectionResponse& go(const Vec6& strain, double elapsed, int parts);

    const SectionResponse& now() const { return now_; }
    const Vec6& strain() const { return strain_; }
    const std::vector<double>& memory() const { return memory_; }
    double work() const { return work_; }                  // by the trapezoid rule
    double size_of_work() const { return size_of_work_; }  // of its parts without sign
    double dissipated() const { return dissipated_; }      // of all steps
    double least_dissipated() const { return least_; }     // of a step

  private:
    const SectionLaw& law_;
    std::vector<double> memory_, after_;
    Vec6 strain_ = Vec6::Zero();
    SectionResponse now_{};
    double work_ = 0.0, size_of_work_ = 0.0, dissipated_ = 0.0, least_ = 0.0;
};

// (Γ, K) with one entry.
Vec6 strain_along(int entry, double value);

// Laws of all kinds over one stiffness, with several sets of parameters.
struct NamedLaw {
    std::string name;
    std::shared_ptr<const SectionLaw> law;
    Vec6 scale;                // of strains at which it does something
    bool is_symmetric = true;  // its tangent
};
std::vector<NamedLaw> every_law();

// Positive definite, with couplings; those of some entries with others left out.
Mat6 some_stiffness(const std::vector<int>& uncoupled = {});

}  // namespace gxrod::test
