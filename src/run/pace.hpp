#pragma once

#include <deque>

namespace gxrod {

// How long a run still takes, from how much of it was done in the latter half of the time that it has taken:
// what a resumed run began with does not count, nor a quick beginning.
class Pace {
  public:
    // That `part` of all, from 0 to 1, was done after so many seconds. Seconds do not fall.
    void record(double seconds, double part);
    // Seconds; negative if not known.
    double seconds_left() const;

  private:
    struct Mark {
        double seconds;
        double part;
    };
    std::deque<Mark> marks_;  // the first one is the last before half of the time
};

}  // namespace gxrod
