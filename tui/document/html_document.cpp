#include "tui/document/html_document.hpp"

#include "acquisition/foundation/utf8.hpp"
#include "tui/document/markup_text.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <iterator>
#include <string_view>

namespace tapfit::tui {
namespace {

constexpr std::string_view style = R"(
*{box-sizing:border-box}
body{font:15px/1.5 system-ui,"Segoe UI",Helvetica,Arial,sans-serif;color:#1a1a1a;
background:#fff;margin:0 auto;padding:1.2rem 1rem 3rem;max-width:60rem}
h1{font-size:1.7rem;line-height:1.2;margin:.2rem 0 .3rem}
h2{font-size:1.2rem;margin:2.2rem 0 .6rem;padding-bottom:.2rem;
border-bottom:1px solid #bbb}
p{margin:.5rem 0;overflow-wrap:anywhere}
.subtitle,.small{color:#555;font-size:.86rem}
.verdict{font-size:1.12rem;line-height:1.45;border-left:4px solid #0072b2;
background:#eef5fa;padding:.7rem .9rem;margin:.9rem 0}
ul{margin:.4rem 0;padding-left:1.3rem}
li{margin:.2rem 0;overflow-wrap:anywhere}
.scroll{overflow-x:auto;margin:.7rem 0}
table{border-collapse:collapse;font-size:.86rem;line-height:1.35}
caption{text-align:left;font-weight:600;padding:.2rem 0}
th,td{padding:.22rem .8rem .22rem 0;text-align:right;vertical-align:top;
border-bottom:1px solid #e2e2e2;font-variant-numeric:tabular-nums}
th{border-bottom:1px solid #888;color:#333;font-weight:600}
td:not(.l),th:not(.l){white-space:nowrap}
.l{text-align:left}
.facts thead{display:none}
.facts tr{display:flex;flex-wrap:wrap;gap:.3rem 1.6rem}
.facts td{display:block;text-align:left;border:0;padding:0}
.facts td::before{content:attr(data-n);display:block;color:#555;font-size:.9em}
figure{margin:.8rem 0;overflow-x:auto}
figure svg{display:block;width:100%;height:auto}
figcaption{color:#444;font-size:.84rem;margin-top:.2rem}
.row{display:grid;gap:.4rem 1.2rem;
grid-template-columns:repeat(auto-fill,minmax(min(17rem,100%),1fr))}
.row.pair{grid-template-columns:repeat(auto-fill,minmax(min(22rem,100%),1fr))}
.row figure{min-width:0;margin:.4rem 0}
@media(max-width:600px){body{font-size:14px;padding:.8rem .7rem 2rem}
figure.wide svg{min-width:30rem}
.cards thead{display:none}
.cards tr{display:block;padding:.3rem 0;border-bottom:1px solid #bbb}
.cards td{display:flex;text-align:left;border:0;padding:.1rem 0}
.cards td:not(.l){white-space:normal}
.cards td:first-child{font-weight:600}.cards td:empty{display:none}
.cards td::before{content:attr(data-n);flex:0 0 8rem;color:#555;
font-weight:400}
.scroll th{white-space:normal}.scroll td,.scroll th{padding-right:.55rem}
figure.wide svg text{font-size:16px}
h1{font-size:1.35rem}.verdict{font-size:1rem}}
@media print{html{font-size:9pt}
body{font-size:1rem;line-height:1.4;max-width:none;padding:0}
h1{font-size:1.6rem;margin-top:0}
h2{break-after:avoid;font-size:1.15rem;margin:.8rem 0 .2rem}
th,td{padding:.12rem .7rem .12rem 0}
.verdict{font-size:1.1rem;padding:.5rem .8rem;margin:.6rem 0}
p,.scroll,figure,.row figure{margin:.3rem 0}
.page{break-before:page}.page h2{margin-top:0}
figure,.verdict,.short{break-inside:avoid}.scroll,figure{overflow:visible}
tr{break-inside:avoid}thead{display:table-header-group}
.row{grid-template-columns:repeat(3,1fr)}
.row.pair{grid-template-columns:1fr 1fr}table{font-size:.9rem}}
)";

// Pictures move on screens only, and where nobody asked for less.
constexpr std::string_view script = R"(
(function(){var all=document.querySelectorAll('svg'),
still=function(){all.forEach(function(s){if(s.pauseAnimations){
s.setCurrentTime(0);s.pauseAnimations();}});},
go=function(){all.forEach(function(s){if(s.unpauseAnimations)
s.unpauseAnimations();});};
addEventListener('beforeprint',still);
if(matchMedia('(prefers-reduced-motion: reduce)').matches)still();
else addEventListener('afterprint',go);})();
)";

/// A text between quotes in a style sheet, which no tag can end.
std::string css_string(std::string_view text) {
  std::string out;
  for (const char c : acquisition::printable(text)) {
    if (c == '"' || c == '\\' || c == '<') {
      out += fmt::format("\\{:x} ", static_cast<int>(c));
    } else {
      out += c == '\n' || c == '\t' ? ' ' : c;
    }
  }
  return out;
}

/// Sheets of paper, each with what it belongs to and its number at its foot.
std::string page_rule(const Document& document) {
  constexpr std::string_view how =
      "font:8pt system-ui,Helvetica,Arial,sans-serif;color:#555";
  return fmt::format(
      "\n@page{{size:A4;margin:15mm 15mm 17mm;\n"
      "@bottom-left{{content:\"{} · {}\";{}}}\n"
      "@bottom-right{{content:\"page \" counter(page) \" of \" "
      "counter(pages);{}}}}}",
      css_string(document.title),
      css_string(document.subtitle),
      how,
      how);
}

/// Escaped, with a number and its % on one line.
std::string prose(std::string_view text) {
  std::string out = escaped(text);
  for (std::size_t at = out.find(" %"); at != std::string::npos;
       at = out.find(" %", at + 1)) {
    out.replace(at, 1, "&#160;");
  }
  return out;
}

std::string html_of(const Paragraph& paragraph) {
  const char* kind =
      paragraph.kind == Paragraph::Kind::Verdict ? " class=\"verdict\""
      : paragraph.kind == Paragraph::Kind::Small ? " class=\"small\""
                                                 : "";
  return fmt::format("<p{}>{}</p>\n", kind, prose(paragraph.text));
}

std::string html_of(const BulletList& list) {
  if (list.items.empty()) return {};
  std::string text = "<ul>\n";
  for (const std::string& item : list.items) {
    text += "<li>" + prose(item) + "</li>\n";
  }
  return text + "</ul>\n";
}

/// @param named whether each cell carries its column's name, to stand without
///   the heading
std::string row_of(const std::vector<std::string>& cells,
                   const std::vector<std::string>& heading,
                   const char* tag,
                   bool named = false) {
  std::string text = "<tr>";
  for (std::size_t k = 0; k < heading.size(); ++k) {
    const ColumnName column = column_name(heading[k]);
    text += fmt::format("<{}{}{}>{}</{}>",
                        tag,
                        column.left ? " class=\"l\"" : "",
                        named ? " data-n=\"" + escaped(column.text) + "\"" : "",
                        k < cells.size() ? escaped(cells[k]) : "",
                        tag);
  }
  return text + "</tr>\n";
}

/// Rows that stay on one sheet of paper.
bool is_short(const DataTable& table) { return table.rows.size() <= 12; }

/// One row of words alone is a list of facts. Few rows with words in them, or
/// of many columns, become cards, their cells one below the other, where there
/// is no room for columns.
enum class Shape { Rows, Facts, Cards };
Shape shape_of(const DataTable& table) {
  const auto columns = std::ssize(table.heading);
  const auto words = std::ranges::count_if(
      table.heading,
      [](const std::string& heading) { return column_name(heading).left; });
  constexpr std::ptrdiff_t most = 6;  // of numbers, beside each other
  if (columns < 3 || (words < 2 && columns <= most) || !is_short(table)) {
    return Shape::Rows;
  }
  const bool facts = table.rows.size() == 1 && words == columns;
  return facts ? Shape::Facts : Shape::Cards;
}

std::string html_of(const DataTable& table) {
  std::vector<std::string> names;
  for (const std::string& heading : table.heading) {
    names.push_back(column_name(heading).text);
  }
  const Shape shape = shape_of(table);
  std::string text = fmt::format("<div class=\"scroll{}{}\"><table>\n",
                                 is_short(table) ? " short" : "",
                                 shape == Shape::Facts   ? " facts"
                                 : shape == Shape::Cards ? " cards"
                                                         : "");
  if (!table.caption.empty()) {
    text += "<caption>" + escaped(table.caption) + "</caption>\n";
  }
  text +=
      "<thead>" + row_of(names, table.heading, "th") + "</thead>\n<tbody>\n";
  for (const auto& row : table.rows) {
    text += row_of(row, table.heading, "td", shape != Shape::Rows);
  }
  return text + "</tbody></table></div>\n";
}

std::string html_figure(const Figure& figure, bool wide) {
  return fmt::format("<figure{}>{}<figcaption>{}</figcaption></figure>\n",
                     wide ? " class=\"wide\"" : "",
                     figure.svg,
                     prose(figure.caption));
}

std::string html_of(const Figure& figure) { return html_figure(figure, true); }

std::string html_of(const FigureRow& row) {
  std::string text = row.figures.size() <= 2 ? "<div class=\"row pair\">\n"
                                             : "<div class=\"row\">\n";
  for (const Figure& figure : row.figures) text += html_figure(figure, false);
  return text + "</div>\n";
}

}  // namespace

std::string as_html(const Document& document) {
  std::string text = fmt::format(
      "<!DOCTYPE html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\"/>\n"
      "<meta name=\"viewport\" "
      "content=\"width=device-width, initial-scale=1\"/>\n"
      "<title>{0}</title>\n<style>{1}{2}</style>\n</head>\n<body>\n"
      "<h1>{0}</h1>\n<p class=\"subtitle\">{3}</p>\n",
      escaped(document.title),
      page_rule(document),
      style,
      escaped(document.subtitle));
  for (const Section& section : document.sections) {
    text += section.new_page ? "<section class=\"page\">\n" : "<section>\n";
    if (!section.title.empty()) {
      text += "<h2>" + escaped(section.title) + "</h2>\n";
    }
    for (const Part& part : section.parts) {
      text += std::visit([](const auto& p) { return html_of(p); }, part);
    }
    text += "</section>\n";
  }
  return text + fmt::format("<script>{}</script>\n</body>\n</html>\n", script);
}

}  // namespace tapfit::tui
