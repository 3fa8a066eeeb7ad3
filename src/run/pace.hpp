#pragma once

#include <deque>

namespace gxrod {

// Estimates the time that a run still takes, from the progress in the latter half of the time so far: neither
// the part before a resumption nor a quick beginning counts.
class Pace {
  public:
    // Records that `part` of the run, from 0 to 1, was done after so many seconds. Seconds must not fall.
    void record(double seconds, double part);
    // Returns seconds; negative if not known.
    double seconds_left() const;

  private:
    struct Mark {
        double seconds;
        double part;
    };
    std::deque<Mark> marks_;  // the first one is the last mark before half of the time
};

}  // namespace gxrod
