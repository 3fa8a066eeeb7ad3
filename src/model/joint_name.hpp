#pragma once

#include "model/joint.hpp"

namespace gxrod {

// Returns the name in decks: "hinge", "weld".
inline const char* name_of(JointKind kind) {
    switch (kind) {
        case JointKind::ball:
            return "ball";
        case JointKind::hinge:
            return "hinge";
        case JointKind::cylinder:
            return "cylinder";
        case JointKind::slider:
            return "slider";
        case JointKind::universal:
            return "universal";
        case JointKind::screw:
            return "screw";
        case JointKind::plane:
            return "plane";
        case JointKind::weld:
            return "weld";
        case JointKind::free:
            return "free";
        case JointKind::sleeve:
            return "sleeve";
        case JointKind::distance:
            break;
    }
    return "distance";
}

}  // namespace gxrod
