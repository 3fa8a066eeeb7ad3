#include <algorithm>

#include "assembly/contact/contact_assembly.hpp"
#include "contact/restitution.hpp"

// Restitution: damping by the speed at which a place met an obstacle, or two pieces each other.
namespace gxrod {
namespace {

// τ v; below 0 without restitution.
double find_number(const std::optional<double>& restitution) {
    return restitution ? find_damping_number(*restitution) : -1.0;
}

}  // namespace

void ContactAssembly::find_restitutions() {
    if (!model_->contact.has_restitution()) return;
    const ContactExceptions exceptions(model_->contact, places_);
    for (const ObstacleSurface& surface : surfaces_) {
        for (std::size_t e = 0; e < places_.elements.size(); ++e) {
            numbers_.push_back(find_number(exceptions.find_restitution_at_obstacle(e, surface.obstacle)));
        }
    }
    if (std::ranges::all_of(numbers_, [](double one) { return one < 0.0; })) numbers_.clear();
}

double ContactAssembly::approach_before(const At& at,
                                        std::size_t obstacle,
                                        std::size_t place,
                                        const State& state) const {
    const ObstacleDistance before = distance_before(at, obstacle, place, state);
    const ContactPlace& own = places_.places[place];
    Vec3 velocity = places_.velocity(own, state.previous);
    if (!at.around.empty() && surfaces_[obstacle].body->motion) {
        const Vec3 point = places_.position(own, state.previous) - before.distance * before.normal;
        const Vec3 start = at.before[obstacle].to_start(point);
        for (std::size_t k = 0; k < at.weights_before.size(); ++k)
            velocity -= at.weights_before[k] * (at.around[obstacle][k].from_start(start) - point);
    }
    return std::max(-before.slope * before.normal.dot(velocity), 0.0);
}

double ContactAssembly::damping_time(const At& at,
                                     std::size_t obstacle,
                                     std::size_t place,
                                     const State& state) const {
    if (numbers_.empty()) return model_->contact.damping;
    const ContactElement& element = places_.element_of(place);
    const double number = numbers_[obstacle * places_.elements.size() + places_.index_of(element)];
    if (number < 0.0) return model_->contact.damping;
    if (number == 0.0) return 0.0;
    const double speed =
        std::max(speed_memory(obstacle, element).of(state)[0], approach_before(at, obstacle, place, state));
    return speed > 0.0 ? number / speed : 0.0;
}

double ContactAssembly::impulse_damping(const At& at,
                                        std::size_t obstacle,
                                        std::size_t place,
                                        const State& state) const {
    if (numbers_.empty()) return at.damping;
    if (!at.has_impacts || !(at.elapsed > 0.0)) return 0.0;
    return damping_time(at, obstacle, place, state) / at.elapsed;
}

double ContactAssembly::find_kept_speed(const At& at,
                                        std::size_t obstacle,
                                        const ContactElement& element,
                                        const State& state) const {
    if (is_far(at, obstacle, element, state)) return 0.0;
    const double range = surfaces_[obstacle].body->stiffness ? 0.0 : element.law.skin;
    double speed = speed_memory(obstacle, element).of(state)[0];
    bool touches = false;
    for (std::size_t p = element.first_place; p < element.end_place; ++p) {
        const Vec3 position = places_.position(places_.places[p], state.trial);
        if (is_beyond(at, obstacle, p, position, state)) continue;
        const SurfaceTouch surface = touch(at, obstacle, p, position);
        if (surface.gap >= range) continue;
        touches = true;
        speed = std::max({speed,
                          approach_before(at, obstacle, p, state),
                          -find_gap_rate(at, obstacle, p, surface, state).rate});
    }
    return touches ? speed : 0.0;
}

void ContactAssembly::keep_speeds(const At& at, State& state) const {
    team_->for_each_range(places_.elements.size(), [&](std::size_t first, std::size_t last) {
        for (std::size_t e = first; e < last; ++e) {
            const ContactElement& element = places_.elements[e];
            for (std::size_t obstacle = 0; obstacle < surfaces_.size(); ++obstacle) {
                if (!(numbers_[obstacle * places_.elements.size() + e] > 0.0)) continue;
                const bool moves_in_time = has_impacts_ || resolves_;
                const double speed = moves_in_time ? find_kept_speed(at, obstacle, element, state) : 0.0;
                speed_memory(obstacle, element).of(state)[0] = speed;
            }
        }
    });
}

void ContactPairs::find_restitutions() {
    if (!model_->contact.has_restitution() || !lines_.is_between_rods) return;
    // Shapes come after all elements of rods.
    const std::size_t count = model_->contact.bodies.size();
    const std::size_t first = lines_.places.elements.size() - count;
    for (std::size_t b = 1; b < count; ++b) {
        for (std::size_t a = 0; a < b; ++a)
            numbers_.push_back(find_number(lines_.exceptions.find_restitution(first + a, first + b)));
    }
    if (std::ranges::all_of(numbers_, [](double one) { return one < 0.0; })) numbers_.clear();
}

std::optional<std::size_t> ContactPairs::find_shape_pair(const NearPieces& near) const {
    const int a = lines_.element_of(lines_.pieces[near.first]).shape;
    const int b = lines_.element_of(lines_.pieces[near.second]).shape;
    if (a < 0 || b < 0) return std::nullopt;
    const auto low = static_cast<std::size_t>(std::min(a, b)),
               high = static_cast<std::size_t>(std::max(a, b));
    return high * (high - 1) / 2 + low;
}

double ContactPairs::number_of(const NearPieces& near) const {
    const std::optional<std::size_t> pair = find_shape_pair(near);
    return pair ? numbers_[*pair] : -1.0;
}

double ContactPairs::find_approach(const NearPieces& near,
                                   const std::vector<Segment>& segments,
                                   const std::vector<Segment>& rates) const {
    const ClosestPoints closest = find_closest_points(segments[near.first], segments[near.second]);
    if (closest.distance == 0.0) return 0.0;
    const Vec3 velocity = rates[near.first].at(closest.s) - rates[near.second].at(closest.t);
    return std::max(-closest.offset.dot(velocity) / closest.distance, 0.0);
}

std::vector<double> ContactPairs::find_dampings(const State& state) const {
    const std::vector<NearPieces>& pieces = state.contact.pieces;
    std::vector<double> dampings(pieces.size(), 0.0);
    const double elapsed = state.trial_time - state.time;
    if (has_impacts_ && !(elapsed > 0.0)) return dampings;
    const std::vector<Segment> before = find_segments(state.previous), rates = find_rates(state.previous);
    const double part = has_impacts_ ? 1.0 / elapsed : 1.0;
    team_->for_each_range(pieces.size(), [&](std::size_t first, std::size_t last) {
        for (std::size_t i = first; i < last; ++i) {
            const double number = number_of(pieces[i]);
            if (number < 0.0) dampings[i] = part * damping_;
            if (!(number > 0.0)) continue;
            const double met = memory_.of(state)[*find_shape_pair(pieces[i])];
            const double speed = std::max(met, find_approach(pieces[i], before, rates));
            if (speed > 0.0) dampings[i] = part * number / speed;
        }
    });
    return dampings;
}

void ContactPairs::keep_speeds(State& state) const {
    const std::vector<double> met(memory_.of(state).begin(), memory_.of(state).end());
    std::ranges::fill(memory_.of(state), 0.0);
    if (!has_impacts_ && !resolves_) return;
    const std::vector<Segment> before = find_segments(state.previous), now = find_segments(state.trial);
    const std::vector<Segment> rates_before = find_rates(state.previous), rates = find_rates(state.trial);
    for (const Touching& touching : find_touching(state)) {
        const NearPieces& near = state.contact.pieces[touching.index];
        if (!(number_of(near) > 0.0)) continue;
        const std::size_t pair = *find_shape_pair(near);
        memory_.of(state)[pair] =
            std::max({met[pair], find_approach(near, before, rates_before), find_approach(near, now, rates)});
    }
}

}  // namespace gxrod
