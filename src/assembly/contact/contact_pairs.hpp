#pragma once

#include <Eigen/Core>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include "assembly/contact/contact_limits.hpp"
#include "assembly/contact/contact_lines.hpp"
#include "assembly/contact/contact_overlap.hpp"
#include "assembly/node_groups.hpp"
#include "assembly/residual.hpp"
#include "assembly/scale_groups.hpp"
#include "contact/pair_friction.hpp"
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
    bool rub() const { return friction_ > 0.0; }

    // Finds what is near the trial, if nodes can move by this much from there.
    void search(double reach, State& state) const;
    // The groups of nodes that the tangent couples: sorted, each once.
    std::vector<NodeGroup> list_groups(const State& state) const;

    // Of the trial motions, by a weight (ContactAssembly).
    void subtract_forces(const State& state, double weight, Residual& residual) const;
    // One block for each of list_groups in which something touches, in their order.
    std::vector<PairBlock> compute_tangents(const State& state,
                                            double weight,
                                            const std::vector<NodeLinearization>& linearizations) const;
    // As ContactAssembly's, of friction; where pieces rub.
    void replace_by_tangent_forces(const State& state, double weight, Residual& residual) const;
    void start(State& state) const;
    void advance(const std::vector<Vec6>& deltas, State& state) const;
    void commit(State& state) const;

    // Lowers the limits of parts of the model whose rods would meet; these then go equally far. Searches
    // first where it has to.
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
    // Of the rod; infinite where nothing can touch it.
    double find_least_gap(const ContactWatch& watch, const State& state) const;
    void add_overlaps(const State& state, std::vector<ContactOverlap>& overlaps) const;

  private:
    Segment segment_of(std::size_t piece, const std::vector<NodeMotion>& motions) const;
    NodeGroup list_nodes(int a, int b) const;  // of two elements
    PairLaw law_of(const NearPieces& near) const;
    // With what the end of a rod adds, whose integral is finite where it touches.
    PairEnergy find_energy(const NearPieces& near, const std::vector<NodeMotion>& motions) const;
    // Of State::contact.pieces, by index.
    struct Touching {
        std::size_t index = 0;
        PairEnergy energy;
    };
    std::vector<Touching> find_touching(const State& state) const;
    // Of nodes in the four ends.
    using Shares = Eigen::Matrix<double, 4, Eigen::Dynamic>;
    Shares find_shares(const NearPieces& near, const NodeGroup& nodes) const;
    int element_of(std::uint32_t piece) const {
        return lines_.places.places[lines_.pieces[piece].place].element;
    }
    PairMotion motion_of(const NearPieces& near, const State& state) const;
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
    // Of a place of a body: where forces act on it, from its node.
    Vec3 find_lever(const ContactPlace& place, const State& state) const;
    double compute_turning_work(const NearPieces& near, const Vec24& forces, const State& state) const;
    void add_tangent_with_body(const Touching& touching,
                               double weight,
                               const std::vector<NodeLinearization>& linearizations,
                               const State& state,
                               const Mat24* rubbing,
                               const Shares& shares,
                               PairBlock& block) const;
    // From derivatives of forces and moments at the ends, by these, to those at the nodes of bodies.
    void take_to_nodes(const NearPieces& near,
                       const Vec24& forces,
                       const State& state,
                       Mat24& derivative) const;
    // How the ends of a piece move, and how far the way of one of a body leaves its chord.
    struct PieceMotion {
        Segment chord;
        double aside = 0.0;
    };
    PieceMotion find_motion(std::size_t piece,
                            double part,
                            const State& state,
                            const std::vector<Vec6>& increments) const;

    const Model* model_;
    const ThreadTeam* team_;
    const ScaleGroups* groups_;
    ContactLines lines_;
    double friction_ = 0.0;
};

}  // namespace gxrod
