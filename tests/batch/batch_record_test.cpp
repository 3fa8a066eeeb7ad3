#include "batch/batch_record.hpp"

#include "batch/batch.hpp"
#include "batch/plans.hpp"
#include "deck/decks.hpp"
#include "machine/file_error.hpp"
#include "tools/catch.hpp"

namespace gxrod::test {
namespace {

const std::string plan_text =
    "deck = \"deck.toml\"\ntime_limit = 5\n[vary]\n\"parameters.EI\" = [100.0, 200.0]\n"
    "[collect]\nz = { history = \"tip\", quantity = \"position\", component = \"z\", take = \"max\" }\n";

// What reading the rows of a folder says that holds the batch of `before`, to the batch of these texts.
std::string differences(const PlanFiles& files, const std::string& plan, const std::string& deck) {
    files.write("plan.toml", plan);
    files.write("deck.toml", deck);
    const std::filesystem::path folder = files.folder() / "out";
    std::string text;
    try {
        const PreparedBatch batch(files.read());
        batch.read_rows(folder);
    } catch (const DeckError& error) {
        text = error.what();
    } catch (const FileError& error) {
        text = error.what();
    }
    const std::string name = files.folder().string() + "/";
    for (std::size_t at = text.find(name); at != std::string::npos; at = text.find(name))
        text.erase(at, name.size());
    return text;
}

void run_in(const PlanFiles& files, const std::filesystem::path& folder) {
    BatchRequest request;
    request.folder = folder;
    run_batch(PreparedBatch(files.read()), request);
}

const std::string end = "\nout: holds another batch; -o starts another batch, --force restarts out";

}  // namespace

TEST_CASE("The record of a batch comes back", "[batch]") {
    const PlanFiles files(plan_text);
    const PreparedBatch batch(files.read());
    write_batch_record(batch.record(), files.folder());
    CHECK(is_batch_folder(files.folder()));
    const BatchRecord back = read_batch_record(files.folder());
    CHECK(back.plan == "plan.toml");
    CHECK(back.plan_text == plan_text);
    CHECK(back.title == "A cantilever");
    CHECK(back.combine == "grid");
    CHECK(back.cases == 2);
    CHECK(back.cases_digest == batch.record().cases_digest);
    CHECK(back.version == batch.record().version);
    REQUIRE(back.decks.size() == 1);
    CHECK(back.decks[0].text == cantilever_deck);
    CHECK(back.parameters == std::vector<std::string>{"parameters.EI"});
    REQUIRE(back.columns.size() == 1);
    CHECK(back.columns[0].description == "largest z of position of tip");
}

TEST_CASE("Seeds are recorded", "[batch]") {
    const PlanFiles files(
        "deck = \"deck.toml\"\ncombine = \"latin-hypercube\"\ncount = 2\nseed = 12345678901234\n"
        "[vary]\n\"parameters.EI\" = { uniform = { from = 1, to = 2 } }\n");
    write_batch_record(PreparedBatch(files.read()).record(), files.folder());
    CHECK(read_batch_record(files.folder()).seed == 12345678901234ULL);
}

TEST_CASE("An invalid record is an error", "[batch]") {
    const ScratchFolder folder;
    CHECK_FALSE(is_batch_folder(folder.path()));
    folder.write("batch.json", "{\"cases\": 5}");
    const std::string path = (folder.path() / "batch.json").string();
    CHECK_THROWS_WITH(read_batch_record(folder.path()),
                      Catch::StartsWith(path + ": is no record of a batch: "));
}

TEST_CASE("A changed plan or deck is noticed, and the key named", "[batch]") {
    const PlanFiles files(plan_text);
    run_in(files, files.folder() / "out");
    const auto with_plan = [&](const std::string& old_text, const std::string& new_text) {
        return differences(files, replaced(plan_text, old_text, new_text), cantilever_deck);
    };
    CHECK(with_plan("[100.0, 200.0]", "[100.0, 300.0]") ==
          "plan.toml:4:27: vary.\"parameters.EI\"[1]: the batch in out has 200.0" + end);
    CHECK(with_plan("[100.0, 200.0]", "[100.0]") ==
          "plan.toml:4:19: vary.\"parameters.EI\": the batch in out has [100.0, 200.0]" + end);
    CHECK(with_plan("take = \"max\"", "take = \"min\"") ==
          "plan.toml:6:71: collect.z.take: the batch in out has \"max\"" + end);
    CHECK(with_plan("[collect]", "\"parameters.load\" = [1.0]\n[collect]") ==
          "plan.toml:5:1: vary.\"parameters.load\": the batch in out has none" + end);
    // What does not change results may change.
    CHECK(with_plan("time_limit = 5", "# longer\ntime_limit = 50").empty());
    CHECK(with_plan("[collect]", "[keep]\nresults = \"none\"\n[collect]").empty());
    const auto with_deck = [&](const std::string& old_text, const std::string& new_text) {
        return differences(files, plan_text, replaced(cantilever_deck, old_text, new_text));
    };
    CHECK(with_deck("elements = 2", "elements = 3") ==
          "deck.toml:10:12: rod.r.elements: the batch in out has 2" + end);
    CHECK(with_deck("A cantilever", "The cantilever").empty());
    CHECK(with_deck("elements = 2", "elements = 2  # few").empty());
}

TEST_CASE("Decks do not go into the batch of a plan, nor a plan into that of decks", "[batch]") {
    const PlanFiles files(plan_text);
    const std::filesystem::path folder = files.folder() / "out";
    run_in(files, folder);
    const PreparedBatch decks(plan_of_decks({files.folder() / "deck.toml"}));
    const std::string hint = "; -o starts another batch, --force restarts " + folder.string();
    CHECK_THROWS_WITH(decks.read_rows(folder),
                      folder.string() + ": holds a batch of the plan plan.toml, not of decks" + hint);
    BatchRequest request;
    request.folder = folder;
    request.begin_anew = true;
    run_batch(decks, request);
    CHECK_THROWS_WITH(PreparedBatch(files.read()).read_rows(folder),
                      folder.string() + ": holds a batch of decks, not of a plan" + hint);
}

TEST_CASE("A batch of other decks is noticed", "[batch]") {
    const PlanFiles files(plan_text);
    files.write("a.toml", cantilever_deck);
    files.write("b.toml", cantilever_deck);
    BatchRequest request;
    request.folder = files.folder() / "out";
    run_batch(PreparedBatch(plan_of_decks({files.folder() / "a.toml"})), request);
    const std::string folder = request.folder.string();
    CHECK_THROWS_WITH(
        PreparedBatch(plan_of_decks({files.folder() / "a.toml", files.folder() / "b.toml"}))
            .read_rows(request.folder),
        folder + ": holds a batch of other decks; -o starts another batch, --force restarts " + folder);
}

TEST_CASE("Other orders and ways of writing are noticed", "[batch]") {
    const std::string vary_a = "\"parameters.EI\" = [100.0, 200.0]\n";
    const std::string vary_b = "\"gravity\" = [[0, 0, -1.0]]\n";
    const std::string column_a =
        "a = { history = \"tip\", quantity = \"position\", component = \"z\", at = 1 }\n";
    const std::string column_b =
        "b = { history = \"tip\", quantity = \"position\", component = \"x\", at = 1 }\n";
    const std::string begin = "deck = \"deck.toml\"\n[vary]\n";
    const PlanFiles files(begin + vary_a + vary_b + "[collect]\n" + column_a + column_b);
    run_in(files, files.folder() / "out");
    const auto with_plan = [&](const std::string& plan) { return differences(files, plan, cantilever_deck); };
    const std::string other = "out: holds a batch of other cases: ";
    const std::string hint = "; -o starts another batch, --force restarts out";
    CHECK(with_plan(begin + vary_b + vary_a + "[collect]\n" + column_a + column_b) ==
          other + "[vary] has its keys in another order" + hint);
    CHECK(with_plan(begin + vary_a + vary_b + "[collect]\n" + column_b + column_a) ==
          other + "[collect] has its columns in another order" + hint);
    // As the record of another version of gxrod may be.
    BatchRecord record = read_batch_record(files.folder() / "out");
    record.cases_digest = "0";
    write_batch_record(record, files.folder() / "out");
    const std::string plan = begin + vary_a + vary_b + "[collect]\n" + column_a + column_b;
    CHECK(with_plan(plan) == other + "the plan's values are written in another way" + hint);
    record.version = "0.0.9";
    write_batch_record(record, files.folder() / "out");
    CHECK(with_plan(plan) == other + "gxrod 0.0.9 made them" + hint);
}

TEST_CASE("A changed table is noticed", "[batch]") {
    const std::string plan = "deck = \"deck.toml\"\ncombine = \"table\"\ntable = \"t.csv\"\n";
    const PlanFiles files(plan);
    files.write("t.csv", "parameters.EI\n100.0\n");
    run_in(files, files.folder() / "out");
    CHECK(differences(files, plan, cantilever_deck).empty());
    files.write("t.csv", "parameters.EI\n200.0\n");
    CHECK(differences(files, plan, cantilever_deck) ==
          "out: holds a batch of other cases: the plan's table has changed; -o starts another batch, --force "
          "restarts out");
}

TEST_CASE("A folder with something else is left alone", "[batch]") {
    const PlanFiles files(plan_text);
    const std::string folder = files.folder().string();
    CHECK_THROWS_WITH(run_in(files, folder),
                      folder + ": is not empty and holds no batch (-o takes another folder)");
    CHECK_THROWS_WITH(run_in(files, folder + "/plan.toml"),
                      folder + "/plan.toml: is no folder (-o takes another one)");
}

}  // namespace gxrod::test
