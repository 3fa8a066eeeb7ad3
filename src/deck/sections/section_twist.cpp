#include "deck/sections/section_twist.hpp"

namespace gxrod {

SectionTwist::SectionTwist(const CheckedValue& twist) {
    if (const auto* total = std::get_if<double>(&twist.value)) {
        rows_ = {{0.0, 0.0}, {1.0, *total}};
    } else {
        rows_ = std::get<CheckedProfile>(twist.value).rows;
    }
}

double SectionTwist::at(double fraction) const {
    std::size_t i = 1;
    while (i + 1 < rows_.size() && fraction > rows_[i].first) ++i;
    const auto& [from, before] = rows_[i - 1];
    const auto& [to, after] = rows_[i];
    return to > from ? before + (after - before) * (fraction - from) / (to - from) : after;
}

SectionTwist find_twist(const CheckedTable& rod, const SectionFile* file, const BuildContext& context) {
    if (file == nullptr || file->twist.empty()) return SectionTwist(*rod.find("twist"));
    if (rod.gives("twist"))
        context.add_fault(
            rod, "twist", "the file of its sections has a column twist; only one of them can be");
    return SectionTwist(file->twist);
}

}  // namespace gxrod
