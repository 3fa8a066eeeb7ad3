#include "report/report.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <nlohmann/json.hpp>
#include <optional>
#include <stdexcept>
#include <system_error>

#include "machine/file_error.hpp"
#include "report/blocks/contact_blocks.hpp"
#include "report/blocks/data_blocks.hpp"
#include "report/blocks/envelope_blocks.hpp"
#include "report/blocks/frame_blocks.hpp"
#include "report/blocks/outline_blocks.hpp"
#include "report/blocks/section_blocks.hpp"
#include "report/blocks/step_blocks.hpp"
#include "report/findings/findings.hpp"
#include "report/page_file.hpp"
#include "report/page_template.hpp"
#include "report/run_story.hpp"
#include "report/script_json.hpp"
#include "results/file/guarded_reading.hpp"
#include "results/file/output_file.hpp"
#include "results/file/results_access.hpp"

namespace gxrod {

namespace {

constexpr std::size_t most_blocks = 23;
constexpr double bytes_in_megabyte = 1e6;

// Frames that the file counts and has times of.
std::size_t count_frames(const Hdf5Reader& file) {
    const std::int64_t counted = file.integer_attribute("/VTKHDF/Steps", "NSteps");
    return std::min(static_cast<std::size_t>(std::max<std::int64_t>(counted, 0)),
                    static_cast<std::size_t>(file.size("/VTKHDF/Steps/Values").at(0)));
}

// A page being made from open results.
class Page {
  public:
    Page(const Hdf5Reader& file, const ReportOptions& options, const std::string& doubt)
        : file_(file),
          options_(options),
          story_(read_run_story(file)),
          charts_(list_charts(file, story_.is_static)),
          contacts_(file, count_frames(file)) {
        content_.topology = &story_.topology;
        content_.marked_nodes = story_.marked_nodes;
        content_.frames = count_frames(file);
        content_.steps = file.size("/histories/time").at(0);
        for (const StepChart& chart : charts_) content_.columns += chart.columns();
        content_.arrows = story_.arrows.size();
        content_.touches = contacts_.most_touches();
        if (story_.problem) {
            content_.moved_obstacles = count_moved_obstacles(story_.problem->model);
            mesh_bytes_ = count_mesh_bytes(story_.problem->model);
            draws_meshes_ = mesh_bytes_ <= options.most_bytes / 4;
            outlines_ = OutlineBlocks(story_.problem->outlines, most_bodies, options.most_bytes / 4);
        }
        content_.is_static = story_.is_static;
        content_.has_sections = file.has("/sections/name");
        for (const char* name : {"von_mises", "exposure"}) {
            if (file.has(std::string("/VTKHDF/CellData/") + name)) content_.cell_scalars.emplace_back(name);
        }
        const std::size_t room = options.most_bytes - std::min(options.most_bytes, shell_.size());
        findings_.emplace(file, options.results, charts_, content_, room);
        content_.shape_vectors = findings_->count_shape_vectors();
        sections_.emplace(file, room / 5);
        envelopes_.emplace(file, room / 10);
        warnings_ = list_warnings(file, story_, content_.steps);
        if (!doubt.empty()) warnings_.push_back("This file is in doubt: " + doubt + ".");
    }

    ReportSummary write(std::ostream& out) {
        plan(shell_.size());
        out << shell_.before;
        write_description(out, describe());
        write_frame_blocks(file_, plan_, content_, story_.arrows, out);
        write_contacts(out);
        outlines_.write(out);
        sections_->write(out);
        envelopes_->write(out);
        write_step_blocks(file_, charts_, plan_.steps, content_.steps, out);
        findings_->write(plan_, out);
        out << shell_.after;
        return {static_cast<std::size_t>(out.tellp()), left_out(), warnings_};
    }

  private:
    void write_contacts(std::ostream& out) {
        const std::vector<std::size_t> frames = plan_.frames(content_.frames);
        contacts_.write(frames, out);
        if (!story_.problem) return;
        if (draws_meshes_) write_obstacle_meshes(story_.problem->model, out);
        const std::vector<double> all = file_.rows("/VTKHDF/Steps/Values", 0, content_.frames, 1);
        std::vector<double> times;
        for (const std::size_t frame : frames) times.push_back(all[frame]);
        write_obstacle_motions(file_, *story_.problem, times, out);
    }

    void plan(std::size_t shell_bytes) {
        // Sentences on what is left out come later.
        constexpr std::size_t sentences = 2000;
        const std::size_t fixed = shell_bytes + write_script_json(describe()).size() + sentences +
                                  (most_blocks + content_.cell_scalars.size()) * block_frame_bytes +
                                  findings_->count_bytes() + sections_->count_bytes() +
                                  envelopes_->count_bytes() + (draws_meshes_ ? mesh_bytes_ : 0) +
                                  outlines_.count_bytes();
        try {
            if (fixed >= options_.most_bytes) throw std::length_error("no room for data");
            plan_ = plan_report(content_, options_.most_bytes - fixed);
        } catch (const std::length_error&) {
            throw FileError(options_.page,
                            fmt::format("the results do not fit into {:g} MB, however thinned",
                                        static_cast<double>(options_.most_bytes) / bytes_in_megabyte),
                            "give a larger --budget");
        }
    }

    nlohmann::ordered_json describe() const {
        nlohmann::ordered_json json = describe_run(file_, story_, [&](int node) { return number_of(node); });
        outlines_.describe(json["bodies"]);
        json["file"] = options_.results.filename().string();
        json["budget_megabytes"] = static_cast<double>(options_.most_bytes) / bytes_in_megabyte;
        json["left_out"] = left_out();
        json["warnings"] = warnings_;
        json["steps"] = content_.steps;
        json["all_frames"] = content_.frames;
        json["node_data"] = plan_.node_data;
        json["cell_data"] = plan_.cell_data;
        json["charts"] = describe_charts(charts_);
        if (!plan_.cell_scalars.empty()) json["cell_scalars"] = plan_.cell_scalars;
        findings_->describe(json);
        sections_->describe(json);
        envelopes_->describe(json);
        return json;
    }

    std::vector<std::string> left_out() const {
        std::vector<std::string> sentences = plan_.left_out;
        for (const std::vector<std::string>& others :
             {findings_->left_out(), sections_->left_out(), envelopes_->left_out(), story_.left_out})
            sentences.insert(sentences.end(), others.begin(), others.end());
        if (!contacts_.left_out().empty()) sentences.push_back(contacts_.left_out());
        if (!outlines_.left_out().empty()) sentences.push_back(outlines_.left_out());
        if (!draws_meshes_)
            sentences.push_back(fmt::format("Meshes of obstacles are not drawn: they would take {:.1f} MB.",
                                            static_cast<double>(mesh_bytes_) / bytes_in_megabyte));
        return sentences;
    }

    // Of a node of the file in the page; before there is a plan, one that is no shorter to write.
    int number_of(int node) const {
        if (plan_.nodes.empty()) return content_.topology->nodes;
        const auto found = std::lower_bound(plan_.nodes.begin(), plan_.nodes.end(), node);
        return static_cast<int>(found - plan_.nodes.begin());
    }

    const Hdf5Reader& file_;
    const ReportOptions& options_;
    PageShell shell_{page_template()};
    RunStory story_;
    std::vector<std::string> warnings_;
    std::vector<StepChart> charts_;
    ContactBlocks contacts_;
    std::size_t mesh_bytes_ = 0;
    bool draws_meshes_ = true;
    OutlineBlocks outlines_;
    ReportContent content_;
    std::optional<Findings> findings_;
    std::optional<SectionBlocks> sections_;
    std::optional<EnvelopeBlocks> envelopes_;
    ReportPlan plan_;
};

void check_page(const ReportOptions& options) {
    std::error_code ignored;
    if (std::filesystem::equivalent(options.results, options.page, ignored)) {
        throw FileError(options.page, "is the results file itself", "give another name for the page");
    }
    check_export_file(options.page, options.existing);
}

ReportSummary write_page(const ReportOptions& options, const std::string& doubt) {
    ReportSummary summary;
    read_results(options.results, [&](const Hdf5Reader& file) {
        check_page(options);
        if (count_frames(file) == 0) {
            throw FileError(options.results, "has no frame yet, so there is nothing to show");
        }
        PageFile page(options.page);
        summary = Page(file, options, doubt).write(page.out());
        page.finish();
    });
    return summary;
}

// A summary as text and back, from a process that read the results.
std::string text_of(const ReportSummary& summary) {
    const nlohmann::json json{summary.bytes, summary.left_out, summary.warnings};
    return json.dump(-1, ' ', false, nlohmann::json::error_handler_t::replace);
}

ReportSummary summary_of(const std::string& text) {
    const nlohmann::json json = nlohmann::json::parse(text);
    return {json.at(0), json.at(1), json.at(2)};
}

}  // namespace

ReportSummary write_report(const ReportOptions& options) {
    const GuardedReading reading(options.results);
    return summary_of(reading.read([&] { return text_of(write_page(options, reading.doubt())); }));
}

}  // namespace gxrod
