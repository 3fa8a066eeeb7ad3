#pragma once

#include <filesystem>
#include <functional>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "verification/check.hpp"

// Built-in verification studies, which `gxrod verify NAME` runs.
namespace gxrod {

struct StudyOptions {
    std::vector<long> steps;        // empty: the study's own
    std::filesystem::path figures;  // folder for figure data; empty: none
};

struct StudyResult {
    nlohmann::ordered_json json;  // the rows, as --json writes them under the study's name
    std::string table;            // the rows for a reader
    std::vector<Check> checks;    // comparisons with references

    bool matches() const;  // whether all checks passed
};

struct Study {
    std::string name;
    std::string sentence;  // its statement
    std::string kind;      // kind of mechanics: "statics", "dynamics", "rigid body", …
    std::string source;    // sources of the problem and its reference
    std::function<StudyResult(const StudyOptions&)> run;
};

// Returns all studies, by name.
const std::vector<Study>& studies();

}  // namespace gxrod
