#include "model/joint.hpp"

namespace gxrod {

bool Joint::has_turn() const {
    switch (kind) {
        case JointKind::hinge:
        case JointKind::cylinder:
        case JointKind::universal:
        case JointKind::screw:
        case JointKind::plane:
        case JointKind::free:
            return true;
        default:
            return false;
    }
}

bool Joint::has_slide() const {
    switch (kind) {
        case JointKind::cylinder:
        case JointKind::slider:
        case JointKind::screw:
        case JointKind::sleeve:
        case JointKind::free:
            return true;
        default:
            return false;
    }
}

}  // namespace gxrod
