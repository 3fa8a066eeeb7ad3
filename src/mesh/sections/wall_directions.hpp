#pragma once

#include <vector>

#include "cross_section/section_mesh.hpp"
#include "mesh/sections/surface_file.hpp"

namespace gxrod {

// The direction t of walls that follow curves of a mesh. Closed curves are walked anticlockwise, open ones as
// their first line in the file. Between the nodes of a curve the direction turns evenly, except at corners.
class WallDirections {
  public:
    // Takes the curves of a group; `nodes` are those of the file in the plane of the section.
    WallDirections(const SurfaceMesh& mesh, int group, const std::vector<PlanePoint>& nodes);

    // Returns the unit vector at the nearest point of the curves.
    PlanePoint at(const PlanePoint& point) const;

  private:
    struct Line {
        PlanePoint from, to, start_direction, end_direction;

        PlanePoint at(double place) const { return from + place * (to - from); }
        PlanePoint direction(double place) const {
            return start_direction + place * (end_direction - start_direction);
        }
    };

    // Returns where on a line, from 0 to 1, a point belongs.
    static double find_place(const Line& line, const PlanePoint& point);

    // Adds the lines between points that follow each other.
    void add_chain(std::vector<PlanePoint> points, bool is_closed);

    std::vector<Line> lines_;
};

}  // namespace gxrod
