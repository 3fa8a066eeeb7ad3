#include "model/scheme_choice.hpp"

namespace gxrod {
namespace {

// What makes a coordinate's force change at once.
std::string find_jump(const JointCoordinate& coordinate) {
    if (coordinate.friction.acts()) return "rubs";
    if (coordinate.limits.lower || coordinate.limits.upper) return "has stops";
    return "";
}

// "joint brake rubs"; "" if forces follow the motion without jumps and kinks.
std::string find_jump(const Model& model) {
    for (const Joint& joint : model.joints) {
        for (const JointCoordinate* one : {&joint.turn, &joint.slide}) {
            if (const std::string jump = find_jump(*one); !jump.empty())
                return "joint " + joint.name + " " + jump;
        }
    }
    for (const Sleeve& sleeve : model.sleeves) {
        if (const std::string jump = find_jump(sleeve.slide); !jump.empty())
            return "joint " + sleeve.name + " " + jump;
    }
    for (const Tendon& tendon : model.tendons) {
        if (tendon.friction) return "tendon " + tendon.name + " rubs";
        if (tendon.winch && tendon.winch->pulls_only) return "tendon " + tendon.name + " can go slack";
    }
    if (model.surroundings.seabed && model.surroundings.seabed->has_friction()) return "the ground rubs";
    return "";
}

}  // namespace

SchemeChoice choose_scheme(const Model& model) {
    if (std::string jump = find_jump(model); !jump.empty()) {
        jump += ", and order is lost where forces jump";
        return {Scheme::generalized_alpha, jump};
    }
    if (model.rods.empty()) return {Scheme::radau_5, "for bodies"};
    return {Scheme::radau_5, "for rods, whose fastest waves no step resolves"};
}

}  // namespace gxrod
