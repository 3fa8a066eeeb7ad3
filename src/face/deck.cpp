#include "face/deck.hpp"

#include <fmt/format.h>

#include "check/findings/plausibility.hpp"
#include "check/findings/unit_questions.hpp"
#include "check/model_examination.hpp"
#include "deck/rods/imperfections.hpp"
#include "deck/text/overrides.hpp"
#include "deck/text/program_laws.hpp"
#include "face/own_laws.hpp"
#include "run/imperfect_shapes.hpp"

namespace gxrod {
namespace {

// Decks that are built here can have imperfections by a mode.
[[maybe_unused]] const bool finds_modes = set_mode_finder(find_imperfect_mode);

}  // namespace

Deck::Deck(const std::filesystem::path& path) : read_(std::make_shared<const DeckTemplate>(path)) {}

Deck Deck::from_text(std::string text, const std::filesystem::path& file) {
    return Deck(std::make_shared<const DeckTemplate>(std::move(text), file));
}

Deck& Deck::set(const std::string& key, const std::string& value) {
    std::erase_if(overrides_, [&](const std::string& one) { return one.starts_with(key + "="); });
    overrides_.push_back(key + "=" + value);
    return *this;
}

Deck& Deck::set_all(const std::vector<std::string>& overrides) {
    overrides_.insert(overrides_.end(), overrides.begin(), overrides.end());
    return *this;
}

Deck& Deck::set(const std::string& key, double value) { return set(key, fmt::format("{}", value)); }

Deck& Deck::set(const std::string& key, std::initializer_list<double> values) {
    return set(key, fmt::format("[{}]", fmt::join(values, ", ")));
}

Deck& Deck::set(const std::string& key, const std::vector<Vec3>& points) {
    std::string text;
    for (const Vec3& point : points)
        text += fmt::format("{}[{}, {}, {}]", text.empty() ? "" : ", ", point.x(), point.y(), point.z());
    return set(key, "[" + text + "]");
}

Deck& Deck::add(std::function<void(Problem&)> change) {
    changes_.push_back(std::move(change));
    return *this;
}

Deck& Deck::set_law(const std::string& section, std::shared_ptr<const SectionLaw> law) {
    return add([section, law = std::move(law)](Problem& problem) { set_section_law(section, law, problem); });
}

Deck& Deck::set_law(const std::string& section, std::function<SectionResponse(const Vec6&)> law) {
    return set_law(section, std::make_shared<const ElasticLaw>(std::move(law)));
}

Deck& Deck::set_force(const std::string& spring, std::function<double(double)> force) {
    return add([spring, force = std::move(force)](Problem& problem) {
        const auto by_length = [force](double length, double) { return force(length); };
        set_spring_force(spring, {by_length, false}, problem);
    });
}

Deck& Deck::set_force(const std::string& spring, SpringLaw::Force force) {
    return add([spring, force = std::move(force)](Problem& problem) {
        set_spring_force(spring, {force, true}, problem);
    });
}

Deck& Deck::set_force(std::size_t load, MotionForce force) {
    return add([load, force = std::move(force)](Problem& problem) { set_load_force(load, force, problem); });
}

Deck& Deck::set_input(const std::string& input, std::function<double(double)> course) {
    return add([input, course = std::move(course)](Problem& problem) { set_course(input, course, problem); });
}

Problem Deck::build() const { return build(false); }

Problem Deck::build_varied() const { return build(true); }

Problem Deck::build(bool is_varied) const {
    for (const std::string& one : overrides_) {
        const std::string key = one.substr(0, one.find('='));
        const std::string lack = describe_missing_parameter(key, read_->tree());
        if (!lack.empty()) throw DeckError({{"--set " + one, 0, 0, key, "the deck has no " + lack}});
    }
    Problem problem = read_->build(overrides_, is_varied);
    if (changes_.empty()) return problem;
    const auto apply = [changes = changes_](Problem& built) {
        for (const auto& change : changes) change(built);
    };
    apply(problem);
    for (StagePlan& stage : problem.stages) {
        if (!stage.vary) continue;
        stage.vary = [apply, vary = std::move(stage.vary)](double value) {
            Problem varied = vary(value);
            apply(varied);
            return varied;
        };
    }
    problem.record.text = std::string(program_laws_note) + problem.record.text;
    return problem;
}

std::vector<std::string> check(const Problem& problem) {
    std::vector<std::string> lines;
    for (const auto& list : {examine_stages(problem.model, problem.stages),
                             question_model(problem.model, problem.stages),
                             question_units(problem.model, problem.record.units)}) {
        for (const Finding& finding : list) lines.push_back(describe(finding));
    }
    return lines;
}

}  // namespace gxrod
