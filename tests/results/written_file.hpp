#pragma once

#include <filesystem>
#include <fstream>

#include "results/file/file_seal.hpp"
#include "results/results_file.hpp"
#include "results/sample.hpp"

// Results files of the sample, and what may become of them.
namespace gxrod::sample {

inline void write_steps(ResultsFile& file, int first, int count) {
    for (int i = first; i < first + count; ++i) {
        const Motion motion(0.25 * i);
        file.record_step(motion.snapshot(), make_ledger(motion.time), make_solver(motion.time));
        if (i % 2 == 0) file.write_frame(motion.snapshot());
        file.set_restart(make_restart(motion.time));
        file.flush();
    }
}

inline DeckRecord make_deck_with_mesh() {
    DeckRecord deck = make_deck();
    deck.meshes.push_back({"cable.msh", "$MeshFormat"});
    return deck;
}

inline void write_bytes(const std::filesystem::path& path, const std::string& bytes) {
    std::ofstream(path, std::ios::binary) << bytes;
}

// As if its writer had been killed while it changed the file.
inline void open_seal(const std::filesystem::path& path) {
    const SealBlock block = write_seal({});
    std::fstream file(path, std::ios::in | std::ios::out | std::ios::binary);
    file.write(reinterpret_cast<const char*>(block.data()), block.size());
}

}  // namespace gxrod::sample
