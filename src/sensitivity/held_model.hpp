#pragma once

#include <memory>
#include <optional>
#include <vector>

#include "model/model.hpp"
#include "model/sections/kinked_law.hpp"

namespace gxrod {

class HeldLaw;

// The pieces of its law, KinkedLaw::find_pieces, on which each force point with a law with kinks is.
using Pieces = std::vector<std::vector<int>>;

// A model whose sections can be held on pieces of their laws. If any has kinks, it is a copy of the given
// one, in which each force point has a law of its own.
class HeldModel {
  public:
    // Takes a model that must outlive this.
    explicit HeldModel(const Model& given);
    HeldModel(const HeldModel&) = delete;
    HeldModel& operator=(const HeldModel&) = delete;

    const Model& model() const { return copy_ ? *copy_ : *given_; }
    bool has_kinks() const { return !laws_.empty(); }
    // From now on laws find their pieces (release), note the pieces that they find (note), or are held on
    // these pieces (hold).
    void release();
    void note();
    void hold(const Pieces& pieces);
    // Returns the pieces that laws noted last or are held on.
    Pieces pieces() const;

  private:
    std::shared_ptr<HeldLaw> make_law(const std::shared_ptr<const SectionLaw>& law);

    const Model* given_;
    std::optional<Model> copy_;
    std::vector<std::shared_ptr<HeldLaw>> laws_;
};

}  // namespace gxrod
