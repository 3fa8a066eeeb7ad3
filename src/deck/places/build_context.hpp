#pragma once

#include <array>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "deck/places/point.hpp"
#include "deck/reading/checked_deck.hpp"
#include "deck/table/table.hpp"
#include "deck/text/fault_list.hpp"
#include "model/evaluation_error.hpp"
#include "model/model.hpp"
#include "model/settings/analysis_traits.hpp"
#include "model/settings/stage.hpp"

namespace gxrod {

struct SurfaceMesh;

// A point that has a node.
struct PlacedPoint {
    int node = 0;
    int rod = -1;             // index in Model::rods, or -1
    int position_in_rod = 0;  // index in Rod::nodes
    int body = -1;            // index in Model::bodies, or -1
    // The first or last element, at an end of a rod that comes back to its node; -1 elsewhere.
    int end_element = -1;
    bool is_end_of_rod = false;  // the end, not the start
    // The place on the rod if it lies between nodes; `node` is then the nearest one.
    std::optional<RodPoint> between = {};
};

// An end of a rod with a hinge, which a [[connect]] ties to the node of other points.
struct MemberHinge {
    std::string name;        // NAME.start or NAME.end
    std::string first_name;  // the point to whose node it is tied
    int node = 0;            // that node
    int own_node = 0;
    int rod = 0;
};

// Where a deck sets an initial velocity of a node; no table where it does not.
struct VelocitySetting {
    const TableHead* table = nullptr;
    const void* field = nullptr;  // of the table
    double size =
        0.0;  // the largest velocity that the key gives to any node: what its round-off is compared with
};

// The data that the builders of a model share. Tables of rods and bodies have the order of Model::rods and
// Model::bodies. A builder adds errors to `faults` and continues with the rest; where a rod or body
// could not be built, its place in the model is kept and its points have no node.
struct BuildContext {
    const CheckedTable& deck;
    const PointNames& names;
    FaultList& faults;
    std::vector<std::string>& notes;
    Model& model;
    std::vector<StagePlan> stages = {};                   // one at least, once built
    std::size_t stage = 0;                                // whose loads and supports are built
    std::vector<std::vector<double>> rod_fractions = {};  // of each rod's nodes; empty for one without a mesh
    std::vector<std::vector<double>> rod_twists = {};     // of their sections there, by rod_fractions
    std::vector<std::vector<int>> rod_nodes = {};         // at those fractions, after build_connections
    std::vector<MemberHinge> hinges = {};                 // after build_connections
    std::vector<int> body_nodes = {};                     // of each body; -1 for one without
    // The settings of each node: of its velocity and of its angular velocity.
    std::vector<std::array<VelocitySetting, 2>> velocity_settings = {};
    std::map<std::string, std::shared_ptr<const TriangleMesh>> obstacle_meshes = {};  // by obstacle

    std::map<std::string, std::shared_ptr<const SurfaceMesh>> section_meshes = {};  // by section

    std::map<std::string, std::vector<PlaneCurve::Point>> cam_points = {};  // of files, by joint

    const AnalysisSettings& analysis() const { return stages[stage].analysis; }
    // Whether any stage integrates accelerations; whether the first one does, which has the initial
    // velocities.
    bool needs_inertia() const;
    bool has_velocities() const { return gxrod::needs_inertia(stages.front().analysis); }

    // Notes that initial velocities given at a place have no effect, in a deck in which nothing moves in
    // time; reports a fault where the first stage has none and a later one has.
    void reject_velocities(const Place& place, const std::string& path) const;

    void add_fault(const CheckedTable& table, std::string_view key, std::string message) const {
        faults.add(table.place_of(key), table.path_of(key), std::move(message));
    }

    // `field` is a member of the table.
    template <class Field>
    void add_fault(const TableHead& table, const Field& field, const std::string& message) const {
        faults.add(table.place_of(&field), table.path_of(&field), message);
    }

    // The error of an expression as a fault of its value; the error names the key, which a fault does too.
    void add_evaluation_fault(const Place& at, const std::string& path, const EvaluationError& error) const {
        faults.add(at, path, std::string(error.what()).substr(path.size() + 2));
    }

    // The node of a point that the deck names; nullopt if there is none, without a fault.
    std::optional<PlacedPoint> place(const std::string& point) const;
    std::optional<PlacedPoint> place(const Point& point) const;

    // The axes of the section or body at a point, at t = 0.
    Quat axes_at(const PlacedPoint& point) const;
    // The turn of the section about the tangent that the deck gives it there; 0 of a body.
    double twist_at(const PlacedPoint& point) const;
};

}  // namespace gxrod
