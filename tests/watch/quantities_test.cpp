#include "watch/quantities.hpp"

#include <algorithm>
#include <set>

#include "cross_section/cross_section.hpp"
#include "cross_section/walls/solid_meshes.hpp"
#include "elements/tie_values.hpp"
#include "results/sample.hpp"
#include "tools/catch.hpp"

using namespace gxrod;

namespace {

// The words of the things of a kind, sorted.
std::vector<std::string> sorted_words(const char* table) {
    std::vector<std::string> words = list_quantity_words(table);
    std::ranges::sort(words);
    return words;
}

const std::set<std::string> dimensions{"1",
                                       "angle",
                                       "angle/length",
                                       "angle/time",
                                       "force",
                                       "force/length",
                                       "force/length²",
                                       "force·length",
                                       "length",
                                       "length/time",
                                       "length/time²",
                                       "length³"};

}  // namespace

TEST_CASE("every quantity has a meaning, a dimension, and a turning that fits its axes", "[watch]") {
    for (const QuantityTable* table : list_quantity_tables()) {
        for (const Quantity& line : table->lines) {
            INFO(table->owners << " " << line.word);
            CHECK(std::string(line.meaning).size() > 3);
            CHECK(dimensions.contains(line.dimension));
            CHECK(part_of(line) == table->part);
            const bool is_fixed = line.axes == Axes::global || line.axes == Axes::observer;
            const bool is_rotation =
                line.turning == Turning::attitude || line.turning == Turning::rotation_since_start;
            CHECK((line.axes == Axes::none) == (line.columns == 1));
            CHECK((line.turning == Turning::none) != is_fixed);
            CHECK((line.columns == 4) == (is_rotation && line.continuous == nullptr));
            CHECK((line.relative_meaning != nullptr) == is_rotation);
        }
    }
}

TEST_CASE("a kind of thing has a word once, and each word is in the list of all", "[watch]") {
    const std::vector<std::string> all = list_quantity_words();
    CHECK(std::set<std::string>(all.begin(), all.end()).size() == all.size());
    for (const char* table :
         {"rod", "body", "spring", "bushing", "joint", "gear", "tendon", "obstacle", "contact"}) {
        INFO(table);
        const std::vector<std::string> words = sorted_words(table);
        CHECK(std::ranges::adjacent_find(words) == words.end());
        for (const std::string& word : words) CHECK(std::ranges::find(all, word) != all.end());
    }
    // A rod as a whole also lies on the ground.
    CHECK(std::ranges::includes(sorted_words("contact"), sorted_words("obstacle")));
    CHECK(find_quantity("stretch") == nullptr);
    CHECK(find_quantity(WatchedTie{TieKind::spring}, "position") == nullptr);
    CHECK_THROWS_WITH(quantity_of(WatchedTie{TieKind::spring}, "position"),
                      "this spring has no quantity \"position\"");
}

TEST_CASE("the value of a quantity is a row of its columns", "[watch]") {
    Model model = sample::make_model();
    model.surroundings.seabed.emplace().point = Vec3(0, 0, 1e3);  // above all
    model.joints.resize(1);
    const ElasticMaterial steel{
        .name = "steel", .stiffness = compute_isotropic_stiffness(1.0, 0.3), .yield_stress = 1.0};
    for (Section& section : model.sections)
        section.shape = compute_cross_section("square", mesh_rectangle(1.0, 1.0), {steel});
    for (Section& section : model.sections) section.fluid.emplace();
    const sample::Motion motion(0.7);
    TieValues ties;
    std::get<0>(ties.lists) = {{0.5, 2.0}};
    std::get<1>(ties.lists) = {
        {Mat3::Identity(), Vec3(1, 2, 3), Vec3(0.1, 0.2, 0.3), Vec3(4, 5, 6), Vec3(7, 8, 9)}};
    const std::vector<JointValues> joints(3, JointValues{.turn = 1.0, .slide = 2.0});
    const std::vector<TendonValues> tendons{{1.0, 2.0, 3.0}};
    const std::vector<ObstacleValues> contacts{{Vec3(1, 2, 3), Vec3(4, 5, 6), 0.1}};
    Snapshot now = motion.snapshot();
    now.ties = &ties;
    now.joints = joints;
    now.tendons = tendons;
    now.obstacles = now.watched_contacts = contacts;
    model.gears.resize(1);
    model.tendons.resize(1);
    model.tendons[0].area = 2.0;
    const std::vector<std::pair<Watched, const char*>> things{{WatchedPoint{{0, 0, 1.0}, 1}, "rod"},
                                                              {WatchedBody{.index = 1, .node = 3}, "body"},
                                                              {WatchedTie{TieKind::spring}, "spring"},
                                                              {WatchedTie{TieKind::bushing}, "bushing"},
                                                              {WatchedTie{TieKind::joint}, "joint"},
                                                              {WatchedTie{TieKind::gear}, "gear"},
                                                              {WatchedTie{TieKind::sleeve}, "joint"},
                                                              {WatchedTendon{}, "tendon"},
                                                              {WatchedObstacle{}, "obstacle"},
                                                              {WatchedContacts{}, "contact"}};
    CHECK(things.size() == std::variant_size_v<Watched> - 1 + tie_kind_count);
    for (const auto& [target, table] : things) {
        HistoryRequest request;
        request.target = target;
        request.quantities = list_quantity_words(table);
        const Subject subject(model, {request}, 0);
        for (const Quantity* line : quantities_of(request)) {
            INFO(table << " " << line->word);
            const HistoryRow row = line->value({subject, now});
            for (std::size_t i = 0; i < row.size(); ++i) {
                CHECK(std::isfinite(row[i]));
                if (i >= static_cast<std::size_t>(line->columns)) CHECK(row[i] == 0.0);
            }
        }
    }
}
