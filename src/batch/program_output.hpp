#pragma once

#include <string>
#include <vector>

namespace gxrod {

struct ProgramOutput {
    bool was_found = true;
    int exit_code = 0;  // 128 + the signal that ended it
    std::string output;
    std::string errors;
};

// Runs a program of the search path to its end and returns its output; no shell reads the words. Throws
// std::system_error if no process can be started.
ProgramOutput run_program(std::vector<std::string> words);

}  // namespace gxrod
