#include "deck/checks/check_points.hpp"

#include <fmt/format.h>

#include "deck/analyses/analysis_table.hpp"
#include "deck/contact/build_contact_exceptions.hpp"
#include "deck/drives/tendon_path.hpp"
#include "deck/joints/ends.hpp"
#include "deck/joints/joint_table.hpp"
#include "deck/output/history_place.hpp"
#include "deck/output/history_table.hpp"
#include "deck/places/part.hpp"
#include "deck/schema/schema_tables.hpp"
#include "deck/schema/suggestion.hpp"
#include "deck/ties/ties.hpp"

namespace gxrod {
namespace {

class PointCheck {
  public:
    explicit PointCheck(const BuildContext& context) : context_(context) {}

    // The point that a text names; nullopt, with a fault, if there is none.
    std::optional<Point> check(const std::string& text, const Place& place, const std::string& path) {
        const std::variant<Point, std::string> found = context_.names.find(text);
        if (const auto* message = std::get_if<std::string>(&found)) {
            context_.faults.add(place, path, *message);
            return std::nullopt;
        }
        const Point& point = std::get<Point>(found);
        if (const auto* of_rod = std::get_if<RodPoint>(&point)) of_rods_.push_back(*of_rod);
        return point;
    }

    // All points that a table names.
    void check_names(const TableHead& table) {
        for (const Ends& ends : values_of<Ends>(table)) {
            for (const CheckedWord& end : ends) check_end(end);
        }
        for (const std::variant<Vec3, PointName>& at : values_of<std::variant<Vec3, PointName>>(table)) {
            if (const auto* point = std::get_if<PointName>(&at)) check_of_rod(*point, "");
        }
        for (const ConnectedPoints& list : values_of<ConnectedPoints>(table)) {
            if (list.are_coincident()) continue;
            for (const CheckedWord& point : list.words) check_pattern_of_rods(point);
        }
        for (const PointName& point : values_of<PointName>(table)) check(point.word, point.place, point.path);
        const bool takes_rods = !values_of<PlaceCondition>(table).empty();
        for (const PointPatterns& points : values_of<PointPatterns>(table)) {
            for (const CheckedWord& word : points.words) check_pattern(word, takes_rods);
        }
    }

    // Points that a text names; rods too if a condition selects points of them.
    void check_pattern(const CheckedWord& word, bool takes_rods) {
        if (takes_rods && !context_.names.find_rods(word.word).empty()) return;
        const auto found = context_.names.find_all(word.word);
        if (const auto* message = std::get_if<std::string>(&found))
            return context_.faults.add(word.place, word.path, *message);
        for (const NamedPoint& one : std::get<std::vector<NamedPoint>>(found)) {
            if (const auto* of_rod = std::get_if<RodPoint>(&one.point)) of_rods_.push_back(*of_rod);
        }
    }

    // Points of rods that a text names.
    void check_pattern_of_rods(const CheckedWord& word) {
        if (word.word.find('*') == std::string::npos)
            check_of_rod(word, "; a body's `at` puts it on one");
        else
            check_pattern(word, false);
    }

    // An end of a spring, a bushing or a joint: a point, or the ground.
    void check_end(const CheckedWord& word) {
        if (word.word == ground_word) return;
        const std::string ground = did_you_mean(word.word, {ground_word});
        const auto found = context_.names.find(word.word);
        if (ground.empty() || std::holds_alternative<Point>(found)) {
            check(word.word, word.place, word.path);
        } else {
            context_.faults.add(word.place, word.path, fmt::format("no point \"{}\"{}", word.word, ground));
        }
    }

    // A point that is to be a rod's; `hint` says what to write for a body.
    void check_of_rod(const CheckedWord& word, const std::string& hint) {
        const std::optional<Point> point = check(word.word, word.place, word.path);
        if (!point || std::holds_alternative<RodPoint>(*point)) return;
        context_.faults.add(word.place,
                            word.path,
                            fmt::format("\"{}\" is a body; expected a point of a rod{}", word.word, hint));
    }

    std::vector<RodPoint> take_points_of_rods() { return std::move(of_rods_); }

  private:
    const BuildContext& context_;
    std::vector<RodPoint> of_rods_;
};

// What a sleeve slides along.
void check_rod(const CheckedWord& word, const BuildContext& context) {
    const auto& rods = context.deck.tables("rod");
    if (find_index(rods, word.word)) return;
    std::vector<std::string> names;
    for (const CheckedTable& rod : rods) names.push_back(rod.name);
    const std::string part = word.word.substr(0, word.word.find_first_of(".@"));
    const std::string hint = did_you_mean(part, names);
    context.faults.add(
        word.place,
        word.path,
        fmt::format("no rod \"{}\"{}; a sleeve is between a rod and the point that slides along it",
                    word.word,
                    hint));
}

}  // namespace

std::vector<RodPoint> check_points(const BuildContext& context) {
    PointCheck points(context);
    const auto check_names = [&](std::initializer_list<const TableSpec*> specs) {
        for (const TableSpec* spec : specs) {
            for (const TableHead& table : tables_of<TableHead>(context.deck, *spec))
                points.check_names(table);
        }
    };
    check_names({&body_table(), &connect_table()});
    for (const ElementTieTable& tie : element_tie_tables) check_names({&tie.spec()});
    for (const JointTable& joint : tables_of<JointTable>(context.deck, joint_table())) {
        if (joint.is_sleeve()) {
            check_rod(joint.between[0], context);
            points.check_end(joint.between[1]);
        } else {
            points.check_names(joint);
        }
    }
    check_names({&load_table(), &support_table()});
    for (const HistoryKeys& table : tables_of<HistoryKeys>(context.deck, history_table())) {
        for (const CheckedWord& word : table.at.words) {
            const std::string reason = explain_no_watched(word.word, context);
            if (!reason.empty()) context.faults.add(word.place, word.path, reason);
        }
        if (const auto& other = table.relative_to) points.check(other->word, other->place, other->path);
    }
    for (const AnalysisTable& table : list_analyses(context.deck)) {
        for (const PathTargetTable& target : table.at) points.check_names(target);
        for (const ExcitationTable& force : table.excite) points.check_names(force);
        if (table.control) points.check_names(*table.control);
    }
    std::vector<RodPoint> all = points.take_points_of_rods();
    for (const std::vector<RodPoint>& more : {list_tendon_points(context), list_contact_part_ends(context)})
        all.insert(all.end(), more.begin(), more.end());
    return all;
}

}  // namespace gxrod
