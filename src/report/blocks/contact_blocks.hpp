#pragma once

#include <nlohmann/json_fwd.hpp>
#include <ostream>
#include <string>
#include <vector>

#include "deck/problem.hpp"
#include "results/file/hdf5_reader.hpp"

// Contacts and obstacles for the page.
namespace gxrod {

// The forces of contact in frames, only the strongest if there are many.
class ContactBlocks {
  public:
    // Reads a run with so many frames; empty without contact. Throws Hdf5Error.
    ContactBlocks(const Hdf5Reader& file, std::size_t frames);

    // Returns the largest number of contacts that are written per frame.
    std::size_t most_touches() const { return most_; }
    // Returns a sentence on what was left out, or "".
    std::string left_out() const;
    // Writes "contact-offsets" for each of the chosen frames and "contacts": point, force on the first rod,
    // and 1 if it slides, plus 2 if two rods touch.
    void write(const std::vector<std::size_t>& chosen, std::ostream& out) const;

    static constexpr std::size_t numbers_of_touch = 7;

  private:
    const Hdf5Reader& file_;
    std::vector<double> offsets_;
    std::size_t all_ = 0, most_ = 0;
};

// Describes obstacles: name, shape, place at t = 0 as points without tangents; `moved` is the number among
// moving obstacles, or −1.
nlohmann::ordered_json describe_obstacles(const Model& model);

std::size_t count_moved_obstacles(const Model& model);

// Writes "obstacles": in each frame, for each moving obstacle, displacement and rotation (quaternion w x y z)
// about its `about`. Throws Hdf5Error.
void write_obstacle_motions(const Hdf5Reader& file,
                            const Problem& problem,
                            const std::vector<double>& times,
                            std::ostream& out);

// Counts the bytes of the meshes of obstacles in a page.
std::size_t count_mesh_bytes(const Model& model);
// Writes "mesh-corners-I" and "mesh-triangles-I" of obstacle I: three numbers each.
void write_obstacle_meshes(const Model& model, std::ostream& out);

}  // namespace gxrod
