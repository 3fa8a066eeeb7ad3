#pragma once

#include <nlohmann/json_fwd.hpp>
#include <ostream>
#include <span>
#include <string>
#include <vector>

#include "model/bodies/body_outline.hpp"

namespace gxrod {

// Writes into the page what bodies look like by the deck.
class OutlineBlocks {
  public:
    OutlineBlocks() = default;
    // Takes those of the first `most` bodies whose looks are given. If they take more than `room` bytes, none
    // is drawn.
    OutlineBlocks(const std::vector<BodyOutline>& outlines, std::size_t most, std::size_t room);

    std::size_t count_bytes() const { return bytes_; }
    // Returns a sentence on what was left out, or "".
    const std::string& left_out() const { return left_out_; }
    // Adds to the description of each body with an outline `reach`, the distance of its farthest corner from
    // the node, and `outline`: where its corners, triangles and lines begin in the blocks, and where they
    // end.
    void describe(nlohmann::ordered_json& bodies) const;
    // Writes "outline-points", "outline-triangles" and "outline-lines": from the node, body axes; corners are
    // numbered within the body.
    void write(std::ostream& out) const;

  private:
    std::vector<const BodyOutline*> drawn_;
    std::size_t bytes_ = 0;
    std::string left_out_;
};

}  // namespace gxrod
