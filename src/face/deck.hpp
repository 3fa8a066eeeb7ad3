#pragma once

#include <filesystem>
#include <functional>
#include <initializer_list>
#include <memory>
#include <string>
#include <type_traits>
#include <vector>

#include "deck/problem.hpp"
#include "deck/text/fault.hpp"
#include "model/sections/section_law.hpp"
#include "model/spring_law.hpp"

namespace gxrod {

// A deck that is read once and built as often as wanted, with other values and with laws of the program's
// own. Copies of one are cheap. Functions and laws that a deck is given are shared by all problems that it
// builds; simulations that run in several threads at once need functions that may be called so.
class Deck {
  public:
    // Reads a file. Throws DeckError if it is not TOML, FileError if it cannot be read.
    explicit Deck(const std::filesystem::path& path);
    // Takes a text. Errors name it `file`, in whose folder files are found that the text names.
    static Deck from_text(std::string text, const std::filesystem::path& file = "deck.toml");

    const std::string& text() const { return read_->text(); }
    const std::string& file() const { return read_->file(); }

    // Sets the value of a key as `--set KEY=VALUE` does, for all problems that are built from now on: a text
    // is TOML, or itself where it is not.
    Deck& set(const std::string& key, const std::string& value);
    Deck& set(const std::string& key, const char* value) { return set(key, std::string(value)); }
    Deck& set(const std::string& key, bool value) { return set(key, value ? "true" : "false"); }
    Deck& set(const std::string& key, double value);
    Deck& set(const std::string& key, std::initializer_list<double> values);
    Deck& set(const std::string& key, const std::vector<Vec3>& points);
    template <class Integer>
        requires std::is_integral_v<Integer>
    Deck& set(const std::string& key, Integer value) {
        return set(key, std::to_string(value));
    }

    // Sets several, "KEY=VALUE" each.
    Deck& set_all(const std::vector<std::string>& overrides);

    // Gives [section.NAME] a law of the program's own instead of its stiffness.
    Deck& set_law(const std::string& section, std::shared_ptr<const SectionLaw> law);
    // Gives it a law without a memory, of the strains (Γ, K) alone. Several threads call it at once.
    Deck& set_law(const std::string& section, std::function<SectionResponse(const Vec6& strain)> law);
    // Gives [spring.NAME] a force in addition to its stiffness and damping, tension positive: by its length,
    // or by its length and the rate of that.
    Deck& set_force(const std::string& spring, std::function<double(double length)> force);
    Deck& set_force(const std::string& spring, SpringLaw::Force force);
    // Gives the [[load]] of this index a force in addition: by time, position and velocity of its point,
    // global.
    Deck& set_force(std::size_t load, MotionForce force);
    // Gives [input.NAME] a course over time. Expressions of the deck read it by its name.
    Deck& set_input(const std::string& input, std::function<double(double time)> course);

    // Checks and builds all. Throws DeckError with all that is wrong, with file, line, column and key of
    // each.
    Problem build() const;
    // Builds one that is only compared with another one of the same deck, as vary does: without its text.
    Problem build_varied() const;

    // Return the deck as it was read, and what was set since, "KEY=VALUE" in their order.
    const std::shared_ptr<const DeckTemplate>& source() const { return read_; }
    const std::vector<std::string>& overrides() const { return overrides_; }

  private:
    explicit Deck(std::shared_ptr<const DeckTemplate> read) : read_(std::move(read)) {}
    Deck& add(std::function<void(Problem&)> change);
    Problem build(bool is_varied) const;

    std::shared_ptr<const DeckTemplate> read_;
    std::vector<std::string> overrides_;
    std::vector<std::function<void(Problem&)>> changes_;  // of each problem that is built
};

// Lists what `gxrod check` finds about a problem, a sentence each: notes, warnings and errors.
std::vector<std::string> check(const Problem& problem);

}  // namespace gxrod
