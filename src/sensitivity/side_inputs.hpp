#pragma once

#include <vector>

namespace gxrod {

// Sets inputs of varied systems that follow from their motions, and so differ from those of the analysis.
class SideInputs {
  public:
    virtual ~SideInputs() = default;
    // Sets the inputs of all sides for the step that the analysis has taken.
    virtual void act() = 0;
    // Takes the ends of this step on all sides. Returns whether the step has to be found again, by what it
    // has set now.
    virtual bool follow() = 0;

    // Return the derivatives of what it keeps, and return to them: the sides have their inputs then.
    virtual std::vector<double> record() const = 0;
    virtual void recall(const std::vector<double>& record) = 0;
};

}  // namespace gxrod
