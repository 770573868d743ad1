// A document printed as HTML and as Markdown.
#include "tests/tui/support/holds.hpp"
#include "tui/document/html_document.hpp"
#include "tui/document/markdown_document.hpp"
#include "tui/document/markup_text.hpp"

#include <gtest/gtest.h>

#include <string>

namespace tapfit::tui {
namespace {

Document small_document() {
  const Figure picture{"curve", "A & B", "<svg><g/></svg>"};
  return {"Frame <1> & \"2\"",
          "tested",
          {{"First",
            {Paragraph{"x < y", Paragraph::Kind::Verdict},
             BulletList{{"one", "two"}},
             DataTable{"sizes", {"<name", "kg"}, {{"a|b", "1"}, {"c", "2"}}}},
            false},
           {"Second", {picture, FigureRow{{picture, picture}}}, true}}};
}

std::string html_of_table(const DataTable& table) {
  Document document;
  document.sections = {{"", {table}, false}};
  return as_html(document);
}

// Without its heading a cell says itself what it is.
TEST(HtmlDocument, NamesTheCellsOfFactsAndCards) {
  DataTable table{"", {"<a", "<b", "<e&f"}, {{"1", "2", "3"}}};
  const std::string facts = html_of_table(table);
  EXPECT_TRUE(holds(facts, " facts\"><table>")) << facts;
  EXPECT_TRUE(holds(facts, "<td class=\"l\" data-n=\"e&amp;f\">3</td>"));
  table.heading[1] = "b";
  const std::string cards = html_of_table(table);
  EXPECT_TRUE(holds(cards, " cards\"><table>")) << cards;
  EXPECT_TRUE(holds(cards, "<td data-n=\"b\">2</td>"));
}

TEST(HtmlDocument, KeepsRowsOfNumbersAndLongTablesInColumns) {
  DataTable numbers{"", {"<a", "b", "c"}, {{"1", "2", "3"}}};
  EXPECT_FALSE(holds(html_of_table(numbers), "data-n=\""));
  numbers.heading[1] = "<b";
  EXPECT_TRUE(holds(html_of_table(numbers), "data-n=\""));
  numbers.heading[1] = "b";
  numbers.heading.resize(7, "c");
  EXPECT_TRUE(holds(html_of_table(numbers), "data-n=\""));
  numbers.rows.resize(13, numbers.rows.front());
  EXPECT_FALSE(holds(html_of_table(numbers), "data-n=\""));
}

// ISO/IEC 17025:2017, 7.8.2.1 d and e: each page is known as one of the report.
TEST(HtmlDocument, NumbersItsPagesUnderItsTitle) {
  const std::string html = as_html(small_document());
  EXPECT_TRUE(holds(html, "counter(page) \" of \" counter(pages)"));
  EXPECT_TRUE(holds(html, "content:\"Frame \\3c 1> & \\22 2\\22  · tested\""))
      << html.substr(0, 600);
}

// 390 px: words wrap, so that numbers beside them have room, and the labels of
// pictures stay legible.
TEST(HtmlDocument, FitsATelephone) {
  const std::string html = as_html(small_document());
  const std::size_t begin = html.find("@media(max-width:600px)");
  const std::string rules =
      html.substr(begin, html.find("@media print") - begin);
  EXPECT_TRUE(holds(rules, ".scroll th{white-space:normal}")) << rules;
  EXPECT_FALSE(holds(rules, "td{white-space:nowrap}")) << rules;
  EXPECT_TRUE(holds(rules, "figure.wide svg text{font-size:16px}")) << rules;
}

TEST(HtmlDocument, NoTitleEndsItsStyles) {
  Document document;
  document.title = "</style><p>\\\"";
  const std::string html = as_html(document);
  const std::size_t begin = html.find("<style>");
  const std::size_t end = html.find("</style>");
  EXPECT_LT(html.find("@media print"), end);
  EXPECT_TRUE(holds(html.substr(begin, end - begin),
                    "\"\\3c /style>\\3c p>\\5c \\22  · \""));
}

TEST(Escaped, LeavesNoMarkup) {
  EXPECT_EQ(escaped("<a b=\"c\">'&"), "&lt;a b=&quot;c&quot;&gt;&#39;&amp;");
}

TEST(Escaped, KeepsUtf8AndNoControlCharacters) {
  EXPECT_EQ(escaped("± N·m\x01\n"), "± N·m? ");
  EXPECT_EQ(escaped("cba\u202e\xff\x1b[31m"), "cba?ÿ?[31m");
}

TEST(HtmlDocument, EscapesEveryTextAndKeepsPictures) {
  const std::string html = as_html(small_document());
  EXPECT_TRUE(holds(html, "<h1>Frame &lt;1&gt; &amp; &quot;2&quot;</h1>"))
      << html;
  EXPECT_TRUE(holds(html, "<p class=\"verdict\">x &lt; y</p>"));
  EXPECT_TRUE(holds(html, "<svg><g/></svg><figcaption>A &amp; B"));
  EXPECT_TRUE(holds(html, "<td class=\"l\">a|b</td><td>1</td>"));
  EXPECT_TRUE(holds(html, "<section class=\"page\">"));
}

// What an HTML file would fetch it names by these.
TEST(HtmlDocument, FetchesNothing) {
  const std::string html = as_html(small_document());
  for (const char* fetched : {"src=", "href=", "url(", "@import"}) {
    EXPECT_FALSE(holds(html, fetched)) << fetched;
  }
}

TEST(HtmlDocument, ARowShorterThanItsHeadingIsFilled) {
  const Document document{
      "t", "", {{"s", {DataTable{"", {"<a", "b"}, {{"1"}}}}, false}}};
  EXPECT_TRUE(holds(as_html(document), "<td class=\"l\">1</td><td></td>"));
}

TEST(MarkdownDocument, PrintsTheSameParts) {
  const std::string text = as_markdown(small_document(), "report files");
  EXPECT_TRUE(text.starts_with("# Frame \\<1\\> \\& \"2\"\n")) << text;
  EXPECT_TRUE(holds(text, "> **x \\< y**\n"));
  EXPECT_TRUE(holds(text, "- one\n- two\n"));
  EXPECT_TRUE(holds(text, "| name | kg |\n|---|--:|\n| a\\|b | 1 |\n"));
  EXPECT_TRUE(holds(text, "![curve](report%20files/curve.svg)\n\nA \\& B\n"));
  EXPECT_TRUE(text.ends_with("\n"));
}

TEST(MarkdownDocument, KnowsEveryPicture) {
  EXPECT_EQ(figures_of(small_document()).size(), 3U);
}

}  // namespace
}  // namespace tapfit::tui
