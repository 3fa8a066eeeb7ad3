#include "deck/sections/section_twist.hpp"

#include <cmath>

#include "deck/places/angle_note.hpp"

namespace gxrod {

SectionTwist::SectionTwist(const NumberAlong& twist) {
    if (const auto* total = std::get_if<double>(&twist)) {
        rows_ = {{0.0, 0.0}, {1.0, *total}};
    } else {
        rows_ = std::get<CheckedProfile>(twist).rows;
    }
}

double SectionTwist::at(double fraction) const {
    std::size_t i = 1;
    while (i + 1 < rows_.size() && fraction > rows_[i].first) ++i;
    const auto& [from, before] = rows_[i - 1];
    const auto& [to, after] = rows_[i];
    return to > from ? before + (after - before) * (fraction - from) / (to - from) : after;
}

double SectionTwist::find_largest() const {
    double largest = 0.0;
    for (const auto& [fraction, angle] : rows_) {
        if (std::abs(angle) > std::abs(largest)) largest = angle;
    }
    return largest;
}

SectionTwist find_twist(const RodTable& rod, const SectionFile* file, const BuildContext& context) {
    if (file == nullptr || file->twist.empty()) {
        const SectionTwist twist(rod.twist);
        const std::string note = describe_many_turns(twist.find_largest());
        if (!note.empty()) context.notes.push_back(rod.path_of(&rod.twist) + ": " + note);
        return twist;
    }
    if (rod.gives(rod.twist))
        context.add_fault(
            rod, rod.twist, "the file of its sections has a column twist; only one of them can be");
    return SectionTwist(file->twist);
}

}  // namespace gxrod
