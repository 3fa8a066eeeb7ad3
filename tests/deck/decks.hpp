#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "deck/problem.hpp"

// Small decks that tests change, and what the reader says of them.
namespace gxrod::test {

// Lines 1 to 7; text that is added begins in line 8.
inline const std::string body_deck = R"([body.top]
mass = 1.0
inertia = [1, 1, 1]
[analysis]
kind = "dynamic"
end_time = 1.0
steps = 10
)";

// Lines 1 to 12; text that is added begins in line 13.
inline const std::string rod_deck = R"([section.s]
stiffness = { EA = 1e4, GAy = 2e4, GAz = 3e4, GJ = 500, EIy = 600, EIz = 700 }
inertia = { rhoA = 1.0, rhoJ = 20, rhoIy = 10, rhoIz = 11 }
[rod.r]
section = "s"
line = { from = [0, 0, 0], to = [10, 0, 0] }
elements = 10
element = "simo"
[analysis]
kind = "dynamic"
end_time = 1.0
steps = 10
)";

// Lines 1 to 10; text that is added begins in line 11.
inline const std::string static_rod_deck = R"([section.s]
stiffness = { EA = 1e4, GAy = 2e4, GAz = 3e4, GJ = 500, EIy = 600, EIz = 700 }
inertia = { rhoA = 1.0, rhoJ = 20, rhoIy = 10, rhoIz = 11 }
[rod.r]
section = "s"
line = { from = [0, 0, 0], to = [10, 0, 0] }
elements = 10
element = "simo"
[analysis]
kind = "static"
)";

// Lines 1 to 14. The clamped column of P16 is twice as stiff about z.
inline const std::string pressed_column_deck = R"([section.s]
stiffness = { EA = 1e3, GAy = 4e2, GAz = 4e2, GJ = 1, EIy = 1, EIz = 2 }
inertia = { rhoA = 1, rhoJ = 3e-4, rhoIy = 1e-4, rhoIz = 2e-4 }
[rod.column]
section = "s"
line = { from = [0, 0, 0], to = [1, 0, 0] }
elements = 16
order = 3
[[support]]
at = "column.start"
fix = "all"
[[load]]
at = "column.end"
force = [-1, 0, 0]
)";

// The deck with one piece of text, which it must have, replaced by another.
std::string replaced(std::string deck, const std::string& old_text, const std::string& new_text);

// A file in a folder of its own, both gone with this object.
class ScratchFile {
  public:
    ScratchFile(const std::string& name, const std::string& text);
    ~ScratchFile();
    ScratchFile(const ScratchFile&) = delete;
    ScratchFile& operator=(const ScratchFile&) = delete;

    const std::filesystem::path& path() const { return path_; }

  private:
    std::filesystem::path path_;
};

Problem read(const std::string& deck, const std::vector<std::string>& overrides = {});

// What a deck of a dynamic analysis asks for.
inline DynamicSettings dynamic_of(const Problem& problem) {
    return std::get<DynamicSettings>(problem.analysis());
}

// All faults of a deck named x.toml, a line each; "" if it has none.
std::string faults_of(const std::string& deck, const std::vector<std::string>& overrides = {});

}  // namespace gxrod::test
