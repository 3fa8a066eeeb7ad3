#include "model/ties/joint_card.hpp"

#include <set>
#include <string_view>

#include "tools/catch.hpp"

using namespace gxrod;

TEST_CASE("every kind of joint has its own card", "[model][joint]") {
    std::set<std::string_view> words;
    for (std::size_t i = 0; i < joint_cards.size(); ++i) {
        INFO(joint_cards[i].word);
        CHECK(joint_cards[i].kind == static_cast<JointKind>(i));
        CHECK(&card_of(joint_cards[i].kind) == &joint_cards[i]);
        CHECK(words.insert(joint_cards[i].word).second);
        CHECK_FALSE(joint_cards[i].leaves_free.empty());
    }
    CHECK(joint_cards.back().kind == JointKind::sleeve);
}
