#include "model/joint.hpp"

#include "model/ties/joint_card.hpp"

namespace gxrod {

bool Joint::has_turn() const { return card_of(kind).has_turn; }

bool Joint::has_slide() const { return card_of(kind).has_slide; }

}  // namespace gxrod
