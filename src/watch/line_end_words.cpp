#include "watch/line_end_words.hpp"

#include "watch/quantities.hpp"

namespace gxrod {

std::vector<std::string> list_line_end_words(const Watched& target, const Model& model) {
    std::vector<std::string> words{"effective_tension",
                                   "wall_tension",
                                   "shear_force",
                                   "bending_moment",
                                   "axis_x",
                                   "force_spatial",
                                   "moment_spatial",
                                   "touch_down_start",
                                   "touch_down_end"};
    std::erase_if(words,
                  [&](const std::string& word) { return !explain_missing(word, target, model).empty(); });
    return words;
}

}  // namespace gxrod
