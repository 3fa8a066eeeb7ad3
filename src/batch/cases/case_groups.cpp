#include "batch/cases/case_groups.hpp"

#include <algorithm>
#include <cctype>
#include <map>

namespace gxrod {
namespace {

template <class Text>
std::vector<CaseGroup> group_rows(const std::vector<CaseRow>& rows, Text&& text_of) {
    std::vector<CaseGroup> groups;
    std::map<std::string, std::size_t> known;
    for (const CaseRow& row : rows) {
        const std::string& text = text_of(row);
        if (text.empty()) continue;
        const std::string key = std::string(name_of(row.status)) + leave_out_numbers(text);
        const auto [place, is_new] = known.try_emplace(key, groups.size());
        if (is_new) groups.push_back({row.status, text, {}});
        groups[place->second].numbers.push_back(row.number);
    }
    std::stable_sort(groups.begin(), groups.end(), [](const CaseGroup& a, const CaseGroup& b) {
        return a.numbers.size() > b.numbers.size();
    });
    return groups;
}

}  // namespace

std::string leave_out_numbers(const std::string& text) {
    std::string rest;
    const auto is_digit = [](char letter) { return std::isdigit(static_cast<unsigned char>(letter)) != 0; };
    for (std::size_t i = 0; i < text.size(); ++i) {
        const bool is_exponent = (text[i] == 'e' || text[i] == '-' || text[i] == '+' || text[i] == '.') &&
                                 !rest.empty() && rest.back() == '#' && i + 1 < text.size() &&
                                 (is_digit(text[i + 1]) || text[i + 1] == '-' || text[i + 1] == '+');
        const bool is_sign = text[i] == '-' && i + 1 < text.size() && is_digit(text[i + 1]);
        if (!is_digit(text[i]) && !is_exponent && !is_sign) {
            rest += text[i];
        } else if (rest.empty() || rest.back() != '#') {
            rest += '#';
        }
    }
    return rest;
}

std::vector<CaseGroup> group_failures(const std::vector<CaseRow>& rows) {
    return group_rows(rows, [](const CaseRow& row) -> const std::string& { return row.reason; });
}

std::vector<CaseGroup> group_warnings(const std::vector<CaseRow>& rows) {
    return group_rows(rows, [](const CaseRow& row) -> const std::string& { return row.warning; });
}

}  // namespace gxrod
