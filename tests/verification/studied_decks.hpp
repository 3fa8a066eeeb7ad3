#pragma once

#include <algorithm>
#include <fstream>
#include <string>
#include <vector>

#include "machine/temporary_folder.hpp"
#include "study/deck_study.hpp"
#include "study/studied_stage.hpp"
#include "tools/catch.hpp"

// Decks that are studied, and how.
namespace gxrod::test {

class DeckFile {
  public:
    explicit DeckFile(const std::string& text) : path_(folder_.path() / "deck.toml") {
        std::ofstream(path_) << text;
    }
    DeckTemplate read() const { return DeckTemplate(path_); }

  private:
    TemporaryFolder folder_{"test"};
    std::filesystem::path path_;
};

inline DeckStudy study(const std::string& text,
                       const std::vector<VariantKind>& kinds,
                       const std::vector<std::string>& overrides = {},
                       const DeckStudyOptions& options = {}) {
    const DeckFile file(text);
    const DeckTemplate deck = file.read();
    std::vector<DeckVariant> variants;
    Problem problem = deck.build(overrides);
    end_with_stage(options.stage, problem);
    for (const DeckVariant& variant : list_variants(problem, 2)) {
        const bool is_wanted = variant.kind == VariantKind::as_it_is ||
                               std::find(kinds.begin(), kinds.end(), variant.kind) != kinds.end();
        if (is_wanted) variants.push_back(variant);
    }
    return study_deck(deck, overrides, variants, options);
}

// A cantilever that swings, in few steps.
inline const std::string swing = R"deck([section.s]
stiffness = { EA = 1e4, GAy = 1e4, GAz = 1e4, GJ = 100, EIy = 100, EIz = 100 }
inertia = { rhoA = 1, rhoIy = 0.01, rhoIz = 0.01 }
[rod.beam]
section = "s"
line = { from = [0, 0, 0], to = [4, 0, 0] }
elements = 4
[[support]]
at = "beam.start"
fix = "all"
[[load]]
at = "beam.end"
force = [0, "3*sin(t)^2", "sin(t)^2"]
[analysis]
kind = "dynamic"
end_time = 2.0
time_step = 0.02
)deck";

// A cantilever that is bent, let go, and held again where it is then.
inline const std::string bent_and_released = R"deck([section.s]
stiffness = { EA = 1e4, GAy = 1e4, GAz = 1e4, GJ = 100, EIy = 100, EIz = 100 }
inertia = { rhoA = 1, rhoIy = 0.01, rhoIz = 0.01 }
[rod.beam]
section = "s"
line = { from = [0, 0, 0], to = [4, 0, 0] }
elements = 4
[[support]]
at = "beam.start"
fix = "all"
[[support]]
at = "beam.end"
fix = ["x", "y"]
axes = [[0.6, 0.8, 0], [-0.8, 0.6, 0], [0, 0, 1]]
stages = "hold"
[[load]]
at = "beam.end"
force = [0, 3, 1]
factor = { bend = "t", swing = "t < 0.5 ? cos(pi*t)^2 : 0" }
[[stage]]
name = "bend"
kind = "static"
steps = 4
[[stage]]
name = "tones"
kind = "modes"
[[stage]]
name = "swing"
kind = "dynamic"
end_time = 1.0
time_step = 0.02
integrator = "newmark-simplified"
[[stage]]
name = "hold"
kind = "static"
steps = 2
)deck";

// The cantilever that swings, of a mesh of two elements, beam.msh.
inline std::string mesh_swing() {
    std::string text = swing;
    const std::size_t line = text.find("line = ");
    return text.replace(line, text.find("[[support]]") - line, "mesh = { file = \"beam.msh\", group = 7 }\n");
}

inline const SeriesReport& find(const DeckStudy& study, const std::string& title) {
    for (const SeriesReport& report : study.series) {
        if (report.series.title() == title) return report;
    }
    FAIL("no series " << title);
    return study.series.front();
}

}  // namespace gxrod::test
