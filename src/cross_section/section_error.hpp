#pragma once

#include <stdexcept>

namespace gxrod {

// A section that cannot be computed; the text says why.
class SectionError : public std::runtime_error {
  public:
    using std::runtime_error::runtime_error;
};

}  // namespace gxrod
