#include "report/report.hpp"

#include <fmt/format.h>

#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>
#include <sstream>

#include "deck/problem.hpp"
#include "machine/file_error.hpp"
#include "results/results_file.hpp"
#include "results/sample.hpp"
#include "tools/catch.hpp"

using namespace gxrod;
using Json = nlohmann::json;

namespace {

constexpr const char* evil = "</script><script>document.title='run'</script>";

// Results of one frame of a model, at rest.
void write_still(const std::filesystem::path& path, const DeckRecord& deck, const Model& model) {
    std::vector<NodeMotion> nodes(model.nodes.size());
    for (std::size_t i = 0; i < nodes.size(); ++i) nodes[i].r = model.nodes[i].position;
    std::size_t elements = 0;
    for (const Rod& rod : model.rods) elements += static_cast<std::size_t>(rod.element_count());
    const Vec3 zero = Vec3::Zero();
    const std::vector<SectionValues> sections(elements, {zero, zero, zero, zero, Quat::Identity()});
    const std::vector<Vec6> reactions(model.nodes.size(), Vec6::Zero());
    ResultsFile file({path}, deck, model, OutputSettings{});
    const Snapshot snapshot{0.0, nodes, sections, reactions};
    file.record_step(snapshot, {}, {});
    file.write_frame(snapshot);
    file.close(RunStatus::complete, "");
}

// A rod of 25 000 elements, with supports at 500 of its last nodes, or more, and 300 loads there, or more.
Problem make_large_problem(int supports = 500, int loads = 300) {
    std::string deck = R"(
[section.s]
stiffness = { EA = 1, GAy = 1, GAz = 1, GJ = 1, EIy = 1, EIz = 1 }
[rod.r]
section = "s"
line = { from = [0, 0, 0], to = [1, 0, 0] }
elements = 25000
[analysis]
kind = "static"
)";
    for (int i = 0; i < supports; ++i) {
        const double place = 1.0 - 0.001 * i;
        deck += fmt::format("[[support]]\nat = \"r@{}\"\nfix = \"all\"\n", place);
        if (i < loads) deck += fmt::format("[[load]]\nat = \"r@{}\"\nforce = [0, 0, 1]\n", place);
    }
    return read_problem_text(deck, "large.toml");
}

// Results whose deck is no deck at all.
void write_sample(const std::filesystem::path& path, int steps, const std::string& title) {
    const Model model = sample::make_model();
    DeckRecord deck = sample::make_deck();
    deck.title = title;
    ResultsFile file({path}, deck, model, sample::make_output());
    for (int i = 0; i < steps; ++i) {
        const double time = 0.01 * i;
        const sample::Motion motion(time);
        file.record_step(motion.snapshot(), sample::make_ledger(time), sample::make_solver(time));
        file.write_frame(motion.snapshot());
    }
    file.close(RunStatus::failed, "it would not", std::vector<std::int64_t>{1});
}

std::string read(const std::filesystem::path& path) {
    std::ostringstream text;
    text << std::ifstream(path, std::ios::binary).rdbuf();
    return text.str();
}

// The JSON of a page.
Json describe(const std::string& page) {
    const std::string start = "<script type=\"application/json\" id=\"report\">";
    const std::size_t first = page.find(start) + start.size();
    return Json::parse(page.substr(first, page.find("</script>", first) - first));
}

}  // namespace

TEST_CASE("A report stays within its budget and says what it left out", "[report]") {
    const sample::ScratchFolder folder;
    write_sample(folder / "a.vtkhdf", 4000, "Sample");
    const ReportSummary whole = write_report({folder / "a.vtkhdf", folder / "whole.html"});
    CHECK(whole.left_out.empty());
    CHECK(whole.bytes == std::filesystem::file_size(folder / "whole.html"));

    for (const std::size_t budget : {1'100'000, 1'500'000, 3'200'000}) {
        const ReportSummary summary =
            write_report({folder / "a.vtkhdf", folder / "thin.html", budget, Existing::replace});
        CHECK(summary.bytes <= budget);
        CHECK(summary.bytes > budget * 8 / 10);
        CHECK(std::filesystem::file_size(folder / "thin.html") == summary.bytes);
        CHECK(summary.left_out.size() == (budget < 3'200'000 ? 2 : 1));
        CHECK(describe(read(folder / "thin.html"))["left_out"] == Json(summary.left_out));
    }
    CHECK_THROWS_WITH(write_report({folder / "a.vtkhdf", folder / "small.html", 10'000}),
                      Catch::Contains("do not fit into 0.01 MB") && Catch::Contains("--budget"));
    CHECK_FALSE(std::filesystem::exists(folder / "small.html"));
    CHECK_FALSE(std::filesystem::exists(folder / "small.html.part"));
}

TEST_CASE("Numbers of nodes have their room in a budget", "[report]") {
    const sample::ScratchFolder folder;
    const Problem problem = make_large_problem();
    write_still(folder / "a.vtkhdf", problem.record, problem.model);
    const auto write = [&](std::size_t budget) {
        return write_report({folder / "a.vtkhdf", folder / "a.html", budget, Existing::replace});
    };
    const std::size_t all = write(100'000'000).left_out.size();
    // Between a budget that is too small for the whole and one that is not.
    std::size_t small = 1'200'000, large = 10'000'000;
    REQUIRE(write(small).left_out.size() > all);
    while (large - small > 100) {
        const std::size_t budget = (small + large) / 2;
        const ReportSummary summary = write(budget);
        CHECK(summary.bytes <= budget);
        (summary.left_out.size() > all ? small : large) = budget;
    }
}

TEST_CASE("If supports and loads are very many, the first are drawn", "[report]") {
    const sample::ScratchFolder folder;
    const Problem problem = make_large_problem(503, 302);
    write_still(folder / "a.vtkhdf", problem.record, problem.model);
    const ReportSummary summary = write_report({folder / "a.vtkhdf", folder / "a.html", 100'000'000});
    CHECK_THAT(summary.left_out,
               Catch::VectorContains(std::string("Of 302 arrows of loads, the first 300 are drawn.")) &&
                   Catch::VectorContains(std::string("Of 503 supports, the first 500 are drawn.")));
}

TEST_CASE("Very many bodies fit; the first are drawn", "[report]") {
    const sample::ScratchFolder folder;
    Model model;
    for (int i = 0; i < 30000; ++i) {
        Body body;
        body.name = fmt::format("body {}", i);
        body.node = i;
        model.bodies.push_back(body);
        model.nodes.push_back({body.name, Vec3(i, 0, 0)});
    }
    write_still(folder / "a.vtkhdf", sample::make_deck(), model);
    const ReportSummary summary = write_report({folder / "a.vtkhdf", folder / "a.html", 1'100'000});
    CHECK(summary.left_out == std::vector<std::string>{"Of 30000 bodies, the first 300 are drawn."});
    const Json bodies = describe(read(folder / "a.html"))["bodies"];
    CHECK(bodies.size() == 300);
    CHECK(bodies[299]["node"] == 299);
}

TEST_CASE("A report removes nothing but what it made", "[report]") {
    const sample::ScratchFolder folder;
    write_sample(folder / "a.vtkhdf", 3, "Sample");
    std::ofstream(folder / "b.html.part") << "mine";
    CHECK_THROWS_AS(write_report({folder / "none.vtkhdf", folder / "b.html"}), FileError);
    CHECK(read(folder / "b.html.part") == "mine");
    std::filesystem::create_directory(folder / "c.html.part");
    CHECK_THROWS_WITH(write_report({folder / "a.vtkhdf", folder / "c.html"}),
                      Catch::Contains("cannot be written"));
    CHECK(std::filesystem::exists(folder / "c.html.part"));
    write_report({folder / "a.vtkhdf", folder / "a.html"});
    CHECK_FALSE(std::filesystem::exists(folder / "a.html.part"));
}

TEST_CASE("Without its model a report shows the frames and says so", "[report]") {
    const sample::ScratchFolder folder;
    write_sample(folder / "a.vtkhdf", 3, evil);
    write_report({folder / "a.vtkhdf", folder / "a.html"});
    const std::string page = read(folder / "a.html");
    CHECK(page.find(evil) == std::string::npos);
    const Json json = describe(page);
    CHECK(json["title"] == evil);
    CHECK(json["why_no_model"] != "");
    CHECK(json["bodies"].size() == 2);
    CHECK(json["fail_nodes"] == Json{1});
    CHECK(json["warnings"][0] == "The run failed: it would not");
}

TEST_CASE("A report does not overwrite what it should not", "[report]") {
    const sample::ScratchFolder folder;
    write_sample(folder / "a.vtkhdf", 3, "Sample");
    write_report({folder / "a.vtkhdf", folder / "a.html"});
    CHECK_THROWS_WITH(write_report({folder / "a.vtkhdf", folder / "a.html"}),
                      Catch::Contains("exists already"));
    ReportOptions onto_itself{folder / "a.vtkhdf", folder / "a.vtkhdf"};
    onto_itself.existing = Existing::replace;
    CHECK_THROWS_WITH(write_report(onto_itself), Catch::Contains("is the results file itself"));
    CHECK_THROWS_AS(write_report({folder / "none.vtkhdf", folder / "b.html"}), FileError);
    CHECK_THROWS_AS(write_report({folder / "a.vtkhdf", folder.path()}), FileError);
}

TEST_CASE("Results without a frame cannot be shown yet", "[report]") {
    const sample::ScratchFolder folder;
    const Model model = sample::make_model();
    { ResultsFile file({folder / "a.vtkhdf"}, sample::make_deck(), model, OutputSettings{}); }
    CHECK_THROWS_WITH(write_report({folder / "a.vtkhdf", folder / "a.html"}),
                      Catch::Contains("has no frame yet"));
}
