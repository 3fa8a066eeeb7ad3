#pragma once

#include <string>
#include <vector>

namespace gxrod {

struct VerifyDeckArguments {
    std::string deck;
    std::vector<std::string> overrides;
    std::string stage;  // empty: the last one that can be studied
    int levels = 2;
    unsigned seed = 1;
    double tolerance = 0.01;
    std::string page;  // empty: none
    bool force = false;
    bool json = false;
};

// Examines a user's deck and prints the findings; the exit code.
int verify_deck(const VerifyDeckArguments& arguments);

}  // namespace gxrod
