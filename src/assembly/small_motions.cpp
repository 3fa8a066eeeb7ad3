#include "assembly/small_motions.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "assembly/system_measures.hpp"
#include "linear/eigen/pencil.hpp"
#include "model/sections/kinked_law.hpp"
#include "model/sections/small_motion_law.hpp"
#include "model/sticking.hpp"

namespace gxrod {

namespace {

// Has the resultants and the memory of another law, and its elastic tangent, plus what relaxes in the time
// `quick`. Small motions dissipate nothing here; 1 stands for a section at its limit.
class ElasticLaw final : public SmallMotionLaw {
  public:
    ElasticLaw(std::shared_ptr<const SectionLaw> law,
               std::shared_ptr<const double> quick,
               Linearization linearization)
        : law_(std::move(law)), quick_(std::move(quick)), linearization_(linearization) {}

    int memory_size() const override { return law_->memory_size(); }
    std::string describe() const override { return law_->describe(); }
    SectionResponse respond(const Vec6& strain,
                            std::span<const double> memory,
                            double elapsed,
                            std::span<double> after) const override {
        SectionResponse response = law_->respond(strain, memory, elapsed, after);
        response.tangent = elastic_tangent(strain, memory);
        if (*quick_ > 0.0) {
            for (const auto& [time, stiffness] : relaxing_stiffness()) {
                if (time == *quick_) response.tangent += stiffness;
            }
        }
        response.dissipated = is_at_limit(strain, memory) ? 1.0 : 0.0;
        return response;
    }
    Mat6 elastic_tangent(const Vec6& strain, std::span<const double> memory) const override {
        const KinkedLaw* kinked = as_kinked(*law_);
        if (linearization_ == Linearization::elastic || kinked == nullptr)
            return find_elastic_tangent(*law_, strain, memory);
        std::vector<int> pieces(static_cast<std::size_t>(kinked->piece_count()));
        std::vector<double> after(memory.begin(), memory.end());
        kinked->find_pieces(strain, memory, pieces);
        return kinked->respond_on(pieces, strain, memory, std::numeric_limits<double>::infinity(), after)
            .tangent;
    }
    std::vector<RelaxingStiffness> relaxing_stiffness() const override {
        return list_relaxing_stiffness(*law_);
    }
    bool is_at_limit(const Vec6& strain, std::span<const double> memory) const override {
        return gxrod::is_at_limit(*law_, strain, memory);
    }

  private:
    std::shared_ptr<const SectionLaw> law_;
    std::shared_ptr<const double> quick_;
    Linearization linearization_;
};

Model linearize(Model model, const std::shared_ptr<const double>& quick, Linearization linearization) {
    const auto set = [&](std::vector<Section>& sections) {
        for (Section& section : sections) {
            if (section.law)
                section.law = std::make_shared<const ElasticLaw>(section.law, quick, linearization);
        }
    };
    set(model.sections);
    for (Rod& rod : model.rods) set(rod.varying.at_forces);
    return set_at_limit(std::move(model),
                        linearization == Linearization::elastic ? AtLimit::sticks : AtLimit::slips);
}

std::vector<double> list_relaxation_times(const Model& model) {
    std::vector<double> times;
    const auto add = [&](const std::vector<Section>& sections) {
        for (const Section& section : sections) {
            if (!section.law) continue;
            for (const RelaxingStiffness& one : list_relaxing_stiffness(*section.law))
                times.push_back(one.time);
        }
    };
    add(model.sections);
    for (const Rod& rod : model.rods) add(rod.varying.at_forces);
    std::ranges::sort(times);
    times.erase(std::ranges::unique(times).begin(), times.end());
    return times;
}

std::vector<double> compute_still_tangent(const System& system, const State& state, double time) {
    const std::vector<NodeLinearization> placements(state.trial.size(), {.placement = 1.0});
    std::vector<double> values;
    system.compute_tangent(state, time, placements, values);
    return values;
}

// By more than limits that are moved a little, and round-off, make.
bool differ(const std::vector<double>& one, const std::vector<double>& other) {
    constexpr double more_than_moved = 1e-5;
    constexpr double rounding = 1e-11;
    double largest = 0.0;
    for (const double value : one) largest = std::max(largest, std::abs(value));
    for (std::size_t i = 0; i < one.size(); ++i) {
        if (std::abs(one[i] - other[i]) > more_than_moved * std::abs(one[i]) + rounding * largest)
            return true;
    }
    return false;
}

}  // namespace

SmallMotions::SmallMotions(const System& system, Linearization linearization) : given_(&system) {
    if (!system.traits().has_laws && list_frictions(system.model()).empty()) return;
    times_ = list_relaxation_times(system.model());
    quick_ = std::make_shared<double>(0.0);
    model_ = std::make_unique<const Model>(linearize(system.model(), quick_, linearization));
    own_.emplace(*model_, system.team(), touching_groups_of(system));
}

std::vector<RelaxingMatrix> SmallMotions::compute_relaxing(const State& state, double time) const {
    std::vector<RelaxingMatrix> list;
    if (!relaxes()) return list;
    const std::vector<double> relaxed = compute_still_tangent(*own_, state, time);
    for (const double tau : times_) {
        *quick_ = tau;
        list.push_back({tau, combine(compute_still_tangent(*own_, state, time), -1.0, relaxed)});
    }
    *quick_ = 0.0;
    return list;
}

double SmallMotions::measure_length_at_limit(const State& state, double time) const {
    return own_ ? SystemMeasures(*own_).compute_law_dissipation(state, time) : 0.0;
}

std::vector<std::string> SmallMotions::list_friction_at_limit(const State& state, double time) const {
    std::vector<std::string> at_limit;
    const std::vector<std::string> listed = list_frictions(given_->model());
    if (listed.empty()) return at_limit;
    const auto tangent_of = [&](const Model& model) {
        return compute_still_tangent(System(model, given_->team(), touching_groups_of(*given_)), state, time);
    };
    const Model& model = given_->model();
    const std::vector<double> sticking = tangent_of(set_at_limit(model, AtLimit::sticks));
    if (!differ(sticking, tangent_of(set_at_limit(model, AtLimit::slips)))) return at_limit;
    // Each takes a system of its own.
    constexpr std::size_t most = 8;
    if (listed.size() > most) return {"some of " + std::to_string(listed.size()) + " joints and others"};
    for (const std::string& name : listed) {
        const Model slips = set_at_limit(set_at_limit(model, AtLimit::sticks), AtLimit::slips, name);
        if (differ(sticking, tangent_of(slips))) at_limit.push_back(name);
    }
    return at_limit;
}

}  // namespace gxrod
