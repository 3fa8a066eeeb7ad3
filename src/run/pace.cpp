#include "run/pace.hpp"

namespace gxrod {

void Pace::record(double seconds, double part) {
    marks_.push_back({seconds, part});
    while (marks_.size() > 2 && marks_[1].seconds <= 0.5 * seconds) marks_.pop_front();
}

double Pace::seconds_left() const {
    if (marks_.size() < 2) return -1.0;
    const double done = marks_.back().part - marks_.front().part;
    if (!(done > 0.0)) return -1.0;
    return (marks_.back().seconds - marks_.front().seconds) * (1.0 - marks_.back().part) / done;
}

}  // namespace gxrod
