#pragma once

#include <filesystem>
#include <functional>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "verification/check.hpp"

// Built-in verification studies: what `gxrod verify NAME` runs.
namespace gxrod {

struct StudyOptions {
    std::vector<long> steps;        // empty: the study's own
    std::filesystem::path figures;  // folder for figure data; empty: none
};

struct StudyResult {
    nlohmann::ordered_json json;  // the rows, as --json writes them under the study's name
    std::string table;            // the same for a reader
    std::vector<Check> checks;    // what was compared with what

    bool matches() const;  // whether no check failed
};

struct Study {
    std::string name;
    std::string sentence;  // what it shows
    std::string kind;      // of mechanics: "statics", "dynamics", "rigid body", …
    std::string source;    // of the problem and of its reference
    std::function<StudyResult(const StudyOptions&)> run;
};

// All studies, by name.
const std::vector<Study>& studies();

}  // namespace gxrod
