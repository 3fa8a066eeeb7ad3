#pragma once

#include <Eigen/Core>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "assembly/contact/contact_limits.hpp"
#include "assembly/contact/contact_lines.hpp"
#include "assembly/contact/contact_overlap.hpp"
#include "assembly/node_groups.hpp"
#include "assembly/residual.hpp"
#include "assembly/scale_groups.hpp"
#include "contact/pairs/pair_friction.hpp"
#include "contact/pairs/pair_impulse.hpp"
#include "parallel/thread_team.hpp"
#include "state/contact_touch.hpp"

namespace gxrod {

// The tangent of the pieces of two elements that are near each other, global axes, six rows a node.
struct PairBlock {
    NodeGroup nodes;
    Eigen::MatrixXd matrix;
};

// Contact of rods with each other and themselves, and of bodies with both, by their straight pieces
// (ContactLines). Which of these are near is kept in State::contact, and found again where a motion could
// take others into reach.
class ContactPairs {
  public:
    // All must outlive it.
    ContactPairs(const Model& model, const ThreadTeam& team, const ScaleGroups& groups);

    bool empty() const { return lines_.pieces.empty(); }
    bool rub() const { return rubs_; }

    // Finds what is near the trial, if nodes can move by this much from there.
    void search(double reach, State& state) const;
    // The groups of nodes that the tangent couples or is likely to: sorted, each once.
    std::vector<NodeGroup> list_groups(const State& state) const;

    // Of the trial motions, by a weight (ContactAssembly).
    void subtract_forces(const State& state, double weight, Residual& residual) const;
    // One block for each two elements in which something touches or is expected to, in the order of elements.
    std::vector<PairBlock> compute_tangents(const State& state,
                                            double weight,
                                            const std::vector<NodeLinearization>& linearizations) const;
    // As ContactAssembly's, of friction and of what is expected to touch.
    void replace_by_tangent_forces(const State& state, double weight, Residual& residual) const;
    void start(State& state) const;
    void advance(const std::vector<Vec6>& deltas, State& state) const;
    void commit(State& state) const;
    // Raises the drag of what touches where the impulses of a step that ends here give energy; whether it
    // had to.
    bool counter_gain(State& state) const;

    // Lowers the limits of parts of the model whose rods would meet; these then go equally far. Searches
    // first where it has to. Pieces that the whole motion would take into touch are expected to touch from
    // then on: their forces are unknowns of the next linear solution, so that all of them come to touch at
    // once, and not one after another.
    void limit(const std::vector<Vec6>& increments,
               State& state,
               Approach approach,
               ContactLimits& limits) const;

    double compute_energy(const State& state) const;
    // Of the forces of impulses: Σ force · displacement over the step.
    double compute_work(const State& state) const;
    // What friction lost in a step without impulses.
    double compute_slip_work(const State& state) const;
    void count(const State& state, ContactCount& result) const;
    // One for two elements that touch.
    void add_touches(const State& state, std::vector<ContactTouch>& touches) const;
    // Lowers those of nodes next to what is nearer.
    void lower_gaps(const State& state, std::vector<double>& gaps) const;
    // Of the rod; infinite where nothing can touch it.
    double find_least_gap(const ContactWatch& watch, const State& state) const;
    void add_overlaps(const State& state, std::vector<ContactOverlap>& overlaps) const;

  private:
    Segment segment_of(std::size_t piece, const std::vector<NodeMotion>& motions) const;
    std::vector<Segment> find_segments(const std::vector<NodeMotion>& motions) const;  // of all pieces
    // No piece moves further.
    double find_reach(const std::vector<Vec6>& increments) const;
    NodeGroup list_nodes(int a, int b) const;  // of two elements
    PairLaw law_of(const NearPieces& near) const;
    double largest_skin() const;
    // How far what reaches so far from its axes may be moved before the next search, as a part of the motion.
    double find_room(double reach, State& state) const;
    // Where all pieces are, and where they were at the start of a step.
    struct PiecesPlaced {
        std::vector<Segment> now, before;
        double damping = 0.0;  // of a change of the gap in the step
        double drag = 0.0;

        bool operator==(const PiecesPlaced&) const = default;
    };
    PiecesPlaced place_pieces(const State& state) const;
    struct PairLimit {
        double fraction = 1.0;
        double gap = 0.0;
        bool can_meet = false;
    };
    // How the ends of a piece move, and how far the way of one of a body leaves its chord.
    struct PieceMotion {
        Segment chord;
        double aside = 0.0;
    };
    PieceMotion find_motion(std::size_t piece,
                            double part,
                            const State& state,
                            const std::vector<Vec6>& increments) const;
    std::vector<PieceMotion> find_motions(const State& state, const std::vector<Vec6>& increments) const;
    // Increments of nodes, and what pieces do with them.
    struct Wanted {
        const std::vector<Vec6>* increments;
        std::vector<Segment> at;
        std::vector<PieceMotion> motions;
    };
    PairLimit limit_pair(const NearPieces& near,
                         const Wanted& wanted,
                         const State& state,
                         Approach approach,
                         double& expected) const;
    void join_limits(const std::vector<PairLimit>& of_pairs,
                     double all,
                     const State& state,
                     ContactLimits& limits) const;
    // Of a piece that is expected to touch: force and stiffness by the gap, and its derivatives by the ends.
    struct Expected {
        double force = 0.0, stiffness = 0.0;
        Vec12 slope;
    };
    std::optional<Expected> find_expected(std::size_t index, const State& state) const;
    ContactLaw expected_law_of(const NearPieces& near) const;
    // Relative to a crossing.
    double find_share_of_crossing(const NearPieces& near) const;
    // With what the end of a rod adds, whose integral is finite where it touches.
    PairEnergy find_energy(const NearPieces& near, const std::vector<Segment>& segments) const;
    double compute_energy_before(const State& state) const;  // at the start of a step
    // Of value(item), the same for any number of threads.
    template <class Item, class Value>
    double sum_of(const std::vector<Item>& items, const Value& value) const;
    // Of State::contact.pieces, by index.
    struct Touching {
        std::size_t index = 0;
        PairEnergy energy;   // by which friction acts
        PairEnergy impulse;  // the forces of a step: turned; else those of the energy
    };
    // With damped forces. They last until the next call.
    const std::vector<Touching>& find_touching(const State& state) const;
    // What touches, or nullptr where it is expected to.
    struct Tangible {
        std::pair<int, int> elements;
        std::size_t index = 0;
        const Touching* touching = nullptr;
    };
    std::vector<Tangible> list_tangible(const State& state) const;  // sorted
    // Forces and moments at the ends, and their derivatives by positions and rotations there.
    struct EndTangent {
        std::size_t index = 0;
        Vec24 forces = Vec24::Zero();  // where there is a body
        Mat24 derivative = Mat24::Zero();
    };
    EndTangent find_end_tangent(const Tangible& one, const State& state) const;
    // Of the same two elements.
    PairBlock compute_block(std::span<const Tangible> those,
                            const State& state,
                            double weight,
                            const std::vector<NodeLinearization>& linearizations) const;
    PairIncrement find_increment(const NearPieces& near,
                                 const std::vector<Vec6>& deltas,
                                 const State& state) const;
    // Of nodes in the four ends.
    using Shares = Eigen::Matrix<double, 4, Eigen::Dynamic>;
    Shares find_shares(const NearPieces& near, const NodeGroup& nodes) const;
    int element_of(std::uint32_t piece) const {
        return lines_.places.places[lines_.pieces[piece].place].element;
    }
    // Where all pieces are as find_touching last found them.
    PairMotion motion_of(const NearPieces& near, const State& state) const;
    OpenEnds open_ends(const NearPieces& near) const;
    std::uint32_t find_next(std::uint32_t piece, int steps) const;  // along its rod
    // From two pieces on, along both rods, to those that are nearer.
    NearPieces find_nearest(NearPieces near, const std::vector<Segment>& segments) const;
    PairStart find_start(const NearPieces& near, const std::vector<Segment>& before) const;
    double coefficient_of(const NearPieces& near) const;
    double friction_stiffness_of(const NearPieces& near) const;
    // As the law has it, or as an iteration takes it for granted.
    CoulombFriction friction_of(std::size_t index, const State& state) const;
    CoulombFriction taken_friction_of(std::size_t index, const State& state) const;
    void keep_slip(std::size_t index, const CoulombFriction& friction, State& state) const;
    double least_gap(const NearPieces& near, const std::vector<NodeMotion>& motions) const;
    // add(node, force and moment) for forces and moments at the ends of two pieces.
    template <class Add>
    void scatter(const NearPieces& near, const Vec24& of_ends, const State& state, const Add& add) const;
    bool has_body(const NearPieces& near) const {
        return lines_.element_of(lines_.pieces[near.first]).is_body ||
               lines_.element_of(lines_.pieces[near.second]).is_body;
    }
    double compute_turning_work(const NearPieces& near, const Vec24& forces, const State& state) const;
    void add_tangent_with_body(const EndTangent& tangent,
                               double weight,
                               const std::vector<NodeLinearization>& linearizations,
                               const State& state,
                               const Shares& shares,
                               PairBlock& block) const;
    // From derivatives of forces and moments at the ends, by these, to those at the nodes of bodies.
    void take_to_nodes(const NearPieces& near,
                       const Vec24& forces,
                       const State& state,
                       Mat24& derivative) const;

    const Model* model_;
    const ThreadTeam* team_;
    const ScaleGroups* groups_;
    ContactLines lines_;
    bool rubs_ = false;
    bool has_impacts_ = false;
    double damping_ = 0.0;  // where there is inertia
    // What was found last, as a Newton iteration asks for it several times.
    struct Found {
        std::vector<NearPieces> pieces;
        PiecesPlaced placed;
        std::vector<Touching> touching;
        std::vector<std::optional<PairStart>> starts;  // of pieces, as far as asked for; the same for a step
    };
    mutable Found found_;
};

}  // namespace gxrod
