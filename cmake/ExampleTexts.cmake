# Writes a source that holds the deck and the reference.toml of every example that has one, so that
# `gxrod verify` knows them wherever it is installed.
function(gxrod_embed_examples examples_dir output)
  file(GLOB references CONFIGURE_DEPENDS "${examples_dir}/*/reference.toml")
  set(entries "")
  foreach(reference IN LISTS references)
    get_filename_component(folder "${reference}" DIRECTORY)
    get_filename_component(name "${folder}" NAME)
    set_property(DIRECTORY APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS "${reference}" "${folder}/${name}.toml")
    file(READ "${folder}/${name}.toml" deck)
    file(READ "${reference}" reference_text)
    string(APPEND entries "        {\"${name}\", R\"deck(${deck})deck\", R\"deck(${reference_text})deck\"},\n")
  endforeach()
  file(CONFIGURE OUTPUT "${output}" @ONLY CONTENT
"#include \"verification/example_texts.hpp\"

namespace gxrod {

const std::vector<ExampleText>& example_texts() {
    static const std::vector<ExampleText> all = {
@entries@    };
    return all;
}

}  // namespace gxrod
")
endfunction()

# Writes a source that holds the decks that `gxrod init` writes.
function(gxrod_embed_first_decks folder output)
  file(GLOB decks CONFIGURE_DEPENDS "${folder}/*.toml")
  set(entries "")
  foreach(deck IN LISTS decks)
    set_property(DIRECTORY APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS "${deck}")
    get_filename_component(name "${deck}" NAME_WE)
    file(READ "${deck}" text)
    string(APPEND entries "        {\"${name}\", R\"deck(${text})deck\"},\n")
  endforeach()
  file(CONFIGURE OUTPUT "${output}" @ONLY CONTENT
"#include \"first_decks.hpp\"

namespace gxrod {

const std::vector<FirstDeck>& list_first_decks() {
    static const std::vector<FirstDeck> all = {
@entries@    };
    return all;
}

}  // namespace gxrod
")
endfunction()

# Writes a source that holds the tables of the catalogue of profiles.
function(gxrod_embed_catalogue folder output)
  file(GLOB tables CONFIGURE_DEPENDS "${folder}/*.csv")
  set(entries "")
  foreach(table IN LISTS tables)
    set_property(DIRECTORY APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS "${table}")
    file(READ "${table}" text)
    string(APPEND entries "        R\"csv(${text})csv\",\n")
  endforeach()
  file(CONFIGURE OUTPUT "${output}" @ONLY CONTENT
"#include \"cross_section/catalogue/catalogue_texts.hpp\"

namespace gxrod {

const std::vector<std::string_view>& catalogue_texts() {
    static const std::vector<std::string_view> all = {
@entries@    };
    return all;
}

}  // namespace gxrod
")
endfunction()
