// A document printed as HTML and as Markdown.
#include "tui/document/html_document.hpp"
#include "tui/document/markdown_document.hpp"
#include "tui/document/markup_text.hpp"

#include <gtest/gtest.h>

#include <string>

namespace tapfit::tui {
namespace {

bool holds(const std::string& text, const std::string& part) {
  return text.find(part) != std::string::npos;
}

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

TEST(HtmlDocument, NamesTheCellsOfOneLongRow) {
  Document document;
  DataTable table{
      "", {"<a", "b", "c", "d", "e&f"}, {{"1", "2", "3", "4", "5"}}};
  document.sections = {{"", {table}, false}};
  const std::string html = as_html(document);
  EXPECT_TRUE(holds(html, "upright\"><table>"));
  EXPECT_TRUE(holds(html, "<td class=\"l\" data-n=\"a\">1</td>"));
  EXPECT_TRUE(holds(html, "<td data-n=\"e&amp;f\">5</td>"));
  table.rows.push_back(table.rows.front());
  document.sections = {{"", {table}, false}};
  EXPECT_FALSE(holds(as_html(document), "data-n=\""));
}

TEST(Escaped, LeavesNoMarkup) {
  EXPECT_EQ(escaped("<a b=\"c\">'&"), "&lt;a b=&quot;c&quot;&gt;&#39;&amp;");
}

TEST(Escaped, KeepsUtf8AndNoControlCharacters) {
  EXPECT_EQ(escaped("± N·m\x01\n"), "± N·m  ");
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
