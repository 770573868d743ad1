#include "tui/report/session_report.hpp"

#include "acquisition/foundation/input_error.hpp"
#include "tui/document/html_document.hpp"
#include "tui/document/markdown_document.hpp"
#include "tui/report/report_front.hpp"
#include "tui/report/report_measurement.hpp"
#include "tui/report/report_model.hpp"
#include "tui/report/report_record.hpp"
#include "tui/report/report_shapes.hpp"

#include <fmt/format.h>

#include <fstream>
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

std::filesystem::path usual_report(const std::filesystem::path& session) {
  return session.parent_path() / "report.html";
}

void write_report(const Document& document, const std::filesystem::path& path) {
  if (!is_markdown(path)) return write_text_file(as_html(document), path);
  const std::string folder = path.stem().string() + "-files";
  std::error_code ignored;
  std::filesystem::create_directories(path.parent_path() / folder, ignored);
  for (const Figure& figure : figures_of(document)) {
    write_text_file(figure.svg + "\n",
                    path.parent_path() / folder / (figure.name + ".svg"));
  }
  write_text_file(as_markdown(document, folder), path);
}

void write_text_file(const std::string& text,
                     const std::filesystem::path& path) {
  std::ofstream file(path, std::ios::binary);
  file << text;
  if (!file.flush()) {
    throw InputError(
        "cannot be written", path.string(), "check folder and permissions");
  }
}

}  // namespace tapfit::tui
