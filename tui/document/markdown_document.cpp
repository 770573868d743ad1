#include "tui/document/markdown_document.hpp"

#include "acquisition/foundation/utf8.hpp"

#include <fmt/format.h>

#include <string_view>

namespace tapfit::tui {
namespace {

/// What Markdown would take for markup, with a backslash; one line.
std::string plain(std::string_view text) {
  std::string out;
  for (const char c : acquisition::printable(text)) {
    if (std::string_view("\\`*_[]<>|#&").find(c) != std::string_view::npos) {
      out += '\\';
    }
    out += c == '\n' || c == '\t' ? ' ' : c;
  }
  return out;
}

/// A link's target: blanks and brackets would end it.
std::string target(std::string_view path) {
  std::string out;
  for (const char c : path) {
    if (std::string_view(" ()<>%").find(c) == std::string_view::npos) {
      out += c;
    } else {
      out += fmt::format("%{:02X}", static_cast<unsigned char>(c));
    }
  }
  return out;
}

struct Printer {
  const std::string& folder;

  std::string operator()(const Paragraph& paragraph) const {
    const bool verdict = paragraph.kind == Paragraph::Kind::Verdict;
    return fmt::format("{}{}{}\n\n",
                       verdict ? "> **" : "",
                       plain(paragraph.text),
                       verdict ? "**" : "");
  }
  std::string operator()(const BulletList& list) const {
    std::string text;
    for (const std::string& item : list.items)
      text += "- " + plain(item) + "\n";
    return text + (text.empty() ? "" : "\n");
  }
  std::string operator()(const DataTable& table) const {
    std::string text;
    if (!table.caption.empty()) text += plain(table.caption) + "\n\n";
    std::string rule;
    for (const std::string& heading : table.heading) {
      const ColumnName name = column_name(heading);
      text += "| " + plain(name.text) + " ";
      rule += name.left ? "|---" : "|--:";
    }
    text += "|\n" + rule + "|\n";
    for (const auto& row : table.rows) {
      for (std::size_t k = 0; k < table.heading.size(); ++k) {
        text += "| " + (k < row.size() ? plain(row[k]) : "") + " ";
      }
      text += "|\n";
    }
    return text + "\n";
  }
  std::string operator()(const Figure& figure) const {
    return fmt::format("![{}]({}/{}.svg)\n\n{}\n\n",
                       plain(figure.name),
                       target(folder),
                       figure.name,
                       plain(figure.caption));
  }
  std::string operator()(const FigureRow& row) const {
    std::string text;
    for (const Figure& figure : row.figures) text += (*this)(figure);
    return text;
  }
};

}  // namespace

std::string as_markdown(const Document& document, const std::string& folder) {
  std::string text = fmt::format(
      "# {}\n\n{}\n\n", plain(document.title), plain(document.subtitle));
  const Printer printer{folder};
  for (const Section& section : document.sections) {
    if (!section.title.empty()) text += "## " + plain(section.title) + "\n\n";
    for (const Part& part : section.parts) text += std::visit(printer, part);
  }
  text.pop_back();
  return text;
}

std::vector<Figure> figures_of(const Document& document) {
  std::vector<Figure> figures;
  for (const Section& section : document.sections) {
    for (const Part& part : section.parts) {
      if (const auto* figure = std::get_if<Figure>(&part)) {
        figures.push_back(*figure);
      } else if (const auto* row = std::get_if<FigureRow>(&part)) {
        figures.insert(figures.end(), row->figures.begin(), row->figures.end());
      }
    }
  }
  return figures;
}

}  // namespace tapfit::tui
