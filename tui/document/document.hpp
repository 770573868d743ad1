// The room tui/document. Written documents: their parts, the pictures in them,
// and the two ways they are printed, HTML and Markdown.
// In:  Words, tables, curves, matrices and shapes.
// Out: Text of files.
// May include: its row in CONTRIBUTING.md.
//
// What a written report is made of. Text is plain UTF-8; what a format wants
// escaped its printer escapes.
#pragma once

#include <string>
#include <variant>
#include <vector>

namespace tapfit::tui {

struct Paragraph {
  enum class Kind { Plain, Verdict, Small };
  std::string text;
  Kind kind = Kind::Plain;
};

struct BulletList {
  std::vector<std::string> items;
};

/// A table of text.
struct DataTable {
  std::string caption;
  std::vector<std::string> heading;  ///< a leading '<' sets a column to the
                                     ///< left, otherwise it is a number's
  std::vector<std::vector<std::string>> rows;  ///< each as long as the heading
};

/// A picture.
struct Figure {
  std::string name;  ///< of its file, where it becomes one: [a-z0-9-]
  std::string caption;
  std::string svg;  ///< a whole <svg> element
};

/// Pictures side by side, as many as there is room for.
struct FigureRow {
  std::vector<Figure> figures;
};

using Part = std::variant<Paragraph, BulletList, DataTable, Figure, FigureRow>;

struct Section {
  std::string title;  ///< empty: none is printed
  std::vector<Part> parts;
  bool new_page = false;  ///< where it is printed on paper
};

struct Document {
  std::string title;
  std::string subtitle;
  std::vector<Section> sections;
};

/// A column's heading without the mark that sets it to the left.
struct ColumnName {
  std::string text;
  bool left = false;
};
[[nodiscard]] ColumnName column_name(const std::string& heading);

}  // namespace tapfit::tui
