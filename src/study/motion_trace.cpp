#include "study/motion_trace.hpp"

#include <algorithm>
#include <cmath>

#include "assembly/system_measures.hpp"
#include "machine/phase_timer.hpp"
#include "model/energy_round_off.hpp"
#include "model/evaluation_error.hpp"
#include "model/settings/analysis_traits.hpp"
#include "results/energy_warning.hpp"
#include "run/signal_board.hpp"
#include "run/stage_sequence.hpp"
#include "study/studied_stage.hpp"
#include "study/trace_sampler.hpp"

namespace gxrod {

namespace {

double total_mass(const Model& model) {
    double mass = 0.0;
    for (const Rod& rod : model.rods) {
        mass += rod.length * model.sections[static_cast<std::size_t>(rod.section)].mass(0, 0);
    }
    for (const Body& body : model.bodies) mass += body.mass;
    return mass;
}

// Adds up what acts from outside and compares it with the momenta.
class MomentumBooks {
  public:
    MomentumBooks(const System& system, double mass) : mass_(mass), length_(system.length_scale()) {}

    void add(double time, const LedgerRow& ledger, const Resultant& resultant, TraceBooks& books) {
        if (!is_begun_) {
            start_ = {ledger.linear_momentum, ledger.angular_momentum};
            is_begun_ = true;
        } else {
            const double half_step = 0.5 * (time - time_);
            impulse_.force += half_step * (last_.force + resultant.force);
            impulse_.moment += half_step * (last_.moment + resultant.moment);
        }
        time_ = time;
        last_ = resultant;
        const double scale = std::sqrt(2.0 * mass_ * std::fmax(0.0, ledger.kinetic_energy));
        const Vec3 linear = ledger.linear_momentum - start_.force - impulse_.force;
        const Vec3 angular = ledger.angular_momentum - start_.moment - impulse_.moment;
        books.momentum_scale = std::fmax(books.momentum_scale, scale);
        books.angular_scale =
            std::fmax(books.angular_scale, std::fmax(scale * length_, ledger.angular_momentum.norm()));
        books.linear_imbalance = std::fmax(books.linear_imbalance, linear.norm());
        books.angular_imbalance = std::fmax(books.angular_imbalance, angular.norm());
    }

  private:
    double mass_;
    double length_;
    bool is_begun_ = false;
    double time_ = 0.0;
    Resultant start_;    // momenta
    Resultant impulse_;  // ∫ F dt, ∫ M dt
    Resultant last_;
};

class Tracer {
  public:
    Tracer(const Problem& problem, const TraceRequest& request)
        : request_(&request),
          problem_(&problem),
          is_dynamic_(std::holds_alternative<DynamicSettings>(studied_analysis(problem))),
          stages_({problem,
                   list_rod_places(problem.output.histories),
                   list_contact_watches(problem.output.histories),
                   request.threads}),
          mass_(total_mass(problem.model)),
          round_off_(compute_energy_round_off(problem.model)),
          momenta_(stages_.analysis().system(), mass_),
          sampler_(request.sample_times, request.sample_times.back()),
          reader_(problem, request.series),
          signals_(problem) {}

    MotionTrace trace() {
        MotionTrace trace;
        trace.length = stages_.analysis().system().length_scale();
        trace.mass = mass_;
        trace.elements = static_cast<long>(SystemMeasures(stages_.analysis().system()).count_elements());
        {
            const PhaseTimer timer(trace.seconds);
            try {
                run(trace);
            } catch (const EvaluationError& error) {
                trace.failure = error.what();
            }
        }
        trace.unknowns = stages_.analysis().system().equations().count();
        trace.warnings = stages_.list_warnings();
        const std::string jump = is_dynamic_ ? "" : describe_imbalance(survey_, round_off_);
        if (!jump.empty()) trace.warnings.push_back(jump);
        trace.is_unstable = stages_.is_unstable() || !jump.empty();
        trace.samples = sampler_.samples().size();
        trace.rows.resize(request_->series.size());
        for (std::size_t k = 0; k < trace.rows.size(); ++k) {
            for (const TraceSampler::Rows& sample : sampler_.samples()) trace.rows[k].push_back(sample[k]);
        }
        return trace;
    }

  private:
    void run(MotionTrace& trace) {
        if (!accept(stages_.analysis().start(), trace) || !pass_earlier_stages(trace)) return;
        visit(trace);
        while (!stages_.analysis().finished()) {
            if (!advance(trace)) return;
            visit(trace);
        }
    }

    // What earlier stages find is not looked for: neither shapes nor branches of paths.
    bool pass_earlier_stages(MotionTrace& trace) {
        while (!stages_.is_last()) {
            const bool moves = has_steps(stages_.settings());
            if (moves) measure();
            while (moves && !stages_.analysis().finished()) {
                if (!advance(trace)) return false;
                measure();
            }
            stages_.leave_branches();
            if (!enter_next_stage(trace)) return false;
        }
        return true;
    }

    bool enter_next_stage(MotionTrace& trace) {
        const std::size_t next = stages_.index() + 1;
        if (has_steps(problem_->stages[next].analysis)) {
            for (const std::shared_ptr<Input>& input : problem_->model.inputs) input->begin_stage();
        }
        const std::optional<Failure> failure = stages_.enter_next();
        if (failure) trace.failure = "stage " + stages_.name_of(next) + ": " + describe_failure(*failure);
        return !failure;
    }

    bool advance(MotionTrace& trace) {
        if (request_->is_interrupted()) throw StudyInterrupted();
        if (is_timed(stages_.settings())) signals_.act(stages_.analysis(), stages_.axis_start());
        if (!accept(stages_.analysis().advance(), trace)) return false;
        ++trace.steps;
        trace.newton_iterations += stages_.analysis().solver_row().newton_iterations;
        return true;
    }

    bool accept(const EquilibriumReport& report, MotionTrace& trace) {
        SteppedAnalysis& analysis = stages_.analysis();
        trace.rejected_at.insert(trace.rejected_at.end(), analysis.solver_row().rejected_steps, reached_);
        if (!report.converged()) {
            trace.failure = describe_failure(analysis.explain(report));
            if (!stages_.is_last()) trace.failure = "stage " + stages_.name() + ": " + trace.failure;
        }
        return report.converged();
    }

    void measure() {
        if (!signals_.empty()) signals_.measure(stages_.analysis().snapshot(false));
    }

    void visit(MotionTrace& trace) {
        const Snapshot snapshot = stages_.analysis().snapshot(false);
        signals_.measure(snapshot);
        reached_ = snapshot.time;
        sampler_.add(snapshot.time, reader_.read(snapshot));
        trace.steps_at.resize(sampler_.samples().size(), trace.steps);
        const LedgerRow ledger = stages_.analysis().ledger_row();
        TraceBooks& books = trace.books;
        const double energy = ledger.kinetic_energy + ledger.strain_energy;
        books.largest_energy = std::max({books.largest_energy, energy, std::abs(ledger.external_work)});
        books.largest_strain_energy = std::fmax(books.largest_strain_energy, ledger.strain_energy);
        books.largest_energy_error = std::fmax(books.largest_energy_error, std::abs(ledger.energy_error));
        if (!is_dynamic_) watch_jumps(snapshot.time, ledger, books.largest_energy);
        if (is_dynamic_) momenta_.add(snapshot.time, ledger, stages_.analysis().outer_resultant(), books);
    }

    // Between equilibria of different branches.
    void watch_jumps(double load_factor, const LedgerRow& ledger, double largest_energy) {
        const double kept =
            ledger.strain_energy + ledger.dissipated_energy + ledger.contact_energy + ledger.contact_loss;
        const EnergyPoint point{load_factor, kept, ledger.external_work, ledger.work_uncertainty};
        if (load_factor > 0.0) {
            const std::optional<EnergyJump> jump = find_jump(last_point_, point, largest_energy);
            if (jump) add_jump(*jump, survey_.jumps);
        }
        survey_.largest = largest_energy;
        last_point_ = point;
    }

    const TraceRequest* request_;
    const Problem* problem_;
    bool is_dynamic_;  // the stage that is recorded
    StageSequence stages_;
    double mass_;
    double round_off_;  // of energies
    EnergySurvey survey_{.is_static = true, .jumps = {}};
    EnergyPoint last_point_;
    MomentumBooks momenta_;
    TraceSampler sampler_;
    SeriesReader reader_;
    SignalBoard signals_;
    double reached_ = 0.0;  // the time of the last step that was accepted
};

// The quantities of points that a deck without histories is judged by.
const std::vector<std::string> words_of_places{"position", "orientation"};

HistoryRequest make_end(const Model& model, int index, bool at_end) {
    const Rod& rod = model.rods[static_cast<std::size_t>(index)];
    HistoryRequest request;
    request.name = rod.name + (at_end ? ".end" : ".start");
    request.at = request.name;
    request.target = WatchedPoint{{index, at_end ? rod.element_count() - 1 : 0, at_end ? 1.0 : -1.0},
                                  at_end ? rod.element_nodes.back() : rod.element_nodes.front()};
    request.quantities = words_of_places;
    return request;
}

}  // namespace

std::vector<Series> list_series(const OutputSettings& output) {
    std::vector<Series> series;
    for (std::size_t i = 0; i < output.histories.size(); ++i) {
        const HistoryRequest& request = output.histories[i];
        const auto asks = [&](const char* word) {
            return std::ranges::find(request.quantities, word) != request.quantities.end();
        };
        for (const Quantity* quantity : quantities_of(request)) {
            const char* continuous = quantity->continuous;
            if (continuous != nullptr && asks(continuous)) continue;
            if (continuous != nullptr) quantity = &quantity_of(request.target, continuous);
            const Turning turning = request.relative_node >= 0 ? Turning::none : quantity->turning;
            const std::string name = continuous != nullptr ? "rotation" : quantity->word;
            series.push_back({request.name, name, i, quantity, turning});
        }
    }
    return series;
}

std::vector<HistoryRequest> make_end_histories(const Model& model) {
    std::vector<HistoryRequest> requests;
    for (int i = 0; i < static_cast<int>(model.rods.size()); ++i) {
        requests.push_back(make_end(model, i, false));
        requests.push_back(make_end(model, i, true));
    }
    for (int i = 0; i < static_cast<int>(model.bodies.size()); ++i) {
        const Body& body = model.bodies[static_cast<std::size_t>(i)];
        HistoryRequest request;
        request.name = body.name;
        request.at = body.name;
        request.target = WatchedBody{.index = i, .node = body.node};
        request.quantities = words_of_places;
        requests.push_back(request);
    }
    return requests;
}

SeriesReader::SeriesReader(const Problem& problem, const std::vector<Series>& series) : series_(&series) {
    for (std::size_t i = 0; i < problem.output.histories.size(); ++i) {
        watches_.emplace_back(problem.model, problem.output.histories, i);
    }
}

std::vector<HistoryRow> SeriesReader::read(const Snapshot& snapshot) {
    std::vector<HistoryRow> rows;
    rows.reserve(series_->size());
    for (const Series& series : *series_) {
        rows.push_back(watches_[series.history].compute(*series.quantity, snapshot));
    }
    return rows;
}

MotionTrace trace_motion(const Problem& problem, const TraceRequest& request) {
    return Tracer(problem, request).trace();
}

}  // namespace gxrod
