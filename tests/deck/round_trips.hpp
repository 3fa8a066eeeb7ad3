#pragma once

#include <functional>
#include <string>
#include <vector>

#include "deck/problem.hpp"

// Round trips of keys, for the tests that want one of every key of the schema.
namespace gxrod::test {

// A deck with a value other than the default for one key, and whether the problem has that value.
struct RoundTrip {
    std::string key;  // path in the schema
    std::string deck;
    std::function<bool(const Problem&)> is_seen;
};

std::vector<RoundTrip> section_trips();
std::vector<RoundTrip> shape_trips();
std::vector<RoundTrip> matrix_trips();
std::vector<RoundTrip> rod_trips();
std::vector<RoundTrip> body_trips();
std::vector<RoundTrip> looks_trips();
std::vector<RoundTrip> plane_trips();
std::vector<RoundTrip> connection_and_initial_trips();
std::vector<RoundTrip> response_trips();
std::vector<RoundTrip> sweep_trips();
std::vector<RoundTrip> analysis_trips();
std::vector<RoundTrip> path_trips();
std::vector<RoundTrip> stage_trips();
std::vector<RoundTrip> follow_trips();
std::vector<RoundTrip> law_trips();
std::vector<RoundTrip> drive_trips();
std::vector<RoundTrip> surroundings_trips();
std::vector<RoundTrip> contact_trips();
std::vector<RoundTrip> section_frame_trips();
std::vector<RoundTrip> spin_trips();
std::vector<RoundTrip> rest_trips();
std::vector<RoundTrip> history_frame_trips();

// Decks of decks.hpp with a line more.
std::string with_body_key(const std::string& line);
std::string with_rod_key(const std::string& line);
std::string with_history(const std::string& line);
// Two stages, whose first is the deck's analysis.
std::string staged(std::string deck);
// Of an analysis that finds shapes.
std::string shape_deck(const std::string& kind, const std::string& key);

}  // namespace gxrod::test
