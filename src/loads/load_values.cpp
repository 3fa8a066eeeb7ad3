#include "loads/load_values.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>

#include "loads/distributed_load.hpp"
#include "loads/nodal_load.hpp"
#include "model/sections/element_lengths.hpp"
#include "model/time/breaks.hpp"

namespace gxrod {

namespace {

// What a whole rod is cut into at least; each part is looked at in five places or more.
constexpr double fewest_pieces_of_rod = 16.0;
// Places in which the switches of a load are looked at along a rod.
constexpr int break_samples = 64;

// The six functions of a load.
template <class Visitor>
void for_each_component(const DistributedLoad& load, const Visitor& visit) {
    for (const LineFunction& component : load.force) visit(component);
    for (const LineFunction& component : load.moment) visit(component);
}

// What is known of all of a load: constants next to something proportional to t make it varying.
LineForm find_form(const DistributedLoad& load) {
    LineForm form{InTime::constant, true};
    bool is_first = true;
    for_each_component(load, [&](const LineFunction& component) {
        if (component.is_zero()) return;
        const LineForm& own = component.form();
        form.is_even = form.is_even && own.is_even;
        form.in_time = is_first || form.in_time == own.in_time ? own.in_time : InTime::varying;
        is_first = false;
    });
    return form;
}

Interval range_of(const Rod& rod) {
    const auto [first, last] = std::minmax_element(rod.arc_length.begin(), rod.arc_length.end());
    return {*first, *last};
}

}  // namespace

LoadValues::LoadValues(const Model& model, std::vector<LoadedElement> elements)
    : model_(&model), elements_(std::move(elements)), nodal_(model.loads.size(), Vec6::Zero()) {
    first_moment_.reserve(elements_.size() + 1);
    std::size_t count = 0;
    for (const LoadedElement& element : elements_) {
        first_moment_.push_back(count);
        count += moment_count(*element.load, element.nodes.size());
        any_turns_ = any_turns_ || element.load->frame != Frame::spatial;
    }
    first_moment_.push_back(count);
    moments_.assign(count, Vec6::Zero());
    distributed_.resize(model.distributed_loads.size());
    for (std::size_t i = 0; i < distributed_.size(); ++i) describe(i);
    if (elements_.empty()) return;
    dead_.assign(model.nodes.size(), Vec6::Zero());
    if (any_turns_) total_.assign(model.nodes.size(), Vec6::Zero());
}

void LoadValues::describe(std::size_t load) {
    Along& along = distributed_[load];
    const DistributedLoad& given = model_->distributed_loads[load];
    const Rod& rod = model_->rods[given.rod];
    along.first_element = load == 0 ? 0 : distributed_[load - 1].last_element;
    along.last_element = along.first_element + static_cast<std::size_t>(rod.element_count());
    along.form = find_form(given);
    // Of the longest element.
    const double share = find_element_lengths(rod).most / rod.length;
    along.pieces = std::max(1, static_cast<int>(std::ceil(share * fewest_pieces_of_rod - 1e-9)));
    Switches fixed;
    for_each_component(given, [&](const LineFunction& component) {
        if (component.switches() == nullptr || component.form().is_even) return;
        for (const Switch& one : *component.switches()) {
            if (!one.has_arc_length) continue;
            const bool moves = one.has_time && along.form.in_time == InTime::varying;
            (moves ? along.moving : fixed).push_back(one);
        }
    });
    if (!fixed.empty()) along.fixed_breaks = find_breaks_along(fixed, 1.0, range_of(rod), break_samples);
}

std::span<Vec6> LoadValues::moments_of(std::size_t element) {
    return std::span(moments_).subspan(first_moment_[element],
                                       first_moment_[element + 1] - first_moment_[element]);
}

void LoadValues::integrate(std::size_t load, double time) {
    const Along& along = distributed_[load];
    const DistributedLoad& given = model_->distributed_loads[load];
    if (along.form.is_even) {
        const Vec6 q = compute_load_per_length(given, time, 0.0);
        for (std::size_t e = along.first_element; e < along.last_element; ++e) {
            integrate_even_load(elements_[e], q, moments_of(e));
        }
        return;
    }
    std::vector<double> breaks = along.fixed_breaks;
    if (!along.moving.empty()) {
        const Interval range = range_of(model_->rods[given.rod]);
        const std::vector<double> moving = find_breaks_along(along.moving, time, range, break_samples);
        breaks.insert(breaks.end(), moving.begin(), moving.end());
        std::sort(breaks.begin(), breaks.end());
    }
    for (std::size_t e = along.first_element; e < along.last_element; ++e) {
        integrate_load(elements_[e], {time, breaks, along.pieces}, moments_of(e));
    }
}

void LoadValues::update(std::size_t load, double time) {
    Along& along = distributed_[load];
    if (along.first_element == along.last_element) return;
    const std::size_t first = first_moment_[along.first_element];
    const std::size_t count = first_moment_[along.last_element] - first;
    const bool is_proportional = along.form.in_time == InTime::proportional;
    if (along.form.in_time == InTime::varying) {
        integrate(load, time);
    } else if (!along.is_known) {
        integrate(load, 1.0);
        if (is_proportional) along.unit_moments.assign(&moments_[first], &moments_[first] + count);
        along.is_known = true;
    }
    if (!is_proportional) return;
    for (std::size_t i = 0; i < count; ++i) moments_[first + i] = time * along.unit_moments[i];
}

void LoadValues::sum_dead_loads() {
    std::fill(dead_.begin(), dead_.end(), Vec6::Zero());
    for (std::size_t e = 0; e < elements_.size(); ++e) {
        const LoadedElement& element = elements_[e];
        if (element.load->frame != Frame::spatial) continue;
        const std::span<const Vec6> shares = moments(e);
        for (std::size_t i = 0; i < element.nodes.size(); ++i) dead_[element.nodes[i]] += shares[i];
    }
}

void LoadValues::forget() {
    time_.reset();
    for (Along& along : distributed_) along.is_known = false;
}

void LoadValues::move_to(double time) {
    if (time_ == time) return;
    time_.reset();
    for (std::size_t i = 0; i < nodal_.size(); ++i) nodal_[i] = evaluate_load(model_->loads[i], time);
    bool changes = false;
    for (std::size_t i = 0; i < distributed_.size(); ++i) {
        changes = changes || distributed_[i].form.in_time != InTime::constant || !distributed_[i].is_known;
        update(i, time);
    }
    if (changes) sum_dead_loads();
    time_ = time;
}

const std::vector<Vec6>& LoadValues::add_distributed(const std::vector<NodeMotion>& motions) {
    if (!any_turns_) return dead_;
    total_ = dead_;
    for (std::size_t e = 0; e < elements_.size(); ++e) {
        if (elements_[e].load->frame == Frame::spatial) continue;
        add_distributed_load(elements_[e], {*time_, moments(e)}, motions, total_);
    }
    return total_;
}

}  // namespace gxrod
