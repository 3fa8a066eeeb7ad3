#include "mesh/line_mesh_bytes.hpp"

#include <cstdint>
#include <cstring>
#include <type_traits>

namespace gxrod {
namespace {

class Writer {
  public:
    template <class Number>
        requires std::is_arithmetic_v<Number>
    void visit(const Number& number) {
        bytes.append(reinterpret_cast<const char*>(&number), sizeof(Number));
    }
    template <class Entry>
    void visit(const std::vector<Entry>& entries);
    void visit(const std::string& text) {
        visit(text.size());
        bytes += text;
    }

    std::string bytes;
};

class Reader {
  public:
    explicit Reader(std::string_view bytes) : rest_(bytes) {}

    template <class Number>
        requires std::is_arithmetic_v<Number>
    void visit(Number& number) {
        std::memcpy(&number, take(sizeof(Number)).data(), sizeof(Number));
    }
    template <class Entry>
    void visit(std::vector<Entry>& entries);
    void visit(std::string& text) { text = take(read_count()); }
    bool is_at_end() const { return rest_.empty(); }

  private:
    std::string_view take(std::size_t count) {
        if (count > rest_.size()) throw MeshError("what was read of it is cut short");
        const std::string_view taken = rest_.substr(0, count);
        rest_.remove_prefix(count);
        return taken;
    }
    // Of entries of a byte at least.
    std::size_t read_count() {
        std::size_t count = 0;
        visit(count);
        if (count > rest_.size()) throw MeshError("what was read of it is cut short");
        return count;
    }

    std::string_view rest_;
};

// Calls stream.visit for each member of an entry, const or not.
template <class Stream, class Entry>
void visit_members(Stream& stream, Entry& entry) {
    using Kind = std::remove_const_t<Entry>;
    if constexpr (std::is_arithmetic_v<Kind>) {
        stream.visit(entry);
    } else if constexpr (std::is_same_v<Kind, Vec3>) {
        for (int i = 0; i < 3; ++i) stream.visit(entry[i]);
    } else {
        stream.visit(entry.number);
        stream.visit(entry.name);
        if constexpr (std::is_same_v<Kind, MeshLines>) stream.visit(entry.orders);
        if constexpr (std::is_same_v<Kind, MeshRegion>) {
            stream.visit(entry.dimension);
        } else {
            stream.visit(entry.nodes);
        }
        if constexpr (std::is_same_v<Kind, MeshLines>) stream.visit(entry.curves);
    }
}

template <class Entry>
void Writer::visit(const std::vector<Entry>& entries) {
    visit(entries.size());
    for (const Entry& entry : entries) visit_members(*this, entry);
}

template <class Entry>
void Reader::visit(std::vector<Entry>& entries) {
    entries.resize(read_count());
    for (Entry& entry : entries) visit_members(*this, entry);
}

template <class Stream, class Mesh>
void visit_mesh(Stream& stream, Mesh& mesh) {
    stream.visit(mesh.positions);
    stream.visit(mesh.lines);
    stream.visit(mesh.points);
    stream.visit(mesh.regions);
}

}  // namespace

std::string write_mesh_bytes(const LineMesh& mesh) {
    Writer writer;
    visit_mesh(writer, mesh);
    return std::move(writer.bytes);
}

LineMesh read_mesh_bytes(std::string_view bytes) {
    Reader reader(bytes);
    LineMesh mesh;
    visit_mesh(reader, mesh);
    if (!reader.is_at_end()) throw MeshError("it has data after its end");
    return mesh;
}

}  // namespace gxrod
