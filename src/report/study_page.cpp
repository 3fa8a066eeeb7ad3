#include "report/study_page.hpp"

#include <nlohmann/json.hpp>

#include "report/page_file.hpp"
#include "report/page_template.hpp"
#include "report/script_json.hpp"
#include "results/file/output_file.hpp"

namespace gxrod {

std::size_t write_study_page(const nlohmann::ordered_json& study,
                             const std::filesystem::path& page,
                             Existing existing) {
    check_export_file(page, existing);
    PageFile file(page);
    const PageShell shell(study_template());
    file.out() << shell.before;
    write_description(file.out(), study);
    file.out() << shell.after;
    const auto bytes = static_cast<std::size_t>(file.out().tellp());
    file.finish();
    return bytes;
}

}  // namespace gxrod
