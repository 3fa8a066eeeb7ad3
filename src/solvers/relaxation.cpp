#include "solvers/relaxation.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "solvers/divergence.hpp"
#include "state/increment.hpp"

namespace gxrod {

namespace {

constexpr int most_steps = 500;  // tries included
constexpr int most_kicks = 12;
constexpr int most_failures = 40;     // of pseudo-steps one after the other
constexpr double loose = 1e-4;        // tolerance of pseudo-steps
constexpr int few = 5;                // iterations after which pseudo-steps grow
constexpr double largest_move = 0.2;  // of a pseudo-step, of the length of its part
constexpr double largest_turn = 0.6;  // in rad
constexpr double settled = 2e-2;      // of these: then Newton's method is tried
constexpr double kick = 0.02;         // of a part's length, or in rad
// Of the stiffness of loads: rates of growth below it are not instabilities.
constexpr double least_rate = 1e-4;

class Fall {
  public:
    Fall(const System& system,
         const Integrator& integrator,
         const NewtonSettings& settings,
         const Stage& stage,
         SolverWorkspace& workspace,
         State& state)
        : system_(system),
          integrator_(integrator),
          settings_(settings),
          stage_(stage),
          time_(integrator.stage_time(stage)),
          workspace_(workspace),
          state_(state),
          drag_(system) {
        pseudo_settings_ = settings;
        pseudo_settings_.tolerance = loose;
        pseudo_settings_.absolute_residual = 0.0;
        if (pseudo_settings_.tangent == TangentKind::difference)
            pseudo_settings_.tangent = TangentKind::consistent;
    }

    RelaxationReport run() {
        integrator_.begin_stage(state_, stage_, system_.team());
        begin();
        int failures = 0;
        for (int tries = 0; tries < most_steps && failures < most_failures; ++tries) {
            const bool is_done = take_pseudo_step();
            failures = is_done ? 0 : failures + 1;
            if (is_done && is_settled() && find_end()) return report_;
        }
        report_.equilibrium.outcome = Outcome::out_of_iterations;
        return report_;
    }

  private:
    // Chooses the first pseudo-step: the loads, which are not in balance, move the model by little in it.
    void begin() {
        constexpr double part = 0.02;
        system_.compute_residual(state_, time_, workspace_.residual);
        load_stiffness_ = measure_load_stiffness(system_, time_, workspace_, state_);
        stiffness_ = load_stiffness_ / part;
        if (!(stiffness_ > 0.0)) stiffness_ = 1.0;
    }

    bool take_pseudo_step() {
        const std::vector<NodeMotion> before = state_.trial;
        const std::vector<JointState> joints_before = state_.joints_trial;
        const PseudoStep step(drag_, stiffness_, kicked_.empty() ? before : kicked_);
        const EquilibriumReport found =
            solve_pseudo_step({system_, integrator_, pseudo_settings_}, stage_, step, workspace_, state_);
        report_.equilibrium.iterations += found.iterations;
        measure_move(before);
        // Where the matrix has negative pivots, the step could end on the far side of what it should leave.
        const bool is_good = found.converged() && found.negative_pivots <= 0 && move_ <= 1.0;
        if (!is_good) {
            state_.trial = before;
            state_.joints_trial = joints_before;
            stiffness_ *= found.converged() && move_ <= 1.0 ? 2.0 : 4.0;
            return false;
        }
        ++report_.pseudo_steps;
        kicked_.clear();
        // Of the step just taken.
        imbalance_stiffness_ = stiffness_;
        if (found.iterations <= few && move_ < 0.5) {
            stiffness_ *= 0.25;
        } else if (found.iterations <= 2 * few) {
            stiffness_ *= 0.5;
        }
        return true;
    }

    // The largest move or turn of a node, relative to what a pseudo-step may do.
    void measure_move(const std::vector<NodeMotion>& before) {
        move_ = 0.0;
        for (std::size_t i = 0; i < before.size(); ++i) {
            const double length = system_.scale_groups().length_at(static_cast<int>(i));
            const double moved = (state_.trial[i].r - before[i].r).norm() / length;
            const double turned = state_.trial[i].Lambda.angularDistance(before[i].Lambda);
            move_ = std::max({move_, moved / largest_move, turned / largest_turn});
        }
        if (!std::isfinite(move_)) move_ = std::numeric_limits<double>::infinity();
    }

    bool is_settled() const { return move_ < settled && imbalance_stiffness_ < try_below_; }

    // Newton's method from where the model has come to. False if that leads elsewhere, or to an equilibrium
    // that the model leaves: then it gets a push in the shape in which it does.
    bool find_end() {
        const std::vector<NodeMotion> before = state_.trial;
        const std::vector<JointState> joints_before = state_.joints_trial;
        const auto undo = [&] {
            state_.trial = before;
            state_.joints_trial = joints_before;
            try_below_ = 0.1 * imbalance_stiffness_;
            return false;
        };
        const PseudoStep free(drag_, 0.0, {});
        EquilibriumReport end;
        for (const TangentKind tangent : {settings_.tangent, TangentKind::consistent}) {
            NewtonSettings newton = settings_;
            newton.tangent = tangent;
            end = solve_pseudo_step({system_, integrator_, newton}, stage_, free, workspace_, state_);
            report_.equilibrium.iterations += end.iterations;
            if (end.converged() || tangent == TangentKind::consistent) break;
            state_.trial = before;
            state_.joints_trial = joints_before;
        }
        measure_move(before);
        if (!end.converged() || move_ > 1.0) return undo();
        const double stiffness = measure_load_stiffness(system_, time_, workspace_, state_);
        const std::optional<Divergence> leaves =
            find_divergence(system_, time_, drag_, least_rate * stiffness, state_);
        if (!leaves) {
            end.iterations = report_.equilibrium.iterations;
            report_.equilibrium = end;
            return true;
        }
        if (kicks_++ == most_kicks) return undo();
        push(*leaves);
        return false;
    }

    void push(const Divergence& leaves) {
        double largest = 0.0;
        std::vector<Vec6> increments(state_.trial.size());
        for (std::size_t i = 0; i < increments.size(); ++i) {
            const int node = static_cast<int>(i);
            increments[i] = system_.equations().increment_of(node, leaves.shape);
            const double length = system_.scale_groups().length_at(node);
            largest =
                std::max({largest, increments[i].head<3>().norm() / length, increments[i].tail<3>().norm()});
        }
        kicked_ = state_.trial;
        for (std::size_t i = 0; i < increments.size(); ++i) {
            const Vec6 increment = kick / largest * increments[i];
            apply_spin(state_.previous[i], increment.head<3>(), increment.tail<3>(), kicked_[i]);
        }
        stiffness_ = 4.0 * leaves.stiffness;
        try_below_ = std::numeric_limits<double>::infinity();
    }

    const System& system_;
    const Integrator& integrator_;
    const NewtonSettings& settings_;
    NewtonSettings pseudo_settings_;
    const Stage& stage_;
    double time_;
    SolverWorkspace& workspace_;
    State& state_;
    PseudoDrag drag_;
    RelaxationReport report_;
    double load_stiffness_ = 0.0;
    double stiffness_ = 0.0;            // of the next pseudo-step
    double imbalance_stiffness_ = 0.0;  // of the last one
    double try_below_ = std::numeric_limits<double>::infinity();
    double move_ = 0.0;
    int kicks_ = 0;
    std::vector<NodeMotion> kicked_;  // to which the next pseudo-step is drawn; empty without a push
};

}  // namespace

RelaxationReport relax(const System& system,
                       const Integrator& integrator,
                       const NewtonSettings& settings,
                       const Stage& stage,
                       SolverWorkspace& workspace,
                       State& state) {
    return Fall(system, integrator, settings, stage, workspace, state).run();
}

}  // namespace gxrod
