#pragma once

#include <string_view>

// What the readers are tried with: each of these takes any bytes and hands them to one reader. They return if
// the reader takes the input or refuses it as documented; whatever else it throws comes out of them.
namespace gxrod::fuzz {

// A deck. Lines that start with "#set " are overrides too. What is accepted can be written and read again.
void try_deck(std::string_view input);
// A plan, which finds a deck "deck.toml" and a table "table.csv" next to it; its cases' overrides are made.
void try_plan(std::string_view input);
// An expression, as each kind of value takes it.
void try_expression(std::string_view input);
// Of input that starts with '$' a mesh file, of any other a list of line elements in binary.
void try_mesh(std::string_view input);

}  // namespace gxrod::fuzz
