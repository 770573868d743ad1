#include "tui/report/session_report.hpp"

#include "acquisition/foundation/output_file.hpp"
#include "tui/document/html_document.hpp"
#include "tui/document/markdown_document.hpp"
#include "tui/report/report_evidence.hpp"
#include "tui/report/report_front.hpp"
#include "tui/report/report_measurement.hpp"
#include "tui/report/report_model.hpp"
#include "tui/report/report_record.hpp"
#include "tui/report/report_shapes.hpp"
#include "updating/export/report_files.hpp"

#include <fmt/format.h>

#include <iterator>

namespace tapfit::tui {
namespace {

void append(std::vector<Section>& sections, std::vector<Section> more) {
  sections.insert(sections.end(),
                  std::make_move_iterator(more.begin()),
                  std::make_move_iterator(more.end()));
}

}  // namespace

Document report_document(const ReportData& data) {
  Document document;
  document.title =
      data.bundle.title.empty() ? "Hammer test" : data.bundle.title;
  document.subtitle = fmt::format("Report of {}", data.date);
  append(document.sections, front_sections(data));
  append(document.sections, measurement_sections(data));
  if (!data.modes.modes.empty() && !data.modes.dofs.empty()) {
    document.sections.push_back(shape_section(data));
  }
  append(document.sections, model_sections(data));
  append(document.sections, evidence_sections(data));
  append(document.sections, firmness_sections(data));
  append(document.sections, record_sections(data));
  return document;
}

void write_report(const Document& document,
                  const std::filesystem::path& path,
                  const acquisition::OutputRule& rule) {
  updating::check_report(rule, path);
  acquisition::OutputFile report(path, rule);
  const auto folder = updating::pictures_folder(path);
  if (!folder) {
    report.stream() << as_html(document);
    return report.commit();
  }
  acquisition::OutputFolder pictures(*folder, rule);
  for (const Figure& figure : figures_of(document)) {
    pictures.write(figure.name + ".svg", figure.svg + "\n");
  }
  report.stream() << as_markdown(document, folder->filename().string());
  report.finish();
  pictures.commit();
  report.commit();
}

}  // namespace tapfit::tui
