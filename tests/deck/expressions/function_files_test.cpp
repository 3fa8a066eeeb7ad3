#include "deck/expressions/function_files.hpp"

#include <fstream>

#include "deck/decks.hpp"
#include "tools/catch.hpp"

namespace gxrod::test {

namespace {

std::string deck_with(const std::string& function) {
    return body_deck + "[function.sway]\n" + function +
           "[[load]]\nat = \"top\"\nforce = [\"sway(t)\", 0, 0]\n";
}

// A deck next to motion.csv.
struct Beside {
    ScratchFile table;
    std::filesystem::path deck;

    explicit Beside(const std::string& csv)
        : table("motion.csv", csv), deck(table.path().parent_path() / "d.toml") {}

    Problem read(const std::string& function) const {
        return read_problem_text(deck_with(function), deck.string());
    }
    std::string faults_of(const std::string& function) const {
        try {
            read(function);
        } catch (const DeckError& error) {
            std::string text;
            for (const DeckFault& fault : error.faults) {
                text += std::to_string(fault.line) + ": " + fault.key + ": " + fault.message + "\n";
            }
            return text;
        }
        return "";
    }
};

double force_at(const Problem& problem, double time) { return problem.model.loads.at(0).force[0](time); }

}  // namespace

TEST_CASE("A function takes its rows from a file next to the deck", "[deck]") {
    const Beside beside("t,x,y\n0,0,5\n1,2,6\n# a comment\n2,8,7\n");
    CHECK(force_at(beside.read("file = \"motion.csv\"\n"), 0.5) == 1.0);
    CHECK(force_at(beside.read("file = \"motion.csv\"\ncolumns = [\"t\", \"y\"]\n"), 1.5) == 6.5);
    CHECK(force_at(beside.read("file = \"motion.csv\"\ncolumns = [1, 3]\n"), 0.0) == 5.0);
    // The parabola through three rows.
    CHECK(force_at(beside.read("file = \"motion.csv\"\ninterpolation = \"cubic\"\n"), 0.5) == Approx(0.5));
    const Beside plain("\xEF\xBB\xBF 0, 1\n 2, 3\n");
    CHECK(force_at(plain.read("file = \"motion.csv\"\n"), 1.0) == 2.0);
}

TEST_CASE("The file is kept with the deck, and read again from there", "[deck]") {
    const Beside beside("0,0\n1,2\n");
    const Problem problem = beside.read("file = \"motion.csv\"\n");
    REQUIRE(problem.record.meshes.size() == 1);
    CHECK(problem.record.meshes[0].file == "motion.csv");
    CHECK(problem.record.meshes[0].bytes == "0,0\n1,2\n");
    CHECK(problem.record.text.find("file = \"motion.csv\"") != std::string::npos);
    std::filesystem::remove(beside.table.path());
    CHECK(force_at(rebuild_problem(problem.record), 0.5) == 1.0);
    CHECK(force_at(read_resumption(problem.record, "", {"analysis.end_time=2"}), 0.5) == 1.0);
    DeckRecord without = problem.record;
    without.meshes.clear();
    CHECK_THROWS_WITH(rebuild_problem(without), Catch::Contains("is not kept in the results file"));
}

TEST_CASE("A run is resumed only with the file that it began with", "[deck]") {
    const Beside beside("0,0\n1,2\n");
    std::ofstream(beside.deck) << deck_with("file = \"motion.csv\"\n");
    const Problem problem = read_problem(beside.deck);
    CHECK_NOTHROW(read_resumption(problem.record, beside.deck, {}));
    std::ofstream(beside.table.path()) << "0,0\n1,3\n";
    CHECK_THROWS_WITH(read_resumption(problem.record, beside.deck, {}),
                      Catch::Contains("the file motion.csv is another one than the run's"));
}

TEST_CASE("What is wrong with a file or its columns is said with the line", "[deck]") {
    const std::string file = "file = \"motion.csv\"\n";
    CHECK(Beside("t,x\n0,1\n0,2\n").faults_of(file) ==
          "9: function.sway.file: line 3: expected a time after 0, that of the row before, found 0\n");
    CHECK(Beside("t,x\n0,1\n1,two\n").faults_of(file) ==
          "9: function.sway.file: line 3: expected a finite number, found \"two\"\n");
    CHECK(Beside("0,1\n1\n").faults_of(file) ==
          "9: function.sway.file: line 2: expected 2 columns or more, found 1\n");
    CHECK(Beside("0;1\n1;2\n").faults_of(file).find("expected two columns, parted by commas, found one") !=
          std::string::npos);
    CHECK(Beside("t,x\n").faults_of(file) == "9: function.sway.file: expected rows of numbers, found none\n");
    CHECK(Beside("t,x\n0,1\n").faults_of(file + "columns = [\"t\", \"z\"]\n") ==
          "10: function.sway.columns: there is no column \"z\"; the file has \"t\", \"x\"\n");
    CHECK(Beside("0,1\n").faults_of(file + "columns = [1, 3]\n") ==
          "10: function.sway.columns: there is no column 3; the file has 2\n");
    CHECK(Beside("0,1\n")
              .faults_of(file + "columns = [\"t\", \"x\"]\n")
              .find("the file has no header with \"t\"") != std::string::npos);
    CHECK(Beside("0,1\n").faults_of(file + "columns = 3\n").find("expected 2 names or numbers of columns") !=
          std::string::npos);
    CHECK(Beside("0,1\n").faults_of("file = \"absent.csv\"\n").find("absent.csv") != std::string::npos);
}

TEST_CASE("Interpolation goes with rows, columns with a file", "[deck]") {
    const Beside beside("0,1\n");
    CHECK_FALSE(beside.faults_of("expression = \"t\"\ninterpolation = \"cubic\"\n").empty());
    CHECK_FALSE(beside.faults_of("table = [[0, 1]]\ncolumns = [1, 2]\n").empty());
    CHECK_FALSE(beside.faults_of("table = [[0, 1]]\nfile = \"motion.csv\"\n").empty());
    CHECK_FALSE(beside.faults_of("table = [[0, 1]]\ninterpolation = \"quintic\"\n").empty());
}

}  // namespace gxrod::test
