#pragma once

#include <string>
#include <vector>

namespace gxrod {

// An example of docs/examples that has a reference.toml, with its text at build time.
struct ExampleText {
    std::string name;  // name of its folder
    std::string deck;
    std::string reference;
};

const std::vector<ExampleText>& example_texts();

}  // namespace gxrod
