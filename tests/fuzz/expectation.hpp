#pragma once

#include <stdexcept>
#include <string>

namespace gxrod::fuzz {

// What no reader throws: that a promise is broken.
class BrokenPromise : public std::logic_error {
  public:
    using std::logic_error::logic_error;
};

inline void expect(bool is_kept, const std::string& promise) {
    if (!is_kept) throw BrokenPromise(promise);
}

}  // namespace gxrod::fuzz
