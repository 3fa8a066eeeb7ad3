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

std::vector<RoundTrip> law_trips();
std::vector<RoundTrip> drive_trips();
std::vector<RoundTrip> surroundings_trips();
std::vector<RoundTrip> contact_trips();
std::vector<RoundTrip> section_file_trips();
std::vector<RoundTrip> section_frame_trips();
std::vector<RoundTrip> spin_trips();
std::vector<RoundTrip> rest_trips();
std::vector<RoundTrip> history_frame_trips();

}  // namespace gxrod::test
