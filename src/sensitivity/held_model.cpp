#include "sensitivity/held_model.hpp"

#include <algorithm>

namespace gxrod {

// The law of one force point, which a single thread asks.
class HeldLaw final : public SectionLaw {
  public:
    enum class Mode { free, notes, held };

    HeldLaw(std::shared_ptr<const SectionLaw> law, const KinkedLaw& kinked)
        : law_(std::move(law)), kinked_(kinked), pieces_(static_cast<std::size_t>(kinked.piece_count())) {}

    int memory_size() const override { return law_->memory_size(); }
    std::string describe() const override { return law_->describe(); }
    SectionResponse respond(const Vec6& strain,
                            std::span<const double> memory,
                            double elapsed,
                            std::span<double> after) const override {
        if (mode_ == Mode::held) return kinked_.respond_on(pieces_, strain, memory, elapsed, after);
        if (mode_ == Mode::notes) kinked_.find_pieces(strain, memory, pieces_);
        return law_->respond(strain, memory, elapsed, after);
    }

    void set(Mode mode) { mode_ = mode; }
    void hold(const std::vector<int>& pieces) {
        pieces_ = pieces;
        mode_ = Mode::held;
    }
    const std::vector<int>& pieces() const { return pieces_; }

  private:
    std::shared_ptr<const SectionLaw> law_;
    const KinkedLaw& kinked_;
    mutable std::vector<int> pieces_;
    Mode mode_ = Mode::free;
};

namespace {

bool is_kinked(const Section& section) { return section.law && as_kinked(*section.law) != nullptr; }

}  // namespace

HeldModel::HeldModel(const Model& given) : given_(&given) {
    const auto bends = [&](const Rod& rod) {
        return rod.has_varying_sections() ? std::ranges::any_of(rod.varying.at_forces, is_kinked)
                                          : is_kinked(given.sections[static_cast<std::size_t>(rod.section)]);
    };
    if (std::ranges::none_of(given.rods, bends)) return;
    copy_ = given;
    for (Rod& rod : copy_->rods) {
        if (!bends(rod)) continue;
        if (!rod.has_varying_sections()) {
            const Section& section = copy_->sections[static_cast<std::size_t>(rod.section)];
            const auto elements = static_cast<std::size_t>(rod.element_count());
            const auto points = static_cast<std::size_t>(rod.order);
            rod.varying.at_forces.assign(elements * points, section);
            rod.varying.at_masses.assign(elements * (points + 1), section);
            rod.varying.at_nodes.assign(elements * (points + 1), section);
        }
        for (Section& section : rod.varying.at_forces)
            if (is_kinked(section)) section.law = make_law(section.law);
    }
}

std::shared_ptr<HeldLaw> HeldModel::make_law(const std::shared_ptr<const SectionLaw>& law) {
    return laws_.emplace_back(std::make_shared<HeldLaw>(law, *as_kinked(*law)));
}

void HeldModel::release() {
    for (const auto& law : laws_) law->set(HeldLaw::Mode::free);
}

void HeldModel::note() {
    for (const auto& law : laws_) law->set(HeldLaw::Mode::notes);
}

void HeldModel::hold(const Pieces& pieces) {
    for (std::size_t i = 0; i < std::min(laws_.size(), pieces.size()); ++i) laws_[i]->hold(pieces[i]);
}

Pieces HeldModel::pieces() const {
    Pieces pieces;
    for (const auto& law : laws_) pieces.push_back(law->pieces());
    return pieces;
}

}  // namespace gxrod
