#pragma once

namespace gxrod::speed {

// The most memory that the program holds at once beyond what it holds when this is made. Linux only.
class MemoryPeak {
  public:
    MemoryPeak();
    double bytes() const;

  private:
    double before_;
};

}  // namespace gxrod::speed
