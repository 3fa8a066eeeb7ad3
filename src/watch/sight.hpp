#pragma once

#include "cross_section/section_stress.hpp"
#include "state/records/step_record.hpp"
#include "watch/grounded_part.hpp"
#include "watch/quantity.hpp"

namespace gxrod {

// A point in global axes, or as seen from the point that a history is relative to: places from there,
// components in its axes, Lambda · start_axes the section or body axes from those.
struct SeenPoint {
    Vec3 start;
    Quat start_axes;  // of the section or body
    NodeMotion motion;

    Quat axes() const { return motion.Lambda * start_axes; }
    Vec3 displacement() const { return motion.r - start; }
    Vec3 material_spin() const { return axes().conjugate() * motion.omega; }
};

// Stresses of a section that a history has: at a point, or where they are worst.
struct WatchedStress {
    SectionStresses section;
    std::optional<int> point = {};  // of the section
    bool is_by_exposure = false;    // which is the worst, else by the von Mises stress

    WatchedStress(std::shared_ptr<const CrossSection> shape, const HistoryRequest& request);
    SectionStress find(const Vec6& resultants) const;
    double find_exposure(const Vec6& resultants) const;
};

// The thing of a history with what its quantities need of the model, which must outlive it.
struct Subject {
    // Takes the thing of requests[index].
    Subject(const Model& model, const std::vector<HistoryRequest>& requests, std::size_t index);

    const Model* model;
    Watched target;
    int relative_node;
    Quat relative_axes;
    Vec3 relative_start = Vec3::Zero();
    std::optional<Vec3> about;
    std::optional<Vec3> no_load;  // in the axes that components are in
    Vec3 start = Vec3::Zero();    // place of a node at t = 0
    Quat start_axes = Quat::Identity();
    std::vector<std::size_t> support_springs = {};  // in Model::bushings, by which a support there yields
    std::size_t point_row = 0;                      // index in Snapshot::points
    std::size_t contact_row = 0;                    // index in Snapshot::watched_contacts
    std::optional<WatchedStress> stress = {};       // of a point of a rod whose section has a shape on cells
};

// The thing of a history at a step: where its quantities find their values.
struct Sight {
    const Subject& of;
    const Snapshot& now;

    SeenPoint point() const;
    Vec3 centre_of_mass() const;
    const PointValues& section() const { return now.points[of.point_row]; }
    SectionStress stress() const;  // with the pressure of water on a solid section
    double exposure() const { return of.stress->find_exposure(section_resultants()); }
    const PointSurroundings& around() const;  // of a point or a body
    // Finds where a rod as a whole lies on the ground; nullopt if it does not.
    std::optional<GroundedPart> grounded_part() const;
    Vec3 reaction_force() const;
    Vec3 reaction_moment() const;
    // The values of a tie that is an element: SpringValues of a spring.
    template <class Values>
    const Values& tie() const {
        return now.ties->of<Values>()[index<WatchedTie>()];
    }
    const JointValues& joint() const;  // also for a gear or a sleeve
    const TendonValues& tendon() const { return now.tendons[index<WatchedTendon>()]; }
    const ObstacleValues& obstacle() const { return now.obstacles[index<WatchedObstacle>()]; }
    const ObstacleValues& contacts() const { return now.watched_contacts[of.contact_row]; }

  private:
    template <class Thing>
    std::size_t index() const {
        return static_cast<std::size_t>(std::get<Thing>(of.target).index);
    }
    SeenPoint point_by_itself() const;
    // Returns the force and the moment that the support at the node exerts on it, springs included.
    Vec6 reaction() const;
    Vec6 section_resultants() const;
};

}  // namespace gxrod
