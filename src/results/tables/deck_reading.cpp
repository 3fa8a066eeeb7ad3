#include "results/tables/deck_reading.hpp"

namespace gxrod {

std::string deck_text_name(std::size_t count) {
    return count == 1 ? "text" : "text_" + std::to_string(count);
}

DeckRecord read_deck_record(const Hdf5Reader& file) {
    DeckRecord record;
    record.name = file.text_attribute("/", "deck_name");
    std::size_t count = 1;
    while (file.has("/deck/" + deck_text_name(count + 1))) ++count;
    record.text = file.text("/deck/" + deck_text_name(count));
    record.title = file.text_attribute("/", "title");
    record.units = file.text_attribute("/", "units");
    const std::string analysis = file.text_attribute("/", "analysis");
    record.is_static = analysis == "static";
    record.has_statics = record.is_static || analysis == "static and dynamic";
    if (!file.has("/deck/meshes")) return record;
    for (const std::string& name : file.members("/deck/meshes")) {
        const std::string path = "/deck/meshes/" + name;
        record.meshes.push_back({file.text_attribute(path, "file"), file.bytes(path)});
    }
    return record;
}

}  // namespace gxrod
