#pragma once

#include <stdexcept>
#include <string>
#include <vector>

namespace gxrod {

// A name that is not there. what() says which name was likely meant, and which there are.
class UnknownNameError : public std::out_of_range {
  public:
    using std::out_of_range::out_of_range;
};

// Returns the index of a name. `what` says what it names, as "history". Throws UnknownNameError.
std::size_t find_name(const std::string& what,
                      const std::string& name,
                      const std::vector<std::string>& names);

}  // namespace gxrod
