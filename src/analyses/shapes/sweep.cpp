#include "analyses/shapes/sweep.hpp"

#include <algorithm>
#include <limits>
#include <optional>

#include "analyses/shapes/eigenvalues.hpp"
#include "analyses/shapes/mode_tracking.hpp"
#include "analyses/shapes/onset.hpp"
#include "assembly/touching_system.hpp"

namespace gxrod {

namespace {

using Complex = std::complex<double>;

// So many more are found, as may come in from beyond.
constexpr int spare = 3;
constexpr double lost = std::numeric_limits<double>::quiet_NaN();

class Sweep {
  public:
    Sweep(const FindSweepState& find_state, const SweepSettings& settings)
        : find_state_(find_state), settings_(settings) {}

    SweepRecord run(const std::vector<double>& values) {
        std::optional<Found> before;
        for (const double value : values) {
            Found found = find(value);
            if (found.failure.empty()) {
                if (before) {
                    follow(*before, found, settings_.halvings);
                } else {
                    start(found);
                }
            }
            add_point(found);
            if (found.failure.empty()) before = std::move(found);
        }
        if (settings_.keeps_shapes) fill_shapes();
        if (settings_.finds_onset) find_onsets();
        return std::move(record_);
    }

  private:
    struct Found {
        double value = 0.0;
        double speed = 0.0;
        std::string failure;
        std::vector<Complex> lambdas;
        std::vector<std::string> words;
        std::vector<Eigenmode> modes;   // if shapes are kept
        std::vector<NodeMotion> nodes;  // likewise
        ModeTraces traces;
        std::vector<int> followed;  // which of these each mode that is followed has become; −1: lost
        std::vector<double> corruption;
    };

    EigenvalueSettings make_settings(bool left) const {
        EigenvalueSettings settings = settings_.eigenvalues;
        settings.count += spare;
        settings.left = left;
        settings.first_steps = steps_;
        return settings;
    }

    Found find(double value) {
        Found found;
        found.value = value;
        const SweepState state = find_state_(value);
        ++record_.equilibria;
        found.failure = state.failure;
        found.speed = state.speed;
        if (!found.failure.empty()) return found;
        const TouchingSystem touching(*state.system, *state.state);
        const System& system = touching.system();
        const StateMatrices matrices = state.frame
                                           ? state.frame->compute_matrices(*state.state, state.time)
                                           : compute_state_matrices(system, touching.state(), state.time);
        const EigenvaluesRecord record =
            find_eigenvalues(system, touching.state(), state.time, make_settings(true), matrices);
        found.failure = record.failure;
        steps_ = record.steps;
        for (const Eigenmode& mode : record.modes) {
            found.lambdas.push_back(mode.lambda());
            found.words.push_back(mode.shape.words);
        }
        found.traces = make_traces(system, matrices, record.modes);
        if (!settings_.keeps_shapes) return found;
        found.modes = record.modes;
        found.nodes = touching.state().trial;
        return found;
    }

    std::vector<Complex> find_lambdas(double value) {
        const SweepState state = find_state_(value);
        ++record_.equilibria;
        if (!state.failure.empty()) return {};
        std::vector<Complex> lambdas;
        const TouchingSystem touching(*state.system, *state.state);
        for (const Eigenmode& mode :
             find_eigenvalues(
                 touching.system(), touching.state(), state.time, make_settings(false), state.frame)
                 .modes)
            lambdas.push_back(mode.lambda());
        return lambdas;
    }

    void start(Found& found) {
        followed_ = std::min(static_cast<std::size_t>(settings_.eigenvalues.count), found.lambdas.size());
        for (std::size_t i = 0; i < followed_; ++i) {
            found.followed.push_back(static_cast<int>(i));
            record_.words.push_back(found.words[i]);
        }
        found.corruption.assign(followed_, 0.0);
    }

    // By values in between, where that is not clear.
    void follow(const Found& before, Found& after, int halvings) {
        const std::vector<ModeMatch> matches = match_modes(before.traces, after.traces);
        after.followed.assign(followed_, -1);
        after.corruption.assign(followed_, 1.0);
        bool is_clear = true;
        for (std::size_t i = 0; i < followed_; ++i) {
            if (before.followed[i] < 0) continue;
            const ModeMatch& match = matches[static_cast<std::size_t>(before.followed[i])];
            after.followed[i] = match.mode;
            after.corruption[i] = match.corruption;
            is_clear = is_clear && match.mode >= 0 && match.corruption <= settings_.most_corruption;
        }
        if (is_clear || halvings == 0) return;
        Found between = find(0.5 * (before.value + after.value));
        if (!between.failure.empty()) return;
        follow(before, between, halvings - 1);
        follow(between, after, halvings - 1);
        for (std::size_t i = 0; i < followed_; ++i)
            after.corruption[i] = std::max(after.corruption[i], between.corruption[i]);
    }

    void add_point(const Found& found) {
        SweepRecord::Point point;
        point.value = found.value;
        point.speed = found.speed;
        point.failure = found.failure;
        point.growth = find_growth(found.lambdas);
        point.is_growing = is_growing(found.lambdas);
        point.corruption = found.corruption;
        for (const int mode : found.followed) {
            const auto at = static_cast<std::size_t>(mode);
            point.lambda.push_back(mode < 0 ? Complex(lost) : found.lambdas[at]);
            point.words.push_back(mode < 0 ? std::string() : found.words[at]);
            if (!found.nodes.empty()) point.modes.push_back(mode < 0 ? Eigenmode{} : found.modes[at]);
        }
        point.nodes = found.nodes;
        record_.points.push_back(std::move(point));
    }

    // Modes that were lost, and all of a value without equilibrium, rest where the last equilibrium was, so
    // that each value has as many shapes.
    void fill_shapes() {
        const auto is_known = [](const SweepRecord::Point& point) { return !point.nodes.empty(); };
        const auto first = std::ranges::find_if(record_.points, is_known);
        if (first == record_.points.end()) return;
        std::vector<NodeMotion> nodes = first->nodes;
        for (SweepRecord::Point& point : record_.points) {
            if (is_known(point)) nodes = point.nodes;
            point.nodes = nodes;
            point.modes.resize(followed_);
            for (Eigenmode& mode : point.modes) {
                mode.shape.nodes.resize(nodes.size(), Vec6::Zero());
                mode.imaginary.resize(nodes.size(), Vec6::Zero());
            }
        }
    }

    void find_onsets() {
        const auto lambdas_at = [this](double value) { return find_lambdas(value); };
        const SweepRecord::Point* before = nullptr;
        for (const SweepRecord::Point& point : record_.points) {
            if (!point.failure.empty()) continue;
            if (before && before->is_growing != point.is_growing) {
                const SweepRecord::Point& stable = point.is_growing ? *before : point;
                const SweepRecord::Point& unstable = point.is_growing ? point : *before;
                std::optional<Onset> onset = find_onset(lambdas_at, stable.value, unstable.value);
                if (onset) {
                    onset->begins = point.is_growing;
                    record_.onsets.push_back(*onset);
                }
            }
            before = &point;
        }
    }

    const FindSweepState& find_state_;
    const SweepSettings& settings_;
    std::size_t followed_ = 0;
    std::int64_t steps_ = 0;  // that the last point took
    SweepRecord record_;
};

}  // namespace

SweepRecord sweep_eigenvalues(const std::vector<double>& values,
                              const FindSweepState& find_state,
                              const SweepSettings& settings) {
    return Sweep(find_state, settings).run(values);
}

}  // namespace gxrod
