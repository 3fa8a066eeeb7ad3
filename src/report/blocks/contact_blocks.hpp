#pragma once

#include <nlohmann/json_fwd.hpp>
#include <ostream>
#include <string>
#include <vector>

#include "deck/problem.hpp"
#include "results/file/hdf5_reader.hpp"

// What touches, and the obstacles, for the page.
namespace gxrod {

// The forces of contact in frames, the strongest where there are many.
class ContactBlocks {
  public:
    // Of a run with so many frames; empty without contact. Throws Hdf5Error.
    ContactBlocks(const Hdf5Reader& file, std::size_t frames);

    // The most that are written of a frame.
    std::size_t most_touches() const { return most_; }
    // A sentence, or "".
    std::string left_out() const;
    // "contact-offsets", of each of the chosen frames; "contacts": point, force on the first rod, and whether
    // it slides, plus 2 where rods touch each other.
    void write(const std::vector<std::size_t>& chosen, std::ostream& out) const;

    static constexpr std::size_t numbers_of_touch = 7;

  private:
    const Hdf5Reader& file_;
    std::vector<double> offsets_;
    std::size_t all_ = 0, most_ = 0;
};

// Name, shape, place at t = 0: points, tangents left out; `moved` is its number among those that move, or −1.
nlohmann::ordered_json describe_obstacles(const Model& model);

std::size_t count_moved_obstacles(const Model& model);

// "obstacles": of each frame, for each obstacle that moves, displacement and rotation (quaternion w x y z)
// about its `about`. Throws Hdf5Error.
void write_obstacle_motions(const Hdf5Reader& file,
                            const Problem& problem,
                            const std::vector<double>& times,
                            std::ostream& out);

// Of meshes of obstacles, in a page.
std::size_t count_mesh_bytes(const Model& model);
// "mesh-corners-I" and "mesh-triangles-I" of the obstacle I: three numbers each.
void write_obstacle_meshes(const Model& model, std::ostream& out);

}  // namespace gxrod
