#pragma once

#include <filesystem>
#include <string>

namespace gxrod::tools {

// A deck with joints: one of the examples, or one that tests alone have.
inline std::filesystem::path find_mechanism_deck(const std::string& name) {
    const std::filesystem::path source = GXROD_SOURCE_DIR;
    const std::filesystem::path example = source / "docs/examples" / name / (name + ".toml");
    return std::filesystem::exists(example) ? example : source / "tests/analyses/joints" / (name + ".toml");
}

}  // namespace gxrod::tools
