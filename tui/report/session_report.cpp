#include "tui/report/session_report.hpp"

#include "acquisition/foundation/output_file.hpp"
#include "tui/document/html_document.hpp"
#include "tui/document/markdown_document.hpp"
#include "tui/report/report_front.hpp"
#include "tui/report/report_measurement.hpp"
#include "tui/report/report_model.hpp"
#include "tui/report/report_record.hpp"
#include "tui/report/report_shapes.hpp"

#include <fmt/format.h>

#include <iterator>

namespace tapfit::tui {
namespace {

void append(std::vector<Section>& sections, std::vector<Section> more) {
  sections.insert(sections.end(),
                  std::make_move_iterator(more.begin()),
                  std::make_move_iterator(more.end()));
}

bool is_markdown(const std::filesystem::path& path) {
  return path.extension() == ".md" || path.extension() == ".markdown";
}

}  // namespace

Document report_document(const ReportData& data) {
  Document document;
  document.title =
      data.bundle.title.empty() ? "Hammer test" : data.bundle.title;
  document.subtitle = fmt::format("Report of {}", data.date);
  append(document.sections, front_sections(data));
  append(document.sections, measurement_sections(data));
  if (!data.modes.modes.empty()) {
    document.sections.push_back(shape_section(data));
  }
  append(document.sections, model_sections(data));
  append(document.sections, record_sections(data));
  return document;
}

void write_report(const Document& document, const std::filesystem::path& path) {
  if (!is_markdown(path)) return acquisition::write_file(path, as_html(document));
  const std::string name = path.stem().string() + "-files";
  acquisition::OutputFolder pictures(path.parent_path() / name, {{}, true});
  for (const Figure& figure : figures_of(document)) {
    acquisition::write_file(pictures.file(figure.name + ".svg"),
                            figure.svg + "\n");
  }
  pictures.commit();
  acquisition::write_file(path, as_markdown(document, name));
}

}  // namespace tapfit::tui
