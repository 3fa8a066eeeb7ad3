#include "deck/expressions/use_order.hpp"

#include <algorithm>

namespace gxrod {
namespace {

class Search {
  public:
    explicit Search(const Uses& uses) : uses_(uses) {}

    void visit(const std::string& name) {
        const auto open = std::find(path_.begin(), path_.end(), name);
        if (open != path_.end()) {
            result_.cycles.emplace_back(open, path_.end());
            result_.in_cycle.insert(open, path_.end());
            return;
        }
        if (visited_.contains(name)) return;
        if (path_.size() >= most_use_depth) return result_.too_deep.push_back(name);
        visited_.insert(name);
        path_.push_back(name);
        for (const std::string& used : uses_.at(name)) visit(used);
        path_.pop_back();
        result_.names.push_back(name);
    }

    UseOrder release() { return std::move(result_); }

  private:
    const Uses& uses_;
    std::set<std::string> visited_;
    std::vector<std::string> path_;  // names whose uses are being visited
    UseOrder result_;
};

}  // namespace

UseOrder find_use_order(const std::vector<std::string>& names, const Uses& uses) {
    Search search(uses);
    for (const std::string& name : names) search.visit(name);
    return search.release();
}

}  // namespace gxrod
