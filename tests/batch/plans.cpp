#include "batch/plans.hpp"

#include <fstream>
#include <random>

#include "batch/batch.hpp"
#include "machine/file_error.hpp"

namespace gxrod::test {

const std::string cantilever_deck = R"(title = "A cantilever"
[parameters]
EI = 500.0
load = 1.0
[section.s]
stiffness = { EA = 1e4, GAy = 2e4, GAz = 3e4, GJ = 500, EIy = "EI", EIz = "EI" }
[rod.r]
section = "s"
line = { from = [0, 0, 0], to = [10, 0, 0] }
elements = 2
[[support]]
at = "r.start"
fix = ["x", "y", "z", "rx", "ry", "rz"]
[[load]]
at = "r.end"
force = [0, 0, "load"]
[analysis]
kind = "static"
steps = 2
[[history]]
name = "tip"
at = "r.end"
quantities = ["position", "quaternion"]
)";

ScratchFolder::ScratchFolder() {
    std::random_device random;
    do {
        path_ = std::filesystem::temp_directory_path() / ("gxrod_batch_" + std::to_string(random()));
    } while (!std::filesystem::create_directory(path_));
}

ScratchFolder::~ScratchFolder() {
    std::error_code ignored;
    std::filesystem::remove_all(path_, ignored);
}

std::filesystem::path ScratchFolder::write(const std::string& name, const std::string& text) const {
    std::ofstream(path_ / name, std::ios::binary) << text;
    return path_ / name;
}

PlanFiles::PlanFiles(const std::string& plan, const std::string& deck) {
    folder_.write("deck.toml", deck);
    folder_.write("plan.toml", plan);
}

std::string PlanFiles::faults() const {
    std::string text;
    try {
        const PreparedBatch batch(read());
    } catch (const DeckError& error) {
        text = error.what();
    } catch (const FileError& error) {
        text = error.what();
    }
    const std::string folder_name = folder().string() + "/";
    for (std::size_t at = text.find(folder_name); at != std::string::npos; at = text.find(folder_name))
        text.erase(at, folder_name.size());
    return text;
}

}  // namespace gxrod::test
