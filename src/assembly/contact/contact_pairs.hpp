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
#include "state/memory_slice.hpp"

namespace gxrod {

// The tangent of the pieces of two neighbouring elements, global axes, six rows per node.
struct PairBlock {
    NodeGroup nodes;
    Eigen::MatrixXd matrix;
};

// Contact of rods with each other and themselves, and of bodies with both, by their straight pieces
// (ContactLines). State::contact keeps the pairs of near pieces; the search is repeated when a motion could
// bring others into reach.
class ContactPairs {
  public:
    // All must outlive it. For small motions contact has no impulses.
    ContactPairs(const Model& model,
                 const ThreadTeam& team,
                 const ScaleGroups& groups,
                 bool is_for_small_motions = false);

    bool empty() const { return lines_.pieces.empty(); }
    bool rub() const { return rubs_; }
    // Does resolve_contact(System&).
    void resolve() {
        resolves_ = has_impacts_;
        has_impacts_ = false;
    }

    // The numbers in State::memory, and where they are.
    std::size_t memory_count() const { return numbers_.size(); }
    void set_memory(const MemorySlice& memory) { memory_ = memory; }

    // Finds near pieces at the trial, for nodes that can move by `reach` from there.
    void search(double reach, State& state) const;
    // Lists the groups of nodes that the tangent couples or is likely to couple: sorted, each once.
    std::vector<NodeGroup> list_groups(const State& state) const;

    // Subtracts the forces of the trial motions times a weight (ContactAssembly).
    void subtract_forces(const State& state, double weight, Residual& residual) const;
    // Computes one block for each two elements in which a pair touches or is expected to, in the order of
    // elements.
    std::vector<PairBlock> compute_tangents(const State& state,
                                            double weight,
                                            const std::vector<NodeLinearization>& linearizations) const;
    // Does the same as ContactAssembly's function, for friction and for pairs that are expected to touch.
    void replace_by_tangent_forces(const State& state, double weight, Residual& residual) const;
    void start(State& state) const;
    void advance(const std::vector<Vec6>& deltas, State& state) const;
    void commit(State& state) const;
    // Raises the drag of touching pairs if the impulses of a step that ends here add energy; returns whether
    // it was raised.
    bool counter_gain(State& state) const;

    // Lowers the limits of parts of the model whose rods would meet; these parts then get the same limit.
    // Searches first if necessary. Pieces that the whole motion would bring into contact are expected to
    // touch from then on: their forces are unknowns of the next linear solution, so that all of them come to
    // touch at once, and not one after another.
    void limit(const std::vector<Vec6>& increments,
               State& state,
               Approach approach,
               ContactLimits& limits) const;

    double compute_energy(const State& state) const;
    // Computes the work of impulses: Σ force · displacement over the step.
    double compute_work(const State& state) const;
    // Computes the power that damping dissipates, by the rates of gaps.
    double compute_damping_power(const State& state) const;
    // Computes the dissipation of friction in a step without impulses.
    double compute_slip_work(const State& state) const;
    void count(const State& state, ContactCount& result) const;
    // Adds one touch for each two elements that touch.
    void add_touches(const State& state, std::vector<ContactTouch>& touches) const;
    // Lowers the gaps of nodes next to nearer pieces.
    void lower_gaps(const State& state, std::vector<double>& gaps) const;
    // Finds the least gap of the rod; infinite if nothing can touch it.
    double find_least_gap(const ContactWatch& watch, const State& state) const;
    void add_overlaps(const State& state, std::vector<ContactOverlap>& overlaps) const;

  private:
    Segment segment_of(std::size_t piece, const std::vector<NodeMotion>& motions) const;
    std::vector<Segment> find_rates(
        const std::vector<NodeMotion>& motions) const;  // of the ends of all pieces
    std::vector<Segment> find_segments(
        const std::vector<NodeMotion>& motions) const;  // segments of all pieces
    // Bounds the motion of all pieces.
    double find_reach(const std::vector<Vec6>& increments) const;
    NodeGroup list_nodes(int a, int b) const;  // nodes of two elements
    PairLaw law_of(const NearPieces& near) const;
    double largest_skin() const;
    // Finds the share of the motion by which all pieces may move, if they reach `reach` from their axes,
    // before the next search.
    double find_room(double reach, State& state) const;
    // The places of all pieces now, and at the start of a step.
    struct PiecesPlaced {
        std::vector<Segment> now, before;
        double damping = 0.0;  // factor of the gap's change in the step
        // With restitution, of each near pair: that factor, or that of the rate where contact is no impulse.
        std::vector<double> dampings{};
        double drag = 0.0;
        std::vector<Segment> rates;  // velocities of the ends, where they damp

        bool operator==(const PiecesPlaced&) const = default;
    };
    PiecesPlaced place_pieces(const State& state) const;
    bool bounces() const { return !numbers_.empty(); }
    // Returns the speed at which two pieces approach each other.
    double find_approach(const NearPieces& near,
                         const std::vector<Segment>& segments,
                         const std::vector<Segment>& rates) const;
    void find_restitutions();
    // Return the numbers of a pair of shapes of bodies: among all such pairs, and τ v.
    std::optional<std::size_t> find_shape_pair(const NearPieces& near) const;
    double number_of(const NearPieces& near) const;
    std::vector<double> find_dampings(const State& state) const;
    void keep_tractions(State& state) const;
    void keep_speeds(State& state) const;
    struct PairLimit {
        double fraction = 1.0;
        double gap = 0.0;
        bool can_meet = false;
    };
    // The motions of a piece's ends; for a piece of a body, also the distance of its path from its chord.
    struct PieceMotion {
        Segment chord;
        double aside = 0.0;
    };
    PieceMotion find_motion(std::size_t piece,
                            double part,
                            const State& state,
                            const std::vector<Vec6>& increments) const;
    std::vector<PieceMotion> find_motions(const State& state, const std::vector<Vec6>& increments) const;
    // Increments of nodes, and the resulting motions of pieces.
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
    // A pair that is expected to touch: force and stiffness by the gap, and the gap's derivatives by the
    // ends.
    struct Expected {
        double force = 0.0, stiffness = 0.0;
        Vec12 slope;
    };
    std::optional<Expected> find_expected(std::size_t index, const State& state) const;
    ContactLaw expected_law_of(const NearPieces& near) const;
    // Finds the pieces' length relative to the reach of a crossing, at most 1.
    double find_share_of_crossing(const NearPieces& near) const;
    // Finds the energy, including the contribution of a rod's end, whose integral is finite where it touches.
    PairEnergy find_energy(const NearPieces& near, const std::vector<Segment>& segments) const;
    double compute_energy_before(const State& state) const;  // at the start of a step
    // Returns the sum of value(item), the same for any number of threads.
    template <class Item, class Value>
    double sum_of(const std::vector<Item>& items, const Value& value) const;
    // A touching pair of State::contact.pieces, by index.
    struct Touching {
        std::size_t index = 0;
        PairEnergy energy;      // friction acts by it
        PairEnergy impulse;     // the forces of a step: turned; else the same as those of the energy
        double by_rates = 0.0;  // times G Gᵀ: the derivative of the gradient G by the rates that damp it
        double damping_power = 0.0;
    };
    // Finds touching pairs with damped forces. The result lasts until the next call.
    const std::vector<Touching>& find_touching(const State& state) const;
    // A pair that touches, or is expected to; then `touching` is nullptr.
    struct Tangible {
        std::pair<int, int> elements;
        std::size_t index = 0;
        const Touching* touching = nullptr;
    };
    std::vector<Tangible> list_tangible(const State& state) const;  // sorted
    // Forces and moments at the ends, and their derivatives by positions and rotations there.
    struct EndTangent {
        std::size_t index = 0;
        Vec24 forces = Vec24::Zero();  // for pairs with a body
        Mat24 derivative = Mat24::Zero();
        Mat24 by_rates = Mat24::Zero();
    };
    EndTangent find_end_tangent(const Tangible& one, const State& state) const;
    // Computes the block of pairs between the same two elements.
    PairBlock compute_block(std::span<const Tangible> those,
                            const State& state,
                            double weight,
                            const std::vector<NodeLinearization>& linearizations) const;
    PairIncrement find_increment(const NearPieces& near,
                                 const std::vector<Vec6>& deltas,
                                 const State& state) const;
    // The shares of nodes in the four ends.
    using Shares = Eigen::Matrix<double, 4, Eigen::Dynamic>;
    Shares find_shares(const NearPieces& near, const NodeGroup& nodes) const;
    int element_of(std::uint32_t piece) const {
        return lines_.places.places[lines_.pieces[piece].place].element;
    }
    // Returns the motion of a pair, with all pieces at the places of the last find_touching.
    PairMotion motion_of(const NearPieces& near, const State& state) const;
    OpenEnds open_ends(const NearPieces& near) const;
    std::uint32_t find_next(std::uint32_t piece, int steps) const;  // along its rod
    // Moves from two pieces along both rods to the nearest ones.
    NearPieces find_nearest(NearPieces near, const std::vector<Segment>& segments) const;
    PairStart find_start(const NearPieces& near, const std::vector<Segment>& before) const;
    double coefficient_of(const NearPieces& near) const;
    // Sets how the coefficient depends on direction and speed.
    void set_friction_shape(const NearPieces& near, const State& state, CoulombFriction& friction) const;
    double friction_stiffness_of(const NearPieces& near) const;
    // Return the friction by the law, and as an iteration assumes it.
    CoulombFriction friction_of(std::size_t index, const State& state) const;
    CoulombFriction taken_friction_of(std::size_t index, const State& state) const;
    void keep_slip(std::size_t index, const CoulombFriction& friction, State& state) const;
    double least_gap(const NearPieces& near, const std::vector<NodeMotion>& motions) const;
    // Calls add(node, force and moment) for forces and moments at the ends of two pieces.
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
    // Takes derivatives of forces and moments at the ends to derivatives at the nodes of bodies.
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
    bool resolves_ = false;  // motions with inertia in which contact is not an impulse
    double damping_ = 0.0;   // with inertia
    // τ v of restitution for each pair of shapes of bodies, negative without it; empty if none has it.
    std::vector<double> numbers_;
    MemorySlice memory_;  // the speed at which each such pair met, 0 where it does not touch
    // The last result, cached since a Newton iteration asks for it several times.
    struct Found {
        std::vector<NearPieces> pieces;
        PiecesPlaced placed;
        std::vector<Touching> touching;
        std::vector<std::optional<PairStart>> starts;  // for pieces, computed on demand; constant in a step
    };
    mutable Found found_;
};

}  // namespace gxrod
