#include <fmt/format.h>

#include <algorithm>

#include "deck/joints/joint_table.hpp"
#include "deck/joints/joints.hpp"
#include "deck/reading/copies.hpp"
#include "deck/schema/suggestion.hpp"
#include "model/ties/joint_card.hpp"

namespace gxrod {
namespace {

struct GearTable : TableHead {
    JointNames joints;
    double ratio = 0.0;
    double backlash = 0.0;
    std::optional<double> stiffness;
    double damping = 0.0;
    Copies copies;
};

}  // namespace

const TableSpec& gear_table() {
    using T = GearTable;
    // clang-format off
    static const TableSpec table = Table<T>("[gear.NAME]",
            "Ties the coordinates of two joints: ratio × first + second = 0, both since t = 0.")
        .key("joints", &T::joints, "The first and the second: joints with a turn or a slide. Of a joint with both, "
             "\"NAME.turn\" or \"NAME.slide\".")
            .required().also("between of shafts coordinates axes")
        .key("ratio", &T::ratio, "How far the second goes back while the first goes on by 1: of two turns a number, "
             "of a turn and the slide of a rack the radius of the pinion.")
            .unit("second/first").required().remark("how far the second goes back while the first goes on by 1")
            .also("n i gear_ratio transmission radius")
        .key("backlash", &T::backlash, "The play of the second coordinate while the first one rests: half of it to each side of "
             "where it is at t = 0.")
            .unit("angle or length").at_least(0).otherwise("0").only_with("stiffness").also("play clearance gap lash")
        .key("stiffness", &T::stiffness, "Of the teeth, beyond the backlash: moment per angle, or force per length, on the second "
             "coordinate.")
            .unit("moment/angle or force/length").above(0).otherwise("rigid").also("k mesh_stiffness tooth_stiffness")
        .key("damping", &T::damping, "Of teeth that touch; they never pull.")
            .unit("moment·time/angle or force·time/length").at_least(0).only_with("stiffness").also("c d mesh_damping")
        .with(add_copies<T>)
        .shown_by(
            "[joint.shaft]\n"
            "type    = \"hinge\"\n"
            "between = [\"ground\", \"flyer.end\"]\n"
            "axis    = [1, 0, 0]\n"
            "[gear.stage]\n"
            "joints = [\"pivot\", \"shaft\"]\n"
            "ratio  = 5.0\n");
    // clang-format on
    return table;
}

namespace {

class GearBuilder {
  public:
    GearBuilder(const GearTable& given, const BuildContext& context) : given_(given), context_(context) {}

    // nullopt, with a fault here or of one of its joints, if it is not complete.
    std::optional<Gear> build() const {
        Gear gear;
        gear.name = given_.name;
        gear.ratio = given_.ratio;
        if (given_.stiffness)
            gear.teeth = {.lower = -0.5 * given_.backlash,
                          .upper = 0.5 * given_.backlash,
                          .stiffness = *given_.stiffness,
                          .damping = given_.damping};
        if (!given_.stiffness && (given_.backlash > 0.0 || given_.damping > 0.0))
            context_.add_fault(given_,
                               given_.stiffness,
                               "missing; teeth with backlash or damping yield; expected how stiff they are");
        if (gear.ratio == 0.0)
            context_.add_fault(
                given_, given_.ratio, "a ratio of 0 does not tie the joints; expected another number");
        bool is_complete = true;
        for (std::size_t i = 0; i < 2; ++i) {
            const std::optional<GearSide> side = find_side(given_.joints[i]);
            is_complete = is_complete && side;
            if (side) gear.sides[i] = *side;
        }
        if (!is_complete) return std::nullopt;
        if (gear.sides[0].joint == gear.sides[1].joint) {
            const std::string& name = context_.model.joints[gear.sides[0].joint].name;
            add(given_.joints[1],
                fmt::format("both are of joint {}; expected another joint, or a screw for its turn and slide",
                            name));
        }
        return gear;
    }

  private:
    void add(const CheckedWord& word, std::string message) const {
        context_.faults.add(word.place, word.path, std::move(message));
    }

    std::optional<GearSide> find_side(const CheckedWord& word) const {
        const std::size_t dot = word.word.find('.');
        const std::string name = word.word.substr(0, dot);
        const JointTable* table = find_joint(context_.deck, name);
        if (table == nullptr) {
            add(word, explain_unknown(name));
            return std::nullopt;
        }
        const std::string given = dot == std::string::npos ? "" : word.word.substr(dot + 1);
        const std::string coordinate = given.empty() ? std::string(plain_coordinate(table->type)) : given;
        std::string reason = explain_coordinate(name, table->type, coordinate);
        if (reason.empty() && (table->breaks || table->stages))
            reason = fmt::format("joint {} does not hold all the time ({}), and a gear needs it",
                                 name,
                                 table->breaks ? "breaks" : "stages");
        if (!reason.empty()) {
            add(word, reason);
            return std::nullopt;
        }
        const auto joint = std::ranges::find(context_.model.joints, name, &Joint::name);
        if (joint == context_.model.joints.end()) return std::nullopt;
        return GearSide{static_cast<int>(joint - context_.model.joints.begin()), coordinate == "turn"};
    }

    std::string explain_unknown(const std::string& name) const {
        std::vector<std::string> known;
        for (const JointTable& joint : tables_of<JointTable>(context_.deck, joint_table()))
            known.push_back(joint.name);
        const std::string nearest = did_you_mean(name, known);
        const std::string hint = !nearest.empty() ? nearest
                                 : known.empty()  ? "; the deck has no joint"
                                                  : "; the deck has " + plain_list(known);
        return fmt::format("no joint \"{}\"{}", name, hint);
    }

    // Why a joint of this kind cannot be tied by it, or "".
    static std::string explain_coordinate(const std::string& name,
                                          JointKind kind,
                                          const std::string& coordinate) {
        const JointCard& card = card_of(kind);
        const std::string_view type = kind == JointKind::free ? "free joint" : card.word;
        if (coordinate.empty()) {
            return fmt::format(
                "a {} has a turn and a slide; expected \"{}.turn\" or \"{}.slide\"", type, name, name);
        }
        if (kind == JointKind::sleeve) return "a gear cannot tie the slide of a sleeve";
        if (!card.has_turn && !card.has_slide)
            return fmt::format("a {} has no turn about one axis and no slide that a gear could tie", type);
        if (coordinate != "turn" && coordinate != "slide")
            return fmt::format("no coordinate \"{}\"; expected turn or slide", coordinate);
        const bool has_it = coordinate == "turn" ? card.has_turn : card.has_slide;
        return has_it ? "" : fmt::format("a {} has no {}", type, coordinate);
    }

    const GearTable& given_;
    const BuildContext& context_;
};

}  // namespace

void build_gears(BuildContext& context) {
    for (const GearTable& given : tables_of<GearTable>(context.deck, gear_table())) {
        if (std::optional<Gear> gear = GearBuilder(given, context).build())
            context.model.gears.push_back(std::move(*gear));
    }
}

}  // namespace gxrod
