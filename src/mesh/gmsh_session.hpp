#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "cross_section/section_mesh.hpp"
#include "mesh/gmsh_library.hpp"
#include "mesh/line_mesh.hpp"

namespace gxrod {

// An array that Gmsh has allocated.
template <class Value>
class GmshArray {
  public:
    explicit GmshArray(const GmshLibrary& gmsh) : gmsh_(&gmsh) {}
    ~GmshArray() { gmsh_->release(data); }
    GmshArray(const GmshArray&) = delete;
    GmshArray& operator=(const GmshArray&) = delete;

    std::span<const Value> values() const { return {data, count}; }

    Value* data = nullptr;
    std::size_t count = 0;

  private:
    const GmshLibrary* gmsh_;
};

// The elements of one type in an entity.
struct GmshElements {
    int type = 0;
    std::vector<std::size_t> nodes;
    std::vector<std::size_t> numbers;
    int entity = 0;  // the number of the entity; −1 with elements of all entities
};

// A model in Gmsh's memory. Gmsh has one memory per process, so only one session can live at a time; its end
// resets all options to their defaults. Nothing is printed; failures throw MeshError with Gmsh's own
// messages.
class GmshSession {
  public:
    explicit GmshSession(const GmshLibrary& gmsh);
    ~GmshSession();
    GmshSession(const GmshSession&) = delete;
    GmshSession& operator=(const GmshSession&) = delete;

    void open(const std::filesystem::path& file);
    void generate_lines();

    // Begins an area in the plane (x, y).
    void begin_area();
    // Adds a closed polygon, with the size of elements at each corner, whose sides are one element each.
    // Returns the lines' numbers.
    std::vector<int> add_loop(const std::vector<PlanePoint>& corners, const std::vector<double>& sizes);
    // Meshes the area between the first loop and the others by triangles.
    void generate_triangles();

    struct Group {
        int dimension, number;
        std::string name;
    };
    struct Nodes {
        std::vector<std::size_t> numbers;
        std::vector<Vec3> positions;
    };
    // Values of elements, one or one for each node.
    struct ElementData {
        std::string name;
        std::vector<std::size_t> numbers;  // of the elements
        std::vector<std::vector<double>> values;
    };
    std::vector<Group> groups() const;
    Nodes nodes() const;
    std::vector<std::size_t> nodes_of(const Group& group) const;
    std::vector<GmshElements> elements_of(const Group& group) const;
    // Returns the elements of an entity, or, with −1, all elements of this dimension.
    std::vector<GmshElements> elements_of_entity(int dimension, int entity) const;
    // Returns the data on elements that a file has beside its mesh; those of several components are left out.
    std::vector<ElementData> element_data() const;

  private:
    // Throws if there is an error or Gmsh has reported one.
    void check(int error, const std::string& failure) const;
    // Returns the first errors that Gmsh has reported.
    std::string messages() const;

    const GmshLibrary& gmsh_;
    std::vector<int> loops_, lines_;  // of an area
};

}  // namespace gxrod
