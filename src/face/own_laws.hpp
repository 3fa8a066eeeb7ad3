#pragma once

#include <functional>
#include <memory>
#include <string>

#include "model/problem.hpp"
#include "model/spring_law.hpp"

// Laws and functions of a program's own, put into a problem that was built. All throw DeckError if the
// problem does not have what they are for.
namespace gxrod {

// A force along a spring, and whether it depends on the rate of the length.
struct OwnForce {
    SpringLaw::Force force;
    bool has_rate;
};

void set_section_law(const std::string& section, std::shared_ptr<const SectionLaw> law, Problem& problem);
void set_spring_force(const std::string& spring, const OwnForce& force, Problem& problem);
void set_load_force(std::size_t load, const MotionForce& force, Problem& problem);
void set_course(const std::string& input, const std::function<double(double)>& course, Problem& problem);

// A law without a memory that is a function of the strains.
class ElasticLaw final : public SectionLaw {
  public:
    explicit ElasticLaw(std::function<SectionResponse(const Vec6& strain)> respond)
        : respond_(std::move(respond)) {}

    int memory_size() const override { return 0; }
    std::string describe() const override { return "a function of the program"; }
    SectionResponse respond(const Vec6& strain,
                            std::span<const double>,
                            double,
                            std::span<double>) const override {
        return respond_(strain);
    }

  private:
    std::function<SectionResponse(const Vec6&)> respond_;
};

}  // namespace gxrod
