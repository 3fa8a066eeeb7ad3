#pragma once

#include <stdexcept>
#include <string>
#include <vector>

namespace gxrod {

// A fault of a deck.
struct DeckFault {
    std::string file;  // as the user named the deck; "--set KEY=VALUE" for a value from there
    int line = 0;      // from 1; 0 for a value of --set
    int column = 0;    // from 1, in characters
    std::string key;   // full path, as in "rod.flyer.section" or "load[0].force[1]"; empty for a syntax error
    std::string message;  // the fault, the expected value, the nearest valid spelling
};

// Returns "file:line:column: key: message", without the parts that the fault does not have.
std::string describe(const DeckFault& fault);

// Thrown if a deck cannot be run. what() has one line per fault, in deck order.
class DeckError : public std::runtime_error {
  public:
    explicit DeckError(std::vector<DeckFault> all);

    std::vector<DeckFault> faults;
};

}  // namespace gxrod
