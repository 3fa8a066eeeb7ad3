#include "results/provenance.hpp"

#include <filesystem>
#include <set>

#include "machine/digest.hpp"
#include "model/version.hpp"
#include "results/tables/deck_reading.hpp"

namespace gxrod {
namespace {

// Each under its file's name; where two folders have files of the same name, the later gets a number as a
// prefix.
void write_meshes(const Hdf5Handle& parent, const std::vector<MeshRecord>& meshes) {
    const Hdf5Handle group = require_group(parent, "meshes");
    std::set<std::string> names;
    for (const MeshRecord& mesh : meshes) {
        const std::string file = std::filesystem::path(mesh.file).filename().string();
        std::string name = file;
        for (int count = 2; !names.insert(name).second; ++count) name = std::to_string(count) + "_" + file;
        const std::vector<std::uint8_t> bytes(mesh.bytes.begin(), mesh.bytes.end());
        write_dataset(group, {name, "bytes of a mesh that the deck names", "none", ""}, bytes);
        const Hdf5Handle dataset(H5Dopen2(group.id(), name.c_str(), H5P_DEFAULT), H5Dclose, "opening a mesh");
        write_attribute(dataset.id(), "file", mesh.file);
        write_attribute(dataset.id(), "sha256", sha256_hex(mesh.bytes));
    }
}

const char* name_analysis(const DeckRecord& deck) {
    if (deck.is_static) return "static";
    return deck.has_statics ? "static and dynamic" : "dynamic";
}

// Gives all attributes of the root one piece of its object header, so that replacing some of them is one
// write, which no kill can split. HDF5 makes a new piece for what does not fit into the first, here `room`,
// and moves `analysis`, which is never replaced, into the place that `room` leaves.
void write_analysis(hid_t root, const DeckRecord& deck) {
    constexpr std::size_t count = 400;  // with its header less than a page of memory
    write_attribute(root, "room", std::vector<std::int64_t>(count));
    write_attribute(root, "analysis", name_analysis(deck));
    remove_attribute(root, "room");
}

}  // namespace

void write_provenance(const Hdf5Handle& root, const DeckRecord& deck) {
    write_analysis(root.id(), deck);
    write_attribute(root.id(), "gxrod_version", version);
    write_attribute(root.id(), "deck_name", deck.name);
    write_attribute(root.id(), "deck_sha256", sha256_hex(deck.text));
    write_attribute(root.id(), "title", deck.title);
    write_attribute(root.id(), "units", deck.units);
    write_attribute(root.id(), "integrator", deck.integrators);
    write_attribute(root.id(), "status", "running");
    write_attribute(root.id(), "reason", "");
    write_attribute(root.id(), "reason_nodes", std::span<const std::int64_t>{});
    write_attribute(root.id(), "warnings", "");
    const Hdf5Handle group = require_group(root, "deck");
    write_dataset(group, {"text", "the deck as run", "none", ""}, deck.text);
    if (!deck.meshes.empty()) write_meshes(group, deck.meshes);
}

void write_resumption(const Hdf5Handle& root, const DeckRecord& before, const DeckRecord& deck) {
    if (before.text != deck.text) {
        const Hdf5Handle group = require_group(root, "deck");
        std::size_t count = 2;
        while (has_link(group, deck_text_name(count))) ++count;
        write_dataset(
            group,
            {deck_text_name(count), "the deck as run after a resumption that changed it", "none", ""},
            deck.text);
        rewrite_attribute(root.id(), "deck_name", deck.name);
        rewrite_attribute(root.id(), "deck_sha256", sha256_hex(deck.text));
        rewrite_attribute(root.id(), "title", deck.title);
        rewrite_attribute(root.id(), "units", deck.units);
    }
    rewrite_attribute(root.id(), "gxrod_version", version);
    rewrite_attribute(root.id(), "status", "running");
    rewrite_attribute(root.id(), "reason", "");
    rewrite_attribute(root.id(), "reason_nodes", std::span<const std::int64_t>{});
    rewrite_attribute(root.id(), "warnings", "");
}

}  // namespace gxrod
